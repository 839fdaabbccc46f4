#include "core/sim/watched_drive.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/robot/kinematics.h"

namespace terratact {
namespace {

constexpr double kRoomBehind = 0.7;  // [m]
constexpr double kMaxPress = 5.0;    // [s]
constexpr double kMaxWay = 10.0;     // [s] without progress
constexpr double kAtAngle = 1e-6;    // [rad]

/// Runs one drive and keeps the lines that the robot sends.
class Drive {
public:
    Drive(const RobotModel& robot, const TerrainProfile& terrain, double startX,
          const WatchedStyle& style, std::uint64_t seed, std::size_t most)
        : style_(style), most_(most), model_(robot),
          robot_(robot, terrain,
                 {.startX = startX,
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
        return std::exchange(lines_, {});
    }

    /// Raises the front flippers while the tracks rest.
    std::vector<WatchedLine> raise()
    {
        robot_.command(DriveCommand{0.0});
        const double high = style_.flippers.drivingAngle - kAtAngle;
        for (double waited = 0.0; robot_.pose().front < high && waited <= kMaxWay;
             waited += style_.period)
            if (!step()) break;
        return std::exchange(lines_, {});
    }

    double x() const { return robot_.pose().base.x; }
    double pitch() const { return robot_.pose().pitch; }
    WatchedLine sense()
    {
        return {.measurement = robot_.measure(),
                .truth = std::nullopt,
                .imu = imuPosition(model_, robot_.pose())};
    }

private:
    /// Returns false once the drive is over.
    bool step()
    {
        if (lines_.size() >= most_) return false;
        const RobotActivity before = robot_.activity();
        robot_.step(style_.period);
        WatchedLine line = sense();
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
            if (waited > kMaxWay || x() >= end_ - 1e-6 || !step()) return false;
        }
        return true;
    }

    bool press()
    {
        robot_.command(PressCommand{style_.flippers.pressTorque});
        for (double waited = 0.0; robot_.activity() != RobotActivity::Pressed;
             waited += style_.period)
            if (waited > kMaxPress || !step()) return false;
        const long steps = std::lround(std::ceil(style_.standing / style_.period - 1e-9));
        for (long k = 0; k < steps; ++k)
            if (!step()) return false;
        return true;
    }

    WatchedStyle style_;
    std::size_t most_;
    RobotModel model_;
    SimulatedRobot robot_;
    double end_;
    std::vector<WatchedLine> lines_;
};

/// Returns the same ground for a robot with the opposite heading: x → begin + end − x.
TerrainProfile turnedRound(const TerrainProfile& terrain)
{
    std::vector<Vec2> points = terrain.points();
    std::reverse(points.begin(), points.end());
    for (Vec2& p : points) p.x = terrain.begin() + terrain.end() - p.x;
    return TerrainProfile(std::move(points));
}

void append(std::vector<WatchedLine>& lines, std::vector<WatchedLine> more)
{
    const Measurement last = lines.back().measurement;
    for (WatchedLine& line : more) {
        Measurement& m = line.measurement;
        m.time += last.time;
        m.travelled = m.travelled.value_or(0.0) + last.travelled.value_or(0.0);
        m.turned = last.turned;
        lines.push_back(line);
    }
}

/// Returns the lines of a turn. The pitch at heading ψ, with θ and θ' at both ends of the turn:
///   ½ θ (1 + cos ψ) + ½ θ' (1 − cos ψ)
std::vector<WatchedLine> turning(Drive& out, Drive& back, double period, const Measurement& last)
{
    std::vector<WatchedLine> lines;
    const long count = std::lround(kTurning / period);
    for (long k = 1; k <= count; ++k) {
        const double turned =
            std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
        const double share = (1.0 - std::cos(turned)) / 2.0;
        Drive& at = share < 0.5 ? out : back;
        WatchedLine line = at.sense();
        Measurement& m = line.measurement;
        m.pitch += (1.0 - share) * out.pitch() + share * back.pitch() - at.pitch();
        m.time = last.time + static_cast<double>(k) * period;
        m.travelled = last.travelled;
        m.turned = turned;
        m.activity = RobotActivity::Driving;
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

double wayBack(const std::vector<WatchedLine>& drive)
{
    double way = 0.0;
    for (std::size_t k = 1; k < drive.size(); ++k) {
        const Measurement &before = drive[k - 1].measurement, &now = drive[k].measurement;
        if (std::abs(before.turned.value_or(0.0)) > std::numbers::pi / 2.0)
            way += now.travelled.value_or(0.0) - before.travelled.value_or(0.0);
    }
    return way;
}

std::vector<WatchedLine> driveWithTelemetry(const RobotModel& robot, const TerrainProfile& terrain,
                                            const WatchedStyle& style, std::uint64_t seed,
                                            std::size_t most)
{
    Drive out(robot, terrain, terrain.begin() + kRoomBehind, style, seed, most);
    std::vector<WatchedLine> lines = out.run();
    if (!style.comesBack) return lines;
    const std::vector<WatchedLine> raised = out.raise();
    lines.insert(lines.end(), raised.begin(), raised.end());
    const double startX = terrain.begin() + terrain.end() - out.x();
    if (lines.empty()) return lines;
    Drive back(robot, turnedRound(terrain), startX, style, ~seed, most);
    const std::vector<WatchedLine> turned =
        turning(out, back, style.period, lines.back().measurement);
    lines.insert(lines.end(), turned.begin(), turned.end());
    append(lines, back.run());
    if (lines.size() > most) lines.resize(most);
    return lines;
}

}  // namespace terratact
