#include "app/console/stop_display.h"

#include <QLabel>

#include "app/display/format.h"

namespace terratact {

StopDisplay::StopDisplay(StatusHeader& header, QLabel& banner) : header_(header), banner_(banner)
{
    banner_.hide();
}

void StopDisplay::show(const StopViewState& viewState)
{
    header_.setStop(viewState);
    const QString text = late(viewState);
    banner_.setVisible(!text.isEmpty());
    if (banner_.text() != text) banner_.setText(text);
}

bool StopDisplay::isLate() const
{
    return !banner_.isHidden();
}

QString StopDisplay::late(const StopViewState& viewState)
{
    const QString age = format::age(viewState.seconds);
    switch (viewState.state) {
    case StopViewState::State::NotSent:
        return tr("STOP NOT SENT for %1, trying again: use the robot's own switch — %2")
            .arg(age, viewState.why);
    case StopViewState::State::Sent:
        if (viewState.seconds < kConfirmsWithin) return {};
        return tr("STOP SENT, NOT CONFIRMED for %1: the robot may still move; STOP is sent again")
            .arg(age);
    case StopViewState::State::Ready:
    case StopViewState::State::Confirmed:
    case StopViewState::State::Elsewhere:
    case StopViewState::State::NoEffect: return {};
    }
    return {};
}

}  // namespace terratact
