#include "core/atem/feel_forward.h"

#include <algorithm>

#include "core/terrain/step.h"

namespace terratact {
namespace {

bool isWithheldFor(const TwoTrackVerdict& verdict, WithholdReason reason)
{
    return std::ranges::any_of(verdict.side, [&](const Verdict& side) {
        return std::ranges::find(side.withheldFor, reason) != side.withheldFor.end();
    });
}

LoopEnd endOf(Shortfall shortfall)
{
    switch (shortfall) {
    case Shortfall::None: return LoopEnd::Undecided;
    case Shortfall::NothingFelt: return LoopEnd::NotFelt;
    case Shortfall::ShortHorizon: return LoopEnd::ShortReach;
    case Shortfall::Spanned: return LoopEnd::Bounded;
    }
    return LoopEnd::Undecided;
}

LoopEnd whyWithheld(const TwoTrackVerdict& verdict)
{
    if (isWithheldFor(verdict, WithholdReason::Stale)
        || isWithheldFor(verdict, WithholdReason::TelemetryGap))
        return LoopEnd::Stale;
    if (isWithheldFor(verdict, WithholdReason::SensorFault)) return LoopEnd::SensorFault;
    if (isWithheldFor(verdict, WithholdReason::Contradiction)) return LoopEnd::Contradiction;
    return LoopEnd::Withheld;
}

LoopEnd whyUndecided(const TwoTrackVerdict& verdict)
{
    for (const Verdict& side : verdict.side)
        if (side.stepVerdict != StepVerdict::Clear && side.shortfall != Shortfall::None)
            return endOf(side.shortfall);
    return LoopEnd::Undecided;
}

bool isTouchRecorded(const TwoTrackVerdict& verdict)
{
    return std::ranges::all_of(verdict.side, &Verdict::touchRecorded);
}

}  // namespace

double LoopPace::metresPerMinute(double now) const
{
    const double seconds = ended.value_or(now) - began;
    return seconds > 0.0 ? 60.0 * way / seconds : 0.0;
}

double clearWay(const TwoTrackVerdict& verdict)
{
    const bool clear = verdict.both == StepVerdict::Clear && isTouchRecorded(verdict)
                    && std::ranges::all_of(verdict.side, [](const Verdict& side) {
                           return side.stepVerdict == StepVerdict::Clear;
                       });
    if (!clear || isWithheld(verdict)) return 0.0;
    const double horizon = std::min(verdict.side[0].horizon, verdict.side[1].horizon);
    return std::max(0.0, horizon - binBegin(kFirstAhead));
}

LoopEnd whyNotAdvancing(const FeltAhead& ahead, double distance)
{
    constexpr double kRounding = 1e-9;  // [m] borders of bins are sums of 0.1 m
    if (!ahead.telemetryFresh) return LoopEnd::Stale;
    if (!ahead.odometry) return LoopEnd::NoOdometry;
    if (ahead.attitude != AttitudeLevel::Level) return LoopEnd::Attitude;
    if (!ahead.verdict) return LoopEnd::NoVerdict;
    const TwoTrackVerdict& verdict = *ahead.verdict;
    if (isWithheld(verdict)) return whyWithheld(verdict);
    if (verdict.both == StepVerdict::Blocked) return LoopEnd::Blocked;
    if (verdict.both == StepVerdict::CannotTell) return whyUndecided(verdict);
    if (!isTouchRecorded(verdict)) return LoopEnd::NotFelt;
    return clearWay(verdict) > distance + kRounding ? LoopEnd::None : LoopEnd::ShortHorizon;
}

}  // namespace terratact
