#include "core/atem/phase_time.h"

namespace terratact {
namespace {

constexpr double kAtOnce = 1.0;  // [s] shorter phases show no time limit

std::optional<double> usualOf(AtemPhase phase, const UsualTimes& usual)
{
    if (phase == AtemPhase::Pressing) return usual.press;
    if (phase == AtemPhase::Probing) return usual.probe;
    return std::nullopt;
}

}  // namespace

std::optional<PhaseTime> phaseTime(const AtemState& state, double now, const AtemLimits& limits,
                                   const UsualTimes& usual)
{
    const double lasted = now - state.since;
    if (const auto takes = usualOf(state.phase, usual); takes && *takes > lasted)
        return PhaseTime{PhaseTime::Kind::Expected, *takes - lasted};
    const auto end = deadline(state, limits);
    if (!end || !(*end > now)) return std::nullopt;
    if (state.phase == AtemPhase::ProposingProbe)
        return PhaseTime{PhaseTime::Kind::Answer, *end - now};
    if (!(lasted >= kAtOnce)) return std::nullopt;
    return PhaseTime{PhaseTime::Kind::GivesUp, *end - now};
}

}  // namespace terratact
