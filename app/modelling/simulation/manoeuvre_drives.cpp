#include "app/modelling/simulation/manoeuvre_drives.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/named.h"
#include "core/robot/kinematics.h"
#include "core/sim/drive.h"
#include "core/sim/ground/random_draw.h"
#include "core/sim/ground/random_ground.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/rest/two_track_rest.h"
#include "core/sim/two_track_drive.h"
#include "core/sim/way_drive.h"

namespace terratact {
namespace {

constexpr auto kManoeuvreNames = namesOf<Manoeuvre>("curve", "turn", "reverse", "probe", "mixed");

constexpr double kBehindRobot = -1.0;             // [m] where the ground that a pose needs begins
constexpr double kCut = 0.01;                     // [m] between two points of a line
constexpr int kCuts = 270;                        // to 1.7 m ahead
constexpr double kStop = 0.1, kOnTheWay = 0.033;  // [m]
constexpr double kTurnStep = 0.05;                // [rad] between two lines
constexpr double kTurnSpeed = 0.3;                // [rad/s]
constexpr double kPast = 0.6;                     // [m] driven behind a hazard's range
constexpr int kMaxStops = 60;
constexpr double kArmDepth = 0.8;  // [m] below the IMU: deeper ground is beyond the arm's reach
constexpr double kBendPerStop = 0.031;  // [rad] 0.1 rad within 0.3 m ends the memory

/// Ground known at every place: lines of roughness, and a hazard where y is beyond an edge.
class PlaneGround {
public:
    PlaneGround(const RobotModel& robot, const HazardGround& ground, std::optional<Hazard> hazard,
                std::mt19937_64& rng)
        : lines_(hazardLines(robot, ground, std::nullopt, true, rng)),
          hazard_(hazard ? randomHazardTerrain(*hazard, 0.0, rng)
                         : flatTerrain(kRandomTerrainLength)),
          side_(whole(rng, 0, 1) == 0 ? 1.0 : -1.0)
    {
        const bool isAcross = whole(rng, 0, 1) == 0;
        edge_ = isAcross ? -10.0 : uniform(rng, 0.1, 0.5);
    }
    double heightAt(double x, double y) const
    {
        const double rough = lines_.under(y).heightAt(x);
        return side_ * y > edge_ ? rough + hazard_.heightAt(x) : rough;
    }
    double side() const { return side_; }  ///< +1: a hazard beside the way is at the left

private:
    GroundLines lines_;
    TerrainProfile hazard_;
    double side_, edge_ = 0.0;
};

struct PlanePose {
    double x = 0.0, y = 0.0, heading = 0.0;
};

/// Drives by commands, and keeps lines and scenes.
class ScriptedDrive {
public:
    ScriptedDrive(const RobotModel& robot, const PlaneGround& ground, const DriveStyle& style,
                  const DriveConditions& conditions, std::mt19937_64& rng)
        : robot_(robot), ground_(ground), style_(style), conditions_(conditions), rng_(rng),
          ys_(groundYs(robot))
    {
        pose_.x = uniform(rng, kHazardBegin - 1.4, kHazardBegin - 1.0);
        drawSlip();
        (void)settle(0.0);
    }

    bool isDone() const { return isLost_ || pose_.x > kHazardEnd + kPast; }
    const PlanePose& pose() const { return pose_; }
    std::vector<ManoeuvreLine> take() { return std::move(lines_); }

    /// Drives `way` [m], back if negative, while the heading changes by `bend` [rad].
    void drive(double way, double bend)
    {
        drawSlip();
        const auto steps = std::max(1L, std::lround(std::abs(way) / kOnTheWay));
        for (long k = 0; k < steps && !isLost_; ++k) {
            const double ds = way / static_cast<double>(steps);
            const double turn = bend / static_cast<double>(steps);
            pose_.heading += 0.5 * turn;
            pose_.x += ds * std::cos(pose_.heading);
            pose_.y += ds * std::sin(pose_.heading);
            pose_.heading += 0.5 * turn;
            turned_ += read(turn);
            time_ += std::abs(ds) / kDriveSpeed;
            (void)settle(ds);
        }
    }

