#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/robot/measurement.h"

namespace terratact {

/// A line of telemetry of a recording.
struct TelemetryLine {
    std::int64_t time = 0;  ///< [ns] since 1970, or since any time of the recording
    Measurement measurement{};
};

/// When a robot stood still with flippers pressed. Noise is averaged over a window of `still` seconds.
/// The robot stands still at its end if two conditions hold. The means of both halves differ by at most
/// maxTurn in pitch, roll and flipper angles. The way in the window is at most maxWay. A line presses if
/// the first of these that the recording knows holds:
///   - the robot says so: its activity is Pressed, or Probing, when its flippers stay pressed;
///   - the mean current of the front or of the rear flippers is at least minCurrent;
///   - the sum of the mean front forces is at least minForce.
struct PressRule {
    bool byActivity = false;  ///< the lines hold the activity that the robot itself reported
    double minCurrent = 1.0;  ///< [A]
    double minForce = 5.0;    ///< [N]
    double still = 0.5;       ///< [s]
    double maxTurn = 0.02;    ///< [rad]
    double maxWay = 0.005;    ///< [m]
    bool operator==(const PressRule&) const = default;
};

/// Returns true if the line presses its flippers onto the ground.
bool presses(const Measurement& measurement, const PressRule& rule);

/// Returns the lines at which a robot stood still with flippers pressed, in the order of time. Each
/// press and pose has one line: the middle of the last window in which the robot stood still. A press
/// ends with a line that does not press, or that comes later than `still` after the one before. A pose
/// begins with its first window. A new one begins once the mean of a window differs from that by more
/// than maxTurn or maxWay. Throws std::invalid_argument if the times of the lines fall.
std::vector<std::size_t> standingPresses(const std::vector<TelemetryLine>& lines,
                                         const PressRule& rule);

/// Returns for each line whether the robot did not stand still in the window that ends with it. The
/// windows of the first lines are shorter.
std::vector<bool> movedAt(const std::vector<TelemetryLine>& lines, const PressRule& rule);

}  // namespace terratact
