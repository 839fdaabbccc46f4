#include "core/infer/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

std::vector<Doubt> doubtsOf(const TerrainEstimate& estimate, const Measurement& scene,
                            const Aftermath& since)
{
    const Settings& settings = estimate.settings;
    std::vector<Doubt> doubts;
    if (!since.heard) doubts.push_back(Doubt::Stale);
    if (!since.unbroken) doubts.push_back(Doubt::Unheard);
    if (!estimate.converged) doubts.push_back(Doubt::NotConverged);
    if (estimate.novelty > 1.0) doubts.push_back(Doubt::UnlikeTraining);
    if (std::abs(scene.roll) > settings.rollLimit) doubts.push_back(Doubt::Roll);
    if (flipperAsymmetry(scene) > settings.asymmetryLimit) doubts.push_back(Doubt::Asymmetry);
    return doubts;
}

}  // namespace

std::string_view name(Outlook outlook)
{
    switch (outlook) {
    case Outlook::Clear: return "CLEAR";
    case Outlook::Blocked: return "BLOCKED";
    case Outlook::CannotTell: return "CANNOT TELL";
    }
    return {};
}

std::string describe(Doubt doubt)
{
    switch (doubt) {
    case Doubt::Stale: return "no live telemetry, the robot may have moved";
    case Doubt::Unheard: return "the link was lost, the robot may have moved";
    case Doubt::NotConverged: return "the chains have not converged";
    case Doubt::UnlikeTraining: return "the scene is unlike all training";
    case Doubt::Roll: return "the robot rolls, left and right ground differ";
    case Doubt::Asymmetry: return "the flippers differ, left and right ground differ";
    }
    throw std::invalid_argument("describe: no such Doubt");
}

std::string describeUnfelt(const Verdict& verdict)
{
    std::string text;
    for (const int bin : verdict.unfelt)
        text += fmt::format("{}{:+.1f} m", text.empty() ? "not felt: " : ", ", binCentre(bin));
    return text;
}

Verdict verdictOf(const TerrainEstimate& estimate, const Measurement& scene, const Aftermath& since,
                  double limit)
{
    if (!(limit >= 0.0) || !std::isfinite(limit))
        throw std::invalid_argument("verdictOf: the limit must be finite and 0 m or more");
    Verdict verdict;
    verdict.likeliest = kFirstAhead;
    verdict.doubts = doubtsOf(estimate, scene, since);
    for (int bin = kFirstAhead; bin < kBins; ++bin)
        if (estimate.priorOnly(bin)) verdict.unfelt.push_back(bin);
    if (estimate.draws.empty()) {
        verdict.step = {0.0, 1.0};
        return verdict;
    }
    verdict.step = anyStep(estimate, limit, kFirstAhead);
    const auto pairs = stepProbabilities(estimate, limit);
    const auto likeliest = std::max_element(pairs.begin() + kFirstAhead, pairs.end(),
                                            [](const auto& a, const auto& b) { return a.p < b.p; });
    verdict.likeliest = static_cast<int>(likeliest - pairs.begin());
    verdict.likeliestP = likeliest->p;
    const double margin = 2.0 * verdict.step.monteCarloSd;
    if (!verdict.doubts.empty()) return verdict;
    if (verdict.step.p + margin < kClearBelow) verdict.outlook = Outlook::Clear;
    if (verdict.step.p - margin > kBlockedAbove) verdict.outlook = Outlook::Blocked;
    return verdict;
}

}  // namespace terratact
