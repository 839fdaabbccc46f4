#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/robot/watch/sensor.h"

namespace terratact {

/// What makes a reading doubtful.
enum class SensorTrouble : std::uint8_t {
    Stuck,         ///< does not change while the robot moves, or while its like have noise
    Spikes,        ///< jumps away and back
    OutOfRange,    ///< beyond what the robot can do
    Flipped,       ///< has the wrong sign
    SwappedAxles,  ///< front and rear are exchanged
    Late,          ///< still changes when all movement has ended
    NoLoad,        ///< feels nothing although the flippers press
    LoadedFree,    ///< feels a load although nothing can press on it
    SidesDiffer,   ///< left and right differ by the same amount at every press
    OffGround,     ///< does not fit the ground that the tracks have driven over
    WrongOrder,    ///< the force elements are counted from the wrong end
    BothWays,      ///< differs on the same ground in both directions
};
inline constexpr int kSensorTroubles = 12;

struct SensorSuspicion {
    Sensor sensor = Sensor::Pitch;
    SensorTrouble trouble = SensorTrouble::Stuck;
    double since = 0.0;   ///< [s] of the telemetry: first evidence
    double until = 0.0;   ///< [s] stands up to that time without more evidence
    double amount = 0.0;  ///< [s] of Stuck; else the reading or the change, in the sensor's unit
    double way = 0.0;     ///< [m] of Stuck: driven meanwhile
    bool operator==(const SensorSuspicion&) const = default;
};

/// What is wrong, without the sensor: "not changed for 12 s while the robot drove 0.6 m, stuck?".
std::string describeTrouble(const SensorSuspicion& suspicion);

/// One sentence: "pitch angle: not changed for 12 s while the robot drove 0.6 m, stuck?".
std::string describe(const SensorSuspicion& suspicion);

}  // namespace terratact
