#include "app/numbers_page.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "widgets/card.h"
#include "widgets/look.h"
#include "widgets/numbers_table.h"
#include "widgets/words.h"

namespace terratact {

NumbersPage::NumbersPage(std::function<NumbersSight()> look, QWidget* parent)
    : Page(parent), look_(std::move(look))
{
    auto* card = new Card(tr("The scene as numbers"), this);
    copy_ = new QPushButton(tr("Copy (Ctrl+C)"), card);
    copy_->setFocusPolicy(Qt::TabFocus);
    copy_->setToolTip(tr("The whole table, columns apart by tabs"));
    card->titleRow()->addWidget(copy_);
    summary_ = new QLabel(card);
    summary_->setWordWrap(true);
    summary_->setAccessibleName(tr("Estimate"));
    setTone(*summary_, Tone::Muted);
    table_ = new NumbersTable(card);
    card->body()->addWidget(summary_);
    card->body()->addWidget(table_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    column->addWidget(card);
    connect(copy_, &QPushButton::clicked, table_, &NumbersTable::copy);
    summary_->setText(look_().whyNoEstimate);
}

void NumbersPage::refresh(double /*now*/)
{
    const NumbersSight sight = look_();
    if (!sight.estimate) {
        if (shown_) table_->clearEstimate();
        shown_.reset();
        summary_->setText(sight.whyNoEstimate);
        return;
    }
    if (shown_ == *sight.estimate && shownLimit_ == sight.stepLimit) return;
    shown_ = *sight.estimate;
    shownLimit_ = sight.stepLimit;
    table_->setEstimate(*shown_, shownLimit_);
    summary_->setText(tr("%1, %2 draws, seed %3; heights above the IMU, steps of more than %4 m")
                          .arg(words::text(name(shown_->settings.method)))
                          .arg(shown_->draws.size())
                          .arg(shown_->settings.seed)
                          .arg(words::number(shownLimit_, 2)));
}

}  // namespace terratact
