#include "core/sim/way_drive.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/learn/data/two_track_scene.h"
#include "core/sim/two_track_drive.h"

namespace terratact {
namespace {

/// Settings of a drive that both kinds of ground share.
struct WaySetting {
    const RobotModel& robot;
    const DriveStyle& style;
    const WayDriveOptions& options;
    const DriveConditions& conditions;
};

/// Rest poses of a robot in one plane, and what its sensors read there.
class PlaneWay {
public:
    PlaneWay(const WaySetting& setting, const TerrainProfile& terrain)
        : setting_(setting), terrain_(terrain)
    {
    }
    const TerrainProfile& ground() const { return terrain_; }

    Result<RestPose> rest(double x, const FlipperDrive& front) const
    {
        return restPose(setting_.robot, terrain_, x, front, HoldAngle{setting_.style.rearAngle},
                        pitch_, setting_.conditions.ground);
    }
    void continueFrom(const RestPose& rest) { pitch_ = rest.pose.pitch; }
    static Pose base(const RestPose& rest) { return rest.pose; }

    Measurement read(const RestPose& rest, std::mt19937_64& rng) const
    {
        const RobotModel& robot = setting_.robot;
        const Proprioception s = noisy(exactReadings(robot, rest), setting_.conditions.noise,
                                       robot.forceSaturation, rng);
        return measurementOf(onBothSides(Scene{.run = {}, .time = 0.0, .s = s, .truth = {}}).s);
    }
    std::array<OptionalHeights, 2> truth(const RestPose& rest, std::mt19937_64& rng) const
    {
        const Heights heights = binHeights(terrain_, imuPosition(setting_.robot, rest.pose));
        const OptionalHeights seen = known(noisy(heights, setting_.conditions.noise, rng));
        return {seen, seen};
    }

private:
    const WaySetting& setting_;
    const TerrainProfile& terrain_;
    double pitch_ = 0.0;
};

/// The same of a robot with two tracks.
class TracksWay {
public:
    TracksWay(const WaySetting& setting, const GroundLines& terrain)
        : setting_(setting), terrain_(terrain)
    {
    }
    const GroundLines& ground() const { return terrain_; }

    Result<TwoTrackRest> rest(double x, const FlipperDrive& front) const
    {
        return restPose(setting_.robot, terrain_, x,
                        flipperDrives(front, HoldAngle{setting_.style.rearAngle}), start_,
                        setting_.conditions.ground);
    }
    void continueFrom(const TwoTrackRest& rest) { start_ = {rest.pose.pitch, rest.pose.roll}; }
    /// Returns the pose of the base: its way is the mean of both tracks' ways.
    static Pose base(const TwoTrackRest& rest)
    {
        return {.base = rest.pose.base, .pitch = rest.pose.pitch};
    }

    Measurement read(const TwoTrackRest& rest, std::mt19937_64& rng) const
    {
        const RobotModel& robot = setting_.robot;
        return measurementOf(noisy(exactReadings(robot, rest), setting_.conditions.noise,
                                   robot.forceSaturation, rng));
    }
    std::array<OptionalHeights, 2> truth(const TwoTrackRest& rest, std::mt19937_64& rng) const
    {
        std::array<OptionalHeights, 2> both;
        const Vec2 imu = imuPosition(setting_.robot, rest.pose);
        for (const Side side : {Side::Left, Side::Right})
            both[indexOf(side)] = known(noisy(sideHeights(terrain_, setting_.robot, side, imu),
                                              setting_.conditions.noise, rng));
        return both;
    }

private:
    const WaySetting& setting_;
    const GroundLines& terrain_;
    RestStart start_;
};

/// One drive along its stops.
template <class Way>
class WayDrive {
public:
    WayDrive(const WaySetting& setting, Way way, std::mt19937_64& rng)
        : setting_(setting), way_(std::move(way)), rng_(rng)
    {
    }

    /// Returns the lines; `skipped` grows by the stops that have no rest pose.
    std::vector<DriveLine> along(const std::vector<double>& stops, int& skipped)
    {
        x_ = stops.front();
        drawCommonSlip();
        drawSlip();
        for (const double stop : stops) {
            const bool rests = driveTo(stop);
            if (std::uniform_real_distribution<double>()(rng_) < setting_.options.pressShare
                && !(rests && press(stop)))
                ++skipped;
            drawSlip();
        }
        return std::move(lines_);
    }

private:
    /// Draws the slip common to the drive from a seed of its own: the other draws do not change.
    void drawCommonSlip()
    {
        std::mt19937_64 copy = rng_;
        std::mt19937_64 own(~copy());
        commonSlip_ = setting_.options.driveSlip * std::normal_distribution<double>()(own);
    }

    void drawSlip()
    {
        slip_ = setting_.options.slipShare * std::normal_distribution<double>()(rng_);
    }

