#include "core/strip/strip.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "core/infer/estimate/felt_horizon.h"
#include "core/strip/scene_contacts.h"

namespace terratact {
namespace {

/// Returns the felt horizon of the side where it is nearer [m]; empty: a side has none.
std::optional<double> nearerHorizon(const TwoTrackEstimate& estimate)
{
    const auto left = feltHorizon(estimate.side[0]), right = feltHorizon(estimate.side[1]);
    return left && right ? std::optional(std::min(*left, *right)) : std::nullopt;
}

StripLedger scored(const std::vector<StripTouch>& touches)
{
    StripLedger ledger;
    for (const StripTouch& touch : touches)
        ledger.add(touch.by, touch.predicted, touch.felt, touch.feltSd);
    return ledger;
}

}  // namespace

Strip::Strip(const RobotModel& robot, const StripLimits& limits, Fusion fusion)
    : robot_(robot), limits_(limits), fusion_(fusion), way_(robot, limits.way)
{
}

void Strip::add(const Measurement& line, const std::vector<SensorSuspicion>& suspicions)
{
    if (isWaySuspected(suspicions))
        way_.end(SectionStart::Suspected);
    else
        way_.add(line);
}

void Strip::beginScene(const Measurement& scene)
{
    isSceneEntered_ = false;
    replaced_.clear();
    scores_.beginScene();
    scene_ = scene;
    way_.beginScene(scene);
}

const StripSection* Strip::sectionOf(std::int64_t segment) const
{
    for (const StripSection& section : sections_)
        if (section.segment == segment) return &section;
    return nullptr;
}

StripSection* Strip::sectionOf(std::int64_t segment)
{
    return const_cast<StripSection*>(std::as_const(*this).sectionOf(segment));
}

StripSection& Strip::sectionOfScene(const WayPose& pose)
{
    const StripWay::ScenePose& scene = *way_.scene();
    if (StripSection* const section = sectionOf(scene.segment)) return *section;
    const SectionStart why = sections_.empty() ? SectionStart::First : scene.why;
    return sections_.emplace_back(StripSection{why, scene.segment, pose, {}});
}

/// Returns the error of the odometry since the scene before.
PoseOffset Strip::offsetOf(const TwoTrackEstimate& estimate)
{
    const StripWay::ScenePose& scene = *way_.scene();
    const PoseCovariance prior = way_.prior();
    const StripSection* const section = sectionOf(scene.segment);
    if (!section || !limits_.corrects) return {{}, prior};
    const Vec2 imu = section->imuAt(
        {.imu = {scene.at.imu.x + scene.chain.shift.x, scene.at.imu.z + scene.chain.shift.z}});
    std::vector<MatchedBin> bins;
    bins.reserve(std::size_t{2} * kBins);
    for (std::size_t side = 0; side < (estimate.onePlane ? 1U : 2U); ++side)
        for (const EnteredBin& entered : binsOf(estimate.side.at(side), imu, 0)) {
            const auto found = section->columns.find(entered.column);
            if (found == section->columns.end() || !found->second.at(side)) continue;
            const StripBin& held = *found->second.at(side);
            const double sd =
                std::hypot(held.band.sd, entered.bin.band.sd,
                           heightSd(scene.chain.drift - source(held).at.drift, held.slopes));
            if (sd > 0.0)
                bins.push_back({held.band.height - entered.bin.band.height,
                                (held.slopes[0] + held.slopes[1]) / 2.0, sd * sd});
        }
    return matched(prior, bins);
}

/// Returns the strip's prediction for a column, as seen from the scene's pose by odometry alone. Empty: the strip has
/// no height of the line that the robot touches there. onFlippers: the line of the flippers, not of the track.
std::optional<HeightBand> Strip::predictedBand(const StripSection& section, const WayPose& pose,
                                               int column, std::size_t side, bool onFlippers) const
{
    const auto found = section.columns.find(column);
    if (found == section.columns.end() || !found->second.at(side)) return std::nullopt;
    const StripBin& held = *found->second.at(side);
    if (!source(held).onePlane && held.onFlipperLine != onFlippers) return std::nullopt;
    return bandFrom(held, section, pose);
}

std::vector<StripTouch> Strip::touchesOf(const TwoTrackEstimate& estimate) const
{
    std::vector<StripTouch> touches;
    const StripSection* const section = way_.scene() ? sectionOf(way_.scene()->segment) : nullptr;
    if (!section) return touches;
    const WayPose pose = way_.scenePose();
    const Vec2 imu = section->imuAt(pose);
    const auto add = [&](ScoredBy by, std::size_t side, int column, bool onFlippers, double height,
                         double sd) {
        const auto predicted = predictedBand(*section, pose, column, side, onFlippers);
        if (predicted && StripLedger::canScore(*predicted, height, sd))
            touches.insert(touches.end(),
                           {by, side, column * kBinWidth - imu.x, *predicted, height, sd});
    };
    const Settings& settings = estimate.side[0].settings;
    const auto contacts = sceneContacts(robot_, scene_, estimate.onePlane, settings);
    for (std::size_t side = 0; side < (estimate.onePlane ? 1U : 2U); ++side) {
        for (const Contact& contact : contacts.at(side))
            add(ScoredBy::Contact, side,
                static_cast<int>(std::lround((imu.x + contact.x) / kBinWidth)), true,
                contact.height, settings.contactSd);
        for (const auto& [column, bin] : binsOf(estimate.side.at(side), {imu.x, 0.0}, 0))
            if (bin.felt == FeltBy::Track)
                add(ScoredBy::Pass, side, column, bin.onFlipperLine, bin.band.height, bin.band.sd);
    }
    return touches;
}

void Strip::enter(const TwoTrackEstimate& estimate, std::int64_t id,
                  std::span<const ArmReading> arm)
{
    if (!way_.scene()) return;
    scores_.addProbes(arm);
    takeOut();
    if (!scores_.hasTouches()) scores_.addTouches(scored(touchesOf(estimate)));
    scores_.show(estimate);
    const std::int64_t number = ++lastNumber_;
    const WayPose pose = way_.settle(offsetOf(estimate));
    const StripWay::ScenePose& scene = *way_.scene();
    sources_.push_back(
        {number, id, scene.time, estimate.onePlane, scene.segment, pose, nearerHorizon(estimate)});
    StripSection& section = sectionOfScene(pose);
    const Vec2 imu = section.imuAt(pose);
    for (std::size_t side = 0; side < 2; ++side)
        for (const EnteredBin& entered : binsOf(estimate.side.at(side), imu, number))
            place(section, side, entered, pose);
    isSceneEntered_ = true;
    dropUnused();
    dropOldest();
}

/// Returns the rule for a bin. What was felt is not lost to an estimate that did not feel it.
Fusion Strip::ruleFor(FeltBy older, FeltBy newer) const
{
    if (fusion_ != Fusion::FeltFirst) return fusion_;
    const bool isLess = (isFelt(older) && !isFelt(newer)) || newer == FeltBy::NotFelt;
    return isLess ? Fusion::MoreCertain : Fusion::Newest;
}

void Strip::place(StripSection& section, std::size_t side, const EnteredBin& entered,
                  const WayPose& pose)
{
    const StripBin& bin = entered.bin;
    std::optional<StripBin>& held = section.columns[entered.column].at(side);
    replaced_.push_back({section.segment, entered.column, side, held});
    if (!held) {
        held = bin;
        return;
    }
    const HeightBand older = raised(bandFrom(*held, section, pose), section.imuAt(pose).z);
    const double apart = std::abs(older.height - bin.band.height);
    if (apart > kContradiction * std::hypot(older.sd, bin.band.sd)) {
        held = bin;
        return;
    }
    const HeightBand band = fused(older, bin.band, ruleFor(held->felt, bin.felt));
    if (band == older) return;  // the bin keeps the moment at which it was felt
    const FeltBy felt = band == bin.band ? bin.felt : std::min(bin.felt, held->felt);
    held = bin;
    held->band = band;
    held->felt = felt;
}

void Strip::removeLast()
{
    takeOut();
    scores_.takeBack();
}

void Strip::takeOut()
{
    if (!isSceneEntered_) return;
    isSceneEntered_ = false;
    way_.unsettle();
    while (!replaced_.empty()) {
        const Replaced last = replaced_.back();
        replaced_.pop_back();
        StripSection* const section = sectionOf(last.segment);
        if (!section) continue;
        StripColumn& column = section->columns[last.column];
        column.at(last.side) = last.bin;
        if (!column[0] && !column[1]) section->columns.erase(last.column);
    }
    std::erase_if(sections_, [](const StripSection& section) { return section.columns.empty(); });
    if (!sources_.empty()) sources_.pop_back();
}

/// Drops the sources of which no bin remains. The bins that the last scene replaced count as well.
void Strip::dropUnused()
{
    if (sources_.size() <= limits_.sources) return;
    std::set<std::int64_t> used{lastNumber_};
    for (const StripSection& section : sections_)
        for (const auto& [index, column] : section.columns)
            for (const auto& bin : column)
                if (bin) used.insert(bin->source);
    for (const Replaced& before : replaced_)
        if (before.bin) used.insert(before.bin->source);
    std::erase_if(sources_,
                  [&](const StripSource& source) { return !used.contains(source.number); });
}

std::size_t Strip::columns() const
{
    std::size_t count = 0;
    for (const StripSection& section : sections_) count += section.columns.size();
    return count;
}

/// Drops the columns that were felt first, until the limits hold.
void Strip::dropOldest()
{
    std::size_t excess = columns() > limits_.columns ? columns() - limits_.columns : 0;
    while (excess > 0) {
        StripSection& oldest = sections_.front();
        const auto felt = [](const auto& entry) {
            std::int64_t newest = 0;
            for (const auto& bin : entry.second)
                if (bin) newest = std::max(newest, bin->source);
            return newest;
        };
        oldest.columns.erase(std::ranges::min_element(oldest.columns, {}, felt));
        if (oldest.columns.empty()) sections_.pop_front();
        --excess;
    }
}

const StripSource& Strip::source(const StripBin& bin) const
{
    const auto found = std::ranges::lower_bound(sources_, bin.source, {}, &StripSource::number);
    if (found == sources_.end() || found->number != bin.source)
        throw std::invalid_argument("Strip: a bin of another strip");
    return *found;
}

HeightBand Strip::bandFrom(const StripBin& bin, const StripSection& section,
                           const WayPose& pose) const
{
    const double sd = heightSd(pose.drift - source(bin).at.drift, bin.slopes);
    return raised(widened(bin.band, sd), -section.imuAt(pose).z);
}

SeenStrip Strip::seen() const
{
    SeenStrip seen;
    if (whyNothing()) return seen;
    const StripSection& section = sections_.back();
    const WayPose pose = *way_.now();
    const double imu = section.imuAt(pose).x;
    for (const auto& [index, column] : section.columns)
        for (std::size_t side = 0; side < 2; ++side) {
            const std::optional<StripBin>& bin = column.at(side);
            if (!bin) continue;
            const StripSource& from = source(*bin);
            seen.onePlane = seen.onePlane && from.onePlane;
            seen.side.at(side).push_back({index * kBinWidth - imu, bandFrom(*bin, section, pose),
                                          bin->felt, from.time,
                                          std::max(0.0, pose.way - from.at.way)});
        }
    if (const StripSource& newest = sources_.back(); newest.segment == section.segment) {
        seen.way = std::max(0.0, pose.way - newest.at.way);
        if (newest.feltTo) seen.feltTo = *newest.feltTo + newest.at.imu.x - pose.imu.x;
    }
    return seen;
}

EarlierSection Strip::earlierOf(const StripSection& section, SectionStart next) const
{
    EarlierSection earlier{.next = next};
    for (const auto& [index, column] : section.columns)
        for (std::size_t side = 0; side < 2; ++side) {
            const std::optional<StripBin>& bin = column.at(side);
            if (!bin) continue;
            earlier.onePlane = earlier.onePlane && source(*bin).onePlane;
            earlier.side.at(side).push_back(
                {index * kBinWidth, bin->band.height, bin->band.sd, bin->felt});
        }
    return earlier;
}

std::vector<EarlierSection> Strip::earlier() const
{
    std::vector<EarlierSection> earlier;
    std::optional<SectionStart> next = whyNothing();
    for (std::size_t k = sections_.size(); k > 0; --k) {
        const StripSection& section = sections_[k - 1];
        if (section.segment < cleared_ || earlier.size() == kEarlier) break;
        if (next) earlier.push_back(earlierOf(section, *next));
        next = section.why;
    }
    return earlier;
}

std::optional<SectionStart> Strip::whyNothing() const
{
    if (sections_.empty()) {
        const SectionStart why = way_.why();
        const bool hasNoPlace = why == SectionStart::NoOdometry || why == SectionStart::Suspected;
        return hasNoPlace && !way_.now() ? why : SectionStart::First;
    }
    if (sections_.back().segment != way_.segment() || !way_.now()) return way_.why();
    return std::nullopt;
}

}  // namespace terratact
