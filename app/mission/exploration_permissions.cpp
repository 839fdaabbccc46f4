// What may be done now, and why not.
#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/exploration.h"
#include "app/mission/text/place_text.h"

namespace terratact {

Message Exploration::whyNoEstimate() const
{
    if (!estimation_.whyNone().empty()) return estimation_.whyNone();
    const ModelInUse& model = estimation_.model();
    if (!linkAlive_ && !ended_)
        return TR_NOOP("terratact::Exploration", "No estimate yet: no telemetry from the robot");
    if (!model.trouble.empty())
        return TR_NOOP("terratact::Exploration", "No estimate: there is no model");
    if (model.name.isEmpty())
        return TR_NOOP("terratact::Exploration", "No estimate yet: the model is being loaded");
    if (following())
        return TR_NOOP("terratact::Exploration",
                       "No estimate yet: one is made when the robot presses its flippers");
    if (!armed())
        return TR_NOOP("terratact::Exploration",
                       "No estimate yet: press M, then hold M to arm; then explore (A)");
    return TR_NOOP("terratact::Exploration", "No estimate yet: explore the terrain (A)");
}

std::optional<Message> Exploration::whyNotOffered() const
{
    if (!estimation_.estimate()) return std::nullopt;
    if (offered_) {
        const bool refused = state_.phase == AtemPhase::Presenting && !state_.followed
                          && !state_.probed && !state_.approvalExpired;
        return refused ? std::optional<Message>(
                   TR_NOOP("terratact::Exploration", "The probe was refused"))
                       : std::nullopt;
    }
    if (estimation_.wasPitchSuspected()) return Preconditions::pitchSuspected().text;
    const ProbeOffer now = probes_.offer();  // limit, policy and telemetry may have changed
    if (now.place)
        return TR_NOOP("terratact::Exploration",
                       "No probe was offered with this estimate: explore again");
    return wordsOf(now.why);
}

std::optional<Message> Exploration::wordsOf(NoProbe why) const
{
    switch (why) {
    case NoProbe::None: break;
    case NoProbe::Certain:
        return Message(
            TR_NOOP("terratact::Exploration",
                    "No probe offered: every bin in reach is known to ± %1 m or better"),
            verbatim(format::number(estimation_.estimate()->side[0].settings.probeAbove, 2)));
    case NoProbe::Decided:
        return Message(TR_NOOP("terratact::Exploration",
                               "No probe offered, by the settings: %1 is decided without the arm"),
                       describe(estimation_.verdict()->both));
    case NoProbe::NoGain:
        return TR_NOOP("terratact::Exploration",
                       "No probe offered, by the settings: no bin in reach informs about the step");
    }
    return std::nullopt;
}

bool Exploration::inReach(ProbePlace place) const
{
    return place.bin >= 0 && place.bin < kBins && robot_.armSd > 0.0
        && robot_.armReaches(place.bin, place.side);
}

std::optional<Message> Exploration::whyNotExploring() const
{
    if (following()) return following_->why();
    if (exploring(state_.phase))
        return TR_NOOP("terratact::Exploration", "an exploration is running");
    for (const Precondition& need : preconditions())
        if (need.level == Precondition::Level::Missing
            || need.level == Precondition::Level::Doubtful)
            return need.text;
    return std::nullopt;
}

std::optional<Message> Exploration::whyNotAsking(ProbePlace place) const
{
    if (following()) return following_->why();
    if (latest_ && isSuspected(latest_->suspicions, Sensor::Pitch))
        return Preconditions::pitchSuspected().text;
    if (!inReach(place))
        return Message(TR_NOOP("terratact::Exploration", "the arm does not reach the ground %1"),
                       placeMessage(place));
    if (state_.phase == AtemPhase::ProposingProbe)
        return probes_.stands() ? std::nullopt : std::optional(Preconditions::stands(false).text);
    return whyNotExploring();
}

QList<Precondition> Exploration::toDrive() const
{
    if (following()) return {Preconditions::arming(following_->why())};
    QList<Precondition> list{
        Preconditions::released(state_.phase == AtemPhase::Stopped, linkAlive_),
        Preconditions::notExploring(exploring(state_.phase) || state_.loops),
        Preconditions::telemetry(linkAlive_, ended_)};
    if (link_) list << Preconditions::arming(whyNotArmed());
    if (armIsOut()) list << Preconditions::armIsOut();
    return list;
}

/// Returns true if the robot reports probing although no exploration runs, for example after an abort.
bool Exploration::armIsOut() const
{
    return linkAlive_ && !following() && !exploring(state_.phase)
        && latest_->sample.measurement.activity == RobotActivity::Probing;
}

/// Returns true if the robot's pitch or roll is beyond the angle at which it tips over.
bool Exploration::isBeyondTipping() const
{
    return linkAlive_ && !following()
        && attitudeOf(latest_->sample.measurement, robot_, options_.attitude).beyondTipping;
}

QList<Precondition> Exploration::toProbe() const
{
    if (following()) return {Preconditions::arming(following_->why())};
    QList<Precondition> list{Preconditions::telemetry(linkAlive_, ended_)};
    if (link_) list << Preconditions::arming(whyNotArmed());
    if (state_.phase != AtemPhase::ProposingProbe || !probes_.current())
        return list << Preconditions::noProbeProposed();
    if (estimation_.hadTelemetryGap()) return list << Preconditions::hadTelemetryGap();
    if (estimation_.wasPitchSuspected()) return list << Preconditions::pitchSuspected();
    return list << Preconditions::stands(probes_.stands());
}

QList<Precondition> Exploration::toReleaseStop() const
{
    if (following()) return {Preconditions::arming(following_->why())};
    const bool confirmed = stopViewState().state == StopViewState::State::Confirmed;
    return {Preconditions::telemetry(linkAlive_, ended_),
            state_.phase == AtemPhase::Stopped ? Preconditions::stopConfirmed(confirmed, linkAlive_)
                                               : Preconditions::nothingToRelease()};
}

std::optional<Message> Exploration::whyNotArmed() const
{
    if (armed()) return std::nullopt;
    if (following()) return following_->why();
    return TR_NOOP("terratact::Exploration", "not armed: press M, then hold M");
}

QList<Precondition> Exploration::preconditions() const
{
    QList<Precondition> list{
        Preconditions::telemetry(linkAlive_, ended_),
        Preconditions::stop(state_.phase == AtemPhase::Stopped, releasing_, linkAlive_),
    };
    if (link_) list << Preconditions::arming(whyNotArmed());
    if (armIsOut()) list << Preconditions::armIsOut();
    if (isBeyondTipping()) list << Preconditions::beyondTipping();
    list << Preconditions::model(estimation_.model());
    if (!linkAlive_)
        list << Preconditions::groundNotKnown();
    else if (const Measurement& m = latest_->sample.measurement; estimation_.estimatesBothSides(m))
        list << Preconditions::bothSides();
    else
        list << ground_.judge(m, options_.settings);
    return list;
}

}  // namespace terratact
