#include "app/modelling/trials/strip_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "app/runtime/parallel.h"
#include "core/sim/watched_drive.h"
#include "core/strip/strip.h"
#include "core/trail/trail_record.h"

namespace terratact {
namespace {

/// A way to place estimates.
struct StripRule {
    Fusion fusion = Fusion::MoreCertain;
    bool corrects = true;
    std::string_view name;
};
constexpr std::array kStripRules{
    StripRule{Fusion::FeltFirst, true, "the newest, but felt ground stays (shipped)"},
    StripRule{Fusion::MoreCertain, true, "the more certain"},
    StripRule{Fusion::Newest, true, "the newest"},
    StripRule{Fusion::Intersection, true, "covariance intersection, equal weights"},
    StripRule{Fusion::Independent, true, "as independent errors"},
    StripRule{Fusion::FeltFirst, false, "shipped, by odometry alone"}};
constexpr double kTelemetryPeriod = 0.1;  // [s]

/// One bin against the truth.
struct JudgedBin {
    double x = 0.0;  ///< [m]
    bool felt = false;
    double error = 0.0;  ///< [m]
    bool inside = false;
    double width = 0.0;  ///< [m]
};

/// Judged bins of one drive, for this scene alone and for each rule.
struct JudgedDrive {
    std::array<std::vector<JudgedBin>, kStripRules.size() + 1> bins;
    StripLedger ledger;  ///< of the shipped rule
    std::array<std::size_t, kScoredBy.size()> inTruth{};
    std::size_t scenes = 0;
    double way = 0.0;
};

JudgedBin judged(const SeenBin& bin, const TerrainProfile& ground, const Vec2& imu)
{
    const double centre = imu.x + bin.x;
    const double truth =
        ground.meanOver(centre - kBinWidth / 2.0, centre + kBinWidth / 2.0) - imu.z;
    return {bin.x, isFelt(bin.felt), bin.band.height - truth,
            bin.band.q10 <= truth && truth <= bin.band.q90, bin.band.q90 - bin.band.q10};
}

std::vector<SeenBin> sceneAlone(const TerrainEstimate& e)
{
    std::vector<SeenBin> bins;
    bins.reserve(kBins);
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        bins.push_back({.x = binCentre(bin),
                        .band = {e.height[i], e.sd[i], e.q10[i], e.q90[i]},
                        .felt = feltBy(e, bin)});
    }
    return bins;
}

class StripDrive {
public:
    StripDrive(const EstimatorBundle& bundle, const TerrainProfile& ground)
        : bundle_(bundle), ground_(ground), record_(bundle.robot)
    {
        strips_.reserve(kStripRules.size());
        for (const StripRule& rule : kStripRules)
            strips_.emplace_back(bundle.robot, StripLimits{.corrects = rule.corrects}, rule.fusion);
    }

    JudgedDrive run(const std::vector<WatchedLine>& lines, const Settings& settings)
    {
        for (const WatchedLine& line : lines) {
            for (Strip& strip : strips_) strip.add(line.measurement);
            if (line.truth)
                measure(line, settings);
            else
                record_.add(line.measurement);
        }
        judged_.ledger = strips_[0].ledger();
        if (!lines.empty())
            judged_.way = lines.back().measurement.travelled.value_or(0.0)
                        - lines.front().measurement.travelled.value_or(0.0);
        return std::move(judged_);
    }

private:
    void measure(const WatchedLine& line, const Settings& settings)
    {
        const TrailHistory history = record_.before(line.measurement);
        record_.addScene(line.measurement);
        const auto estimated = estimate(line.measurement, settings, history);
        if (!estimated) return;
        ++judged_.scenes;
        judge(0, sceneAlone(*estimated), line.imu);
        const TwoTrackEstimate entered = equalSides(*estimated);
        for (std::size_t k = 0; k < strips_.size(); ++k) {
            strips_[k].beginScene(line.measurement);
            if (k == 0) scoreByTruth(entered, line.imu);
            strips_[k].enter(entered, static_cast<std::int64_t>(judged_.scenes));
            judge(k + 1, strips_[k].seen().side[0], line.imu);
        }
    }

    std::optional<TerrainEstimate> estimate(const Measurement& line, const Settings& settings,
                                            const TrailHistory& history) const
    {
        if (settings.method == Method::Trail)
            return estimateTerrain(proprioception(line), {}, bundle_.robot, bundle_.models,
                                   settings, {}, &history);
        const Scene scene{.run = {}, .time = 0.0, .s = proprioception(line), .truth = {}};
        return estimateScene(scene, bundle_, settings).estimate;
    }

    /// Counts the shipped strip's bins that the scene touches and whose true height is within the band.
    void scoreByTruth(const TwoTrackEstimate& estimate, const Vec2& imu)
    {
        for (const StripTouch& touch : strips_[0].touchesOf(estimate)) {
            const bool isInside =
                judged({touch.x, touch.predicted, {}, 0.0, 0.0}, ground_, imu).inside;
            judged_.inTruth.at(static_cast<std::size_t>(touch.by)) += isInside ? 1U : 0U;
        }
    }

    void judge(std::size_t result, const std::vector<SeenBin>& bins, const Vec2& imu)
    {
        for (const SeenBin& bin : bins) {
            const double behind = imu.x + bin.x - kBinWidth / 2.0;
            const double ahead = imu.x + bin.x + kBinWidth / 2.0;
            if (behind < ground_.begin() || ahead > ground_.end()) continue;
            judged_.bins.at(result).push_back(judged(bin, ground_, imu));
        }
    }

