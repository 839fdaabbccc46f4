#include "app/review/review_signals_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/display/format.h"
#include "app/mission/signal_rows.h"
#include "app/pages/dbc_files.h"
#include "widgets/base/card.h"
#include "widgets/base/plain_label.h"
#include "widgets/signals/signal_table.h"

namespace terratact {

ReviewSignalsPage::ReviewSignalsPage(SessionReader& session, PreferenceStore& preferences,
                                     QWidget* parent)
    : Page(parent), payload_(session), dbc_(new DbcFiles(preferences, *this))
{
    auto* card = new Card(tr("Signals of other devices"), this);
    card->note()->hide();
    card->titleRow()->addStretch(1);
    dbc_->addButtons(*card->titleRow());
    headline_ = new PlainLabel(card);
    headline_->setWordWrap(true);
    headline_->setAccessibleName(tr("Which signals these are"));
    card->body()->addWidget(headline_);
    dbc_->addLines(*card->body());
    table_ = new SignalTable(card);
    table_->setColumnHidden(SignalTable::History, true);  // the timeline shows the history
    card->body()->addWidget(table_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    column->addWidget(card, 1);
    connect(dbc_, &DbcFiles::wereRead, this, [this](const DbcReading& reading) {
        payload_.describe(reading.book);
        if (isVisible()) refresh(0.0);
    });
    dbc_->read();
}

void ReviewSignalsPage::setTime(SessionTime time)
{
    time_ = time;
    if (isVisible()) refresh(0.0);
}

void ReviewSignalsPage::refresh(double /*now*/)
{
    const auto frames = payload_.at(time_);
    const QString seconds = format::number(ReviewPayload::kWindow, 0);
    headline_->setText(
        frames.empty()
            ? tr("No other device had sent a frame in the %1 s before this time").arg(seconds)
            : tr("The newest values of the %1 s before this time; minimum and maximum are of those "
                 "seconds")
                  .arg(seconds));
    table_->setRows(signalRows(frames));
}

void ReviewSignalsPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    refresh(0.0);
}

}  // namespace terratact