    /// Adds the lines behind x_ up to the stop. Returns true if the robot rests at the stop.
    bool driveTo(double stop)
    {
        const double from = x_;
        const double way = stop - from;
        const auto steps = std::max(1L, std::lround(std::ceil(way / setting_.options.step - 1e-9)));
        bool rests = false;
        for (long k = 1; k <= steps; ++k)
            rests = stepTo(k == steps
                               ? stop
                               : from + way * static_cast<double>(k) / static_cast<double>(steps));
        return rests;
    }

    bool stepTo(double x)
    {
        time_ += (x - x_) / kDriveSpeed;
        x_ = x;
        const auto rest = way_.rest(x, HoldAngle{setting_.style.drivingAngle});
        if (!rest) return false;
        way_.continueFrom(*rest);
        const Pose base = Way::base(*rest);
        if (last_) travelled_ += (1.0 + commonSlip_) * (1.0 + slip_) * trackWay(*last_, base);
        last_ = base;
        add(*rest, RobotActivity::Driving);
        return true;
    }

    bool press(double x)
    {
        const double torque = setting_.options.pressTorque > 0.0 ? setting_.options.pressTorque
                                                                 : setting_.style.pressTorque;
        const auto rest = way_.rest(x, PressTorque{torque});
        if (!rest) return false;
        time_ += kPressingTime;
        add(*rest, RobotActivity::Pressed);
        lines_.back().isScene = true;
        lines_.back().truth = way_.truth(*rest, rng_);
        time_ += kRaisingTime;
        return true;
    }

    void add(const auto& rest, RobotActivity activity)
    {
        Measurement line = way_.read(rest, rng_);
        line.time = time_;
        line.pitch += setting_.options.pitchBias;
        line.activity = activity;
        line.travelled = travelled_;
        line.turned = 0.0;
        lines_.push_back({.line = line});
    }

    const WaySetting& setting_;
    Way way_;
    std::mt19937_64& rng_;
    std::vector<DriveLine> lines_;
    double x_ = 0.0, time_ = 0.0, travelled_ = 0.0, slip_ = 0.0, commonSlip_ = 0.0;
    std::optional<Pose> last_;
};

/// Erases the lines of a random interval.
void loseTelemetry(std::vector<DriveLine>& lines, double gap, std::mt19937_64& rng)
{
    if (!(gap > 0.0) || lines.empty()) return;
    const double first = lines.front().line.time;
    const double last = std::max(first, lines.back().line.time - gap);
    const double begin = std::uniform_real_distribution<double>(first, last)(rng);
    std::erase_if(lines, [&](const DriveLine& line) {
        return line.line.time >= begin && line.line.time < begin + gap;
    });
}

void check(const WayDriveOptions& options, const DriveConditions& conditions)
{
    const auto isAtLeast0 = [](double x) { return x >= 0.0 && std::isfinite(x); };
    if (!isAtLeast0(options.spacing) || !isAtLeast0(options.slipShare)
        || !isAtLeast0(options.driveSlip) || !isAtLeast0(options.pressTorque)
        || !isAtLeast0(options.gap) || !std::isfinite(options.pitchBias) || !(options.step > 0.0)
        || !(options.pressShare >= 0.0 && options.pressShare <= 1.0))
        throw std::invalid_argument("driveWay: an option is beyond its range");
    if (conditions.reading || conditions.rested || conditions.slide > 0.0)
        throw std::invalid_argument("driveWay: only noise and ground may be set");
}

template <class Way>
std::vector<DriveLine> linesOfDrive(const WaySetting& setting, Way way, std::mt19937_64& rng,
                                    int& skipped)
{
    const WayDriveOptions& options = setting.options;
    check(options, setting.conditions);
    const double spacing =
        options.spacing > 0.0
            ? options.spacing
            : std::uniform_real_distribution<double>(kMinWaySpacing, kMaxWaySpacing)(rng);
    const std::vector<double> stops = stopsOver(way.ground(), spacing);
    std::vector<DriveLine> lines =
        WayDrive<Way>(setting, std::move(way), rng).along(stops, skipped);
    loseTelemetry(lines, options.gap, rng);
    return lines;
}

}  // namespace

DriveLines driveWay(const RobotModel& robot, const TerrainProfile& terrain, const std::string& run,
                    const DriveStyle& style, const WayDriveOptions& options,
                    const DriveConditions& conditions, std::mt19937_64& rng, int& skipped)
{
    const WaySetting setting{robot, style, options, conditions};
    return {.run = run,
            .onePlane = true,
            .lines = linesOfDrive(setting, PlaneWay(setting, terrain), rng, skipped)};
}

DriveLines driveWay(const RobotModel& robot, const GroundLines& terrain, const std::string& run,
                    const DriveStyle& style, const WayDriveOptions& options,
                    const DriveConditions& conditions, std::mt19937_64& rng, int& skipped)
{
    const WaySetting setting{robot, style, options, conditions};
    return {.run = run,
            .onePlane = false,
            .lines = linesOfDrive(setting, TracksWay(setting, terrain), rng, skipped)};
}

}  // namespace terratact
