#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "core/robot/measurement.h"
#include "core/robot/watch/sensor.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Detects forces on raised front flippers while the robot drives. An element that feels at least
/// kLoad in nine lines of ten has drifted or is stuck. Four elements together are suspected over
/// kWay, one alone over kLongWay. The flipper may lean on a wall for a while. Both sides of an
/// element count as one of the four.
class UnloadedWatch {
public:
    static constexpr double kLoad = 1.0;     ///< [N]
    static constexpr double kRaised = 0.3;   ///< [rad] least angle of both front flippers
    static constexpr double kWay = 0.25;     ///< [m]
    static constexpr double kLongWay = 1.5;  ///< [m]
    static constexpr double kHold = 60.0;  ///< [s] duration of a suspicion after the last such line

    void add(const Measurement& line);
    /// Suspicions of the last line.
    const std::vector<SensorSuspicion>& found() const { return found_; }
    void reset();

private:
    struct Element {
        int lines = 0, free = 0;  ///< since the element was last free in more than one line of ten
        double way = 0.0;         ///< [m]
        double least = 0.0;       ///< [N]
    };
    void add(Element& element, double force, double way);
    void suspect(Sensor sensor, double now);

    std::optional<double> travelled_;
    std::array<Element, kSensors> elements_{};  ///< of forces
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
