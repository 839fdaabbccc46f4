#include "app/console/pages/alarms_page.h"

#include <QVBoxLayout>

#include "app/mission/console_alarms.h"
#include "app/runtime/steady_now.h"
#include "widgets/base/card.h"
#include "widgets/signals/alarm_table.h"

namespace terratact {

AlarmsPage::AlarmsPage(ConsoleAlarms& alarms, QWidget* parent) : Page(parent), alarms_(alarms)
{
    auto* card = new Card(tr("Alarms"), this);
    table_ = new AlarmTable(card);
    table_->setSoundOn(alarms_.soundOn());
    card->body()->addWidget(table_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    column->addWidget(card, 1);
    connect(table_, &AlarmTable::acknowledged, this,
            [this](const QString& id) { alarms_.acknowledge(id.toStdString()); });
    connect(table_, &AlarmTable::allAcknowledged, this, [this] { alarms_.acknowledgeAll(); });
    connect(table_, &AlarmTable::silenced, this,
            [this](double seconds) { alarms_.silence(steadyNow() + seconds); });
    connect(table_, &AlarmTable::soundTried, this, [this] { alarms_.trySound(); });
    connect(table_, &AlarmTable::soundWanted, this, [this](bool on) { alarms_.setSoundOn(on); });
}

void AlarmsPage::refresh(double now)
{
    table_->setAlarms(alarms_.list().alarms(), now, alarms_.list().silentFor(now));
    table_->setSoundTrouble(alarms_.soundTrouble());
}

}  // namespace terratact
