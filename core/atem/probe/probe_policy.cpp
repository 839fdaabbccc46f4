#include "core/atem/probe/probe_policy.h"

#include "core/base/named.h"
#include <algorithm>
#include <functional>
#include <numbers>

namespace terratact {
namespace {

constexpr auto kProbePolicyNames = namesOf<ProbePolicy>("variance", "variance-if-open", "question");

}  // namespace

std::string_view name(ProbePolicy policy)
{
    return nameIn(kProbePolicyNames, policy);
}

std::vector<ProbeGain> ranked(const ProbeAdvice& advice, ProbePolicy policy)
{
    std::vector<ProbeGain> gains = advice.gains;
    if (policy == ProbePolicy::Question)
        std::ranges::stable_sort(gains, std::greater{}, &ProbeGain::entropyReduction);
    return gains;
}

ProbeOffer offerProbe(const ProbeAdvice& advice, StepVerdict verdict, ProbePolicy policy)
{
    if (policy != ProbePolicy::Variance && verdict != StepVerdict::CannotTell)
        return {.place = {}, .why = NoProbe::Decided};
    if (policy == ProbePolicy::Question && !advice.gains.empty()) {
        const ProbeGain best = ranked(advice, policy).front();
        if (best.entropyReduction < kMinBits * std::numbers::ln2)
            return {.place = {}, .why = NoProbe::NoGain};
        return {.place = best.place(), .why = NoProbe::None};
    }
    return {.place = advice.place, .why = advice.place ? NoProbe::None : NoProbe::Certain};
}

}  // namespace terratact
