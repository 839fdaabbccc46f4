#include "app/modelling/evaluation/two_track_csv.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "core/base/message.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/store/csv_text.h"

namespace terratact {

namespace {

constexpr std::array<const char*, 2> kSideNames{"left", "right"};
constexpr std::size_t kFields = 22, kTrueHeight = 12;

void addSide(std::string& csv, const TwoTrackScene& scene, const TwoTrackEstimate& estimate,
             const TwoTrackVerdict& verdict, std::size_t side)
{
    const TerrainEstimate& e = estimate.side[side];
    for (std::size_t i = 0; i < kBins; ++i)
        csv += csvLine({scene.run,
                        scene.time,
                        kSideNames[side],
                        signedTenth(binCentre(static_cast<int>(i))),
                        e.height[i],
                        e.mean[i],
                        e.sd[i],
                        e.q10[i],
                        e.q90[i],
                        name(e.origin[i]),
                        std::isfinite(e.ceiling[i]) ? CsvValue(e.ceiling[i]) : CsvValue(),
                        name(e.touch[i]),
                        scene.truth[side][i],
                        estimate.onePlane,
                        e.novelty,
                        verdict.side[side].step.p,
                        name(verdict.side[side].stepVerdict),
                        verdict.either.p,
                        verdict.crossSlope.steepest,
                        verdict.crossSlope.beyond.p,
                        name(verdict.both),
                        describe(verdict)});
}

/// Adds the rows of a scene that could not be estimated.
void addUnknown(std::string& csv, const TwoTrackScene& scene)
{
    for (std::size_t side = 0; side < 2; ++side)
        for (std::size_t i = 0; i < kBins; ++i) {
            std::array<CsvValue, kFields> fields{scene.run, scene.time, kSideNames[side],
                                                 signedTenth(binCentre(static_cast<int>(i)))};
            fields[kTrueHeight] = scene.truth[side][i];
            csv += csvLine(fields);
        }
}

}  // namespace

std::string twoTrackCsvHeader()
{
    return "run,t_s,side,bin_m,height_m,mean_m,sd_m,q10_m,q90_m,source,ceiling_m,touch,"
           "truth_m,one_plane,novelty,p_step,side_verdict,p_either,cross_slope_rad,"
           "p_slope,verdict,text\n";
}

std::string twoTrackCsvRows(std::span<const TwoTrackScene> scenes, const RobotModel& robot,
                            const TrackEstimates& estimates)
{
    if (scenes.size() != estimates.size()) throw std::invalid_argument("one estimate per scene");
    std::string csv;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        if (!estimates[k]) {
            addUnknown(csv, scenes[k]);
            continue;
        }
        const TwoTrackVerdict verdict = verdictOf(*estimates[k], robot, scenes[k].s, kStepLimit);
        for (std::size_t side = 0; side < 2; ++side)
            addSide(csv, scenes[k], *estimates[k], verdict, side);
    }
    return csv;
}

}  // namespace terratact
