#include "core/infer/reconstruct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/support/toy_model.h"

namespace terratact {
namespace {

struct SamplingBench {
    RobotModel robot = absolem();
    ModelData data = toyModel();
    BinModels pa{data, FeatureSet::Pa};
    BinModels paf{data, FeatureSet::Paf};
    Scene scene = someScenes(3, 42, SensorNoise::none())[4];
};

const SamplingBench& samplingBench()
{
    static const SamplingBench shared;
    return shared;
}

Settings quick(Method method)
{
    Settings settings;
    settings.method = method;
    settings.draws = 400;
    settings.chains = 8;
    return settings;
}

TerrainEstimate reconstruct(const Proprioception& s, std::span<const ArmReading> arm,
                            const RobotModel& robot, const BinModels& models,
                            const Settings& settings, const Watch& watch = {})
{
    return sampleScene(paperSampling(s, arm, robot, models, settings, watch), watch);
}

TerrainEstimate estimate(Method method, std::span<const ArmReading> arm = {})
{
    const SamplingBench& b = samplingBench();
    return reconstruct(b.scene.s, arm, b.robot, usesForces(method) ? b.paf : b.pa, quick(method));
}

TEST(Reconstruct, givesFiniteNumbersInOrderForEveryMethod)
{
    for (const Method method : {Method::Pa, Method::Pac, Method::Pafc, Method::Pafac}) {
        const TerrainEstimate e = estimate(method);
        for (std::size_t i = 0; i < kBins; ++i) {
            EXPECT_TRUE(std::isfinite(e.mean[i]) && std::isfinite(e.rhat[i])
                        && std::isfinite(e.ess[i]));
            EXPECT_LE(e.q10[i], e.q90[i]);
            EXPECT_GT(e.sd[i], 0.0);
        }
    }
}

TEST(Reconstruct, constrainsPacButNotPa)
{
    const TerrainEstimate pa = estimate(Method::Pa);
    const TerrainEstimate pac = estimate(Method::Pac);
    int above = 0;
    for (std::size_t i = 0; i < kBins; ++i) {
        EXPECT_LE(pac.q90[i], pac.ceiling[i]);
        above += pa.q90[i] > pa.ceiling[i] ? 1 : 0;
    }
    EXPECT_GT(above, 0);
}

TEST(Reconstruct, fixesContactBinsForPafcOnly)
{
    Proprioception s = samplingBench().scene.s;
    s.force = {0.0, 0.0, 0.0, 0.0, 9.0, 0.0};
    const TerrainEstimate e =
        reconstruct(s, {}, samplingBench().robot, samplingBench().paf, quick(Method::Pafc));
    int contacts = 0;
    for (std::size_t i = 0; i < kBins; ++i) {
        if (e.origin[i] != Origin::Contact) continue;
        ++contacts;
        EXPECT_DOUBLE_EQ(e.sd[i], e.settings.contactSd);
        EXPECT_NEAR(e.q90[i] - e.mean[i], 1.2815515655446004 * e.settings.contactSd, 1e-12);
    }
    EXPECT_EQ(contacts, 1);
    const TerrainEstimate pac =
        reconstruct(s, {}, samplingBench().robot, samplingBench().pa, quick(Method::Pac));
    EXPECT_EQ(std::count(pac.origin.begin(), pac.origin.end(), Origin::Contact), 0);
}

TEST(Reconstruct, fixesTheBinTheArmMeasured)
{
    const ArmReading reading{9, -0.31, 0.03};
    const TerrainEstimate e = estimate(Method::Pafc, {&reading, 1});
    EXPECT_EQ(e.origin[9], Origin::Arm);
    EXPECT_DOUBLE_EQ(e.mean[9], -0.31);
    EXPECT_DOUBLE_EQ(e.sd[9], 0.03);
    EXPECT_EQ(e.origin[10], Origin::Sampled);
}

TEST(Reconstruct, factorisesTheModelsOfSampledBinsAlone)
{
    const BinModels models(samplingBench().data, FeatureSet::Paf);
    EXPECT_EQ(models.factorised(), BinSet{});
    Proprioception s = samplingBench().scene.s;
    s.force = {0.0, 0.0, 0.0, 0.0, 9.0, 0.0};
    const std::array arm{ArmReading{9, -0.31, 0.03}, ArmReading{10, -0.3, 0.03}};
    const TerrainEstimate e =
        reconstruct(s, arm, samplingBench().robot, models, quick(Method::Pafc));
    BinSet sampled;
    for (std::size_t i = 0; i < kBins; ++i) sampled.set(i, e.origin[i] == Origin::Sampled);
    EXPECT_EQ(sampled.count(), 8U);
    EXPECT_EQ(models.factorised(), sampled);
}

TEST(Reconstruct, samplesNothingWhereEveryBinIsMeasured)
{
    const BinModels models(samplingBench().data, FeatureSet::Paf);
    std::vector<ArmReading> arm;
    for (int bin = 0; bin < kBins; ++bin) arm.push_back({bin, -0.3, 0.03});
    const TerrainEstimate e = reconstruct(samplingBench().scene.s, arm, samplingBench().robot,
                                          models, quick(Method::Pafc));
    EXPECT_EQ(models.factorised(), BinSet{});
    EXPECT_TRUE(e.converged);
    EXPECT_EQ(e.ending, Ending::NotSampled);
    for (std::size_t i = 0; i < kBins; ++i) EXPECT_EQ(e.mean[i], -0.3);
}

TEST(Reconstruct, reportsHowSamplingEndedAndCountsDraws)
{
    const ArmReading reading{4, -0.3, 0.03};
    Settings settings = quick(Method::Pa);
    settings.chains = 3;
    settings.draws = 100;  // 34 of every chain
    const auto run = [&](const Watch& watch) {
        return reconstruct(samplingBench().scene.s, {&reading, 1}, samplingBench().robot,
                           samplingBench().pa, settings, watch);
    };
    const TerrainEstimate whole = run({});
    EXPECT_EQ(whole.ending, Ending::Sweeps);
    EXPECT_EQ(whole.draws.size(), 102U);
    EXPECT_EQ(whole.ess[4], 102.0);
    Watch hurried;
    hurried.outOfTime = [] { return true; };
    const TerrainEstimate cut = run(hurried);
    EXPECT_EQ(cut.ending, Ending::Time);
    EXPECT_EQ(cut.draws.size(), 12U);
    EXPECT_EQ(cut.ess[4], 12.0);
    EXPECT_NE(cut.warnings.back().english().find("when time was out"), std::string::npos);
}

TEST(Reconstruct, reportsAnArmReadingAboveTheBodyAndKeepsIt)
{
    const ArmReading impossible{3, 0.2, 0.03};
    const TerrainEstimate e = estimate(Method::Pafc, {&impossible, 1});
    EXPECT_EQ(e.origin[3], Origin::Arm);
    ASSERT_FALSE(e.warnings.empty());
    EXPECT_NE(e.warnings.front().english().find("above the robot's own lower edge"),
              std::string::npos);
}

TEST(Reconstruct, repeatsBitForBit)
{
    EXPECT_EQ(estimate(Method::Pafc), estimate(Method::Pafc));
}

TEST(Reconstruct, throughInducingRowsComesCloseToTheTrainedModels)
{
    const SamplingBench& b = samplingBench();
    const auto through = [&](int inducing) {
        Settings settings = quick(Method::Pac);
        settings.inducing = inducing;
        return reconstruct(b.scene.s, {}, b.robot, b.pa, settings);
    };
    const TerrainEstimate exact = through(0);
    const TerrainEstimate sparse = through(static_cast<int>(b.pa.bin(0).rows()) / 2);
    EXPECT_NE(exact.mean, sparse.mean);
    for (std::size_t i = 0; i < kBins; ++i)
        EXPECT_NEAR(sparse.mean[i], exact.mean[i], 0.5 * exact.sd[i]) << i;
    EXPECT_THROW((void)through(-1), std::invalid_argument);
}

TEST(Reconstruct, warnsIfTheChainsHaveNotConverged)
{
    Settings settings = quick(Method::Pa);
    settings.draws = 16;
    settings.burnIn = 0;
    const TerrainEstimate e = reconstruct(samplingBench().scene.s, {}, samplingBench().robot,
                                          samplingBench().pa, settings);
    EXPECT_FALSE(e.converged);
    ASSERT_FALSE(e.warnings.empty());
    EXPECT_NE(e.warnings.back().english().find("not converged"), std::string::npos);
}

TEST(Reconstruct, refusesTheWrongModelsAndMissingFeatures)
{
    const SamplingBench& b = samplingBench();
    EXPECT_THROW((void)reconstruct(b.scene.s, {}, b.robot, b.paf, quick(Method::Pa)),
                 std::invalid_argument);
    Proprioception s = b.scene.s;
    s.force[2].reset();
    EXPECT_THROW((void)reconstruct(s, {}, b.robot, b.paf, quick(Method::Pafc)),
                 std::invalid_argument);
    EXPECT_NO_THROW((void)reconstruct(s, {}, b.robot, b.pa, quick(Method::Pa)));
    Settings none = quick(Method::Pa);
    none.chains = 0;
    EXPECT_THROW((void)reconstruct(s, {}, b.robot, b.pa, none), std::invalid_argument);
}

TEST(PlanarWarning, isGivenForEachReadingThatBreaksThePlane)
{
    TerrainEstimate e = estimate(Method::Pa);
    e.warnings.clear();
    Measurement level;
    warnIfNotPlanar(e, level);
    EXPECT_TRUE(e.warnings.empty());
    level.roll = 0.2;
    level.frontLeft = 0.3;
    warnIfNotPlanar(e, level);
    EXPECT_EQ(e.warnings.size(), 2U);
    level.differential = -0.1;
    warnIfNotPlanar(e, level);
    EXPECT_EQ(e.warnings.size(), 5U);
}

}  // namespace
}  // namespace terratact
