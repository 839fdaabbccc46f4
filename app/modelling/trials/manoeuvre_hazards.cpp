#include "app/modelling/trials/manoeuvre_hazards.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/runtime/parallel.h"
#include "core/infer/two_track_estimator.h"
#include "core/sim/two_track_check.h"
#include "core/trail/trail_record.h"

namespace terratact {
namespace {

constexpr std::array kManoeuvreMethods{Method::Trail, Method::Local};
using MethodCounts = std::array<ManoeuvreLineCounts, kManoeuvreMethods.size()>;

bool remembersAhead(const TwoTrackEstimate& estimate)
{
    for (const TerrainEstimate& side : estimate.side)
        if (std::find(side.touch.begin() + kFirstAhead, side.touch.end(), Touch::Remembered)
            != side.touch.end())
            return true;
    return false;
}

/// Judges the scenes of one drive by both methods.
class ManoeuvreJudge {
public:
    ManoeuvreJudge(const EstimatorBundle& bundle, const HazardTrial& trial)
        : bundle_(bundle), trial_(trial), record_(bundle.robot)
    {
        for (std::size_t m = 0; m < kManoeuvreMethods.size(); ++m)
            counts_[m].method = kManoeuvreMethods[m];
    }

    MethodCounts judge(const std::vector<ManoeuvreLine>& lines)
    {
        for (const ManoeuvreLine& line : lines) {
            if (!line.driven.isScene) {
                record_.add(line.driven.line);
                continue;
            }
            const TrailHistory history = record_.before(line.driven.line);
            record_.addScene(line.driven.line);
            judgeScene(line, {}, history);
            if (line.arm.empty()) continue;
            judgeScene(line, line.arm, history);
            for (const ArmReading& reading : line.arm) record_.addArm(line.driven.line, reading);
        }
        return counts_;
    }

private:
    void judgeScene(const ManoeuvreLine& line, std::span<const ArmReading> arm,
                    const TrailHistory& history)
    {
        TwoTrackScene scene;
        scene.s = twoTrackReadings(line.driven.line);
        scene.truth = line.driven.truth;
        for (ManoeuvreLineCounts& counts : counts_) {
            Settings settings = trial_.settings;
            settings.method = counts.method;
            settings.hazardRate = trial_.rates.back();
            TwoTrackEstimate estimate = estimateMeasured(line.driven.line, arm, bundle_.robot,
                                                         bundle_.models, settings, {}, &history);
            writePosteriorCheck(estimate, line.driven.line, bundle_.robot);
            const std::size_t before = counts.counts.robot.falseClear;
            countScene(scene, bundle_.robot, estimate, trial_.stepLimit, counts.counts);
            const bool remembers = remembersAhead(estimate);
            counts.remembered += remembers ? 1 : 0;
            counts.falseRemembered += remembers ? counts.counts.robot.falseClear - before : 0;
            counts.cut += isUsable(history) ? 0 : 1;
        }
    }

    const EstimatorBundle& bundle_;
    const HazardTrial& trial_;
    TrailRecord record_;
    MethodCounts counts_{};
};

/// One drive of every ground and hazard, and of no hazard.
struct ManoeuvreGround {
    std::size_t ground = 0;
    std::optional<Hazard> hazard{};
};

std::vector<ManoeuvreGround> manoeuvreGrounds()
{
    std::vector<ManoeuvreGround> all;
    for (std::size_t ground = 0; ground < kHazardGrounds.size(); ++ground) {
        all.push_back({ground, std::nullopt});
        for (const Hazard hazard : kHazards) all.push_back({ground, hazard});
    }
    return all;
}

void addTo(ManoeuvreLineCounts& sum, const ManoeuvreLineCounts& drive)
{
    ++sum.drives;
    sum.counts.robot += drive.counts.robot;
    sum.counts.sides += drive.counts.sides;
    sum.remembered += drive.remembered;
    sum.falseRemembered += drive.falseRemembered;
    sum.cut += drive.cut;
}

}  // namespace

std::vector<ManoeuvreLineCounts> tryManoeuvres(const EstimatorBundle& bundle,
                                               const HazardTrial& trial)
{
    const std::vector<ManoeuvreGround> grounds = manoeuvreGrounds();
    const std::size_t each = grounds.size() * static_cast<std::size_t>(trial.drives);
    std::vector<ManoeuvreLineCounts> lines;
    lines.reserve(kManoeuvres.size() * kManoeuvreMethods.size());
    for (std::size_t k = 0; k < kManoeuvres.size(); ++k) {
        std::vector<MethodCounts> drives(each);
        parallelFor(static_cast<int>(each), [&](int drive) {
            const auto i = static_cast<std::size_t>(drive);
            const ManoeuvreGround& on = grounds[i % grounds.size()];
            std::mt19937_64 rng(trial.seed * 15'485'863 + k * 104'729 + i);
            drives[i] = ManoeuvreJudge(bundle, trial)
                            .judge(driveManoeuvre(bundle.robot, kHazardGrounds[on.ground],
                                                  on.hazard, kManoeuvres[k], rng));
        });
        for (std::size_t m = 0; m < kManoeuvreMethods.size(); ++m) {
            ManoeuvreLineCounts& sum = lines.emplace_back();
            sum.manoeuvre = kManoeuvres[k];
            sum.method = kManoeuvreMethods[m];
            for (const MethodCounts& drive : drives) addTo(sum, drive[m]);
        }
    }
    return lines;
}

std::string manoeuvreTable(std::span<const ManoeuvreLineCounts> lines)
{
    std::string text = "drives that turn, reverse and probe\n" + std::string(kCountsHead);
    for (const ManoeuvreLineCounts& line : lines)
        text += countsLine(fmt::format("{}, by {}", name(line.manoeuvre), name(line.method)),
                           line.counts.robot);
    text += fmt::format("\n{:30} {:>6} {:>7} {:>10} {:>6}\n", "", "drives", "no way", "remembered",
                        "false");
    for (const ManoeuvreLineCounts& line : lines)
        if (line.method == Method::Trail)
            text += fmt::format("{:30} {:6} {:7} {:10} {:6}\n", name(line.manoeuvre), line.drives,
                                line.cut, line.remembered, line.falseRemembered);
    text += R"(
no way: scenes before which nothing is remembered; remembered: scenes with a remembered bin ahead; false: CLEAR of these
with a true step before the horizon. A scene where the arm probed counts again with its readings.
)";
    return text.append(kCountsLegend);
}

}  // namespace terratact
