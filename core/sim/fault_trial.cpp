#include "core/sim/fault_trial.h"

#include <array>
#include <stdexcept>

#include "core/robot/watch/sensor_watch.h"
#include "core/sim/sensor_fault.h"

namespace terratact {
namespace {

constexpr std::string_view kTilt = "a tilt of the whole world agrees with every other sensor until "
                                   "the robot comes back: compare on level ground";
constexpr std::string_view kSmallAngle = "a few degrees are less than the ground under the tracks "
                                         "tells: lay the flippers flat on a floor";
constexpr std::string_view kNeedsFeltGround =
    "the tracks must first pass ground that several presses felt";
constexpr std::string_view kTooLow =
    "an angle that is too small looks like hollow ground: lay the flippers flat on a floor";
constexpr std::string_view kNearTracks =
    "within 11° of the tracks both signs fit the ground: lay the flippers flat on a floor";
constexpr std::string_view kAlike =
    "left and right are moved together, and the estimate uses their mean";
constexpr std::string_view kElement =
    "most presses load one element beyond its range, and its like carry nothing";
constexpr std::string_view kLightly =
    "the flipper often rests with less current than this looks for";
constexpr std::string_view kAsLoaded = "rear flippers may carry as much as the front ones press";
constexpr std::string_view kDirection =
    "telemetry does not say which way the robot was told to drive";

constexpr std::array kTried{
    TriedFault{"", "none", ""},
    TriedFault{"stuck-at-scene:pitch", "pitch stuck at the last stop", ""},
    TriedFault{"stuck:pitch", "pitch stuck since the start", ""},
    TriedFault{"zero:pitch", "pitch stuck at 0", ""},
    TriedFault{"offset:pitch:0.0524", "pitch +3°", kTilt},
    TriedFault{"offset:pitch:-0.0524", "pitch -3°", kTilt},
    TriedFault{"drift:pitch:0.1", "pitch drifts 6° a minute", kTilt},
    TriedFault{"flipped:pitch", "pitch sign flipped", ""},
    TriedFault{"spikes:pitch:0.349", "pitch ±20° in one line of four", ""},
    TriedFault{"scatter:pitch:0.349", "pitch ±20° in every line", ""},
    TriedFault{"late:pitch", "pitch 0.5 s late", ""},
    TriedFault{"out-of-range:pitch", "pitch out of range", ""},
    TriedFault{"stuck:roll", "roll stuck", ""},
    TriedFault{"spikes:roll:0.349", "roll ±20° in one line of four", ""},
    TriedFault{"out-of-range:roll", "roll out of range", ""},
    TriedFault{"offset:roll:0.0524", "roll +3°", kTilt},
    TriedFault{"stuck:front", "both front angles stuck", ""},
    TriedFault{"stuck:front-left", "left front angle stuck", ""},
    TriedFault{"late:front", "both front angles 0.5 s late", ""},
    TriedFault{"flipped:front", "both front angles' sign flipped", ""},
    TriedFault{"spikes:front", "front angles ±10° in one line of four", ""},
    TriedFault{"offset:front:0.1745", "both front angles +10°", ""},
    TriedFault{"drift:front:0.1", "both front angles drift 6° a minute", kSmallAngle},
    TriedFault{"offset:front-left:0.1745", "left front angle +10°", ""},
    TriedFault{"offset:front-left:0.0873", "left front angle +5°", ""},
    TriedFault{"swapped:front", "front angles' sides swapped", kAlike},
    TriedFault{"swapped-axles:angles", "front and rear angles swapped", ""},
    TriedFault{"stuck:rear", "both rear angles stuck", ""},
    TriedFault{"spikes:rear", "rear angles ±10° in one line of four", ""},
    TriedFault{"offset:rear:-0.1745", "both rear angles -10°", kTooLow},
    TriedFault{"flipped:rear", "both rear angles' sign flipped", kNearTracks},
    TriedFault{"zero:currents", "currents zero", ""},
    TriedFault{"stuck:currents", "currents stuck", ""},
    TriedFault{"flipped:currents", "currents' sign flipped", ""},
    TriedFault{"late:currents", "currents 0.5 s late", ""},
    TriedFault{"zero:front-left-current", "one front current zero", ""},
    TriedFault{"out-of-range:rear-left-current", "one rear current out of range", ""},
    TriedFault{"flipped:rear-current", "rear currents' sign flipped", kLightly},
    TriedFault{"swapped-axles:currents", "front and rear currents swapped", kAsLoaded},
    TriedFault{"spikes:currents:3", "currents ±3 A in one line of four", ""},
    TriedFault{"zero:forces", "forces zero", ""},
    TriedFault{"stuck:forces", "forces stuck", ""},
    TriedFault{"offset:forces:3", "forces +3 N", ""},
    TriedFault{"drift:forces:3", "forces drift 3 N a minute", ""},
    TriedFault{"late:forces", "forces 0.5 s late", ""},
    TriedFault{"full-scale:force-6", "element 6 saturated", ""},
    TriedFault{"offset:force-3:3", "element 3 +3 N", ""},
    TriedFault{"zero:force-6", "element 6 zero", kElement},
    TriedFault{"swapped:forces", "forces in the reverse order", kNeedsFeltGround},
    TriedFault{"zero:left-forces", "left forces zero", ""},
    TriedFault{"swapped:left-forces", "left forces in the reverse order", ""},
    TriedFault{"zero:left-force-6", "left element 6 zero", ""},
    TriedFault{"full-scale:left-force-6", "left element 6 saturated", ""},
    TriedFault{"offset:left-force-3:3", "left element 3 +3 N", ""},
    TriedFault{"late:left-force-6", "left element 6 0.5 s late", ""},
    TriedFault{"spikes:left-force-3:10", "left element 3 ±10 N in one line of four", ""},
    TriedFault{"stuck:odometry", "odometry stuck", ""},
    TriedFault{"late:odometry", "odometry 0.5 s late", ""},
    TriedFault{"spikes:odometry", "odometry ±1 m in one line of four", ""},
    TriedFault{"flipped:odometry", "odometry's sign flipped", kDirection},
    TriedFault{"late:all", "everything 0.5 s late", ""},
};

OptionalHeights knownHeights(const Heights& heights)
{
    OptionalHeights result;
    for (std::size_t i = 0; i < heights.size(); ++i) result[i] = heights[i];
    return result;
}

}  // namespace

std::span<const TriedFault> triedFaults()
{
    return kTried;
}

WatchedFault watchFault(std::span<const WatchedLine> drive, const RobotModel& robot,
                        std::string_view text, std::size_t number)
{
    const std::optional<SensorFault> fault = sensorFaultFrom(text);
    if (!fault && !text.empty()) throw std::invalid_argument("watchFault: no such fault");
    std::optional<FaultySensors> faulty;
    if (fault) faulty.emplace(*fault, robot, number);
    WatchedFault watched;
    SensorWatch watch(robot);
    for (const WatchedLine& line : drive) {
        const Measurement m = faulty ? faulty->apply(line.measurement) : line.measurement;
        watch.add(m);
        if (line.truth)
            watched.scenes.push_back({.scene = {.run = std::to_string(number + 1),
                                                .time = m.time,
                                                .s = proprioception(m),
                                                .truth = knownHeights(*line.truth)},
                                      .measurement = m});
        if (watch.standing().empty()) continue;
        if (!watched.noticed) {
            watched.noticed = m.time;
            watched.scenesUntilNoticed = watched.scenes.size();
            watched.first = watch.standing();
        }
        if (m.activity == RobotActivity::Pressed && !watched.scenes.empty())
            watched.scenes.back().isSuspect = true;
    }
    return watched;
}

}  // namespace terratact
