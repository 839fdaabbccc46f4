#include "app/modelling/simulation/simulated_recording.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "app/recording/export/mcap_writer.h"
#include "app/runtime/text_output.h"
#include "core/sim/simulated_robot.h"

namespace terratact {
namespace {

constexpr std::uint64_t kSimulatedBegin = 1'700'000'000'000'000'000;  // [ns] since 1970
constexpr std::uint64_t kSimulatedStep = 50'000'000;                  // [ns]
constexpr std::uint64_t kBetweenRuns = 60'000'000'000;                // [ns]
constexpr int kRaisedLines = 20, kPressedLines = 30;
constexpr double kRaisedFront = 0.7, kRaisedCurrent = 0.1;  // [rad], [A]

/// Held angles of the front and rear flippers [rad] on a flat floor.
constexpr std::array kHeldPoses{std::pair{0.7, 0.6},   std::pair{-0.2, 0.6},  std::pair{-0.35, 0.6},
                                std::pair{-0.5, 0.6},  std::pair{-0.65, 0.6}, std::pair{-0.8, 0.6},
                                std::pair{-0.95, 0.6}, std::pair{0.7, -0.2},  std::pair{0.7, -0.35},
                                std::pair{0.7, -0.5},  std::pair{0.7, -0.65}, std::pair{0.7, -0.8},
                                std::pair{-0.4, -0.4}, std::pair{-0.6, -0.3}, std::pair{0.7, 0.6}};
constexpr int kMovedLines = 60, kHeldLines = 40;  // of each pose: the flippers turn slowly
constexpr double kFloorTorque = 12.0;             // [N m]

constexpr const char* kAnyObject = R"({"type":"object"})";

std::string jsonOf(const std::optional<double>& value)
{
    return value ? fmt::format("{}", *value) : "null";
}

template <class Values>
std::string jsonArray(const Values& values)
{
    std::string text;
    for (const auto& value : values) text += (text.empty() ? "[" : ",") + jsonOf(value);
    return text + "]";
}

std::string jsonOf(const Eigen::Quaterniond& q)
{
    return fmt::format(R"({{"x":{},"y":{},"z":{},"w":{}}})", q.x(), q.y(), q.z(), q.w());
}

class SimulatedRecorder {
public:
    SimulatedRecorder(std::ostream& out, const RobotModel& robot)
        : robot_(robot), mcap_(out, "terratact simulate"),
          imu_(mcap_.addChannel("/imu/data", "sensor_msgs/Imu", kAnyObject)),
          joints_(mcap_.addChannel("/joint_states", "sensor_msgs/JointState", kAnyObject)),
          forces_{mcap_.addChannel("/fsr/left", "std_msgs/Float64MultiArray", kAnyObject),
                  mcap_.addChannel("/fsr/right", "std_msgs/Float64MultiArray", kAnyObject)},
          pose_(mcap_.addChannel("/map_pose", "nav_msgs/Odometry", kAnyObject))
    {
    }

    void add(const RecordedStop& stop)
    {
        if (stop.run != run_ && time_ > kSimulatedBegin) time_ += kBetweenRuns;
        run_ = stop.run;
        TwoTrackReadings raised = stop.s;
        raised.flippers[indexOf(Flipper::FrontLeft)] = kRaisedFront;
        raised.flippers[indexOf(Flipper::FrontRight)] = kRaisedFront;
        raised.currents.fill(kRaisedCurrent);
        for (auto& forces : raised.forces) forces.fill(0.0);
        for (int i = 0; i < kRaisedLines; ++i) addLine(raised, stop.base, false);
        for (int i = 0; i < kPressedLines; ++i) addLine(stop.s, stop.base, true);
    }

    void addFloorPoses(std::uint64_t seed)
    {
        time_ += kBetweenRuns;
        SimulatedRobot::Options options;
        options.seed = seed;
        SimulatedRobot sim(robot_, TerrainProfile(std::vector<Vec2>{{-3.0, 0.0}, {5.0, 0.0}}),
                           options);
        const auto run = [&](int lines) {
            for (int i = 0; i < lines; ++i) {
                sim.step(1e-9 * static_cast<double>(kSimulatedStep));
                addLine(twoTrackReadings(sim.measure()), {}, false);
            }
        };
        for (const auto& [front, rear] : kHeldPoses) {
            sim.command(HoldFlippersCommand{front, rear});
            run(kMovedLines + kHeldLines);
        }
        sim.command(PressCommand{kFloorTorque});
        run(kMovedLines + kHeldLines);
    }

    void finish() { mcap_.finish(); }

private:
    void addLine(const TwoTrackReadings& s, const CloudPose& base, bool stands)
    {
        const Eigen::Quaterniond measured = Eigen::AngleAxisd(-s.pitch, Eigen::Vector3d::UnitY())
                                          * Eigen::AngleAxisd(s.roll, Eigen::Vector3d::UnitX());
        mcap_.write(imu_, time_, fmt::format(R"({{"orientation":{}}})", jsonOf(measured)));
        PerFlipper<std::optional<double>> efforts = s.currents;
        for (auto& effort : efforts)
            if (effort) *effort *= robot_.torquePerAmpere;
        const auto& f = s.flippers;
        mcap_.write(joints_, time_,
                    fmt::format(R"({{"name":["flipper_fl","flipper_fr","flipper_rl","flipper_rr"],)"
                                R"("position":[{},{},{},{}],"effort":{}}})",
                                -f[0], -f[1], f[2], f[3], jsonArray(efforts)));
        for (const std::size_t side : {0U, 1U})
            mcap_.write(forces_.at(side), time_,
                        fmt::format(R"({{"data":{}}})", jsonArray(s.forces.at(side))));
        if (stands)
            mcap_.write(
                pose_, time_,
                fmt::format(
                    R"({{"pose":{{"pose":{{"position":{{"x":{},"y":{},"z":{}}},"orientation":{}}}}}}})",
                    base.place.x(), base.place.y(), base.place.z(), jsonOf(base.turn)));
        time_ += kSimulatedStep;
    }

    const RobotModel& robot_;
    McapWriter mcap_;
    std::uint16_t imu_, joints_;
    std::array<std::uint16_t, 2> forces_;
    std::uint16_t pose_;
    std::string run_;
    std::uint64_t time_ = kSimulatedBegin;
};

}  // namespace

Status addSimulatedRecording(FileGroup& files, const std::string& path, const RobotModel& robot,
                             const std::vector<RecordedStop>& stops, bool withFloorPoses,
                             std::uint64_t seed)
{
    auto out = TextOutput::begin(path);
    if (!out) return out.error();
    SimulatedRecorder recorder(out->stream(), robot);
    for (const RecordedStop& stop : stops) recorder.add(stop);
    if (withFloorPoses) recorder.addFloorPoses(seed);
    recorder.finish();
    return out->addTo(files);
}

}  // namespace terratact
