#include "app/modelling/robots/robot_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/robot/attitude.h"
#include "core/robot/kinematics.h"
#include "core/robot/robot_file_lines.h"
#include "core/store/file_read.h"
#include "core/terrain/bins.h"

namespace terratact {
namespace {

constexpr double kGravity = 9.81;              // [m/s²]
constexpr double kEdgeRemark = 0.003;          // [m] lower edges that should be in line
constexpr double kEdgeProblem = 0.03;          // [m]
constexpr std::size_t kMaxRobotBytes = 65536;  // as readRobotModel()

/// Collects the findings about one robot.
class RobotNumbers {
public:
    explicit RobotNumbers(const RobotModel& robot) : r_(robot) {}

    std::vector<RobotFinding> findings()
    {
        checkBase();
        checkImu();
        checkBody();
        checkFlipper(r_.front, "front_flipper", 1.0);
        checkFlipper(r_.rear, "rear_flipper", -1.0);
        if (arePivotsRight_) {
            checkFolding();
            checkSupport();
            checkTorques();
        }
        checkForces();
        checkArm();
        checkSides();
        return std::move(findings_);
    }

private:
    void add(RobotFinding::Level level, std::string key, std::string text)
    {
        findings_.push_back({level, std::move(key), std::move(text)});
    }
    void remark(std::string key, std::string text)
    {
        add(RobotFinding::Level::Remark, std::move(key), std::move(text));
    }
    void problem(std::string key, std::string text)
    {
        add(RobotFinding::Level::Problem, std::move(key), std::move(text));
    }
    /// Adds a problem or a remark about a distance from what was expected [m], if it is large.
    void byDistance(double distance, const std::string& key, const std::string& text)
    {
        if (std::abs(distance) > kEdgeProblem) problem(key, text);
        if (std::abs(distance) > kEdgeRemark && std::abs(distance) <= kEdgeProblem)
            remark(key, text);
    }
    /// Returns the height of the tracks' lower edge, base frame.
    double trackEdge() const { return r_.trackZ - r_.trackRadius; }
    double trackEnd() const { return 0.5 * r_.trackAxle + r_.trackRadius; }

    void checkBase()
    {
        const double expected = -trackEdge();
        byDistance(
            r_.baseHeight - expected, "base.height_m",
            fmt::format("is {:.4f}, expected {:.4f}: the tracks' lower edge is at "
                        "track.wheel_z_m − track.wheel_radius_m = {:.4f}; correct one of the "
                        "three",
                        r_.baseHeight, expected, trackEdge()));
    }

    void checkImu()
    {
        const double top = std::max(highest(), trackEnd()) + 0.3;
        if (r_.imu.z < trackEdge())
            problem("imu.z_m", fmt::format("is {:.3f}, below the floor at {:.3f}: z is up from the "
                                           "base's origin, not from the floor or down",
                                           r_.imu.z, trackEdge()));
        else if (std::abs(r_.imu.x) > trackEnd() || r_.imu.z > top)
            remark(std::abs(r_.imu.x) > trackEnd() ? "imu.x_m" : "imu.z_m",
                   fmt::format(
                       "puts the IMU at ({:.3f}, {:.3f}), expected |x| up to {:.3f} and z up to "
                       "{:.3f}, "
                       "on the robot: measure from the base's origin midway between the tracks",
                       r_.imu.x, r_.imu.z, trackEnd(), top));
    }

    double highest() const
    {
        double top = r_.trackZ + r_.trackRadius;
        for (const auto& polygon : r_.body)
            for (const Vec2 p : polygon) top = std::max(top, p.z);
        return top;
    }

