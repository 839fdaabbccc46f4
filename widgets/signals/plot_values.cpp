#include "widgets/signals/plot_values.h"

#include <QAbstractTableModel>
#include <utility>

#include "app/display/format.h"
#include "widgets/base/tips.h"

namespace terratact {

/// The rows of PlotValues.
class PlotValuesModel final : public QAbstractTableModel {
public:
    using QAbstractTableModel::QAbstractTableModel;

    void setValues(std::vector<PlottedValues> values)
    {
        if (values.size() != values_.size()) {
            beginResetModel();
            values_ = std::move(values);
            endResetModel();
            return;
        }
        values_ = std::move(values);
        if (!values_.empty())
            emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }

    int rowCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(values_.size());
    }
    int columnCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : PlotValues::kColumns;
    }
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override
    {
        if (orientation != Qt::Horizontal) return {};
        const QString names[PlotValues::kColumns]{
            PlotValues::tr("Plot"),   PlotValues::tr("Signal"),
            PlotValues::tr("Unit"),   PlotValues::tr("Cursor"),
            PlotValues::tr("Min"),    PlotValues::tr("Max"),
            PlotValues::tr("Mean"),   PlotValues::tr("sd"),
            PlotValues::tr("Values"), {}};
        if (role == Qt::DisplayRole) return names[section];
        if (role == Qt::TextAlignmentRole) return alignment(section);
        return {};
    }
    QVariant data(const QModelIndex& index, int role) const override
    {
        if (!index.isValid()) return {};
        if (role == Qt::TextAlignmentRole) return alignment(index.column());
        const QString shown = text(values_[static_cast<std::size_t>(index.row())], index.column());
        if (role == Qt::DisplayRole) return shown;
        if (role == Qt::ToolTipRole) return plainTip(shown);
        return {};
    }

private:
    static QVariant alignment(int column)
    {
        const bool isText = column == PlotValues::Name || column == PlotValues::Unit;
        return QVariant::fromValue(
            Qt::Alignment((isText ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter));
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

    std::vector<PlottedValues> values_;
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
    model_->setValues(std::move(values));
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
