#include "core/infer/verdict/verdict.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "core/base/message.h"
#include "core/base/named.h"
#include "core/infer/estimate/contradiction.h"
#include "core/robot/side_plane.h"

namespace terratact {
namespace {

constexpr auto kStepVerdictNames = namesOf<StepVerdict>("CLEAR", "BLOCKED", "CANNOT TELL");

std::vector<WithholdReason> withholdReasons(const TerrainEstimate& estimate,
                                            const Measurement& scene, const LinkSinceScene& since)
{
    const Settings& settings = estimate.settings;
    std::vector<WithholdReason> reasons;
    if (!since.telemetryFresh) reasons.push_back(WithholdReason::Stale);
    if (!since.unbroken) reasons.push_back(WithholdReason::TelemetryGap);
    if (!estimate.converged) reasons.push_back(WithholdReason::NotConverged);
    if (estimate.novelty > 1.0) reasons.push_back(WithholdReason::UnlikeTraining);
    if (std::abs(scene.roll) > settings.rollLimit) reasons.push_back(WithholdReason::Roll);
    if (flipperAsymmetry(scene) > settings.asymmetryLimit)
        reasons.push_back(WithholdReason::Asymmetry);
    if (hasTurned(scene.differential)) reasons.push_back(WithholdReason::Differential);
    if (!since.sensorsSound) reasons.push_back(WithholdReason::SensorFault);
    if (estimate.contradicts) reasons.push_back(WithholdReason::Contradiction);
    return reasons;
}

Touch touchAt(const TerrainEstimate& estimate, int bin)
{
    return estimate.touch[static_cast<std::size_t>(bin)];
}

/// Returns the last bin ahead that the robot covers; kFirstAhead − 1: none.
int reachBin(const TerrainEstimate& estimate)
{
    int last = kFirstAhead - 1;
    for (int bin = kFirstAhead; bin < kBins; ++bin)
        if (std::isfinite(estimate.ceiling[static_cast<std::size_t>(bin)])) last = bin;
    return last;
}

Shortfall shortfallOf(const TerrainEstimate& estimate, int horizon)
{
    if (!isTouchRecorded(estimate)) return Shortfall::None;
    const bool presses = estimate.feltTo > binBegin(0);
    if (horizon < kFirstAhead && !presses) return Shortfall::NothingFelt;
    if (horizon < std::max(reachBin(estimate), kMinHorizonBin)) return Shortfall::ShortHorizon;
    return lastFeltBin(estimate) >= horizon ? Shortfall::None : Shortfall::Spanned;
}

Help helpFor(Shortfall shortfall, const Measurement& scene)
{
    if (shortfall == Shortfall::None) return Help::Nothing;
    const double slope = scene.pitch + 0.5 * (scene.frontLeft + scene.frontRight);
    if (std::abs(slope) > kSteepFlipper) return Help::Flatten;
    return shortfall == Shortfall::Spanned ? Help::DriveOn : Help::Nothing;
}

void writeHorizon(Verdict& verdict, const TerrainEstimate& estimate, const Measurement& scene,
                  double limit)
{
    const int last = horizonBin(estimate);
    verdict.touchRecorded = isTouchRecorded(estimate);
    verdict.horizon = binBegin(last + 1);
    verdict.feltTo = binBegin(lastFeltBin(estimate) + 1);
    verdict.shortfall = shortfallOf(estimate, last);
    verdict.help = helpFor(verdict.shortfall, scene);
    verdict.toHorizon = {1.0, 0.0};
    if (last >= kMinHorizonBin && !estimate.draws.empty())
        verdict.toHorizon = anyStep(estimate, limit, kFirstAhead, last);
}

/// Returns true if the felt ground allows CLEAR. Spanned ground is part of the probability to the
/// horizon.
bool isClear(const Verdict& verdict)
{
    const bool reached =
        verdict.shortfall == Shortfall::None || verdict.shortfall == Shortfall::Spanned;
    return reached && verdict.toHorizon.p + 2.0 * verdict.toHorizon.monteCarloSd < kClearBelow;
}

}  // namespace

std::string_view name(StepVerdict stepVerdict)
{
    return nameIn(kStepVerdictNames, stepVerdict);
}

SourceText describe(StepVerdict stepVerdict)
{
    switch (stepVerdict) {
    case StepVerdict::Clear: return TR_NOOP("core", "CLEAR");
    case StepVerdict::Blocked: return TR_NOOP("core", "BLOCKED");
    case StepVerdict::CannotTell: return TR_NOOP("core", "CANNOT TELL");
    }
    throw std::invalid_argument("describe: no such StepVerdict");
}

SourceText describe(WithholdReason reason)
{
    switch (reason) {
    case WithholdReason::Stale:
        return TR_NOOP("core", "no live telemetry, the robot may have moved");
    case WithholdReason::TelemetryGap:
        return TR_NOOP("core", "the link was lost, the robot may have moved");
    case WithholdReason::NotConverged: return TR_NOOP("core", "the chains have not converged");
    case WithholdReason::UnlikeTraining: return TR_NOOP("core", "the scene is unlike all training");
    case WithholdReason::Roll:
        return TR_NOOP("core", "the robot rolls, left and right ground differ");
    case WithholdReason::Asymmetry:
        return TR_NOOP("core", "the flippers differ, left and right ground differ");
    case WithholdReason::Differential:
        return TR_NOOP("core", "the track differential has turned, left and right ground differ");
    case WithholdReason::SensorFault:
        return TR_NOOP("core", "a sensor may be wrong, see the alarms");
    case WithholdReason::Contradiction:
        return TR_NOOP("core", "the estimate contradicts the readings");
    }
    throw std::invalid_argument("describe: no such WithholdReason");
}

bool isUnfeltAhead(const TerrainEstimate& estimate, int bin)
{
    const Touch touch = touchAt(estimate, bin);
    if (touch == Touch::Unrecorded) return estimate.priorOnly(bin);
    return bin >= kFirstAhead && (touch == Touch::Bounded || touch == Touch::NotFelt);
}

SourceText describe(Shortfall shortfall)
{
    switch (shortfall) {
    case Shortfall::None: return {};
    case Shortfall::NothingFelt: return TR_NOOP("core", "the front flippers press on nothing");
    case Shortfall::ShortHorizon:
        return TR_NOOP("core", "the front flippers reach further than they press");
    case Shortfall::Spanned:
        return TR_NOOP("core", "the front flippers span ground that they do not press");
    }
    throw std::invalid_argument("describe: no such Shortfall");
}

SourceText describe(Help help)
{
    switch (help) {
    case Help::Nothing: return {};
    case Help::Flatten: return TR_NOOP("core", "lay the front flippers flatter");
    case Help::DriveOn: return TR_NOOP("core", "drive on 0.1 m and explore again");
    }
    throw std::invalid_argument("describe: no such Help");
}

bool isClearToHorizon(const Verdict& verdict)
{
    return verdict.stepVerdict == StepVerdict::Clear && verdict.touchRecorded;
}

const StepProbability& answeredBy(const Verdict& verdict)
{
    return isClearToHorizon(verdict) ? verdict.toHorizon : verdict.step;
}

Message stepVerdictMessage(const Verdict& verdict)
{
    const SourceText answer = describe(verdict.stepVerdict);
    if (!isClearToHorizon(verdict)) return answer;
    const std::string to = signedFixed(verdict.horizon, 2);
    if (verdict.shortfall == Shortfall::Spanned && isNothingFeltAhead(verdict))
        return {TR_NOOP("core", "%1 to %2 m, nothing felt ahead"), answer, to};
    if (verdict.shortfall == Shortfall::Spanned)
        return {TR_NOOP("core", "%1 to %2 m, felt to %3 m"), answer, to,
                signedFixed(verdict.feltTo, 2)};
    return {TR_NOOP("core", "%1 to %2 m"), answer, to};
}

std::vector<int> notFelt(const Verdict& verdict)
{
    std::vector<int> bins;
    std::ranges::set_difference(verdict.unfelt, verdict.bounded, std::back_inserter(bins));
    return bins;
}

bool isNothingFeltAhead(const Verdict& verdict)
{
    return verdict.feltTo < binCentre(kFirstAhead);
}

Message placesOf(const std::vector<int>& bins)
{
    std::vector<Message> places;
    places.reserve(bins.size());
    for (const int bin : bins)
        places.push_back(Message::verbatim(signedFixed(binCentre(bin), 1) + " m"));
    return Message::listed(std::move(places), ", ");
}

Message unfeltMessage(const Verdict& verdict)
{
    std::vector<Message> parts;
    if (!verdict.bounded.empty())
        parts.emplace_back(TR_NOOP("core", "bounded: %1"), placesOf(verdict.bounded));
    if (const std::vector<int> bins = notFelt(verdict); !bins.empty())
        parts.emplace_back(TR_NOOP("core", "not felt: %1"), placesOf(bins));
    return Message::listed(std::move(parts), "; ");
}

Verdict verdictOf(const TerrainEstimate& estimate, const Measurement& scene,
                  const LinkSinceScene& since, double limit)
{
    if (!(limit >= 0.0) || !std::isfinite(limit))
        throw std::invalid_argument("verdictOf: the limit must be finite and 0 m or more");
    Verdict verdict;
    verdict.likeliest = kFirstAhead;
    verdict.withheldFor = withholdReasons(estimate, scene, since);
    for (int bin = kFirstAhead; bin < kBins; ++bin)
        if (isUnfeltAhead(estimate, bin)) {
            verdict.unfelt.push_back(bin);
            if (touchAt(estimate, bin) == Touch::Bounded) verdict.bounded.push_back(bin);
        }
    writeHorizon(verdict, estimate, scene, limit);
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
    if (!verdict.withheldFor.empty()) return verdict;
    if (isClear(verdict)) verdict.stepVerdict = StepVerdict::Clear;
    if (verdict.step.p - margin > kBlockedAbove) verdict.stepVerdict = StepVerdict::Blocked;
    return verdict;
}

Verdict verdictOf(const TerrainEstimate& estimate, const Proprioception& scene, double limit)
{
    Measurement even;
    even.pitch = scene.pitch;
    even.frontLeft = even.frontRight = scene.front;
    even.rearLeft = even.rearRight = scene.rear;
    return verdictOf(estimate, even, {}, limit);
}

}  // namespace terratact
