#include "core/clouds/cloud_alignment.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr std::size_t kMinSideCells = 5;
constexpr double kNearMargin = 0.10, kWideMargin = 0.50;  // [m]
/// The least of some noisy gaps lies this many sd below the true one, as measured over simulated drives.
constexpr double kMinGapBias = 0.6;
constexpr double kOffDistance = 0.05;  // [m]
constexpr double kScatterPerMad = 1.4826, kMedianSd = 1.2533;

/// Gap between the robot and the cloud below it.
struct CloudGap {
    double x = 0.0, gap = 0.0, sd = 0.0;
};

struct GapLine {
    double offset = 0.0, slope = 0.0;
    double at(double x) const { return offset + slope * x; }
};

double medianOf(std::vector<double> values)
{
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Returns the line below all gaps that is highest at x: an edge of their lower hull. Noise lowers a hull, so it is
/// raised by the expected amount.
GapLine lineBelow(std::vector<CloudGap> gaps, double x)
{
    std::ranges::sort(gaps, {}, &CloudGap::x);
    std::vector<CloudGap> hull;
    const auto isAbove = [&](const CloudGap& next) {
        const CloudGap &a = hull[hull.size() - 2], &b = hull.back();
        return (b.gap - a.gap) * (next.x - a.x) >= (next.gap - a.gap) * (b.x - a.x);
    };
    for (const CloudGap& gap : gaps) {
        if (!hull.empty() && hull.back().x == gap.x) {
            if (hull.back().gap <= gap.gap) continue;
            hull.pop_back();
        }
        while (hull.size() >= 2 && isAbove(gap)) hull.pop_back();
        hull.push_back(gap);
    }
    const auto after = std::ranges::upper_bound(hull, x, {}, &CloudGap::x);
    const CloudGap &a = *(after - 1), &b = *after;
    const double slope = (b.gap - a.gap) / (b.x - a.x);
    return {a.gap - slope * a.x + kMinGapBias * 0.5 * (a.sd + b.sd), slope};
}

std::optional<GapLine> sideLine(const SceneGrid& grid, const RobotModel& robot, std::size_t place,
                                Side side, const TruthRule& rule)
{
    const TwoTrackReadings& s = grid.places()[place].s;
    const double mass = massX(robot, s);
    std::vector<CloudGap> gaps;
    gaps.reserve(2 * grid.cells());
    std::size_t behind = 0;
    for (const int flippers : {0, 1}) {
        const auto line = static_cast<TruthLine>((side == Side::Left ? 0 : 2) + flippers);
        const auto cells = groundOf(grid, robot, place, line, {}, rule);
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const double x = grid.cellX(k), part = partAbove(robot, s, line, x);
            if (!cells[k].isKnown || !std::isfinite(part)) continue;
            gaps.push_back({x, part - cells[k].height, cells[k].sd});
            behind += x < mass ? 1 : 0;
        }
    }
    if (behind < kMinSideCells || gaps.size() - behind < kMinSideCells) return std::nullopt;
    return lineBelow(std::move(gaps), mass);
}

CloudCorrection turnedTilt(const CloudCorrection& c, double angle)
{
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return {c.offset, cosine * c.tiltX - sine * c.tiltY, sine * c.tiltX + cosine * c.tiltY};
}

/// Medians of tilts, and the median distance from them.
struct TiltFit {
    double x = 0.0, y = 0.0, scatter = 0.0;
};

TiltFit fitTilt(const std::vector<CloudCorrection>& tilts)
{
    std::vector<double> xs, ys, apart;
    for (const CloudCorrection& c : tilts) {
        xs.push_back(c.tiltX);
        ys.push_back(c.tiltY);
    }
    TiltFit fit{medianOf(xs), medianOf(ys)};
    for (const CloudCorrection& c : tilts)
        apart.push_back(std::hypot(c.tiltX - fit.x, c.tiltY - fit.y));
    fit.scatter = medianOf(apart);
    return fit;
}