    const EstimatorBundle& bundle_;
    const TerrainProfile& ground_;
    TrailRecord record_;
    std::vector<Strip> strips_;
    JudgedDrive judged_;
};

JudgedDrive driveWithStrips(const EstimatorBundle& bundle, const StripTrial& trial, std::size_t k)
{
    std::seed_seq seed{trial.seed, static_cast<std::uint64_t>(k)};
    std::mt19937_64 rng(seed);
    WatchedStyle style;
    style.flippers = randomDriveStyle(rng);
    style.spacing = trial.spacing;
    style.period = kTelemetryPeriod;
    const auto lines = driveWithTelemetry(bundle.robot, trial.grounds[k], style, rng());
    return StripDrive(bundle, trial.grounds[k]).run(lines, trial.settings);
}

bool isWithin(const JudgedBin& bin, const StripStretch& stretch)
{
    return bin.x >= stretch.begin && bin.x < stretch.end && (bin.felt || !stretch.feltOnly);
}

StripErrors errorsWithin(const std::vector<JudgedDrive>& drives, std::size_t result,
                         const StripStretch& stretch)
{
    StripErrors sum;
    std::vector<double> errors;
    for (const JudgedDrive& drive : drives)
        for (const JudgedBin& bin : drive.bins.at(result)) {
            if (!isWithin(bin, stretch)) continue;
            errors.insert(errors.end(), std::abs(bin.error));
            sum.in80 += bin.inside ? 1.0 : 0.0;
            sum.width += bin.width;
        }
    if (errors.empty()) return sum;
    sum.bins = errors.size();
    const auto count = static_cast<double>(errors.size());
    sum.in80 /= count;
    sum.width /= count;
    sum.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / count;
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::ranges::nth_element(errors, middle);
    sum.median = *middle;
    return sum;
}

StripResult resultOf(const std::vector<JudgedDrive>& drives, std::size_t result)
{
    StripResult row{.name = result == 0 ? "this scene alone" : kStripRules.at(result - 1).name,
                    .stretch = {}};
    for (std::size_t k = 0; k < kStripStretches.size(); ++k)
        row.stretch.at(k) = errorsWithin(drives, result, kStripStretches.at(k));
    return row;
}

std::string ledgerTable(const StripFindings& findings)
{
    if (findings.ledger.all().n == 0) return {};
    std::string text = fmt::format("\nlater touches against the shipped strip before them\n"
                                   "{:28} {:>7} {:>7} {:>7} {:>7} {:>7}\n",
                                   "by", "bins", "in 80%", "truth", "mean z", "rms z");
    for (const ScoredBy by : kScoredBy) {
        const StripScore& score = findings.ledger.of(by);
        if (score.n == 0) continue;
        const auto percent = [&](std::size_t in) {
            return 100.0 * static_cast<double>(in) / static_cast<double>(score.n);
        };
        text += fmt::format("{:28} {:7} {:7.1f} {:7.1f} {:7.2f} {:7.2f}\n", name(by), score.n,
                            percent(score.in80),
                            percent(findings.inTruth.at(static_cast<std::size_t>(by))),
                            score.meanZ(), score.rmsZ());
    }
    return text;
}

}  // namespace

StripFindings tryStrips(const EstimatorBundle& bundle, const StripTrial& trial)
{
    std::vector<JudgedDrive> drives(trial.grounds.size());
    parallelFor(static_cast<int>(drives.size()), [&](int k) {
        const auto drive = static_cast<std::size_t>(k);
        drives[drive] = driveWithStrips(bundle, trial, drive);
    });
    StripFindings findings;
    for (const JudgedDrive& drive : drives) {
        findings.drives += drive.scenes > 0 ? 1 : 0;
        findings.scenes += drive.scenes;
        findings.way += drive.scenes > 0 ? drive.way : 0.0;
        findings.ledger += drive.ledger;
        for (std::size_t by = 0; by < kScoredBy.size(); ++by)
            findings.inTruth[by] += drive.inTruth[by];
    }
    if (findings.drives > 0) findings.way /= static_cast<double>(findings.drives);
    findings.results.reserve(kStripRules.size() + 1);
    for (std::size_t k = 0; k <= kStripRules.size(); ++k)
        findings.results.push_back(resultOf(drives, k));
    return findings;
}

std::string stripTable(const StripFindings& findings)
{
    constexpr double kMillimetres = 1000.0;
    std::string text = fmt::format("{} drives of {:.1f} m on average, {} scenes\n", findings.drives,
                                   findings.way, findings.scenes);
    for (const StripResult& result : findings.results) {
        text += fmt::format("\n{}\n{:28} {:>7} {:>7} {:>7} {:>7} {:>7}\n", result.name, "place",
                            "bins", "median", "mean", "in 80%", "width");
        for (std::size_t k = 0; k < kStripStretches.size(); ++k) {
            const StripErrors& e = result.stretch.at(k);
            if (e.bins > 0)
                text += fmt::format("{:28} {:7} {:7.1f} {:7.1f} {:7.1f} {:7.1f}\n",
                                    kStripStretches.at(k).name, e.bins, kMillimetres * e.median,
                                    kMillimetres * e.mean, 100.0 * e.in80, kMillimetres * e.width);
        }
    }
    return text + ledgerTable(findings);
}

}  // namespace terratact
