#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/robot/watch/sensor.h"

namespace terratact {

/// Fault that makes a reading doubtful.
enum class SensorTrouble : std::uint8_t {
    Stuck,         ///< does not change while the robot moves, or while similar sensors show noise
    Spikes,        ///< jumps away and back
    OutOfRange,    ///< is beyond what the robot can do
    Flipped,       ///< has the wrong sign
    SwappedAxles,  ///< front and rear are exchanged
    Late,          ///< still changes after all movement has ended
    NoLoad,        ///< feels nothing although the flippers press
    LoadedFree,    ///< feels a load although nothing can press on it
    SidesDiffer,   ///< left and right differ by the same amount at every press
    OffGround,     ///< contradicts the ground that the tracks have driven over
    WrongOrder,    ///< the force elements are counted from the wrong end
    BothWays,      ///< differs between the two directions on the same ground
};
inline constexpr int kSensorTroubles = 12;

struct SensorSuspicion {
    Sensor sensor = Sensor::Pitch;
    SensorTrouble trouble = SensorTrouble::Stuck;
    double since = 0.0;  ///< telemetry time of the first evidence [s]
    double until = 0.0;  ///< time at which the suspicion ends without further evidence [s]
    /// Duration of Stuck [s]; else the reading or the change, in the sensor's unit.
    double amount = 0.0;
    double way = 0.0;  ///< distance driven during Stuck [m]
    bool operator==(const SensorSuspicion&) const = default;
};

/// Returns a suspicion of a change, or of a reading, that holds for some seconds without further evidence.
SensorSuspicion suspicionFor(double seconds, Sensor sensor, SensorTrouble trouble, double now,
                             double amount);

/// Returns true if one of the suspicions is of that sensor.
bool isSuspected(const std::vector<SensorSuspicion>& suspicions, Sensor sensor);

/// Returns true if the odometry or the pitch is suspected. They place the robot along its way.
bool isWaySuspected(const std::vector<SensorSuspicion>& suspicions);

/// Returns the fault without the sensor: "not changed for 12 s while the robot drove 0.6 m,
/// stuck?".
Message describeTrouble(const SensorSuspicion& suspicion);

/// Returns one sentence: "pitch angle: not changed for 12 s while the robot drove 0.6 m, stuck?".
Message describe(const SensorSuspicion& suspicion);

}  // namespace terratact
