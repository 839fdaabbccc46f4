#pragma once

#include <array>

#include "core/atem/atem_machine.h"

/// What tests of the ATEM loop share: its time limits, its phases, and states in them.
namespace terratact::atem_loop {

inline constexpr AtemLimits kLimits{
    .halt = 3.0, .press = 15.0, .estimate = 30.0, .approval = 20.0, .probe = 90.0, .advance = 10.0};

inline constexpr std::array kPhases{AtemPhase::Idle,
                                    AtemPhase::Halting,
                                    AtemPhase::Pressing,
                                    AtemPhase::Estimating,
                                    AtemPhase::ProposingProbe,
                                    AtemPhase::Probing,
                                    AtemPhase::EstimatingAgain,
                                    AtemPhase::Presenting,
                                    AtemPhase::Stopped,
                                    AtemPhase::Failed,
                                    AtemPhase::Advancing};

/// A state that began at 100 s. A failed one has this failure.
inline AtemState at(AtemPhase phase, AtemFailure failure = AtemFailure::PressTimeout)
{
    return {.phase = phase,
            .failure = phase == AtemPhase::Failed ? failure : AtemFailure::None,
            .since = 100.0};
}

}  // namespace terratact::atem_loop
