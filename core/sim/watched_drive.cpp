#include "core/sim/watched_drive.h"

#include <cmath>

namespace terratact {
namespace {

constexpr double kRoomBehind = 0.7;    // [m]
constexpr double kLongestPress = 5.0;  // [s]
constexpr double kLongestWay = 10.0;   // [s] without getting on

/// Runs one drive and keeps what the robot sends.
class Drive {
public:
    Drive(const RobotModel& robot, const TerrainProfile& terrain, const WatchedStyle& style,
          std::uint64_t seed, std::size_t most)
        : style_(style), most_(most), robot_(robot, terrain,
                                             {.startX = terrain.begin() + kRoomBehind,
                                              .rearAngle = style.flippers.rearAngle,
                                              .drivingAngle = style.flippers.drivingAngle,
                                              .noise = {},
                                              .seed = seed}),
          end_(terrain.end() - kRoomBehind)
    {
    }

    std::vector<WatchedLine> run()
    {
        while (goOn() && press()) {
        }
        return std::move(lines_);
    }

private:
    double x() const { return robot_.rest().pose.base.x; }

    /// False: the drive is over.
    bool step()
    {
        if (lines_.size() >= most_) return false;
        const RobotActivity before = robot_.activity();
        robot_.step(style_.period);
        WatchedLine line{.measurement = robot_.measure(), .truth = std::nullopt};
        if (robot_.activity() == RobotActivity::Pressed && before == RobotActivity::Pressing)
            line.truth = robot_.truth();
        lines_.push_back(line);
        return robot_.activity() != RobotActivity::Halted || before == RobotActivity::Halted;
    }

    bool goOn()
    {
        const double from = x();
        robot_.command(DriveCommand{style_.speed});
        for (double waited = 0.0; x() - from < style_.spacing; waited += style_.period) {
            if (waited > kLongestWay || x() >= end_ - 1e-6 || !step()) return false;
        }
        return true;
    }

    bool press()
    {
        robot_.command(PressCommand{style_.flippers.pressTorque});
        for (double waited = 0.0; robot_.activity() != RobotActivity::Pressed;
             waited += style_.period)
            if (waited > kLongestPress || !step()) return false;
        const long steps = std::lround(std::ceil(style_.standing / style_.period - 1e-9));
        for (long k = 0; k < steps; ++k)
            if (!step()) return false;
        return true;
    }

    WatchedStyle style_;
    std::size_t most_;
    SimulatedRobot robot_;
    double end_;
    std::vector<WatchedLine> lines_;
};

}  // namespace

std::vector<WatchedLine> driveWithTelemetry(const RobotModel& robot, const TerrainProfile& terrain,
                                            const WatchedStyle& style, std::uint64_t seed,
                                            std::size_t most)
{
    return Drive(robot, terrain, style, seed, most).run();
}

}  // namespace terratact
