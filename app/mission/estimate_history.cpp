#include "app/mission/estimate_history.h"

#include <string_view>
#include <utility>

#include "app/mission/exploration.h"

namespace terratact {
namespace {

/// Returns the estimate without its draws, which are most of its size.
TwoTrackEstimate withoutDraws(TwoTrackEstimate estimate)
{
    for (TerrainEstimate& side : estimate.side) side.draws = {};
    return estimate;
}

std::vector<EstimateError> errorsOf(const TwoTrackEstimate& estimate, const CapturedScene& scene)
{
    if (estimate.onePlane)
        return scene.truth ? std::vector{errorAgainst(estimate.side[0], *scene.truth)}
                           : std::vector<EstimateError>{};
    if (!scene.sideTruth) return {};
    return {errorAgainst(estimate.side[0], scene.sideTruth->at(0)),
            errorAgainst(estimate.side[1], scene.sideTruth->at(1))};
}

}  // namespace

EstimateHistory::EstimateHistory(const Exploration& exploration, QObject* parent)
    : QObject(parent), exploration_(exploration)
{
    connect(&exploration.estimation(), &Estimation::estimateReady, this, [this](bool second) {
        if (!second) addPresent();
    });
    connect(&exploration, &Exploration::decided, this, [this](const char* what) {
        if (entries_.empty()) return;
        // "forget" comes before the estimate is hidden, "restore" after it is back.
        const bool hides = what == std::string_view("forget") && present() == last_;
        if (hides) entries_.front().isHidden = true;
        if (hides) emit changed();
    });
}

const PastEstimate* EstimateHistory::entry(std::int64_t number) const
{
    const std::int64_t index = last_ - number;
    if (index < 0 || index >= static_cast<std::int64_t>(entries_.size())) return nullptr;
    return &entries_[static_cast<std::size_t>(index)];
}

std::int64_t EstimateHistory::present() const
{
    return exploration_.estimation().estimate() && !entries_.empty() ? last_ : 0;
}

void EstimateHistory::addPresent()
{
    const Estimation& estimation = exploration_.estimation();
    const auto& scene = estimation.scene();
    if (!estimation.estimate() || !scene) return;
    if (!entries_.empty() && entries_.front().isHidden
        && entries_.front().scene == scene->measurement) {
        entries_.front().isHidden = false;
        entries_.front().isRestored = true;
        emit changed();
        return;
    }
    PastEstimate past{
        .number = ++last_,
        .at = QDateTime::currentDateTime(),
        .estimate = std::make_shared<const TwoTrackEstimate>(withoutDraws(*estimation.estimate())),
        .scene = scene->measurement,
        .truth = scene->truth,
        .sideTruth = scene->sideTruth,
        .verdict = estimation.verdict(),
        .stepLimit = exploration_.options().stepLimit,
        .hasReading = !estimation.readings().empty(),
        .errors = errorsOf(*estimation.estimate(), *scene),
        .probed = {},
        .isHidden = false,
        .isRestored = false};
    if (past.hasReading) score(past);
    entries_.push_front(std::move(past));
    if (entries_.size() > kMaxKept) entries_.pop_back();
    emit changed();
}

/// Adds the newest arm reading and the estimate's error there to the previous estimate of the same scene.
void EstimateHistory::score(const PastEstimate& with)
{
    if (entries_.empty() || entries_.front().scene != with.scene) return;
    PastEstimate& before = entries_.front();
    const ArmReading& reading = exploration_.estimation().readings().back();
    if (reading.side == ProbeSide::Middle && !before.estimate->onePlane) return;
    const std::size_t side = reading.side == ProbeSide::Right ? 1 : 0;
    const double height =
        before.estimate->side.at(side).height.at(static_cast<std::size_t>(reading.bin));
    before.probed.push_back({{reading.bin, reading.side}, height - reading.height});
}

}  // namespace terratact
