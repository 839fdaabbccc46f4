#include "app/modelling/truth/laser_truth_report.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "core/base/text.h"
#include "core/learn/data/drive_file.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/store/csv_text.h"

namespace terratact {
namespace {

constexpr double kTruthDegree = 57.29577951308232;
constexpr double kOffsetToApply = 0.01, kTiltToApply = 0.01;  // [m], slope

std::string errorLine(const char* what, const TruthErrors& e)
{
    return fmt::format("  {:<28} {:6} bins: bias {:+.1f} mm, mean |error| {:.1f} mm, rms {:.1f} "
                       "mm, worst {:.0f} mm, "
                       "{:.0f} % within the 80 % band\n",
                       what, e.bins, 1e3 * e.bias, 1e3 * e.meanError, 1e3 * e.rms, 1e3 * e.worst,
                       1e2 * e.within);
}

/// Returns "1.2° nose up".
std::string tiltText(double slope, const char* positive, const char* negative)
{
    return fmt::format("{:.2f}° {}", std::abs(std::atan(slope)) * kTruthDegree,
                       slope >= 0.0 ? positive : negative);
}

std::string alignmentLines(const CloudAlignment& a, bool applied)
{
    const CloudCorrection& c = a.correction;
    std::string text = fmt::format("alignment: over {} scenes the cloud lies {:.1f} ± {:.1f} mm {} "
                                   "the robot's tracks; scatter {:.1f} mm\n",
                                   a.scenes, 1e3 * std::abs(c.offset), 1e3 * a.offsetSd,
                                   c.offset >= 0.0 ? "below" : "above", 1e3 * a.scatter);
    text += a.isOfMap
              ? fmt::format("alignment: the map is tilted: the cloud falls {:+.2f}° along its x "
                            "and {:+.2f}° along its y, "
                            "± {:.2f}°\n",
                            std::atan(c.tiltX) * kTruthDegree, std::atan(c.tiltY) * kTruthDegree,
                            a.tiltSd * kTruthDegree)
              : fmt::format("alignment: against the cloud the robot is {} and {}, ± {:.2f}°\n",
                            tiltText(c.tiltX, "nose up", "nose down"),
                            tiltText(c.tiltY, "left up", "left down"), a.tiltSd * kTruthDegree);
    text += fmt::format(
        "alignment: the scenes' pitch and roll differ from the poses' by {:+.2f}° and {:+.2f}°\n",
        a.pitchApart * kTruthDegree, a.rollApart * kTruthDegree);
    const bool isLarge =
        std::abs(c.offset) > kOffsetToApply || std::hypot(c.tiltX, c.tiltY) > kTiltToApply;
    if (applied)
        text += "alignment: offset and tilt were removed\n";
    else if (isLarge)
        text += "alignment: nothing was removed; --align removes offset and tilt\n";
    return text;
}

/// Points under the tracks and flippers of all scenes.
struct TruthSupport {
    double perSquareMetre = 0.0;
    double filled = 0.0;  ///< share of the cells that have a point
};

TruthSupport supportOf(const LaserTruth& truth)
{
    const SceneGrid& grid = *truth.grid;
    double points = 0.0, area = 0.0, cells = 0.0, filled = 0.0;
    for (std::size_t place = 0; place < grid.places().size(); ++place)
        for (std::size_t i = 0; i < kTruthLines; ++i) {
            const auto line = static_cast<TruthLine>(i);
            for (std::size_t k = 0; k < grid.cells(); ++k) {
                points += grid.count(place, line, k);
                filled += grid.count(place, line, k) > 0 ? 1.0 : 0.0;
                area += kTruthCell * 2.0 * lineHalfWidth(truth.robot, line);
                ++cells;
            }
        }
    return {points / area, filled / cells};
}

}  // namespace

std::string noHeightsText(const LaserTruth& truth)
{
    constexpr double kEnoughFilled = 0.6;  // three of the five cells of a bin
    const TruthSupport support = supportOf(truth);
    if (support.filled < kEnoughFilled)
        return fmt::format(
            "no bin has a known height: {:.0f} points lie on a square metre under the scenes, and "
            "{:.0f} % of the cells of {:.0f} cm have one; a bin needs three of five: take a denser "
            "cloud or more scans, and look at --sheet",
            support.perSquareMetre, 1e2 * support.filled, 1e2 * kTruthCell);
    if (truth.rule.placeSd > truth.rule.maxSd)
        return fmt::format(
            "no bin has a known height: the height between robot and cloud has an sd of {:.0f} mm, "
            "and --max-sd allows {:.0f}: look at the alignment above, correct the poses, or give "
            "--align",
            1e3 * truth.rule.placeSd, 1e3 * truth.rule.maxSd);
    return "no bin has a known height: look at the alignment above, at --max-sd, and at --sheet";
}

std::string truthReport(const LaserTruth& truth, const LaserTruthOptions& options)
{
    std::string text = fmt::format("{} points of {} clouds", truth.points, truth.clouds);
    if (truth.grid->ownPoints() > 0)
        text += fmt::format(", {} of them the robot's own", truth.grid->ownPoints());
    text +=
        fmt::format("; {} of {} scenes have heights", truth.count(TruthGap::None), truth.scenes());
    const auto reason = [&](TruthGap gap, const char* why) {
        if (const std::size_t n = truth.count(gap); n > 0) text += fmt::format(", {} {}", n, why);
    };
    reason(TruthGap::OtherRun, "are of another run");
    reason(TruthGap::NoPose, "have no poses around their time");
    reason(TruthGap::OffCloud, "lie off the cloud");
    reason(TruthGap::NoCloud, "have no bin that is known well enough");
    reason(TruthGap::Excluded, "are excluded by decision");
    text += '\n';
    if (truth.alignment)
        text += alignmentLines(*truth.alignment, options.align);
    else
        text += "alignment: unknown, no scene has points under both tracks\n";
    if (truth.under.bins + truth.ahead.bins > 0) {
        text += fmt::format("against the heights that {} held:\n", printable(options.scenes));
        text += errorLine("under the tracks, to +0.2 m", truth.under);
        text += errorLine("ahead, from +0.3 m", truth.ahead);
    }
    return text;
}

std::string truthSupportCsv(const LaserTruth& truth)
{
    std::string text = "run,t_s,side,bin_m,height_m,sd_m,points,cells\n";
    const auto add = [&](std::size_t row, const char* side, const SideTruth& bins) {
        for (std::size_t i = 0; i < kBins; ++i) {
            const BinTruth& bin = bins.at(i);
            text +=
                csvLine({truth.runOf(row), truth.timeOf(row), side,
                         signedTenth(binCentre(static_cast<int>(i))), bin.height,
                         bin.height ? std::optional(bin.sd) : std::nullopt, bin.points, bin.cells});
        }
    };
    for (std::size_t row = 0; row < truth.scenes(); ++row) {
        const SceneTruth& scene = truth.truths[row];
        if (scene.gap == TruthGap::OtherRun || scene.gap == TruthGap::NoPose) continue;
        if (truth.isPlane) {
            add(row, "both", scene.plane);
            continue;
        }
        add(row, "left", scene.side[0]);
        add(row, "right", scene.side[1]);
    }
    return text;
}

std::string truthScenesCsv(const LaserTruth& truth)
{
    if (truth.drives.empty())
        return truth.isPlane ? scenesText(truth.plane) : twoTrackScenesText(truth.tracks);
    std::string text = drivesHeader(truth.isPlane, DriveColumns::Measured);
    std::size_t row = 0;
    for (DriveLines drive : truth.drives) {
        for (DriveLine& line : drive.lines) {
            if (!line.isScene) continue;
            if (truth.isPlane) {
                line.truth.fill(truth.plane.at(row).truth);
                line.truthSd.fill(truth.plane.at(row).truthSd);
            } else {
                line.truth = truth.tracks.at(row).truth;
                line.truthSd = truth.tracks.at(row).truthSd;
            }
            ++row;
        }
        text += driveText(drive, DriveColumns::Measured);
    }
    return text;
}

}  // namespace terratact
