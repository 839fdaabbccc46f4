#include "app/console/replay_bar.h"

#include <QHBoxLayout>
#include <QPushButton>

#include "app/shell/key_table.h"
#include "display/format.h"
#include "drivers/log_replay.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/tips.h"

namespace terratact {

ReplayBar::ReplayBar(LogReplay& replay, QWidget* parent) : QWidget(parent), replay_(replay)
{
    setAccessibleName(tr("Replay"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 0, 12, 6);
    row->setSpacing(8);
    const auto button = [&](const QString& text, const QString& tip) {
        auto* made = new QPushButton(text, this);
        made->setFocusPolicy(Qt::TabFocus);
        made->setMinimumHeight(scaled(kTarget));
        setTip(*made, tip);
        row->addWidget(made);
        return made;
    };
    back_ = button(tr("◀ %1 s").arg(kStep), tr("Goes back in the log (Ctrl+Left)"));
    pause_ = button(tr("Pause"), tr("Halts the log, or lets it go on (Ctrl+Space)"));
    pause_->setCheckable(true);
    on_ = button(tr("%1 s ▶").arg(kStep), tr("Goes on in the log (Ctrl+Right)"));
    repeat_ = button(tr("Repeat"), tr("Begins again at the end of the log (Ctrl+R)"));
    repeat_->setCheckable(true);
    at_ = new PlainLabel(this);
    at_->setAccessibleName(tr("How far the log is"));
    row->addWidget(at_);
    row->addStretch(1);
    connect(pause_, &QPushButton::clicked, this,
            [this](bool paused) { replay_.setPaused(paused); });
    connect(repeat_, &QPushButton::clicked, this,
            [this](bool repeats) { replay_.setRepeats(repeats); });
    connect(back_, &QPushButton::clicked, this, [this] { step(-kStep); });
    connect(on_, &QPushButton::clicked, this, [this] { step(kStep); });
    poll();
}

void ReplayBar::step(double seconds)
{
    replay_.seek(replay_.progress().at + seconds);
}

void ReplayBar::addKeys(KeyTable& keys)
{
    keys.addGroup(tr("Replay"));
    const auto add = [&](Qt::Key key, const QString& meaning, QPushButton* button) {
        keys.add({{QKeyCombination(Qt::CTRL, key)}, meaning, [button] { button->click(); }});
    };
    add(Qt::Key_Space, tr("pause the log, or let it go on"), pause_);
    add(Qt::Key_Left, tr("back in the log"), back_);
    add(Qt::Key_Right, tr("on in the log"), on_);
    add(Qt::Key_R, tr("begin again at the end of the log, or not"), repeat_);
}

void ReplayBar::poll()
{
    const LogReplay::Progress now = replay_.progress();
    pause_->setChecked(now.paused);
    pause_->setText(now.paused ? tr("Go on") : tr("Pause"));
    repeat_->setChecked(now.repeats);
    const QString at =
        tr("%1 of %2 s").arg(format::number(now.at, 1), format::number(now.length, 1));
    at_->setText(now.paused ? tr("paused at %1").arg(at) : at);
}

}  // namespace terratact
