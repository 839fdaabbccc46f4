#pragma once

#include <string>
#include <vector>

#include "core/learn/model/clearance_model.h"
#include "core/learn/model/clearance_training.h"
#include "core/learn/model/side_training.h"
#include "core/learn/model/training.h"
#include "core/sim/ground/random_ground.h"
#include "core/sim/two_track_drive.h"
#include "tests/support/absolem.h"

namespace terratact {

/// Returns scenes of a short simulated campaign over ground that differs left and right.
inline std::vector<TwoTrackScene> someTrackScenes(int runs, std::uint64_t seed)
{
    const RobotModel robot = absolem();
    const std::vector<double> ys{robot.lateral.flipperY, robot.lateral.trackY,
                                 -robot.lateral.trackY, -robot.lateral.flipperY};
    std::mt19937_64 rng(seed);
    std::vector<TwoTrackScene> scenes;
    int skipped = 0;
    for (int run = 0; run < runs; ++run) {
        const GroundLines ground = randomGround(randomGroundKind(rng), ys, rng);
        auto more = driveOver(robot, ground, stopsOver(ground, 0.3), std::to_string(run + 1),
                              randomDriveStyle(rng), DriveConditions{}, rng, skipped);
        scenes.insert(scenes.end(), more.begin(), more.end());
    }
    return scenes;
}

/// Trains the processes of both sides with a short search.
inline SurfaceData toySides(const std::vector<TwoTrackScene>& scenes)
{
    const RobotModel robot = absolem();
    SurfaceData sides = prepareSides(scenes).rows;
    const Eigen::MatrixXd ceilings = bodyCeilings(sides.features, robot);
    const std::vector<int> places = placesOf(sides);
    prepareClearance(sides, ceilings);
    TrainingOptions quick;
    quick.subset = 100;
    quick.subsetEvaluations = 6;
    for (int bin = 0; bin < kBins; ++bin)
        for (const bool covered : {false, true})
            store(sides, trainSurface(sides, ceilings, bin, covered, quick, {}, places), bin,
                  covered);
    finishSides(sides, robot);
    return sides;
}

inline SurfaceData toySides(int runs = 8, std::uint64_t seed = 1)
{
    return toySides(someTrackScenes(runs, seed));
}

}  // namespace terratact