    void turn(double angle)
    {
        const auto steps = std::max(1L, std::lround(std::ceil(std::abs(angle) / kTurnStep)));
        for (long k = 0; k < steps && !isLost_; ++k) {
            const double part = angle / static_cast<double>(steps);
            pose_.heading += part;
            turned_ += read(part);
            time_ += std::abs(part) / kTurnSpeed;
            (void)settle(0.0);
        }
    }

    /// Presses; probes: the arm measures bins ahead then.
    void press(bool probes)
    {
        if (isLost_) return;
        const GroundLines lines = linesHere();
        const auto rest = restAt(lines, PressTorque{style_.pressTorque});
        if (!rest) return;
        time_ += kPressingTime;
        add(*rest, RobotActivity::Pressed);
        ManoeuvreLine& scene = lines_.back();
        scene.driven.isScene = true;
        const Vec2 imu = imuPosition(robot_, rest->pose);
        for (const Side side : {Side::Left, Side::Right})
            scene.driven.truth[indexOf(side)] =
                known(noisy(sideHeights(lines, robot_, side, imu), conditions_.noise, rng_));
        if (probes) probe(scene, lines, imu);
        time_ += kRaisingTime;
    }

private:
    void drawSlip() { slip_ = 0.10 * std::normal_distribution<double>()(rng_); }

    double read(double turn)
    {
        return turn * (1.0 + 0.02 * std::normal_distribution<double>()(rng_));
    }

    GroundLines linesHere() const
    {
        std::vector<GroundLine> lines;
        lines.reserve(ys_.size());
        const double c = std::cos(pose_.heading), s = std::sin(pose_.heading);
        for (const double y : ys_) {
            std::vector<Vec2> points;
            points.reserve(kCuts);
            for (int i = 0; i < kCuts; ++i) {
                const double x = kBehindRobot + i * kCut;
                points.push_back(
                    {x, ground_.heightAt(pose_.x + x * c - y * s, pose_.y + x * s + y * c)});
            }
            lines.push_back({y, TerrainProfile(std::move(points))});
        }
        return GroundLines(std::move(lines));
    }

    Result<TwoTrackRest> restAt(const GroundLines& lines, const FlipperDrive& front) const
    {
        return restPose(robot_, lines, 0.0, flipperDrives(front, HoldAngle{style_.rearAngle}),
                        start_, conditions_.ground);
    }

    /// Lets the robot come to rest where it has been driven to, and adds a line. way: [m] seen from above.
    bool settle(double way)
    {
        const auto rest = restAt(linesHere(), HoldAngle{style_.drivingAngle});
        isLost_ = !rest;
        if (isLost_) return false;
        start_ = {rest->pose.pitch, rest->pose.roll};
        const double rise = way == 0.0 || !height_ ? 0.0 : rest->pose.base.z - *height_;
        height_ = rest->pose.base.z;
        travelled_ += (1.0 + slip_) * std::copysign(std::hypot(way, rise), way);
        add(*rest, RobotActivity::Driving);
        return true;
    }

    void add(const TwoTrackRest& rest, RobotActivity activity)
    {
        Measurement line = measurementOf(
            noisy(exactReadings(robot_, rest), conditions_.noise, robot_.forceSaturation, rng_));
        line.time = time_;
        line.activity = activity;
        line.travelled = travelled_;
        line.turned = turned_ + 0.002 * std::normal_distribution<double>()(rng_);
        lines_.push_back({.driven = {.line = line}});
    }

