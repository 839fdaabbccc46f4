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
        Said,   ///< an older word, of a frame that is sent on occasion: grey, but still to be read
        Stale,  ///< reads "--"
    };
    QString frame;  ///< "022 Attitude"; empty: the same as above
    QString name, value, unit;
    Standing standing = Standing::Stale;
    std::optional<double> rate;  ///< [Hz] of the frame
    std::optional<double> age;   ///< [s]
    QString least, most;
    std::vector<float> history;     ///< newest last; NaN: a gap
    QString meaning, frameMeaning;  ///< plain text for a tip; empty: nothing is known
    bool operator==(const SignalRow&) const = default;
};

/// The lines of a history in a box, from its least to its most; what is not finite is a gap.
std::vector<QPolygonF> sparkline(std::span<const float> history, const QRectF& box);

class SignalModel;

/// Signals with value, age, extremes and the last seconds.
class SignalTable final : public PlainTable {
    Q_OBJECT
public:
    enum Column { Frame, Name, Value, Unit, Rate, Age, Least, Most, History, kColumns };

    explicit SignalTable(QWidget* parent = nullptr);
    void setRows(std::vector<SignalRow> rows);
    QString text(int row, Column column) const;  ///< as shown
    int rows() const;

private:
    SignalModel* model_ = nullptr;
};

}  // namespace terratact