    void checkBody()
    {
        double lowest = highest(), left = -trackEnd(), right = trackEnd();
        for (const auto& polygon : r_.body)
            for (const Vec2 p : polygon) {
                lowest = std::min(lowest, p.z);
                left = std::min(left, p.x);
                right = std::max(right, p.x);
            }
        if (lowest < trackEdge())
            problem(
                "body.polygons_m",
                fmt::format("reach down to z = {:.3f}, expected above the tracks' lower edge at "
                            "{:.3f}: the robot would stand on its body; correct the polygon or "
                            "the track",
                            lowest, trackEdge()));
        const Vec2 c = r_.bodyCom;
        if (c.z < trackEdge() || c.z > highest() || c.x < left || c.x > right)
            problem("body.com_m",
                    fmt::format("is ({:.3f}, {:.3f}), expected within the body and the tracks, x "
                                "from {:.3f} to {:.3f} and z from {:.3f} to {:.3f}: points are "
                                "(x, z) in m from the base's origin",
                                c.x, c.z, left, right, trackEdge(), highest()));
    }

    void checkFlipper(const FlipperGeometry& f, const std::string& name, double direction)
    {
        checkPivot(f, name, direction);
        const double length = f.axleDistance + f.tipRadius, track = 2.0 * trackEnd();
        if (length > track)
            remark(name + ".axle_distance_m",
                   fmt::format(
                       "is {:.3f}: the flipper is {:.3f} m from pivot to tip and longer than "
                       "the track with {:.3f} m; expected a shorter one, check for millimetres "
                       "or a misplaced decimal point",
                       f.axleDistance, length, track));
        if (f.mass > r_.bodyMass)
            remark(
                name + ".mass_kg",
                fmt::format("is {:.2f}, more than body.mass_kg {:.2f}: expected the mass of both "
                            "flippers of the axle in kg",
                            f.mass, r_.bodyMass));
        const double held = 0.5 * f.mass * kGravity * f.comDistance;
        if (held > r_.maxFlipperTorque)
            problem(
                "flipper_drive.max_torque_nm",
                fmt::format("is {:.3g}, but one flipper of [{}] held level needs {:.3g} N m: its "
                            "motor cannot lift it; correct the torque, {}.mass_kg or "
                            "{}.com_distance_m",
                            r_.maxFlipperTorque, name, held, name, name));
    }

    void checkPivot(const FlipperGeometry& f, const std::string& name, double direction)
    {
        if (f.pivot.x * direction <= 0.0) {
            arePivotsRight_ = false;
            problem(
                name + ".pivot_m",
                fmt::format("has x = {:.3f}, expected {} 0: x is forward, so {} flippers turn at "
                            "{} x; was front exchanged with rear?",
                            f.pivot.x, direction > 0.0 ? "above" : "below",
                            direction > 0.0 ? "front" : "rear",
                            direction > 0.0 ? "positive" : "negative"));
            return;
        }
        byDistance(
            f.pivot.z - f.pivotRadius - trackEdge(), name + ".pivot_radius_m",
            fmt::format("is {:.4f}, expected {:.4f}: a flipper at angle 0 lies in line with "
                        "the tracks' lower edge at {:.4f}, and its pivot is at {:.4f}; measure "
                        "the angle from there, or correct pivot_m",
                        f.pivotRadius, f.pivot.z - trackEdge(), trackEdge(), f.pivot.z));
        if (std::abs(f.pivot.x) > trackEnd())
            remark(name + ".pivot_m",
                   fmt::format("is {:.3f} m ahead of the middle, beyond the track's end at {:.3f}: "
                               "expected an axle on the track; check track.axle_distance_m, too",
                               std::abs(f.pivot.x), trackEnd()));
    }

    void checkFolding()
    {
        const double room = r_.front.pivot.x - r_.rear.pivot.x;
        const double both =
            r_.front.axleDistance + r_.rear.axleDistance + r_.front.tipRadius + r_.rear.tipRadius;
        if (room > 0.0 && both > room + r_.front.axleDistance)
            remark(
                "rear_flipper.axle_distance_m",
                fmt::format("is {:.3f}: the rear flipper folded over the track reaches {:.3f} m, "
                            "past the front pivot at {:.3f} m; expected a shorter flipper, or "
                            "never fold both",
                            r_.rear.axleDistance, r_.rear.axleDistance + r_.rear.tipRadius, room));
    }

