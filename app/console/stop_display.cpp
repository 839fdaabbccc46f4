#include "app/console/stop_display.h"

#include <QLabel>

#include "widgets/base/words.h"

namespace terratact {

StopDisplay::StopDisplay(StatusHeader& header, QLabel& banner) : header_(header), banner_(banner)
{
    banner_.hide();
}

void StopDisplay::show(const StopSight& sight)
{
    header_.setStop(sight);
    const QString text = late(sight);
    banner_.setVisible(!text.isEmpty());
    if (banner_.text() != text) banner_.setText(text);
}

bool StopDisplay::isLate() const
{
    return !banner_.isHidden();
}

QString StopDisplay::late(const StopSight& sight)
{
    const QString age = words::age(sight.seconds);
    switch (sight.state) {
    case StopSight::State::NotSent:
        return tr("STOP NOT SENT for %1, it is tried again: use the robot's own switch — %2")
            .arg(age, sight.why);
    case StopSight::State::Sent:
        if (sight.seconds < kConfirmsWithin) return {};
        return tr("STOP SENT, NOT CONFIRMED for %1: the robot may still move; STOP is sent again")
            .arg(age);
    case StopSight::State::Ready:
    case StopSight::State::Confirmed:
    case StopSight::State::Elsewhere:
    case StopSight::State::NoEffect: return {};
    }
    return {};
}

}  // namespace terratact
