#include "widgets/signals/plot_values.h"

#include <utility>

#include "app/display/format.h"
#include "widgets/base/tips.h"
#include "widgets/signals/live_rows.h"

namespace terratact {

/// The rows of PlotValues.
class PlotValuesModel final : public LiveRows<PlottedValues, PlotValues::kColumns> {
public:
    using LiveRows::LiveRows;

    QVariant data(const QModelIndex& index, int role) const override
    {
        if (!index.isValid()) return {};
        if (role == Qt::TextAlignmentRole) return alignment(index.column());
        const QString shown = text(row(index.row()), index.column());
        if (role == Qt::DisplayRole) return shown;
        if (role == Qt::ToolTipRole) return plainTip(shown);
        return {};
    }

private:
    QString heading(int column) const override
    {
        const QString names[PlotValues::kColumns]{
            PlotValues::tr("Plot"),   PlotValues::tr("Signal"),
            PlotValues::tr("Unit"),   PlotValues::tr("Cursor"),
            PlotValues::tr("Min"),    PlotValues::tr("Max"),
            PlotValues::tr("Mean"),   PlotValues::tr("sd"),
            PlotValues::tr("Values"), {}};
        return names[column];
    }
    bool isNumber(int column) const override
    {
        return column != PlotValues::Name && column != PlotValues::Unit;
    }
    static QString text(const PlottedValues& of, int column)
    {
        const auto value = [&](double number) {
            return of.visible.count > 0 ? format::significant(number, 5) : format::kNothing;
        };
        switch (column) {
        case PlotValues::Plot: return QString::number(of.row);
        case PlotValues::Name: return of.name;
        case PlotValues::Unit: return of.unit;
        case PlotValues::Cursor:
            return of.atCursor ? format::significant(*of.atCursor, 5) : format::kNothing;
        case PlotValues::Least: return value(of.visible.low);
        case PlotValues::Most: return value(of.visible.high);
        case PlotValues::Mean: return value(of.visible.mean);
        case PlotValues::Sd:
            return of.visible.count > 1 ? value(of.visible.sd()) : format::kNothing;
        case PlotValues::Count: return QString::number(of.visible.count);
        default: return {};
        }
    }
};

PlotValues::PlotValues(QWidget* parent) : PlainTable(parent), model_(new PlotValuesModel(this))
{
    setAccessibleName(tr("Values in sight"));
    setModel(model_);
    setAlternatingRowColors(true);
    const QString number = QStringLiteral("\u22121.2345e+06");
    setWidest({{QStringLiteral("6")},
               {QStringLiteral("front flipper right")},
               {QStringLiteral("rad/s")},
               {number},
               {number},
               {number},
               {number},
               {number},
               {QStringLiteral("12345678")},
               {}});
}

void PlotValues::setValues(std::vector<PlottedValues> values)
{
    model_->setRows(std::move(values));
}

QString PlotValues::text(int row, Column column) const
{
    return model_->data(model_->index(row, column), Qt::DisplayRole).toString();
}

int PlotValues::rows() const
{
    return model_->rowCount();
}

}  // namespace terratact
