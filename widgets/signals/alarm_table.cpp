#include "widgets/signals/alarm_table.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/plain_table.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

enum Column { State, Text, Since, Times, kColumns };
constexpr double kMinute = 60.0;  // [s]

QString alarmStateText(AlarmState state, Severity severity)
{
    const bool isCritical = severity == Severity::Critical;
    switch (state) {
    case AlarmState::Unacknowledged:
        return isCritical ? AlarmTable::tr("▲ CRITICAL, new") : AlarmTable::tr("◆ caution, new");
    case AlarmState::Returned: return AlarmTable::tr("▽ over, not seen");
    case AlarmState::Acknowledged:
        return isCritical ? AlarmTable::tr("■ critical, seen") : AlarmTable::tr("■ caution, seen");
    }
    return {};
}

QColor colourOf(const Alarm& alarm)
{
    if (alarm.state == AlarmState::Returned) return theme().muted;
    return alarm.severity == Severity::Critical ? theme().bad : theme().warning;
}

QString sinceText(const Alarm& alarm, double now)
{
    const QString ago = format::countdown(std::floor(now - alarm.since));
    if (alarm.state != AlarmState::Returned) return AlarmTable::tr("for %1").arg(ago);
    return AlarmTable::tr("over for %1").arg(format::countdown(std::floor(now - alarm.returned)));
}

/// Returns every text that the state column can show.
QStringList allStates()
{
    QStringList words;
    for (const AlarmState state :
         {AlarmState::Unacknowledged, AlarmState::Returned, AlarmState::Acknowledged})
        for (const Severity severity : {Severity::Caution, Severity::Critical})
            words << alarmStateText(state, severity);
    return words;
}

QPushButton* button(const QString& text, const QString& tip, QWidget* parent)
{
    auto* made = new QPushButton(text, parent);
    setTip(*made, tip);
    made->setFocusPolicy(Qt::TabFocus);
    made->setMinimumHeight(kTarget);
    return made;
}

}  // namespace

AlarmTable::AlarmTable(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Alarms"));
    table_ = new QTableWidget(0, kColumns, this);
    table_->setAccessibleName(tr("Alarms, most urgent first"));
    table_->setHorizontalHeaderLabels({tr("State"), tr("What"), tr("Since"), tr("Times")});
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    table_->setWordWrap(true);
    table_->setShowGrid(false);
    table_->setFrameShape(QFrame::NoFrame);
    table_->verticalHeader()->setVisible(false);
    table_->verticalHeader()->setMinimumSectionSize(kTarget);
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setHighlightSections(false);
    table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table_->horizontalHeader()->setSectionResizeMode(Text, QHeaderView::Stretch);
    nothing_ = new PlainLabel(tr("✔ No alarms."), this);
    nothing_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setTone(*nothing_, Tone::Good);

    acknowledge_ = button(tr("Acknowledge"), {}, this);  // offer() sets the tips
    all_ = button(tr("Acknowledge all"), {}, this);
    one_ = button(tr("Mute 60 s"), tr("Mutes alarms for 60 s; new alarms still sound"), this);
    two_ = button(tr("Mute 120 s"), tr("Mutes alarms for 120 s; new alarms still sound"), this);
    sound_ = new QCheckBox(tr("Sound"), this);
    setTip(*sound_,
           tr("Critical alarms beep until they are acknowledged: at once, then every 10 s"));
    sound_->setMinimumHeight(kTarget);
    sound_->setChecked(true);
    try_ = button(tr("Test the sound"), tr("Plays the alarm sound once"), this);
    soundTrouble_ = new PlainLabel(this);
    soundTrouble_->setWordWrap(true);
    soundTrouble_->hide();
    setTone(*soundTrouble_, Tone::Bad);
    silence_ = new PlainLabel(this);
    silence_->setAccessibleName(tr("Mute"));
    setTone(*silence_, Tone::Warning);
    connect(acknowledge_, &QPushButton::clicked, this, [this] { emit acknowledged(chosen()); });
    connect(table_, &QTableWidget::itemSelectionChanged, this, &AlarmTable::offer);
    connect(table_, &QTableWidget::activated, this, [this] { emit acknowledged(chosen()); });
    connect(all_, &QPushButton::clicked, this, &AlarmTable::allAcknowledged);
    connect(one_, &QPushButton::clicked, this, [this] { emit silenced(kMinute); });
    connect(two_, &QPushButton::clicked, this, [this] { emit silenced(2.0 * kMinute); });
    connect(try_, &QPushButton::clicked, this, &AlarmTable::soundTried);
    connect(sound_, &QCheckBox::toggled, this, &AlarmTable::soundWanted);

    auto* actions = new QHBoxLayout;
    actions->setSpacing(10);
    for (QPushButton* b : {acknowledge_, all_}) actions->addWidget(b);
    actions->addSpacing(24);
    for (QPushButton* b : {one_, two_}) actions->addWidget(b);
    actions->addWidget(sound_);
    actions->addWidget(try_);
    actions->addWidget(silence_);
    actions->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addLayout(actions);
    column->addWidget(soundTrouble_);
    column->addWidget(nothing_, 1);  // either the table or this label is visible
    column->addWidget(table_, 1);
    setAlarms({}, 0.0, 0.0);
    resizeToFont();
}

