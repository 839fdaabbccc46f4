#include "app/mission/screen_text.h"

#include <utility>
#include <vector>

#include "app/mission/exploration.h"
#include "app/mission/text/place_text.h"
#include "core/base/text.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/terrain/bins.h"

namespace terratact {
namespace {

Message stepText(const StepProbability& step, double limit)
{
    return {TR_NOOP("terratact::SessionEventLogger", "P(step > %1 m) = %2 % ± %3"), fixed(limit, 2),
            fixed(100.0 * step.p, 1), randomErrorText(100.0 * step.monteCarloSd, 1)};
}

/// Returns the probability that the answer of one plane or side rests on.
Message stepText(const Verdict& verdict, double limit)
{
    if (!isClearToHorizon(verdict)) return stepText(verdict.step, limit);
    const StepProbability& step = answeredBy(verdict);
    return {TR_NOOP("terratact::SessionEventLogger", "P(step > %1 m to %2 m) = %3 % ± %4"),
            fixed(limit, 2), signedFixed(verdict.horizon, 2), fixed(100.0 * step.p, 1),
            randomErrorText(100.0 * step.monteCarloSd, 1)};
}

/// Adds what keeps the verdict open: bins that are bounded or not felt, and reasons to withhold it.
void addWithholdReasons(std::vector<Message>& parts, const Verdict& verdict)
{
    if (!verdict.bounded.empty())
        parts.emplace_back(TR_NOOP("terratact::SessionEventLogger", "bounded: %1"),
                           placesOf(verdict.bounded));
    if (const std::vector<int> bins = notFelt(verdict); !bins.empty())
        parts.emplace_back(TR_NOOP("terratact::SessionEventLogger", "not felt: %1"),
                           placesOf(bins));
    for (const WithholdReason reason : verdict.withheldFor) parts.emplace_back(describe(reason));
}

/// Returns the probability that the robot's answer rests on.
Message robotStepText(const TwoTrackVerdict& verdict, double limit)
{
    const StepProbability& step = answeredBy(verdict);
    if (verdict.both != StepVerdict::Clear) return stepText(step, limit);
    return {
        TR_NOOP("terratact::SessionEventLogger", "P(step > %1 m up to each horizon) = %2 % ± %3"),
        fixed(limit, 2), fixed(100.0 * step.p, 1), randomErrorText(100.0 * step.monteCarloSd, 1)};
}

Message sideText(SourceText side, const Verdict& verdict, double limit)
{
    std::vector<Message> parts{stepVerdictMessage(verdict), stepText(verdict, limit)};
    addWithholdReasons(parts, verdict);
    return {side, Message::listed(std::move(parts), ", ")};
}

void addVerdict(std::vector<Message>& parts, const TwoTrackVerdict& verdict, double limit)
{
    const auto& [left, right] = verdict.side;
    if (verdict.onePlane) {
        parts.push_back(stepVerdictMessage(left));
        parts.push_back(stepText(left, limit));
        return addWithholdReasons(parts, left);
    }
    parts.emplace_back(describe(verdict.both));
    parts.emplace_back(TR_NOOP("terratact::SessionEventLogger", "either side: %1"),
                       robotStepText(verdict, limit));
    parts.push_back(sideText(TR_NOOP("terratact::SessionEventLogger", "left: %1"), left, limit));
    parts.push_back(sideText(TR_NOOP("terratact::SessionEventLogger", "right: %1"), right, limit));
}

Message proposalText(const ProbeProposal& p)
{
    return {TR_NOOP("terratact::SessionEventLogger", "probe proposed %1: %2 m, %3 … %4 m, sd %5 m"),
            placeMessage({p.bin, p.side}),
            fixed(p.height, 3),
            fixed(p.q10, 3),
            fixed(p.q90, 3),
            fixed(p.sd, 3)};
}

}  // namespace

Message screenText(const Exploration& exploration, const LinkAccount& link)
{
    std::vector<Message> parts{{TR_NOOP("terratact::SessionEventLogger", "exploration: %1"),
                                describe(exploration.state().phase)},
                               describe(link)};
    if (const auto verdict = exploration.estimation().verdict())
        addVerdict(parts, *verdict, exploration.options().stepLimit);
    else
        parts.emplace_back(TR_NOOP("terratact::SessionEventLogger", "no estimate"));
    if (const auto& proposal = exploration.proposal()) parts.push_back(proposalText(*proposal));
    if (const auto place = exploration.probingPlace())
        parts.emplace_back(TR_NOOP("terratact::SessionEventLogger", "probing %1"),
                           placeMessage(*place));
    return Message::listed(std::move(parts), "; ");
}

}  // namespace terratact
