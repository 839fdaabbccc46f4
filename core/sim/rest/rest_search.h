#pragma once

#include <algorithm>

#include "core/robot/kinematics.h"
#include "core/sim/rest/ground_contact.h"

namespace terratact {

// Constants and the schedule that the searches for rest poses share, on one plane and on two tracks.

inline constexpr double kGravity = 9.81;      ///< [m/s²]
inline constexpr double kMaxRestPitch = 1.2;  ///< [rad] beyond it the robot tips over

/// Returns how much ground is searched on either side of the base [m].
inline double searchReach(const RobotModel& robot, const GroundOptions& ground)
{
    constexpr double kMinReach = 0.75;  // [m]
    return std::max(kMinReach, reachOf(robot) + ground.skin);
}

enum class Start { Above, Here };

/// Lowers a robot from above the ground with growing contact stiffness, or lets it settle where it
/// is.
template <class Descent, class State>
void lower(Descent& descent, State& state, double stiffness, Start start)
{
    constexpr int kSoftIterations = 60;
    constexpr int kFinalIterations = 300;
    if (start == Start::Above) {
        descent.run(state, stiffness / 300.0, kSoftIterations);
        descent.run(state, stiffness / 20.0, kSoftIterations);
    }
    descent.run(state, stiffness, kFinalIterations);
}

}  // namespace terratact
