#pragma once

#include <optional>

#include "core/atem/atem_machine.h"

namespace terratact {

/// How long a phase may still last, and what it is that comes then.
struct PhaseTime {
    enum class Kind {
        Answer,    ///< the operator has so long to answer; no answer means no
        Expected,  ///< it usually takes that long from now on
        GivesUp,   ///< unless it is done before, it has failed then
    };
    Kind kind = Kind::GivesUp;
    double seconds = 0.0;  ///< [s] > 0
    bool operator==(const PhaseTime&) const = default;
};

/// What a phase usually takes [s]; empty: nobody knows.
struct UsualTimes {
    std::optional<double> press, probe;
};

/// Of the state at `now` [s on its clock].  Expected as long as it takes no longer than usual, then GivesUp; a time limit
/// is told only once the phase has lasted a second, since most are over at once.  Empty where there is nothing to tell.
std::optional<PhaseTime> phaseTime(const AtemState& state, double now, const AtemLimits& limits,
                                   const UsualTimes& usual);

}  // namespace terratact
