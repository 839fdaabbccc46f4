#pragma once

#include <random>

#include "core/learn/model/bin_models.h"
#include "core/learn/model/clearance_model.h"
#include "core/learn/model/clearance_training.h"
#include "core/learn/model/training.h"
#include "core/sim/drive.h"
#include "core/sim/ground/random_terrain.h"
#include "tests/support/absolem.h"

namespace terratact {

/// Returns scenes of a short simulated campaign over varied ground.
inline std::vector<Scene> someScenes(int runs, std::uint64_t seed, SensorNoise noise = {})
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(seed);
    std::vector<Scene> scenes;
    int skipped = 0;
    for (int run = 0; run < runs; ++run) {
        const TerrainProfile terrain = randomVariedTerrain(rng);
        auto more = driveOver(robot, terrain, stopsOver(terrain, 0.3), std::to_string(run + 1),
                              randomDriveStyle(rng), {.noise = noise}, rng, skipped);
        scenes.insert(scenes.end(), more.begin(), more.end());
    }
    return scenes;
}

/// Trains surface processes with a short search.
inline void trainToyClearances(ModelData& model)
{
    const RobotModel robot = absolem();
    const Eigen::MatrixXd ceilings = bodyCeilings(model.features, robot);
    const std::vector<int> places = placesOf(model);
    prepareClearance(model, ceilings);
    TrainingOptions quick;
    quick.subset = 100;
    quick.subsetEvaluations = 6;
    for (int bin = 0; bin < kBins; ++bin)
        for (const bool covered : {false, true})
            store(model, trainSurface(model, ceilings, bin, covered, quick, {}, places), bin,
                  covered);
    finishClearance(model, ceilings, robot);
}

/// Returns a small real model with plausible hyperparameters, not optimised, so that it is made quickly.
inline ModelData toyModel(int runs = 8, std::uint64_t seed = 1)
{
    ModelData model = prepareTraining(someScenes(runs, seed)).model;
    for (BinModelData* data : {&model.pa, &model.paf})
        for (std::size_t i = 0; i < kBins; ++i) {
            Hyperparameters& hyper = data->bins[i];
            hyper.lengthScale = Eigen::VectorXd::Constant(data->mean.size() - 1, 5.0);
            hyper.signalSd = data->sd[static_cast<Eigen::Index>(i)];
            hyper.noiseSd = 0.02;
        }
    model.command = "toy";
    trainToyClearances(model);
    return model;
}

}  // namespace terratact