    void probe(ManoeuvreLine& scene, const GroundLines& lines, const Vec2& imu)
    {
        for (const Side side : {Side::Left, Side::Right})
            for (int bin = whole(rng_, kFirstAhead + 1, kBins - 1); bin < kBins; ++bin) {
                const double y = signOf(side) * robot_.lateral.flipperY;
                const double z = lines.under(y).heightAt(imu.x + binCentre(bin)) - imu.z;
                if (z < -kArmDepth) continue;
                ArmReading reading{.bin = bin};
                reading.height = z + 0.01 * std::normal_distribution<double>()(rng_);
                reading.side = side == Side::Left ? ProbeSide::Left : ProbeSide::Right;
                scene.arm.push_back(reading);
            }
    }

    const RobotModel& robot_;
    const PlaneGround& ground_;
    const DriveStyle& style_;
    const DriveConditions& conditions_;
    std::mt19937_64& rng_;
    std::vector<double> ys_;
    std::vector<ManoeuvreLine> lines_;
    PlanePose pose_;
    RestStart start_;
    std::optional<double> height_;
    double time_ = 0.0, travelled_ = 0.0, turned_ = 0.0, slip_ = 0.0;
    bool isLost_ = false;
};

/// Gives the commands between two presses.
class Script {
public:
    Script(Manoeuvre manoeuvre, double towards, std::mt19937_64& rng)
        : manoeuvre_(manoeuvre), bend_(towards * kBendPerStop), rng_(rng)
    {
    }

    void goOn(ScriptedDrive& drive)
    {
        const bool isMixed = manoeuvre_ == Manoeuvre::Mixed;
        if ((isMixed || manoeuvre_ == Manoeuvre::Reverse) && happens(0.2)) reverse(drive);
        if ((isMixed || manoeuvre_ == Manoeuvre::Turn) && happens(isMixed ? 0.15 : 0.25))
            turn(drive);
        const bool bends = manoeuvre_ == Manoeuvre::Curve || (isMixed && happens(0.5));
        if (bends && (happens(0.1) || std::abs(drive.pose().heading) > 0.4)) bend_ = -bend_;
        drive.drive(kStop, bends ? bend_ : 0.0);
        drive.press((isMixed || manoeuvre_ == Manoeuvre::Probe) && happens(0.5));
    }

private:
    bool happens(double share) { return std::uniform_real_distribution<double>()(rng_) < share; }

    void reverse(ScriptedDrive& drive)
    {
        const int stops = whole(rng_, 1, 5);
        for (int k = 0; k < stops; ++k) {
            drive.drive(-kStop, 0.0);
            if (happens(0.5)) drive.press(false);
        }
        for (int k = 0; k + 1 < stops; ++k) {
            drive.drive(kStop, 0.0);
            drive.press(false);
        }
    }

    void turn(ScriptedDrive& drive)
    {
        const double angle = (happens(0.5) ? 1.0 : -1.0) * uniform(rng_, 0.02, 0.5);
        drive.turn(angle);
        drive.press(false);
        if (!happens(0.7)) return;
        drive.turn(-angle);
        drive.press(false);
    }

    Manoeuvre manoeuvre_;
    double bend_;
    std::mt19937_64& rng_;
};

}  // namespace

std::string_view name(Manoeuvre manoeuvre)
{
    return nameIn(kManoeuvreNames, manoeuvre);
}

std::vector<ManoeuvreLine> driveManoeuvre(const RobotModel& robot, const HazardGround& ground,
                                          std::optional<Hazard> hazard, Manoeuvre manoeuvre,
                                          std::mt19937_64& rng)
{
    const PlaneGround plane(robot, ground, hazard, rng);
    DriveConditions conditions;
    conditions.noise.height = 0.0;
    if (ground.isSoft) conditions.ground = randomSoftGround(rng);
    const DriveStyle style = whole(rng, 0, 1) == 0 ? randomDriveStyle(rng) : DriveStyle{};
    ScriptedDrive drive(robot, plane, style, conditions, rng);
    Script script(manoeuvre, plane.side(), rng);
    for (int stop = 0; stop < kMaxStops && !drive.isDone(); ++stop) script.goOn(drive);
    return drive.take();
}

}  // namespace terratact
