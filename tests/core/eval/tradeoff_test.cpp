#include "core/eval/tradeoff.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <stdexcept>

namespace terratact {
namespace {

TEST(ParetoFront, holdsExactlyTheUnbeatenPoints)
{
    std::mt19937_64 rng(3);
    std::uniform_int_distribution<int> number(0, 30);  // with ties
    for (int round = 0; round < 200; ++round) {
        std::vector<double> cost, error;
        for (int k = 0; k < 20; ++k) {
            cost.push_back(number(rng));
            error.push_back(number(rng));
        }
        const std::vector<bool> front = paretoFront(cost, error);
        for (std::size_t k = 0; k < cost.size(); ++k) {
            bool beaten = false;
            for (std::size_t j = 0; j < cost.size(); ++j) {
                const bool noWorse = cost[j] <= cost[k] && error[j] <= error[k];
                const bool better = cost[j] < cost[k] || error[j] < error[k];
                beaten = beaten || (noWorse && (better || j < k));
            }
            EXPECT_EQ(front[k], !beaten) << round << " " << k;
        }
    }
}

TEST(ParetoFront, refusesNumbersThatDoNotBelongTogether)
{
    EXPECT_THROW((void)paretoFront(std::vector{1.0}, std::vector{1.0, 2.0}), std::invalid_argument);
    EXPECT_TRUE(paretoFront({}, {}).empty());
}

TEST(EstimateDistance, isTheMeanOverTheBins)
{
    TerrainEstimate a, b;
    b.mean[2] = 0.11;
    b.q10[3] = -0.22;
    b.q90[3] = 0.44;
    EXPECT_DOUBLE_EQ(distance(a, b).mean, 0.01);
    EXPECT_DOUBLE_EQ(distance(a, b).quantile, 0.03);
}

/// Returns a setting without the varied part.
Settings withoutWhatVaries(const TradeSetting& t)
{
    Settings settings = t.settings;
    if (t.varied == "draws") settings.draws = Settings{}.draws;
    if (t.varied == "chains") settings.chains = Settings{}.chains;
    if (t.varied == "precision") settings.precision = Settings{}.precision;
    if (t.varied == "inducing") settings.inducing = Settings{}.inducing;
    if (t.varied == "early stop") {  // the budget of a longer run, which it ends early
        settings.stopEarly = false;
        settings.draws = Settings{}.draws;
    }
    return settings;
}

TEST(TradeSettings, holdEveryPresetOnceAndVaryOneThingAtATime)
{
    for (const Method method : kSceneMethods) {
        std::set<QualityPreset> presets;
        for (const TradeSetting& t : tradeSettings(method, 7)) {
            EXPECT_EQ(t.settings.method, method);
            EXPECT_EQ(t.settings.seed, 7U);
            EXPECT_EQ(t.settings.stopEarly, t.varied == "early stop" || t.preset);
            if (t.preset) {
                EXPECT_TRUE(presets.insert(*t.preset).second);
                Settings asRun = withPreset({.method = method}, *t.preset);
                asRun.seed = 7;
                asRun.hazardRate = 0.0;
                EXPECT_EQ(t.settings, asRun);
            }
            if (!t.preset) {
                Settings base{.method = method};
                base.seed = 7;
                base.stopEarly = false;
                base.hazardRate = 0.0;
                EXPECT_EQ(withoutWhatVaries(t), base) << t.varied;
            }
        }
        EXPECT_EQ(presets.size(), kQualityPresets.size());
        EXPECT_EQ(tradeSettings(method, 7).size(), isClosedForm(method) ? 9U : 20U);
    }
}

TEST(ReferenceSettings, haveFourTimesTheMostDraws)
{
    std::vector<TradePoint> points(3);
    points[0].draws = 250;
    points[1].draws = 12000;
    points[1].setting.settings.draws = 64000;  // most of these draws were not needed
    points[2].draws = 4000;
    EXPECT_EQ(leastReferenceDraws(points), 48000);
    EXPECT_EQ(leastReferenceDraws({}), 0);
}

TEST(ReferenceQuality, isTheWorstBinOfTheWorstScene)
{
    TerrainEstimate a, b;
    for (TerrainEstimate* e : {&a, &b}) {
        e->settings.method = Method::Pafc;
        e->draws.resize(640);
        e->rhat.fill(1.0);
        e->ess.fill(640.0);
        e->sd.fill(0.02 * std::sqrt(640.0));
    }
    a.rhat[3] = 1.04;
    b.ess[10] = 77.0;
    ReferenceQuality quality;
    quality.add(a);
    EXPECT_EQ(quality.ess, 640.0);
    quality.add(b);
    EXPECT_EQ(quality.method, Method::Pafc);
    EXPECT_EQ(quality.draws, 640);
    EXPECT_EQ(quality.rhat, 1.04);
    EXPECT_EQ(quality.ess, 77.0);
    const double inTheWorst = 0.02 * std::sqrt(640.0 / 77.0);
    EXPECT_NEAR(quality.error, (21 * 0.02 + inTheWorst) / 22, 1e-12);
}

TEST(TradeFronts, arePerMethodAndGlobalAgainstTruth)
{
    const auto point = [](Method method, double seconds, double off, double error) {
        TradePoint p;
        p.setting.settings.method = method;
        p.seconds = seconds;
        p.reference.quantile = off;
        p.error = error;
        return p;
    };
    const std::vector<TradePoint> points{
        point(Method::Local, 0.001, 0.0, 0.030), point(Method::Pafc, 0.010, 0.004, 0.040),
        point(Method::Pafc, 0.020, 0.005, 0.020), point(Method::Pa, 0.015, 0.006, 0.035),
        point(Method::Pa, 0.030, 0.003, 0.025)};
    const TradeFronts fronts = tradeFronts(points);
    EXPECT_EQ(fronts.reference, (std::vector<bool>{false, true, false, true, true}));
    EXPECT_EQ(fronts.truth, (std::vector<bool>{true, false, true, false, false}));
}

}  // namespace
}  // namespace terratact
