#include "core/learn/model/clearance_conditionals.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "tests/support/toy_clearance.h"

namespace terratact {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ClearanceScale, isALogarithmUnderTheRobotAndTheHeightElsewhere)
{
    EXPECT_DOUBLE_EQ(toLogClearance(-0.25, kInfinity), -0.25);
    EXPECT_DOUBLE_EQ(fromLogClearance(-0.25, kInfinity), -0.25);
    EXPECT_DOUBLE_EQ(toLogClearance(-0.25, -0.2), std::log(0.05 + kClearanceOffset));
    EXPECT_NEAR(fromLogClearance(toLogClearance(-0.25, -0.2), -0.2), -0.25, 1e-15);
}

TEST(ClearanceScale, neverPutsGroundAboveTheCeiling)
{
    EXPECT_DOUBLE_EQ(toLogClearance(-0.1, -0.2), std::log(kClearanceOffset));
    for (const double y : {-1000.0, -6.0, std::log(kClearanceOffset), -1.0, 3.0})
        EXPECT_LE(fromLogClearance(y, -0.2), -0.2) << y;
}

/// 237 rows: the robot always covers bins 1 … 5, and never bins 9 and 10.
const ClearanceTraining& campaign()
{
    static const ClearanceTraining training = campaignTraining();
    return training;
}

TEST(ClearanceConditionals, standardisesEveryBinInEitherRegime)
{
    const ClearanceTraining& t = campaign();
    const ClearanceConditionalData data = prepareClearanceConditionals(t);
    for (int i = 0; i < kBins; ++i) {
        EXPECT_EQ(data.at(i, Regime::Covered).rows + data.at(i, Regime::Open).rows,
                  t.heights.rows());
        for (const Regime regime : kRegimes) {
            double sum = 0.0;
            double squares = 0.0;
            for (Eigen::Index u = 0; u < t.heights.rows(); ++u) {
                if (regimeOf(t.ceilings(u, i)) != regime) continue;
                const double z =
                    (toLogClearance(t.heights(u, i), t.ceilings(u, i)) - data.at(i, regime).mean)
                    / data.at(i, regime).sd;
                sum += z;
                squares += z * z;
            }
            EXPECT_NEAR(sum, 0.0, 1e-8);
            const int rows = data.at(i, regime).rows;  // a single value does not vary: its sd is 1
            EXPECT_NEAR(squares, rows > 1 ? rows : 0, 1e-6);
        }
    }
}

TEST(ClearanceConditionals, takesTheOtherBinsByTheirRegimeThenLogForces)
{
    const ClearanceConditionals models(campaign(), plausibleConditionals(campaign()));
    const ClearanceConditionalData& data = models.data();
    Heights ceiling{};
    ceiling.fill(-0.2);
    ceiling[9] = ceiling[10] = kInfinity;
    Heights y{};
    for (std::size_t i = 0; i < kBins; ++i) y[i] = -4.0 + 0.1 * static_cast<double>(i);
    Eigen::VectorXd s = Eigen::VectorXd::Zero(11);
    s[4] = 2.5;
    s[5] = 6.0;
    s[6] = -0.5;  // noise around no force
    const Eigen::VectorXd x = models.input(3, y, ceiling, s);
    ASSERT_EQ(x.size(), 21);
    const auto z = [&](int bin, Regime regime) {
        return (y[static_cast<std::size_t>(bin)] - data.at(bin, regime).mean)
             / data.at(bin, regime).sd;
    };
    EXPECT_DOUBLE_EQ(x[2], z(2, Regime::Covered));
    EXPECT_DOUBLE_EQ(x[3], z(4, Regime::Covered));
    EXPECT_DOUBLE_EQ(x[9], z(10, Regime::Open));
    EXPECT_DOUBLE_EQ(x[10 + 4], (2.5 - data.featureMean[4]) / data.featureSd[4]);
    EXPECT_DOUBLE_EQ(x[10 + 5], (std::log(3.0) - data.featureMean[5]) / data.featureSd[5]);
    EXPECT_DOUBLE_EQ(x[10 + 6], -data.featureMean[6] / data.featureSd[6]);
}

