// What may be done now, and why not.
#include "app/display/format.h"
#include "app/mission/exploration.h"

namespace terratact {

QString Exploration::whyNoEstimate() const
{
    if (QString why = estimation_.whyNone(); !why.isEmpty()) return why;
    const ModelInUse& model = estimation_.model();
    if (!linkAlive_ && !ended_) return tr("No estimate yet: no telemetry from the robot");
    if (!model.trouble.isEmpty()) return tr("No estimate: there is no model");
    if (model.name.isEmpty()) return tr("No estimate yet: the model is being loaded");
    if (following()) return tr("No estimate yet: one is made when the robot presses its flippers");
    if (!armed()) return tr("No estimate yet: press M, then hold M to arm; then explore (A)");
    return tr("No estimate yet: explore the terrain (A)");
}

QString Exploration::whyNotOffered() const
{
    if (!estimation_.estimate() || offered_) return {};
    if (estimation_.wasPitchSuspected()) return Preconditions::pitchSuspected().text;
    const ProbeOffer now = probes_.offer();  // limit, policy and telemetry may have changed
    if (now.bin) return tr("No probe was offered with this estimate: explore again");
    return wordsOf(now.why);
}

QString Exploration::wordsOf(NoProbe why) const
{
    switch (why) {
    case NoProbe::None: break;
    case NoProbe::Certain:
        return tr("No probe offered: every bin in reach is known to ± %1 m")
            .arg(format::number(estimation_.estimate()->settings.probeAbove, 2));
    case NoProbe::Decided:
        return tr("No probe offered, by the settings: %1 stands without the arm")
            .arg(format::sentence(name(estimation_.verdict()->stepVerdict)));
    case NoProbe::NoGain:
        return tr("No probe offered, by the settings: no bin in reach informs about the step");
    }
    return {};
}

bool Exploration::inReach(int bin) const
{
    return bin >= 0 && bin < kBins && robot_.armSd > 0.0 && robot_.armReaches(bin);
}

QString Exploration::whyNotAsking(int bin) const
{
    if (following()) return following_->why();
    if (latest_ && isSuspected(latest_->suspicions, Sensor::Pitch))
        return Preconditions::pitchSuspected().text;
    if (!inReach(bin)) return tr("the arm does not reach bin %1").arg(format::binName(bin));
    if (state_.phase == AtemPhase::ProposingProbe)
        return probes_.stands() ? QString() : Preconditions::stands(false).text;
    if (exploring(state_.phase)) return tr("an exploration is running");
    for (const Precondition& need : preconditions())
        if (need.level == Precondition::Level::Missing
            || need.level == Precondition::Level::Doubtful)
            return need.text;
    return {};
}

QList<Precondition> Exploration::toDrive() const
{
    if (following()) return {Preconditions::arming(following_->why())};
    QList<Precondition> list{
        Preconditions::released(state_.phase == AtemPhase::Stopped, linkAlive_),
        Preconditions::notExploring(exploring(state_.phase)),
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

QString Exploration::whyNotArmed() const
{
    if (armed()) return {};
    return following() ? following_->why() : tr("not armed: press M, then hold M");
}

QList<Precondition> Exploration::preconditions() const
{
    QList<Precondition> list{
        Preconditions::telemetry(linkAlive_, ended_),
        Preconditions::stop(state_.phase == AtemPhase::Stopped, releasing_, linkAlive_),
    };
    if (link_) list << Preconditions::arming(whyNotArmed());
    if (armIsOut()) list << Preconditions::armIsOut();
    list << Preconditions::model(estimation_.model());
    if (linkAlive_)
        list << ground_.judge(latest_->sample.measurement, options_.settings);
    else
        list << Preconditions::groundNotKnown();
    return list;
}

}  // namespace terratact
