#include "core/infer/estimator.h"

#include <gtest/gtest.h>

#include "tests/support/toy_clearance.h"

namespace terratact {
namespace {

/// Returns a model with conditionals over clearances for every regime that has enough rows.
ModelData modelWithClearances()
{
    ModelData model = toyModel(12);
    const ClearanceConditionalData data =
        plausibleConditionals(clearanceTraining(model, absolem()));
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        model.clearance.conditionalCovered[i] = data.at(bin, Regime::Covered).hyper;
        model.clearance.conditionalOpen[i] = data.at(bin, Regime::Open).hyper;
    }
    return model;
}

BinSet trained(const Models& models, Regime regime)
{
    BinSet bins;
    for (int bin = 0; bin < kBins; ++bin)
        bins[static_cast<std::size_t>(bin)] = models.conditionals.isTrained(bin, regime);
    return bins;
}

TEST(MakeProcesses, makesThoseOfTheMethodForWhateverScene)
{
    const Models models(modelWithClearances(), absolem());
    makeProcesses(models, {.method = Method::Local});
    EXPECT_EQ(models.pa.factorised() | models.paf.factorised(), BinSet{}) << "a formula needs none";
    makeProcesses(models, {.method = Method::Pafc});
    EXPECT_EQ(models.paf.factorised(), kAllBins);
    EXPECT_EQ(models.pa.factorised(), BinSet{});
    makeProcesses(models, {.method = Method::Pac});
    EXPECT_EQ(models.pa.factorised(), kAllBins);
    for (const Regime regime : kRegimes)
        EXPECT_EQ(models.conditionals.factorised(regime), BinSet{});
    makeProcesses(models, {.method = Method::Clearance});
    for (const Regime regime : kRegimes) {
        EXPECT_EQ(models.conditionals.factorised(regime), trained(models, regime));
        EXPECT_GE(trained(models, regime).count(), 3U);
    }
    EXPECT_FALSE(trained(models, Regime::Covered).all()) << "the bins ahead are never covered";
}

TEST(MakeProcesses, continuesAfterACancellation)
{
    const ModelData data = modelWithClearances();
    const auto questions = [](const Models& models, int most) {
        int asked = 0;
        Watch watch;
        watch.cancelled = [&asked, most] { return ++asked > most; };
        try {
            makeProcesses(models, {.method = Method::Pafc}, watch);
        } catch (const Cancelled&) {
            EXPECT_EQ(asked, most + 1);
        }
        return asked;
    };
    constexpr int kAll = 1 << 30;
    const int whole = questions(Models(data, absolem()), kAll);
    const Models models(data, absolem());
    questions(models, whole / 2);
    const std::size_t made = models.paf.factorised().count();
    EXPECT_GT(made, 0U);
    EXPECT_LT(made, kAllBins.count());
    EXPECT_LT(questions(models, kAll), whole - whole / 4) << "what was made is made";
    EXPECT_EQ(models.paf.factorised(), kAllBins);
}

}  // namespace
}  // namespace terratact
