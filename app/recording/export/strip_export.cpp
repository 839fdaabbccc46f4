#include "app/recording/export/strip_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/robot/probe_side.h"
#include "core/store/csv_text.h"
#include "core/strip/strip_points.h"

namespace terratact {
namespace {

constexpr int kDecimals = 4;  // [m] a tenth of a millimetre

std::string metres(double value)
{
    return fmt::format("{:.{}f}", value, kDecimals);
}

std::string_view sideName(std::size_t side)
{
    return name(side == 0 ? ProbeSide::Left : ProbeSide::Right);
}

std::vector<StripPoint> pointsOfSection(const Strip& strip, const RobotModel& robot,
                                        std::optional<int> section)
{
    const auto sections = static_cast<int>(strip.sections().size());
    if (section && (*section < 1 || *section > sections))
        throw std::invalid_argument("strip: no such section");
    std::vector<StripPoint> points = pointsOf(strip, robot);
    if (section)
        std::erase_if(points, [&](const StripPoint& point) {
            return static_cast<int>(point.section) + 1 != *section;
        });
    return points;
}

std::string csvLineOf(const StripPoint& p, const Strip& strip)
{
    const HeightBand& band = p.bin->band;
    return csvLine({p.section + 1, name(strip.sections()[p.section].why), sideName(p.side),
                    p.source->onePlane, fmt::format("{:.1f}", p.along), metres(p.x), metres(p.y),
                    metres(band.height), metres(band.sd), metres(band.q10), metres(band.q90),
                    metres(p.driftSd), name(p.bin->felt), fmt::format("{:.3f}", p.source->time),
                    p.source->estimate});
}

/// Moves the sections along x, so that each begins kSectionGap ahead of the end of the one before.
void laySectionsApart(std::vector<StripPoint>& points)
{
    std::optional<double> end;
    for (auto first = points.begin(); first != points.end();) {
        const auto last = std::find_if(first, points.end(), [&](const StripPoint& point) {
            return point.section != first->section;
        });
        const auto [rear, front] = std::minmax_element(
            first, last, [](const StripPoint& a, const StripPoint& b) { return a.x < b.x; });
        const double shift = end ? *end + kSectionGap - rear->x : 0.0;
        end = front->x + shift;
        for (; first != last; ++first) first->x += shift;
    }
}

constexpr std::string_view kPlyProperties = "property float x\n"
                                            "property float y\n"
                                            "property float z\n"
                                            "property float sd\n"
                                            "property double time\n"
                                            "property uchar side\n"
                                            "property uchar felt\n"
                                            "property int section\n"
                                            "end_header\n";

}  // namespace

std::string stripCsv(const Strip& strip, const RobotModel& robot, std::optional<int> section)
{
    std::string text =
        "section,start,side,one_plane,x_m,plan_x_m,plan_y_m,height_m,sd_m,q10_m,q90_m,"
        "drift_sd_m,felt,time_s,estimate\n";
    for (const StripPoint& point : pointsOfSection(strip, robot, section))
        text += csvLineOf(point, strip);
    return text;
}

std::string ledgerText(const StripLedger& ledger)
{
    constexpr std::array kTouchKinds{"contacts", "probes", "passes"};
    std::string text;
    for (const ScoredBy by : kScoredBy) {
        const StripScore& score = ledger.of(by);
        if (score.n == 0) continue;
        text += text.empty() ? "80 % bands held at later " : ", ";
        text += fmt::format("{}: {} of {}", kTouchKinds.at(static_cast<std::size_t>(by)),
                            score.in80, score.n);
    }
    return text;
}

std::string stripPly(const Strip& strip, const RobotModel& robot, std::optional<int> section)
{
    std::vector<StripPoint> points = pointsOfSection(strip, robot, section);
    laySectionsApart(points);
    std::string vertices;
    for (const StripPoint& p : points)
        vertices += fmt::format("{} {} {} {} {:.3f} {} {} {}\n", metres(p.x), metres(p.y),
                                metres(p.z), metres(p.bin->band.sd), p.source->time, p.side,
                                static_cast<int>(p.bin->felt), p.section + 1);
    return fmt::format(
        "ply\n"
        "format ascii 1.0\n"
        "comment strip of felt ground: metres, x forward, y left, z up, time in s\n"
        "comment sections are laid {:.0f} m apart along x: the strip holds no place between them\n"
        "element vertex {}\n{}{}",
        kSectionGap, points.size(), kPlyProperties, vertices);
}

}  // namespace terratact
