#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/clouds/cloud_truth.h"

namespace terratact {

/// Height and tilt of the cloud against the robot at one scene: what lets the robot rest on the cloud.
struct SceneContact {
    std::size_t place = 0;         ///< of the grid
    CloudCorrection correction{};  ///< positive offset: the cloud lies too low
};

/// Returns the correction that lets the robot rest on the cloud. Each side's tracks and flippers then touch it in
/// front of and behind the centre of mass. Nowhere are they inside it. Of each side the gap between robot and cloud
/// has a line below it that touches it there. It is raised by 0.6 sd of its cells, because the least of noisy gaps is
/// too small. Empty if one side has fewer than five known cells in front of or behind the centre of mass.
std::optional<SceneContact> contactAt(const SceneGrid& grid, const RobotModel& robot,
                                      std::size_t place, const TruthRule& rule);

/// Offset and tilt between cloud and robot over a drive.
struct CloudAlignment {
    std::size_t scenes = 0;  ///< that determine it
    bool isOfMap = false;    ///< the tilt belongs to the cloud's axes, not to the robot's
    /// Medians. The tilt is along and across the robot, or along x and y of the cloud.
    CloudCorrection correction{};
    double offsetSd = 0.0, tiltSd = 0.0;  ///< of the medians: 1.25 scatter / √scenes
    double scatter = 0.0;  ///< [m] of a scene's offset: 1.48 times the median |residual|
    double pitchApart = 0.0, rollApart = 0.0;  ///< [rad] medians of scene − pose
    std::vector<SceneContact> contacts{};
    std::vector<std::size_t>
        off{};  ///< places whose offset differs by more than 5 cm and 4 scatters

    /// Returns the correction of a scene with this heading [rad].
    CloudCorrection at(double heading) const;
};

/// Estimates the alignment over all scenes. The tilt is the robot's (an IMU or a sensor is mounted askew)
/// or the map's. The one with smaller residuals counts. Empty if no scene has a contact. Points higher
/// above the robot's lower boundary than 0.1 m count as its own. It is 0.5 m if fewer than half of the
/// scenes have a contact then.
std::optional<CloudAlignment> alignmentOf(const SceneGrid& grid, const RobotModel& robot,
                                          const TruthRule& rule);

}  // namespace terratact
