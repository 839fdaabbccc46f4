#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/base/poll.h"
#include "core/learn/data/two_track_scene.h"
#include "core/learn/model/model.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Number of scenes of two tracks that a model keeps. Processes learn from all scenes. Their
/// inducing rows, and the residuals of method `local`, are those of the first scenes.
inline constexpr int kKeptScenes = 12'000;

/// Largest number of scenes of two tracks that a model learns from.
inline constexpr int kMaxSideScenes = 100'000;

/// Steps of the numbers that a model of sides holds: angles [rad], currents [A], forces [N], heights
/// [m] and residuals [y]. They are far below the sensors' noise. Training rounds to them, so that a
/// file of integers keeps every bit.
inline constexpr double kAngleStep = 1e-4, kCurrentStep = 1e-3, kForceStep = 1e-2,
                        kHeightStep = 1e-4, kResidualStep = 1e-4;

/// Returns the step of a feature of a side.
double sideFeatureStep(std::size_t feature);

/// Returns the multiple of step nearest to a value.
double inSteps(double value, double step);

/// Training rows of both sides (SurfaceData), in the order of the scenes, rounded to steps. Scenes
/// that lack a current, a front force or every height are left out, and those whose differential has
/// turned. So are copies (withoutCopies): bands would shrink.
struct SideTrainingSet {
    SurfaceData rows;
    int used = 0, leftOut = 0;             ///< scenes
    int withHoles = 0;                     ///< those of `used` with unknown heights
    int exactCopies = 0, nearCopies = 0;   ///< left out, not counted in leftOut
    std::set<std::string> runsWithCopies;  ///< drives of the near copies
};

/// Throws std::invalid_argument if fewer than kMinTrainingRows scenes are left, or if a bin's height
/// is known in fewer.
SideTrainingSet prepareSides(const std::vector<TwoTrackScene>& scenes);

/// Completes the sides once all bins are stored: keeps kKeptScenes scenes, rounds the residuals, and
/// does what finishClearance() does.
void finishSides(SurfaceData& sides, const RobotModel& robot, const Poll& poll = {});

}  // namespace terratact
