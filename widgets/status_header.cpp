#include "widgets/status_header.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStyle>

#include "widgets/arming_control.h"
#include "widgets/look.h"

namespace terratact {

StatusHeader::StatusHeader(QWidget* parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("statusHeader"));
    setAccessibleName(tr("Status"));
    source_ = new QLabel(this);
    source_->setObjectName(QStringLiteral("sourceName"));
    source_->setAccessibleName(tr("Where the data come from"));
    const auto chip = [this](const QString& name) {
        auto* label = new QLabel(this);
        label->setProperty("chip", true);
        label->setAccessibleName(name);
        return label;
    };
    link_ = chip(tr("Link"));
    robot_ = chip(tr("What the robot does"));
    model_ = chip(tr("Model"));
    overridden_ = chip(tr("Checks overridden"));
    overridden_->setText(tr("! CHECK OVERRIDDEN"));
    setTone(*overridden_, Tone::Doubt);
    overridden_->hide();
    alarms_ = new QPushButton(this);
    alarms_->setProperty("role", "quiet");
    alarms_->setFocusPolicy(Qt::TabFocus);
    alarms_->setToolTip(tr("What is wrong, and what was and has not been seen (F4)"));
    connect(alarms_, &QPushButton::clicked, this, &StatusHeader::alarmsRequested);
    setAlarms(0, 0);
    quality_ = new QPushButton(this);
    quality_->setProperty("role", "quiet");
    quality_->setFocusPolicy(Qt::TabFocus);
    quality_->setAccessibleName(tr("Quality of the estimate"));
    quality_->setToolTip(tr("How much time an estimate may take for its accuracy"));
    quality_->setVisible(false);
    arming_ = new ArmingControl(this);
    help_ = new QPushButton(tr("Keys\nF1"), this);
    help_->setFocusPolicy(Qt::TabFocus);
    help_->setToolTip(tr("Every key, and what this program is"));
    stop_ = new QPushButton(tr("STOP (F12)"), this);
    stop_->setProperty("role", "stop");
    stop_->setProperty("latched", false);
    stop_->setFocusPolicy(Qt::TabFocus);
    stop_->setAccessibleName(tr("STOP"));
    stop_->setAccessibleDescription(
        tr("Halts the robot at once and latches; F12 does the same everywhere"));
    stop_->setToolTip(stop_->accessibleDescription());

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(18, 7, 12, 7);
    row->setSpacing(8);
    row->addWidget(source_);
    row->addSpacing(6);
    for (QLabel* label : {overridden_, link_, robot_, model_})
        row->addWidget(label, 0, Qt::AlignVCenter);
    row->addWidget(arming_, 0, Qt::AlignVCenter);
    row->addStretch(1);
    row->addWidget(alarms_, 0, Qt::AlignVCenter);
    row->addWidget(quality_, 0, Qt::AlignVCenter);
    row->addSpacing(20);  // nothing harmless close to STOP
    row->addWidget(stop_);
    connect(help_, &QPushButton::clicked, this, &StatusHeader::helpRequested);
    connect(stop_, &QPushButton::pressed, this, &StatusHeader::stopPressed);
}

void StatusHeader::setSource(const QString& name)
{
    source_->setText(name);
}

void StatusHeader::setLink(const QString& text, Tone tone, const QString& details)
{
    link_->setText(text);
    if (link_->toolTip() != details) link_->setToolTip(details);
    setTone(*link_, tone);
}

void StatusHeader::setAlarms(int unseen, int all)
{
    const QString count = all == 0 ? tr("no alarms") : tr("alarms: %1").arg(all);
    const QString text = unseen > 0 ? QStringLiteral("▲ ") + count : count;
    if (alarms_->text() == text) return;
    alarms_->setText(text);
    alarms_->setAccessibleName(tr("%1, %2 not acknowledged").arg(count).arg(unseen));
    alarms_->setProperty("role", unseen > 0 ? "alarm" : "quiet");
    alarms_->style()->unpolish(alarms_);
    alarms_->style()->polish(alarms_);
}

void StatusHeader::setRobot(const QString& text, Tone tone)
{
    robot_->setText(text);
    setTone(*robot_, tone);
}

void StatusHeader::setOverridden(const QString& what)
{
    overridden_->setVisible(!what.isEmpty());
    overridden_->setToolTip(what);
}

void StatusHeader::setModel(const QString& text, Tone tone, const QString& details)
{
    model_->setText(text);
    model_->setToolTip(details);
    setTone(*model_, tone);
    fit();
}

void StatusHeader::fit()
{
    const int needed = layout()->sizeHint().width()
                     + (model_->isHidden() ? model_->sizeHint().width() + layout()->spacing() : 0);
    const bool trouble = model_->property("tone").toString() == QLatin1String("bad");
    model_->setVisible(needed <= width() || trouble);
}

void StatusHeader::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    fit();
}

bool StatusHeader::event(QEvent* event)
{
    const bool handled = QFrame::event(event);
    if (event->type() == QEvent::LayoutRequest) fit();
    return handled;
}

void StatusHeader::setQualities(const QStringList& names, const QStringList& lines, int chosen)
{
    auto* menu = new QMenu(quality_);
    for (int k = 0; k < lines.size(); ++k) {
        QAction* action = menu->addAction(lines[k]);
        action->setCheckable(true);
        action->setChecked(k == chosen);
        connect(action, &QAction::triggered, this, [this, menu, names, k] {
            for (int i = 0; i < names.size(); ++i) menu->actions().at(i)->setChecked(i == k);
            quality_->setText(names[k]);
            emit qualityChosen(k);
        });
    }
    delete quality_->menu();
    quality_->setMenu(menu);
    quality_->setText(names.value(chosen));
    quality_->setVisible(!lines.isEmpty());
}

void StatusHeader::setLatched(bool latched)
{
    if (stop_->property("latched").toBool() == latched) return;
    stop_->setProperty("latched", latched);
    stop_->setText(latched ? tr("STOPPED (F12)") : tr("STOP (F12)"));
    stop_->style()->unpolish(stop_);
    stop_->style()->polish(stop_);
}

QString StatusHeader::sourceName() const
{
    return source_->text();
}

QString StatusHeader::linkText() const
{
    return link_->text();
}

}  // namespace terratact