    void checkSupport()
    {
        const TipOver flat = tipOver(r_, 0.0, 0.0), raised = tipOver(r_, 1.2, 1.2);
        const auto side = [](const TipOver& t) { return t.noseUp < 0.0 ? "rear" : "front"; };
        if (flat.noseUp <= 0.0 || flat.noseDown <= 0.0)
            problem("body.com_m",
                    fmt::format("puts the robot's centre of mass beyond the {} end of its support "
                                "with flippers flat: it would tip over on a flat floor; correct "
                                "body.com_m, or the masses of the flippers",
                                side(flat)));
        else if (raised.noseUp <= 0.0 || raised.noseDown <= 0.0)
            remark(
                "body.com_m",
                fmt::format("puts the robot's centre of mass beyond the {} end of the tracks, so "
                            "it tips over as soon as flippers are raised: expected between the "
                            "wheels; weigh the robot at both ends",
                            side(raised)));
    }

    double voltageAt(double force) const
    {
        const auto& curve = r_.forceCalibration.curve;
        double low = r_.forceCalibration.supply * 1e-6,
               high = r_.forceCalibration.supply * (1 - 1e-6);
        if (curve.size() < 2) return 0.0;
        for (int i = 0; i < 60; ++i) {
            const double v = 0.5 * (low + high);
            const double read =
                curveForce(elementResistance(v, r_.forceCalibration), r_.forceCalibration);
            (read < force ? low : high) = v;
        }
        return 0.5 * (low + high);
    }

    void checkForces()
    {
        const ForceCalibration& c = r_.forceCalibration;
        if (const double full = voltageAt(r_.forceSaturation); full > c.shortAbove)
            problem(
                "force_calibration.short_above_v",
                fmt::format("is {:.3f}, but an element at force_elements.saturation_n {:.3g} reads "
                            "{:.3f} V and would count as short: raise it, or lower reference_ohm",
                            c.shortAbove, r_.forceSaturation, full));
        double least = r_.forceSaturation;
        for (const auto* bias : {&c.biasLeft, &c.biasRight})
            for (const double b : *bias) least = std::min(least, b);
        const double rest = least > 0.0 ? voltageAt(least) : 0.0;
        if (rest < c.openBelow && c.openBelow > 0.0)
            add(least > 0.0 ? RobotFinding::Level::Problem : RobotFinding::Level::Remark,
                "force_calibration.open_below_v",
                fmt::format(
                    "is {:.3f}, but an unloaded element with a bias of {:.3g} N reads {:.3f} V "
                    "and would count as a broken wire: lower it, or measure the bias",
                    c.openBelow, least, rest));
        if (!c.curve.empty() && c.curve.back().force < r_.forceSaturation)
            remark("force_calibration.curve_n_ohm",
                   fmt::format("ends at {:.3g} N, below force_elements.saturation_n {:.3g}: forces "
                               "between are extrapolated; measure a point there",
                               c.curve.back().force, r_.forceSaturation));
    }

    void checkTorques()
    {
        const double amperes = r_.maxFlipperTorque / r_.torquePerAmpere;
        if (amperes < 0.05 || amperes > 200.0)
            remark(
                "flipper_drive.torque_per_ampere_nm",
                fmt::format("is {:.3g}: max_torque_nm {:.3g} would need {:.3g} A, expected 0.05 to "
                            "200 A; give both at the flipper's axle and in N m",
                            r_.torquePerAmpere, r_.maxFlipperTorque, amperes));
        const double needed = liftingTorque();
        if (needed > r_.maxFlipperTorque)
            remark(
                "flipper_drive.max_torque_nm",
                fmt::format("is {:.3g}, but to lift the robot's front end one motor needs {:.3g} "
                            "N m: expected at least that, or the flippers only press; check the "
                            "masses and body.com_m",
                            r_.maxFlipperTorque, needed));
    }

