#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/atem/arm_choice.h"
#include "core/infer/verdict/verdict.h"

namespace terratact {

/// Which probes are put to the operator.
enum class ProbePolicy : std::uint8_t {
    Variance,      ///< chooseProbe(): wherever the terrain is uncertain, as in the paper
    VarianceOpen,  ///< the same, as long as the verdict's question is open
    Question       ///< what is expected to tell most about that question, as long as it is open
};
inline constexpr std::array kProbePolicies{ProbePolicy::Variance, ProbePolicy::VarianceOpen,
                                           ProbePolicy::Question};

/// "variance", "variance-if-open", "question".
std::string_view name(ProbePolicy policy);

/// Why no probe is put to the operator.
enum class NoProbe : std::uint8_t {
    None,     ///< one is
    Certain,  ///< no bin in reach has an sd above Settings::probeAbove
    Decided,  ///< the verdict stands without the arm
    NoGain    ///< no bin in reach is expected to tell about the verdict's question
};

struct ProbeOffer {
    std::optional<int> bin;       ///< to be put to the operator
    NoProbe why = NoProbe::None;  ///< without it
    bool operator==(const ProbeOffer&) const = default;
};

/// The advice's bins, the best for this policy first: by the variance that they are expected to take away, or by
/// the entropy (of equals the one that is first in the advice).
std::vector<ProbeGain> ranked(const ProbeAdvice& advice, ProbePolicy policy);

/// What is put to the operator.  verdict: the answer without the arm; a verdict withheld is CannotTell, which leaves the
/// question open.  Question asks whatever the sds are, where a bin is expected to gain kMinBits or more; without
/// gains (no draws) it asks for what VarianceOpen does.
ProbeOffer offerProbe(const ProbeAdvice& advice, StepVerdict verdict, ProbePolicy policy);

}  // namespace terratact
