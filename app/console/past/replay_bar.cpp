#include "app/console/past/replay_bar.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <cmath>

#include "app/display/format.h"
#include "app/shell/key_table.h"
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
    back_ = button(tr("◀ %1 s").arg(kStep), tr("Steps back in the log (Ctrl+Left)"));
    pause_ = button(tr("Pause"), tr("Pauses or continues the log (Ctrl+Space)"));
    pause_->setCheckable(true);
    on_ = button(tr("%1 s ▶").arg(kStep), tr("Steps forward in the log (Ctrl+Right)"));
    repeat_ = button(tr("Repeat"), tr("Repeats the log from its end (Ctrl+R)"));
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
    add(Qt::Key_Space, tr("pause or continue the log"), pause_);
    add(Qt::Key_Left, tr("back in the log"), back_);
    add(Qt::Key_Right, tr("forward in the log"), on_);
    add(Qt::Key_R, tr("repeat the log, on or off"), repeat_);
}

bool ReplayBar::isStill()
{
    const LogReplay::Progress now = replay_.progress();
    if (now.paused != wasPaused_) pausedAt_ = now.at;
    wasPaused_ = now.paused;
    return now.paused && std::abs(now.at - pausedAt_) < kStep / 2.0;
}

void ReplayBar::poll()
{
    const LogReplay::Progress now = replay_.progress();
    pause_->setChecked(now.paused);
    pause_->setText(now.paused ? tr("Continue") : tr("Pause"));
    repeat_->setChecked(now.repeats);
    const QString at =
        tr("%1 of %2 s").arg(format::number(now.at, 1), format::number(now.length, 1));
    at_->setText(now.paused ? tr("paused at %1").arg(at) : at);
}

}  // namespace terratact
