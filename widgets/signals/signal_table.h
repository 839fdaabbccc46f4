#pragma once

#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <optional>
#include <span>
#include <vector>

#include "widgets/base/plain_table.h"

namespace terratact {

/// One signal as the operator reads it.
struct SignalRow {
    enum class Standing {
        Fresh,
        /// An older value of a frame that is sent on occasion: grey, still readable.
        Said,
        Stale,  ///< too old: reads "--"
    };
    QString frame;  ///< "022 Attitude"; empty: same frame as the row above
    QString name, value, unit;
    Standing standing = Standing::Stale;
    std::optional<double> rate;  ///< [Hz] rate of the frame
    std::optional<double> age;   ///< [s]
    QString least, most;
    std::vector<float> history;     ///< newest last; NaN: a gap
    QString meaning, frameMeaning;  ///< plain text for the tip; empty: unknown
    bool operator==(const SignalRow&) const = default;
};

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