void AlarmTable::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (changesFont(*event) && table_) resizeToFont();
}

void AlarmTable::resizeToFont()
{
    const QString longest = QStringLiteral("599:59");
    table_->setColumnWidth(State, columnWidthFor(*table_, fontMetrics(), State, allStates()));
    table_->setColumnWidth(
        Since, columnWidthFor(*table_, fontMetrics(), Since,
                              {tr("for %1").arg(longest), tr("over for %1").arg(longest)}));
    table_->setColumnWidth(Times,
                           columnWidthFor(*table_, fontMetrics(), Times, {QStringLiteral("9999")}));
}

void AlarmTable::put(int row, const Alarm& alarm, double now)
{
    const QString texts[kColumns]{alarmStateText(alarm.state, alarm.severity),
                                  translated(alarm.text), sinceText(alarm, now),
                                  QString::number(alarm.raised)};
    for (int column = 0; column < kColumns; ++column) {
        QTableWidgetItem* item = table_->item(row, column);
        if (!item) table_->setItem(row, column, item = new QTableWidgetItem);
        if (item->text() != texts[column]) item->setText(texts[column]);
        if (column == Times) continue;
        const QColor colour = column == Since ? theme().text : colourOf(alarm);
        if (item->foreground().color() != colour) item->setForeground(colour);
    }
    table_->item(row, State)->setData(Qt::UserRole, format::text(alarm.id));
}

void AlarmTable::setAlarms(const std::vector<Alarm>& alarms, double now, double silentFor)
{
    const QString id = chosen();
    const int rows = static_cast<int>(alarms.size());
    const bool isFirst = table_->rowCount() == 0;
    const bool isGone =
        std::ranges::none_of(alarms, [&](const Alarm& a) { return format::text(a.id) == id; });
    if (isGone)
        table_->setCurrentItem(nullptr);  // otherwise Qt would select the next item of the row
    if (table_->rowCount() != rows) table_->setRowCount(rows);
    for (int row = 0; row < rows; ++row) {
        put(row, alarms[static_cast<std::size_t>(row)], now);
        if (table_->item(row, State)->data(Qt::UserRole).toString() == id
            && table_->currentRow() != row)
            table_->selectRow(row);  // the selection follows the moved alarm
    }
    if (rows > 0 && isFirst) table_->selectRow(0);
    nothing_->setVisible(rows == 0);
    table_->setVisible(rows > 0);
    offer();
    describe(silentFor);
}

void AlarmTable::offer()
{
    const bool any = table_->rowCount() > 0, one = !chosen().isEmpty();
    const QString none = tr("No alarm is active");
    acknowledge_->setEnabled(one);
    setTip(*acknowledge_, one   ? tr("Acknowledges the selected alarm")
                          : any ? tr("No alarm is selected in the list")
                                : none);
    all_->setEnabled(any);
    setTip(*all_, any ? tr("Acknowledges all alarms") : none);
}

void AlarmTable::describe(double silentFor)
{
    silence_->setText(silentFor > 0.0 ? tr("muted for %1").arg(format::countdown(silentFor))
                                      : QString());
}

void AlarmTable::setSoundTrouble(const QString& why)
{
    if (why.isEmpty() != soundTrouble_->isHidden()) soundTrouble_->setVisible(!why.isEmpty());
    const QString said =
        why.isEmpty() ? QString() : tr("✘ Only the desktop's bell can sound: %1").arg(why);
    if (said != soundTrouble_->text()) soundTrouble_->setText(said);
}

void AlarmTable::setSoundOn(bool on)
{
    sound_->setChecked(on);
}

QString AlarmTable::chosen() const
{
    const QTableWidgetItem* item = table_->item(table_->currentRow(), State);
    return item ? item->data(Qt::UserRole).toString() : QString();
}

}  // namespace terratact
