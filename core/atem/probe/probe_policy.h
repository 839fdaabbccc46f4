#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/atem/probe/arm_choice.h"
#include "core/infer/verdict/verdict.h"

namespace terratact {

/// Policy that decides which probes are offered to the operator.
enum class ProbePolicy : std::uint8_t {
    Variance,      ///< chooseProbe(): any sd above the probe threshold, as in the paper
    VarianceOpen,  ///< the same, but only while the verdict is CANNOT TELL
    Question  ///< the bin with the largest expected gain for the verdict, while it is CANNOT TELL
};
inline constexpr std::array kProbePolicies{ProbePolicy::Variance, ProbePolicy::VarianceOpen,
                                           ProbePolicy::Question};

/// Returns "variance", "variance-if-open" or "question".
std::string_view name(ProbePolicy policy);

/// Reason why no probe is offered.
enum class NoProbe : std::uint8_t {
    None,  ///< a probe is offered
    /// No bin in reach (RobotModel::armReaches()) has an sd above the probe threshold Settings::probeAbove.
    Certain,
    Decided,  ///< the verdict is certain without the arm
    NoGain    ///< no bin in reach has an expected gain for the verdict
};

struct ProbeOffer {
    std::optional<ProbePlace> place;  ///< place offered to the operator
    NoProbe why = NoProbe::None;      ///< reason if there is no place
    bool operator==(const ProbeOffer&) const = default;
};

/// Returns the advice's places, best first for this policy: by the expected reduction of variance or
/// of entropy. Equal places keep the advice's order.
std::vector<ProbeGain> ranked(const ProbeAdvice& advice, ProbePolicy policy);

/// Decides which probe is offered. verdict: the answer without the arm; a withheld verdict is
/// CannotTell. Question offers the best bin if its expected gain is at least kMinBits, whatever the
/// sds. Without gains (no draws) it offers what VarianceOpen does.
ProbeOffer offerProbe(const ProbeAdvice& advice, StepVerdict verdict, ProbePolicy policy);

}  // namespace terratact
