#pragma once

#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <span>
#include <vector>

#include "app/display/signal_row.h"
#include "widgets/base/plain_table.h"

namespace terratact {

/// Returns the polylines of a history scaled into a box; values that are not finite break the line.
std::vector<QPolygonF> sparkline(std::span<const float> history, const QRectF& box);

class SignalModel;

/// Signals with value, age, extremes and a sparkline of the last seconds.
class SignalTable final : public PlainTable {
    Q_OBJECT
public:
    enum Column { Frame, Name, Value, Unit, Rate, Age, Least, Most, History, kColumns };

    explicit SignalTable(QWidget* parent = nullptr);
    void setRows(std::vector<SignalRow> rows);
    QString text(int row, Column column) const;  ///< text as shown
    int rows() const;

private:
    SignalModel* model_ = nullptr;
};

}  // namespace terratact
