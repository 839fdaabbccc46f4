#include "widgets/signals/time_plots.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"

namespace terratact {

TimePlots::TimePlots(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this))
{
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(2);
    empty_ = new PlainLabel(this);
    empty_->setText(tr("No plot yet: drag a signal here, or choose one and press New plot"));
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    setTone(*empty_, Tone::Muted);
    column_->addWidget(empty_, 1);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void TimePlots::setRows(int count)
{
    while (rows() > count) {
        TimePlot* const last = rows_.takeLast();
        column_->removeWidget(last);
        last->hide();
        last->deleteLater();
    }
    while (rows() < count) {
        auto* row = new TimePlot(this);
        const int index = rows();
        rows_ << row;
        column_->addWidget(row, 1);
        connect(row, &TimePlot::pointed, this, &TimePlots::pointed);
        connect(row, &TimePlot::left, this, &TimePlots::pointerLeft);
        connect(row, &TimePlot::clicked, this, &TimePlots::clicked);
        connect(row, &TimePlot::zoomed, this, &TimePlots::zoomed);
        connect(row, &TimePlot::moved, this, &TimePlots::moved);
        connect(row, &TimePlot::boxed, this,
                [this, index](const PlotBox& box) { emit boxed(index, box); });
        connect(row, &TimePlot::chosen, this, [this, index] { emit rowChosen(index); });
        row->QWidget::show();
    }
    empty_->setVisible(count == 0);
    for (int i = 0; i < count; ++i) rows_[i]->setTimeScaleShown(i + 1 == count);
}

void TimePlots::setViewState(TimePlotsViewState viewState)
{
    viewState_ = std::move(viewState);
    const int count = std::min(static_cast<int>(viewState_.rows.size()), kMaxRows);
    if (count != rows() || empty_->isVisibleTo(this) != (count == 0)) setRows(count);
    for (int i = 0; i < count; ++i) {
        TimePlotRow& shown = viewState_.rows[static_cast<std::size_t>(i)];
        TimePlot& row = *rows_[i];
        row.setCurves(shown.curves);
        row.setValues(shown.values);
        row.setSpan(viewState_.from, viewState_.to, viewState_.zero, viewState_.until);
        row.setCursor(viewState_.cursor);
        row.setChosen(i == target_ || (target_ < 0 && count > 1 && i == viewState_.chosen));
        row.TimePlot::show();
    }
    alignRows();
}

/// Gives all scales of values the width of the widest one.
void TimePlots::alignRows()
{
    int widest = 0;
    for (TimePlot* row : rows_) {
        row->setValueExtent(0);
        widest = std::max(widest, row->valueExtent());
    }
    for (TimePlot* row : rows_) {
        row->setValueExtent(widest);
        row->updateLayout();
    }
}

int TimePlots::rowAt(const QPoint& global) const
{
    if (!rect().contains(mapFromGlobal(global))) return -1;
    for (int i = 0; i < rows(); ++i)
        if (rows_[i]->rect().contains(rows_[i]->mapFromGlobal(global))) {
            // The lowest part of the last row is below it.
            const int y = rows_[i]->mapFromGlobal(global).y();
            const bool isBelow = i + 1 == rows() && y > rows_[i]->canvas()->geometry().bottom();
            return isBelow ? rows() : i;
        }
    return rows();
}

int TimePlots::columns() const
{
    return std::max(2, rows_.isEmpty() ? width() : rows_.first()->canvas()->width());
}

void TimePlots::setTarget(int row)
{
    target_ = row;
    for (int i = 0; i < rows(); ++i) {
        rows_[i]->setChosen(i == target_ || (target_ < 0 && rows() > 1 && i == viewState_.chosen));
        rows_[i]->replot();
    }
}

}  // namespace terratact
