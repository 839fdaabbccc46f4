#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/modelling/robots/floor_model.h"
#include "app/modelling/simulation/standing_poses.h"
#include "core/base/result.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// A number with its standard deviation.
struct Calibrated {
    double value = 0.0, sd = 0.0;
    /// The recordings at least halve what was known before; of a torque, to 10 %.
    bool isIdentified = false;
};

/// Numbers of a robot as identified from poses on a flat, level floor.
struct RobotCalibration {
    std::array<Calibrated, FloorParameter::Count> parameter{};
    std::optional<Calibrated>
        torquePerAmpere;  ///< [N m / A]; empty: fewer than three poses are lifted by flippers
    std::size_t poses = 0, used = 0;
    std::size_t onFrontTips = 0, onRearTips = 0;  ///< poses in which tips lift the robot
    double before = 0.0,
           after = 0.0;  ///< [rad] rms of measured less expected pitch, by the file and calibrated
};

/// Fits the parameters to poses on a flat, level floor by Bayesian least squares. The file's numbers are the prior. Its
/// sds are 3 cm (flippers), 2 cm (track), 3 mm (tips) and 0.1 rad (sensors). Pitch and roll are observed. The tip of a
/// flipper with at least 1 A touches the floor. Poses with residuals above four times the scatter are left out. Sds are
/// enlarged where the poses scatter more than their noise. The scale is that of the file's pivots. Errors: fewer than
/// three poses; most poses do not fit.
Result<RobotCalibration> calibrateRobot(const RobotModel& robot,
                                        const std::vector<StandingPose>& poses);

}  // namespace terratact