std::vector<SceneContact> contactsOf(const SceneGrid& grid, const RobotModel& robot, TruthRule rule,
                                     double margin)
{
    rule.ownMargin = margin;
    std::vector<SceneContact> contacts;
    for (std::size_t p = 0; p < grid.places().size(); ++p)
        if (const auto contact = contactAt(grid, robot, p, rule)) contacts.push_back(*contact);
    return contacts;
}

void addTilt(const SceneGrid& grid, CloudAlignment& a)
{
    std::vector<CloudCorrection> ofRobot, ofMap;
    std::vector<double> pitch, roll;
    for (const SceneContact& c : a.contacts) {
        const ScenePlace& place = grid.places()[c.place];
        ofRobot.push_back(c.correction);
        ofMap.push_back(turnedTilt(c.correction, place.heading));
        pitch.push_back(place.s.pitch - place.posePitch);
        roll.push_back(place.s.roll - place.poseRoll);
    }
    const TiltFit robotFit = fitTilt(ofRobot), mapFit = fitTilt(ofMap);
    a.isOfMap = mapFit.scatter < 0.95 * robotFit.scatter;
    const TiltFit& fit = a.isOfMap ? mapFit : robotFit;
    a.correction.tiltX = fit.x;
    a.correction.tiltY = fit.y;
    a.tiltSd = kMedianSd * fit.scatter / std::sqrt(static_cast<double>(a.scenes));
    a.pitchApart = medianOf(pitch);
    a.rollApart = medianOf(roll);
}

CloudAlignment summed(const SceneGrid& grid, std::vector<SceneContact> contacts)
{
    CloudAlignment a;
    a.contacts = std::move(contacts);
    a.scenes = a.contacts.size();
    std::vector<double> offsets, apart;
    for (const SceneContact& c : a.contacts) offsets.push_back(c.correction.offset);
    a.correction.offset = medianOf(offsets);
    for (const double o : offsets) apart.push_back(std::abs(o - a.correction.offset));
    a.scatter = kScatterPerMad * medianOf(apart);
    a.offsetSd = kMedianSd * a.scatter / std::sqrt(static_cast<double>(a.scenes));
    const double most = std::max(kOffDistance, 4.0 * a.scatter);
    for (const SceneContact& c : a.contacts)
        if (std::abs(c.correction.offset - a.correction.offset) > most) a.off.push_back(c.place);
    addTilt(grid, a);
    return a;
}

}  // namespace

std::optional<SceneContact> contactAt(const SceneGrid& grid, const RobotModel& robot,
                                      std::size_t place, const TruthRule& rule)
{
    const auto left = sideLine(grid, robot, place, Side::Left, rule);
    const auto right = sideLine(grid, robot, place, Side::Right, rule);
    if (!left || !right) return std::nullopt;
    const double roll = grid.places()[place].s.roll;
    const double yLeft = lineY(robot, TruthLine::LeftTrack, roll);
    const double yRight = lineY(robot, TruthLine::RightTrack, roll);
    const double tiltY = (left->offset - right->offset) / (yLeft - yRight);
    return SceneContact{place,
                        {.offset = left->offset - tiltY * yLeft,
                         .tiltX = 0.5 * (left->slope + right->slope),
                         .tiltY = tiltY}};
}

CloudCorrection CloudAlignment::at(double heading) const
{
    return isOfMap ? turnedTilt(correction, -heading) : correction;
}

std::optional<CloudAlignment> alignmentOf(const SceneGrid& grid, const RobotModel& robot,
                                          const TruthRule& rule)
{
    auto contacts = contactsOf(grid, robot, rule, kNearMargin);
    if (2 * contacts.size() < grid.places().size()) {
        auto wide = contactsOf(grid, robot, rule, kWideMargin);
        if (wide.size() > contacts.size()) contacts = std::move(wide);
    }
    if (contacts.empty()) return std::nullopt;
    return summed(grid, std::move(contacts));
}

}  // namespace terratact
