#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/infer/estimator.h"
#include "tests/support/random_model.h"
#include "tests/support/toy_clearance.h"
#include "tests/support/toy_model.h"

namespace terratact {

inline const RobotModel& robot()
{
    static const RobotModel model = absolem();
    return model;
}

/// Returns toyModel with hyperparameters for the conditionals over clearances.
inline ModelData modelFor(int runs, std::uint64_t seed)
{
    ModelData model = toyModel(runs, seed);
    const auto data = plausibleConditionals(clearanceTraining(model, robot()));
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        model.clearance.conditionalOpen[i] = data.at(bin, Regime::Open).hyper;
        model.clearance.conditionalCovered[i] = data.at(bin, Regime::Covered).hyper;
    }
    return model;
}

inline const ModelData& modelData()
{
    static const ModelData data = modelFor(12, 1);
    return data;
}

inline const Models& models()
{
    static const Models toy(modelData(), robot());
    return toy;
}

inline Scene someScene()
{
    static const Scene scene = someScenes(2, 99).front();
    return scene;
}

inline std::vector<double> numbersOf(const TerrainEstimate& e)
{
    std::vector<double> all{e.novelty};
    for (const Heights& h : {e.mean, e.sd, e.q10, e.q90, e.height, e.rhat, e.ess})
        all.insert(all.end(), h.begin(), h.end());
    for (const Heights& h : e.draws) all.insert(all.end(), h.begin(), h.end());
    return all;
}

inline void expectSound(const TerrainEstimate& e, const std::string& what)
{
    for (const double x : numbersOf(e)) ASSERT_TRUE(std::isfinite(x)) << what;
    for (std::size_t i = 0; i < kBins; ++i) {
        EXPECT_LE(e.q10[i], e.q90[i]) << what << ", bin " << i;
        EXPECT_GE(e.sd[i], 0.0) << what << ", bin " << i;
        EXPECT_FALSE(std::isnan(e.ceiling[i])) << what << ", bin " << i;
        if (usesCeiling(e.settings.method) && e.origin[i] == Origin::Sampled
            && e.settings.ceiling != CeilingRule::None) {
            EXPECT_LE(e.q90[i], e.ceiling[i]) << what << ", bin " << i;
        }
    }
}

struct Asked {
    Scene scene = someScene();
    std::vector<ArmReading> arm;
    Settings settings;
};

inline TerrainEstimate estimateOf(const Asked& asked, const Watch& watch = {},
                                  const RobotModel& of = robot())
{
    return estimateTerrain(asked.scene.s, asked.arm, of, models(), asked.settings, watch);
}

}  // namespace terratact
