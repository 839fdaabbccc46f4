#include "core/infer/estimate/missing_sensors.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/infer/closed_form.h"
#include "core/infer/estimate_batch.h"
#include "core/infer/estimator.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

struct Bench {
    RobotModel robot = absolem();
    ModelData data = toyModel(30);
    Models models{data, robot};
    std::vector<Scene> scenes = someScenes(20, 77, [] {
        SensorNoise noise;
        noise.height = 0.0;
        return noise;
    }());
};

const Bench& bench()
{
    static const Bench instance;
    return instance;
}

Proprioception without(Proprioception s, MissingFeatures missing)
{
    if (missing[kFrontCurrentFeature]) s.frontCurrent.reset();
    if (missing[kRearCurrentFeature]) s.rearCurrent.reset();
    for (std::size_t e = 0; e < s.force.size(); ++e)
        if (missing[kFirstForceFeature + e]) s.force[e].reset();
    return s;
}

const MissingFeatures kNoCurrents = 0x018, kNoForces = 0x7E0, kNothing = 0x7F8, kDead4 = 0x100;

TerrainEstimate estimate(const Scene& scene, Method method, MissingFeatures missing,
                         const Models& models = bench().models)
{
    Settings settings;
    settings.method = method;
    settings.draws = 64;
    settings.chains = 4;
    return estimateTerrain(without(scene.s, missing), {}, bench().robot, models, settings);
}

TEST(MissingSensors, everyMethodEstimatesAndNamesThem)
{
    for (const Method method : kMethods) {
        const TerrainEstimate e = estimate(bench().scenes[3], method, kDead4 | kNoCurrents);
        EXPECT_EQ(e.settings.method, method);
        EXPECT_EQ(e.missing, usesForces(method) ? kDead4 | kNoCurrents : MissingFeatures{});
        const std::vector<Message> said = missingSentences(method, e.missing, false);
        ASSERT_GE(e.warnings.size(), said.size());
        EXPECT_TRUE(std::equal(said.begin(), said.end(), e.warnings.begin())) << name(method);
    }
    EXPECT_TRUE(missingSentences(Method::Local, {}, true).empty());
}

TEST(MissingSensors, onlyReadingsOfTheArmInUseAreNamed)
{
    const auto said = [](bool usesArm) {
        return missingSentences(Method::Trail, kDead4, usesArm).back().english();
    };
    EXPECT_EQ(said(true), "the memory of the way needs every current and force: only the arm's "
                          "earlier readings are used");
    EXPECT_EQ(said(false),
              "the memory of the way needs every current and force: this scene alone counts");
}

TEST(MissingSensors, forcesOfOneSideAreNamedOnce)
{
    const auto said = [](MissingFeatures own, MissingFeatures other) {
        return english(oneSidedSentences(own, other), "; ");
    };
    EXPECT_EQ(said({}, {}), "");
    EXPECT_EQ(said({}, kNoForces), "");
    EXPECT_EQ(said(kNoForces, kNoForces), "") << "the plane has none";
    EXPECT_EQ(said(kDead4, kDead4), "") << "the plane lacks it";
    EXPECT_EQ(said(kNoForces, kDead4),
              "no force was measured: the other side's forces count for both");
    EXPECT_EQ(said(kDead4, {}),
              "the force of element 4 was not measured: the other side's counts for both");
}

TEST(MissingSensors, nothingMissingIsTheModelItself)
{
    const Scene& scene = bench().scenes[5];
    Settings settings;
    settings.draws = 64;
    EXPECT_EQ(estimate(scene, Method::Local, {}).draws,
              reconstructClosedForm(scene.s, {}, bench().robot, bench().models.clearance, settings)
                  .draws);
    EXPECT_THROW((void)bench().models.reduced.without(MissingFeatures{}), std::invalid_argument);
    EXPECT_THROW((void)bench().models.reduced.without(MissingFeatures{0x001}),
                 std::invalid_argument);
}

TEST(MissingSensors, aModelThatNeedsAFeatureRefusesASceneWithout)
{
    EXPECT_THROW((void)reconstructClosedForm(without(bench().scenes[0].s, kDead4), {},
                                             bench().robot, bench().models.clearance, {}),
                 std::invalid_argument);
}

TEST(MissingSensors, earlierEstimatesChangeNoLaterOne)
{
    const Models fresh(bench().data, bench().robot);
    (void)estimate(bench().scenes[1], Method::Local, kNoForces, fresh);
    EXPECT_EQ(estimate(bench().scenes[7], Method::Local, kDead4, fresh),
              estimate(bench().scenes[7], Method::Local, kDead4));
    EXPECT_EQ(estimate(bench().scenes[7], Method::Clearance, kDead4).draws,
              estimate(bench().scenes[7], Method::Local, kDead4).draws);
}

TEST(MissingSensors, aBatchEstimatesTheSame)
{
    EstimateBatch batch(bench().robot, bench().models);
    Settings settings;
    settings.draws = 64;
    batch.add(0, without(bench().scenes[2].s, kNoCurrents), {}, settings);
    const auto ready = batch.next();
    ASSERT_EQ(ready.size(), 1U);
    settings.chains = 16;
    EXPECT_EQ(ready[0].estimate, estimateTerrain(without(bench().scenes[2].s, kNoCurrents), {},
                                                 bench().robot, bench().models, settings));
}

TEST(MissingSensors, aCancelledTrainingRestarts)
{
    const ReducedClearances reduced(bench().data, bench().robot);
    struct Enough {};
    int polls = 0;
    EXPECT_THROW((void)reduced.without(kNoForces, {},
                                       [&] {
                                           if (++polls > 10) throw Enough{};
                                       }),
                 Enough);
    EXPECT_EQ(reduced.without(kNoForces), reduced.without(kNoForces)) << "made once";
}

TEST(MissingSensors, bandsHoldTheTruthAsOftenAsWithAllSensors)
{
    const auto shareHeld = [](MissingFeatures missing) {
        double held = 0.0, bins = 0.0;
        for (const Scene& scene : bench().scenes) {
            const TerrainEstimate e = estimate(scene, Method::Joint, missing);
            for (std::size_t i = 0; i < kBins; ++i) {
                held += *scene.truth[i] >= e.q10[i] && *scene.truth[i] <= e.q90[i] ? 1.0 : 0.0;
                bins += 1.0;
            }
        }
        return held / bins;
    };
    const double whole = shareHeld({});
    for (const MissingFeatures missing : {kNoCurrents, kNoForces, kNothing, kDead4})
        EXPECT_NEAR(shareHeld(missing), whole, 0.08) << missing;
}

}  // namespace
}  // namespace terratact
