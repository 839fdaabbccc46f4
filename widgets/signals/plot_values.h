#pragma once

#include <QString>
#include <vector>

#include "core/series/series_view.h"
#include "widgets/base/plain_table.h"

namespace terratact {

/// A plotted signal in numbers.
struct PlottedValues {
    int row = 1;  ///< number of its plot, from 1
    QString name, unit;
    std::optional<double> atCursor{};
    SeriesSummary visible{};
};

class PlotValuesModel;

/// The plotted signals in numbers: value at the cursor, and lowest, highest, mean, standard deviation and number of the
/// visible values.
class PlotValues final : public PlainTable {
    Q_OBJECT
public:
    /// Rest takes the remaining width, so that no other column is cut.
    enum Column { Plot, Name, Unit, Cursor, Least, Most, Mean, Sd, Count, Rest, kColumns };

    explicit PlotValues(QWidget* parent = nullptr);
    void setValues(std::vector<PlottedValues> values);
    QString text(int row, Column column) const;  ///< text as shown
    int rows() const;

private:
    PlotValuesModel* model_ = nullptr;
};

}  // namespace terratact