TEST(ClearanceConditionals, predictsAsAGaussianProcessOnTheRowsOfTheRegime)
{
    // With almost no noise the process passes through its rows.
    ClearanceConditionalData data = plausibleConditionals(campaign());
    ClearanceRegimeData& own = data.at(5, Regime::Covered);
    own.hyper.noiseSd = 1e-3 * own.sd;
    own.hyper.lengthScale.setConstant(2.0);
    const ClearanceConditionals models(campaign(), data);
    EXPECT_EQ(models.gp(5, Regime::Covered).rows(), own.rows);
    const Eigen::Index u = 7;
    Heights y{}, ceiling{};
    for (std::size_t i = 0; i < kBins; ++i) {
        const auto j = static_cast<Eigen::Index>(i);
        ceiling[i] = campaign().ceilings(u, j);
        y[i] = toLogClearance(campaign().heights(u, j), ceiling[i]);
    }
    const Normal p = models.gp(5, Regime::Covered)
                         .predict(models.input(5, y, ceiling, campaign().features.row(u)));
    EXPECT_NEAR(p.mean, y[5], 0.02 * own.sd);
}

TEST(ClearanceConditionals, usesTheFirst1400RowsAtMost)
{
    const ClearanceTraining few = knownWorldTraining(100, 3);
    ClearanceTraining many;
    many.heights = few.heights.replicate(15, 1);
    many.ceilings = few.ceilings.replicate(15, 1);
    many.features = few.features.replicate(15, 1);
    const ClearanceConditionals models(many, plausibleConditionals(many));
    EXPECT_EQ(models.data().at(4, Regime::Covered).rows, 1500);
    EXPECT_EQ(models.gp(4, Regime::Covered).rows(), kMaxClearanceRows);
}

TEST(ClearanceConditionals, areTrainedByTheirLikelihood)
{
    const ClearanceTraining training = knownWorldTraining(150, 5);
    const ClearanceConditionalData data = prepareClearanceConditionals(training);
    TrainingOptions options;
    options.fullEvaluations = 40;
    const TrainedBin trained =
        trainClearanceConditional(training, data, 4, Regime::Covered, options);
    // Given both neighbours the sd of z is √((1 − ρ²) / (1 + ρ²)) = 0.686.
    EXPECT_NEAR(trained.hyper.noiseSd, 0.6 * 0.686, 0.08);
    EXPECT_TRUE(std::isfinite(trained.logLikelihood));
    const TrainedBin again = trainClearanceConditional(training, data, 4, Regime::Covered, options);
    EXPECT_EQ(trained.hyper.lengthScale, again.hyper.lengthScale);
}

TEST(ClearanceConditionals, refuseARegimeWithTooFewRows)
{
    ClearanceTraining training = knownWorldTraining(60, 3);
    training.ceilings.col(4).setConstant(-0.1);
    training.ceilings.col(4).head(29).setConstant(kInfinity);
    const ClearanceConditionals models(training, plausibleConditionals(training));
    EXPECT_NO_THROW((void)models.gp(4, Regime::Covered));
    try {
        (void)models.gp(4, Regime::Open);
        FAIL() << "29 rows were enough";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("+0.1 m with no robot above it was seen in 29"),
                  std::string::npos)
            << error.what();
    }
    EXPECT_THROW((void)trainClearanceConditional(training, models.data(), 4, Regime::Open, {}),
                 std::invalid_argument);
}

TEST(ClearanceConditionals, refuseWhatDoesNotFit)
{
    const ClearanceTraining good = knownWorldTraining(60, 3);
    const ClearanceConditionalData data = plausibleConditionals(good);
    const auto refused = [&](auto change) {
        ClearanceTraining training = good;
        ClearanceConditionalData changed = data;
        change(training, changed);
        EXPECT_THROW(ClearanceConditionals(training, changed), std::invalid_argument);
    };
    refused([](auto& t, auto&) { t.ceilings.conservativeResize(59, kBins); });
    refused([](auto& t, auto&) { t.heights(3, 3) = kInfinity; });
    refused([](auto& t, auto&) { t.ceilings(3, 3) = std::nan(""); });
    refused([](auto& t, auto&) { t.ceilings(3, 3) = -kInfinity; });
    refused([](auto& t, auto&) { t.ceilings(3, 4) = kInfinity; });  // other rows per regime
    refused([](auto&, auto& d) { d.offset = 0.01; });
    refused([](auto&, auto& d) { d.featureSd[2] = 0.0; });
    const ClearanceConditionals models(good, prepareClearanceConditionals(good));
    EXPECT_THROW((void)models.gp(4, Regime::Covered), std::invalid_argument);  // not trained
    EXPECT_THROW((void)models.gp(11, Regime::Covered), std::invalid_argument);
    EXPECT_THROW((void)models.input(0, {}, {}, Eigen::VectorXd::Zero(3)), std::invalid_argument);
    ClearanceTraining still = good;
    still.features.col(1).setConstant(0.1);
    EXPECT_THROW((void)prepareClearanceConditionals(still), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