    /// Returns the torque of one front motor [N m] that lifts the front end on a flat floor. The flippers' tips push
    /// down and the tracks' rear wheels carry the rest.
    double liftingTorque() const
    {
        const double total = r_.totalMass(), rear = -0.5 * r_.trackAxle;
        const double arm = r_.front.axleDistance * std::cos(r_.front.taper());
        const double x =
            (r_.bodyMass * r_.bodyCom.x + r_.front.mass * (r_.front.pivot.x + r_.front.comDistance)
             + r_.rear.mass * (r_.rear.pivot.x - r_.rear.comDistance))
            / total;
        return 0.5 * total * kGravity * std::max(0.0, x - rear) / (r_.front.pivot.x + arm - rear)
             * arm;
    }

    void checkArm()
    {
        int reached = 0;
        for (int bin = 0; bin < kBins; ++bin) reached += r_.armReaches(bin) ? 1 : 0;
        if (reached == 0)
            remark(
                "arm.reach_begin_m",
                fmt::format("to arm.reach_end_m, {:.2f} to {:.2f}, holds the centre of no bin from "
                            "−0.3 to 0.7 m: the arm can probe nothing; measure x from the IMU",
                            r_.armReachBegin, r_.armReachEnd));
    }

    void checkSides()
    {
        const LateralGeometry& y = r_.lateral;
        const double outer =
            std::max(y.trackY + 0.5 * y.trackWidth, y.flipperY + 0.5 * y.flipperWidth);
        if (r_.halfWidth > outer + 1e-3)
            problem(
                "tip_over.half_width_m",
                fmt::format("is {:.3f}, expected at most {:.3f}: the outermost track or flipper "
                            "ends there; it is half of the robot's width, in m",
                            r_.halfWidth, outer));
        else if (r_.halfWidth < y.trackY - 0.5 * y.trackWidth)
            remark(
                "tip_over.half_width_m",
                fmt::format("is {:.3f}, inside of the tracks, which begin at {:.3f}: expected the "
                            "outer edge of a track",
                            r_.halfWidth, y.trackY - 0.5 * y.trackWidth));
        if (y.trackWidth > 2.0 * trackEnd())
            remark("lateral.track_width_m",
                   fmt::format(
                       "is {:.3f}, wider than the track is long, {:.3f}: expected the width of "
                       "one track",
                       y.trackWidth, 2.0 * trackEnd()));
    }

    const RobotModel& r_;
    std::vector<RobotFinding> findings_;
    bool arePivotsRight_ = true;  ///< front ahead, rear behind: the rest can be judged
};

}  // namespace

std::vector<RobotFinding> checkRobot(const RobotModel& robot)
{
    return RobotNumbers(robot).findings();
}

std::size_t RobotCheck::problems() const
{
    return static_cast<std::size_t>(
        std::count_if(findings.begin(), findings.end(), [](const RobotFinding& f) {
            return f.level == RobotFinding::Level::Problem;
        }));
}

Result<RobotCheck> checkRobotFile(const std::string& path)
{
    const auto text = readFile(path, kMaxRobotBytes);
    if (!text) return text.error();
    auto robot = robotModelFrom(path, *text);
    if (!robot) return robot.error();
    RobotCheck check{.robot = *robot, .findings = checkRobot(*robot)};
    if (lineOfKey(*text, "lateral") == 0)
        check.findings.push_back({RobotFinding::Level::Remark, "lateral",
                                  "is missing, so Absolem's distances of tracks and flippers from "
                                  "the middle are assumed: measure them (docs/robot.md)"});
    for (RobotFinding& finding : check.findings) {
        const std::size_t line = lineOfKey(*text, finding.key);
        finding.text = line == 0 ? fmt::format("{} {}", finding.key, finding.text)
                                 : fmt::format("line {}: {} {}", line, finding.key, finding.text);
    }
    return check;
}

}  // namespace terratact
