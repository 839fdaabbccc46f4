// STOP, from the operator's press to the robot's confirmation. The path of a press:
//   key or button → stopFrom() → CanSource::send() → ConsoleLink::send(), which asks the command gate and
//   makes the frame (frameOf()).
// The threads of panel and gamepad call CanSource::send() themselves; the window then sends it again by
// stopFrom(). ConsoleLink keeps STOP latched until releaseStop(), and so does the robot.
#include "app/display/translated.h"
#include "app/mission/exploration.h"
#include "app/mission/text/bus_text.h"

namespace terratact {
namespace {

constexpr double kRepeatStop = 0.2;  // [s]
constexpr double kReleaseFor = 5.0;  // [s] a release of STOP is retried

}  // namespace

void Exploration::stop()
{
    stopFrom({});
}

void Exploration::stopFrom(const Message& where)
{
    if (following()) {
        emit stoppedNothing(following_->why());
        return;  // nothing is stopped, so the display must not show a stop
    }
    emit decided("stop", where);
    if (stopViewState().state != StopViewState::State::Sent
        && stopViewState().state != StopViewState::State::NotSent)
        stopBegan_ = now_;
    // A repeated press keeps an existing confirmation.
    stopConfirmed_ = stopConfirmed_ && linkAlive_ && !releasing_;
    sendStop();
    pending_.stop = true;
    releasing_ = false;
    driving_ = false;
    driveWanted_.reset();
}

void Exploration::releaseStop()
{
    if (state_.phase != AtemPhase::Stopped || following()) return;
    emit decided("release stop", {});
    releasing_ = true;
    releaseBegan_ = stopSent_ = now_;
    command(ReleaseStopCommand{});
    emit happened(TR_NOOP("terratact::Exploration", "STOP released by the operator"),
                  EventSeverity::Warning);
}

void Exploration::sendStop()
{
    stopSent_ = now_;
    commandedAt_ = latest_ ? latest_->count : 0;
    const Status sent = source_.send(StopCommand{});
    const Message trouble = sent ? Message() : troubleOf(link_, sent.error().message);
    if (!trouble.empty() && trouble != stopTrouble_)
        emit stateChanged(Message(TR_NOOP("terratact::Exploration", "STOP not sent: %1"), trouble),
                          EventSeverity::Bad);
    stopTrouble_ = trouble;
}

void Exploration::confirmStop(bool latched)
{
    if (!linkAlive_ || latched == stopConfirmed_ || (releasing_ && !latched)) return;
    stopConfirmed_ = latched;
    if (latched)
        emit happened(TR_NOOP("terratact::Exploration", "the robot reports stopped"),
                      EventSeverity::Note);
    else
        stopBegan_ = now_;  // the request starts again
}

StopViewState Exploration::stopViewState() const
{
    using State = StopViewState::State;
    if (following()) return {.state = State::NoEffect, .why = translated(following_->why())};
    if (state_.phase != AtemPhase::Stopped && !pending_.stop) return {};
    if (stopConfirmed_) return {.state = State::Confirmed};
    return {.state = stopTrouble_.empty() ? State::Sent : State::NotSent,
            .seconds = now_ - stopBegan_,
            .why = translated(stopTrouble_)};
}

void Exploration::repeatStop(AtemInput& in)
{
    const bool latched = latest_ && latest_->sample.measurement.activity == RobotActivity::Stopped;
    if (latched && state_.phase != AtemPhase::Stopped) in.stop = true;
    confirmStop(latched);
    if (state_.phase != AtemPhase::Stopped) return;
    if (answered() && releasing_ && !latched) in.stopReleased = true;
    if (releasing_ && now_ - releaseBegan_ > kReleaseFor) {
        releasing_ = false;  // the operator's request has expired
        emit happened(
            TR_NOOP("terratact::Exploration", "the robot did not release STOP: hold R again"),
            EventSeverity::Bad);
    }
    if (now_ - stopSent_ < kRepeatStop || latched != releasing_) return;
    if (!releasing_) return sendStop();
    stopSent_ = now_;
    command(ReleaseStopCommand{});
}

}  // namespace terratact
