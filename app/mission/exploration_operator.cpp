// What the operator does.
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/exploration.h"
#include "app/mission/text/place_text.h"

namespace terratact {

void Exploration::request()
{
    if (following() || armIsOut() || isBeyondTipping()) return;
    asked_.reset();
    explore();
}

void Exploration::explore()
{
    emit decided("explore", {});
    pending_.requested = true;
    driving_ = false;  // the exploration itself sends the halt
    driveWanted_.reset();
}

void Exploration::askProbe(ProbePlace place)
{
    if (const auto why = whyNotAsking(place))
        return void(emit happened(
            Message(TR_NOOP("terratact::Exploration", "no probe requested: %1"), *why),
            EventSeverity::Warning));
    if (state_.phase == AtemPhase::ProposingProbe) return choose(probes_.current()->id, place);
    emit decided("choose", placeName(place));
    emit happened(
        Message(TR_NOOP("terratact::Exploration",
                        "a probe %1 is requested: the robot presses again, then asks for approval"),
                placeMessage(place)),
        EventSeverity::Note);
    asked_ = place;
    explore();
}

void Exploration::forgetResult()
{
    if (exploring(state_.phase)) return;
    const bool stood = estimation_.estimate().has_value();
    emit decided("forget", {});
    const Message why =
        stood ? Message(TR_NOOP("terratact::Exploration", "No estimate: explore the terrain (A)"))
              : Message(estimation_.whyNone());
    estimation_.setAside(why);
    probes_.withdraw();
    const bool ends = state_.phase == AtemPhase::Presenting || state_.phase == AtemPhase::Failed;
    if (ends || following()) pending_.aborted = true;
    if (stood)
        emit happened(
            TR_NOOP("terratact::Exploration", "the estimate is hidden: Ctrl+Z restores it"),
            EventSeverity::Note);
}

void Exploration::restoreResult()
{
    if (!exploring(state_.phase) && estimation_.restore()) {
        pending_.aborted = false;
        emit decided("restore", {});
        emit happened(TR_NOOP("terratact::Exploration", "the estimate is back"),
                      EventSeverity::Note);
    } else {
        emit happened(TR_NOOP("terratact::Exploration", "no estimate can be brought back"),
                      EventSeverity::Note);
    }
}

void Exploration::abort()
{
    emit decided("abort", {});
    pending_.aborted = true;
}

void Exploration::approve(quint64 proposal)
{
    if (!probes_.isCurrent(proposal)) return;
    if (estimation_.wasPitchSuspected())
        return void(emit happened(Preconditions::pitchSuspected().text, EventSeverity::Warning));
    emit decided("approve", placeName({probes_.current()->bin, probes_.current()->side}));
    pending_.approved = true;
    pending_.approvedFor = probes_.proposedOn();
    approvedAt_ = now_;
}

void Exploration::refuse(quint64 proposal)
{
    if (!probes_.isCurrent(proposal)) return;
    emit decided("refuse", placeName({probes_.current()->bin, probes_.current()->side}));
    pending_.refused = true;
}

void Exploration::choose(quint64 proposal, ProbePlace place)
{
    if (!probes_.isCurrent(proposal) || !probes_.stands() || !inReach(place)) return;
    emit decided("choose", placeName(place));
    probes_.propose(place);
    emit proposed();
    emit happened(Message(TR_NOOP("terratact::Exploration", "probe %1 requested instead"),
                          placeMessage(place)),
                  EventSeverity::Note);
}

void Exploration::setStepLimit(double metres)
{
    if (metres == options_.stepLimit) return;
    options_.stepLimit = metres;
    estimation_.adviseAnew();
}

void Exploration::setSecondMethod(std::optional<Method> method)
{
    emit decided("second method",
                 method ? Message::verbatim(std::string(name(*method))) : TR_NOOP("event", "none"));
    estimation_.setSecondMethod(method);
}

void Exploration::drive(int direction)
{
    if (whyNotDriving()) return;
    driving_ = true;
    driveBegan_ = now_;
    direction_ = direction;
    driveWanted_ = driveCommand();
    emit decided("drive", direction > 0 ? TR_NOOP("event", "forward") : TR_NOOP("event", "back"));
    driveOn();
}

DriveCommand Exploration::driveCommand() const
{
    return {.speed = direction_ * driveSpeed_.value_or(options_.driveSpeed)};
}

void Exploration::setDriveSpeed(std::optional<double> speed)
{
    if (speed == driveSpeed_) return;
    driveSpeed_ = speed;
    if (!driving_) return;
    driveWanted_ = driveCommand();
    driveOn();
}

void Exploration::halt()
{
    if (!std::exchange(driving_, false)) return;
    driveWanted_.reset();
    emit decided("halt", {});
    command(HaltCommand{});
}

void Exploration::setSettings(const Settings& settings)
{
    const std::uint64_t seed = options_.settings.seed;
    options_.settings = settings;
    options_.settings.seed = seed;
    emit happened(Message(TR_NOOP("terratact::Exploration",
                                  "the next estimate: %1, %2 draws, contacts above %3 N"),
                          verbatim(format::text(name(settings.method))), settings.draws,
                          verbatim(format::number(settings.forceThreshold, 1))),
                  EventSeverity::Note);
}

void Exploration::overrideWarnings()
{
    if (following() || !linkAlive_) return;  // the doubtful values are unknown
    const Measurement& m = latest_->sample.measurement;
    if (estimation_.estimatesBothSides(m)) return;  // nothing is doubtful
    for (const Message& warning : ground_.overrideWarnings(m, options_.settings)) {
        emit decided("override", warning);
        emit happened(
            Message(TR_NOOP("terratact::Exploration", "overridden by the operator: %1"), warning),
            EventSeverity::Warning);
    }
}

void Exploration::leave()
{
    halt();
    letGo();
    if (exploring(state_.phase) && !following()) command(AbortAtemCommand{});
    if (link_) link_->disarm();
    estimation_.cancel();
}

}  // namespace terratact
