#pragma once

#include <optional>

#include "core/atem/atem_machine.h"

namespace terratact {

/// Remaining time of a phase, and what happens then.
struct PhaseTime {
    enum class Kind {
        Answer,    ///< approval expiry: no answer of the operator means no
        Expected,  ///< expected end of the phase
        GivesUp,   ///< time limit: the phase fails then
    };
    Kind kind = Kind::GivesUp;
    double seconds = 0.0;  ///< [s] > 0
    bool operator==(const PhaseTime&) const = default;
};

/// Usual duration of a phase [s]; empty: unknown.
struct UsualTimes {
    std::optional<double> press, probe;
};

/// Returns the remaining time of the state at `now` [s on its clock]. It is Expected up to the
/// usual duration, then GivesUp. A time limit is given only once the phase has lasted a second,
/// because most phases end sooner. Empty if there is nothing to show.
std::optional<PhaseTime> phaseTime(const AtemState& state, double now, const AtemLimits& limits,
                                   const UsualTimes& usual);

}  // namespace terratact
