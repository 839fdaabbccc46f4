#include "widgets/signals/signal_table.h"

#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "core/robot/measurement.h"
#include "widgets/base/palette.h"
#include "widgets/base/tips.h"
#include "widgets/signals/live_rows.h"

namespace terratact {

/// The rows of SignalTable.
class SignalModel final : public LiveRows<SignalRow, SignalTable::kColumns> {
public:
    using LiveRows::LiveRows;

    QVariant data(const QModelIndex& index, int role) const override
    {
        if (!index.isValid()) return {};
        const SignalRow& r = row(index.row());
        switch (role) {
        case Qt::DisplayRole: return text(r, index.column());
        case Qt::TextAlignmentRole: return alignment(index.column());
        case Qt::ForegroundRole: return colour(r, index.column());
        case Qt::ToolTipRole: return plainTip(tip(r, index.column()));
        case Qt::AccessibleDescriptionRole:
            return index.column() == SignalTable::Frame ? r.frameMeaning : r.meaning;
        case Qt::AccessibleTextRole:
            return index.column() == SignalTable::History
                     ? SignalTable::tr("history of %1").arg(r.name)
                     : text(r, index.column());
        default: return {};
        }
    }

private:
    QString heading(int column) const override
    {
        const QString names[SignalTable::kColumns]{
            SignalTable::tr("Frame"), SignalTable::tr("Signal"), SignalTable::tr("Value"),
            SignalTable::tr("Unit"),  SignalTable::tr("Rate"),   SignalTable::tr("Age"),
            SignalTable::tr("Min"),   SignalTable::tr("Max"),    SignalTable::tr("Last 12 s")};
        return names[column];
    }
    bool isNumber(int column) const override
    {
        return (column >= SignalTable::Rate && column <= SignalTable::Most)
            || column == SignalTable::Value;
    }
    static QColor colour(const SignalRow& row, int column)
    {
        const bool lives = row.standing == SignalRow::Standing::Fresh;
        const bool isBeside = column == SignalTable::Unit || column == SignalTable::Least
                           || column == SignalTable::Most || column == SignalTable::Rate;
        if (column == SignalTable::Frame || column == SignalTable::Name) return theme().text;
        return lives && !isBeside ? theme().text : theme().muted;
    }
    /// Returns the full text of a cell that may be elided.
    static QString tip(const SignalRow& row, int column)
    {
        if (column == SignalTable::Frame) return row.frameMeaning;
        if (column != SignalTable::Name && column != SignalTable::Value) return row.meaning;
        return (text(row, column) + QLatin1Char('\n') + row.meaning).trimmed();
    }
    static QString text(const SignalRow& row, int column)
    {
        switch (column) {
        case SignalTable::Frame: return row.frame;
        case SignalTable::Name: return row.name;
        case SignalTable::Value:
            return row.standing == SignalRow::Standing::Stale ? format::kNothing : row.value;
        case SignalTable::Unit: return row.unit;
        case SignalTable::Rate:
            return row.rate ? format::number(*row.rate, 1) + QStringLiteral(" Hz")
                            : format::kNothing;
        case SignalTable::Age: return row.age ? format::age(*row.age) : format::kNothing;
        case SignalTable::Least: return row.least;
        case SignalTable::Most: return row.most;
        default: return {};
        }
    }
};

namespace {

/// Draws the history; the base class draws the other columns.
class HistoryDelegate final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const auto* model = static_cast<const SignalModel*>(index.model());
        painter->setPen(theme().contact);
        for (const QPolygonF& line : sparkline(model->row(index.row()).history,
                                               QRectF(option.rect).adjusted(6, 4, -6, -4))) {
            if (line.size() == 1)
                painter->drawPoint(line.first());
            else
                painter->drawPolyline(line);
        }
    }
};

/// Returns the longest usual texts of a signal.
QStringList activities()
{
    QStringList words;
    for (const RobotActivity activity :
         {RobotActivity::Halted, RobotActivity::Driving, RobotActivity::Pressing,
          RobotActivity::Pressed, RobotActivity::Probing, RobotActivity::Stopped})
        words << translated(describe(activity));
    return words;
}

}  // namespace

std::vector<QPolygonF> sparkline(std::span<const float> history, const QRectF& box)
{
    float least = 0.0F, most = 0.0F;
    bool any = false;
    for (const float value : history) {
        if (!std::isfinite(value)) continue;
        least = any ? std::min(least, value) : value;
        most = any ? std::max(most, value) : value;
        any = true;
    }
    if (!any || !(box.width() > 0.0) || !(box.height() > 0.0)) return {};
    const double range = static_cast<double>(most) - static_cast<double>(least);
    const double step =
        box.width() / std::max<double>(1.0, static_cast<double>(history.size()) - 1.0);
    std::vector<QPolygonF> lines;
    bool pen = false;
    for (std::size_t i = 0; i < history.size(); ++i) {
        if (!std::isfinite(history[i])) {
            pen = false;
            continue;
        }
        const double share = range > 0.0 ? (static_cast<double>(history[i]) - least) / range : 0.5;
        if (!pen) lines.emplace_back();
        lines.back() << QPointF(box.left() + step * static_cast<double>(i),
                                box.bottom() - share * box.height());
        pen = true;
    }
    return lines;
}

SignalTable::SignalTable(QWidget* parent) : PlainTable(parent), model_(new SignalModel(this))
{
    setAccessibleName(tr("Signals"));
    setModel(model_);
    setItemDelegateForColumn(History, new HistoryDelegate(this));
    setAlternatingRowColors(true);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    const QString number = QStringLiteral("\u22123.14159");
    setWidest({{QStringLiteral("00000000 RightForces4To6")},
               {QStringLiteral("LastCommand")},
               activities(),
               {QStringLiteral("N.m ")},
               {QStringLiteral("9000.0 Hz")},
               {QStringLiteral("3600.0 s")},
               {number},
               {number},
               {}});
}

void SignalTable::setRows(std::vector<SignalRow> rows)
{
    model_->setRows(std::move(rows));
}

QString SignalTable::text(int row, Column column) const
{
    return model_->data(model_->index(row, column), Qt::DisplayRole).toString();
}

int SignalTable::rows() const
{
    return model_->rowCount();
}

}  // namespace terratact
