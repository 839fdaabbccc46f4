#include "core/learn/model/clearance_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/learn/data/columns.h"
#include "core/learn/model/clearance.h"
#include "core/terrain/body_ceiling.h"
#include "core/terrain/kinematic_reconstruction.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

const ModelData& toy()
{
    static const ModelData model = toyModel(40);
    return model;
}

Eigen::VectorXd row(Eigen::Index u)
{
    return toy().features.row(u).transpose();
}

TEST(ClearanceModel, predictsWhatTrainingLeftOver)
{
    // y = prediction + residual of the full fit; leave-one-out residuals are larger than those. With
    // several rows of a place, this holds for their sum only.
    const std::vector<int> places = placesOf(toy());
    const ClearanceModel model(toy());
    const Eigen::MatrixXd ceilings = bodyCeilings(toy().features, absolem());
    double fit = 0.0;
    double leftOut = 0.0;
    for (Eigen::Index u = 0; u < toy().heights.rows(); ++u) {
        const unsigned covered = toy().clearance.coveredBins[static_cast<std::size_t>(u)];
        const Heights y = model.predict(row(u), covered);
        for (int i = 0; i < kBins; ++i) {
            const double residual =
                toSurface(toy().heights(u, i), ceilings(u, i)) - y[static_cast<std::size_t>(i)];
            fit += residual * residual;
            leftOut += std::pow(toy().clearance.residuals(u, i), 2.0);
            if (std::count(places.begin(), places.end(), places[static_cast<std::size_t>(u)]) > 1)
                continue;
            EXPECT_LE(std::abs(residual), std::abs(toy().clearance.residuals(u, i)) + 1e-6);
        }
    }
    EXPECT_LT(fit, leftOut);
}

TEST(ClearanceModel, covarianceIsThatOfCompleteScenes)
{
    ModelData holed = toy();
    holed.unknownBins.assign(static_cast<std::size_t>(toy().heights.rows()), 0U);
    ModelData marked = holed;
    const Eigen::Index last = toy().heights.rows() - 1;
    // Every row is an inducing row here, so the processes lose a weight with the last row.
    holed.unknownBins.back() = (1U << unsigned{kBins}) - 1U;
    holed.heights.row(last).setZero();
    holed.clearance.residuals.row(last).setZero();
    for (int bin = 0; bin < kBins; ++bin)
        for (const bool covered : {false, true}) {
            auto& process = (covered ? holed.clearance.covered
                                     : holed.clearance.open)[static_cast<std::size_t>(bin)];
            const auto rows = inducingRows(rowsOf(holed, bin, covered)).size();
            if (process.weights.size() > 0)
                process.weights.conservativeResize(static_cast<Eigen::Index>(rows));
        }
    marked.clearance.residuals.row(last).setConstant(1000.0);
    const unsigned covered = toy().clearance.coveredBins.back();
    const Eigen::MatrixXd c = ClearanceModel(holed).residualCovariance(covered);
    EXPECT_LT(c.trace(), 0.1 * ClearanceModel(marked).residualCovariance(covered).trace());
    EXPECT_NEAR(c.trace(), ClearanceModel(toy()).residualCovariance(covered).trace(),
                0.2 * c.trace());
}

TEST(ClearanceModel, weighsTheResidualsOfLikeScenes)
{
    const ClearanceModel model(toy());
    const unsigned covered = toy().clearance.coveredBins[5];
    const ResidualSample sample = model.localResiduals(row(5), covered);
    EXPECT_NEAR(sample.weight.sum(), 1.0, 1e-12);
    EXPECT_LE(sample.weight.size(), kNeighbours);
    EXPECT_EQ(sample.residual.rows(), kBins);
    EXPECT_TRUE(sample.residual.allFinite());
    // The scene itself is the nearest scene.
    Eigen::Index heaviest = 0;
    sample.weight.maxCoeff(&heaviest);
    EXPECT_TRUE(sample.residual.col(heaviest).isApprox(toy().clearance.residuals.row(5).transpose(),
                                                       1e-12));
}

TEST(ClearanceModel, aPlaceLendsOneResidualOnly)
{
    std::vector<int> places = placesOf(toy());
    for (std::size_t u = 3; u < 60; ++u) places[u] = 3;
    const ClearanceModel model(toy(), {}, places);
    const ResidualSample sample = model.localResiduals(row(5), toy().clearance.coveredBins[5]);
    ASSERT_EQ(sample.weight.size(), kNeighbours);
    int shared = 0;
    for (Eigen::Index u = 3; u < 60; ++u)
        for (Eigen::Index k = 0; k < kNeighbours; ++k)
            shared += sample.residual(0, k) == toy().clearance.residuals(u, 0) ? 1 : 0;
    EXPECT_EQ(shared, 1);
    EXPECT_THROW(ClearanceModel(toy(), {}, {1, 2}), std::invalid_argument);
}

TEST(ClearanceModel, borrowsResidualsIfFewScenesMatch)
{
    const ClearanceModel model(toy());
    for (const unsigned covered : {0x003U, 0x7FFU, 0x000U, 0x0FFU}) {
        const ResidualSample sample = model.localResiduals(row(5), covered);
        EXPECT_TRUE(sample.residual.allFinite()) << covered;
        const Heights y = model.predict(row(5), covered);
        EXPECT_TRUE(std::all_of(y.begin(), y.end(), [](double v) { return std::isfinite(v); }));
        const Eigen::MatrixXd c = model.residualCovariance(covered);
        EXPECT_TRUE(c.allFinite() && (c.diagonal().array() > 0.0).all()) << covered;
    }
}

TEST(ClearanceModel, covarianceWeighsEachPlaceOnce)
{
    const ClearanceModel model(toy());
    const ClearanceData& data = toy().clearance;
    const unsigned covered = data.coveredBins[5];
    const Eigen::MatrixXd c = model.residualCovariance(covered);
    const std::vector<int> places = placesOf(toy());
    for (int i = 0; i < kBins; ++i) {
        double sum = 0.0;
        double count = 0.0;
        for (Eigen::Index u = 0; u < data.residuals.rows(); ++u) {
            if (isCovered(data.coveredBins[static_cast<std::size_t>(u)], i)
                != isCovered(covered, i))
                continue;
            const double weight =
                1.0
                / static_cast<double>(
                    std::count(places.begin(), places.end(), places[static_cast<std::size_t>(u)]));
            sum += weight * data.residuals(u, i) * data.residuals(u, i);
            count += weight;
        }
        EXPECT_NEAR(c(i, i), sum / count, 1e-9 * c(i, i)) << i;  // variances stay as they are
    }
}

TEST(ClearanceModel, callsOneTrainingSceneInAHundredNovel)
{
    const ClearanceModel model(toy());
    const Eigen::Index rows = toy().features.rows();
    int novel = 0;
    for (Eigen::Index u = 0; u < rows; ++u) novel += model.novelty(row(u)) > 1.0 ? 1 : 0;
    EXPECT_LE(novel, 0.02 * static_cast<double>(rows) + 1.0);
    Eigen::VectorXd strange = row(0);
    strange.tail(6).setConstant(500.0);
    EXPECT_GT(model.novelty(strange), 1.0);
}

TEST(ClearanceModel, refusesAModelWithoutClearancesAndAnIncompleteS)
{
    ModelData without = toy();
    without.clearance = {};
    EXPECT_THROW(ClearanceModel{without}, std::invalid_argument);
    const ClearanceModel model(toy());
    EXPECT_THROW((void)model.predict(Eigen::VectorXd::Zero(3), 0), std::invalid_argument);
    EXPECT_THROW((void)model.novelty(Eigen::VectorXd::Constant(11, std::nan(""))),
                 std::invalid_argument);
}

TEST(ClearanceTraining, givesAContactTheGainItHas)
{
    // The toy's forces are part of s. The sd of a contact is always positive and finite.
    EXPECT_GE(toy().clearance.contactSd, 0.005);
    EXPECT_LE(toy().clearance.contactSd, 10.0);
    EXPECT_LE(std::abs(toy().clearance.contactBias), 0.1);
}

/// Isolated contacts of a training row of the toy.
OptionalHeights contactsOf(Eigen::Index u)
{
    FeatureValues values;
    for (std::size_t d = 0; d < kFeatures; ++d)
        values[d] = toy().features(u, static_cast<Eigen::Index>(d));
    return reconstructContacts(absolem(), proprioception(values), 2.0, true).height;
}

TEST(ClearanceTraining, aContactsBiasIsItsOwnErrorNotThePredictions)
{
    // Every prediction is 2 cm too high on average, and contacts show 1 cm of its error. The residuals
    // hold the 2 cm already.
    ModelData model = toy();
    const Eigen::MatrixXd ceilings = bodyCeilings(model.features, absolem());
    double errors = 0.0, count = 0.0;
    for (Eigen::Index u = 0; u < model.heights.rows(); ++u) {
        const OptionalHeights contacts = contactsOf(u);
        for (int i = 0; i < kBins; ++i) {
            const double h = model.heights(u, i);
            const double m = h + 0.02 + (u % 2 == 0 ? 0.01 : -0.01);
            model.clearance.residuals(u, i) =
                toSurface(h, ceilings(u, i)) - toSurface(m, ceilings(u, i));
            const auto& z = contacts[static_cast<std::size_t>(i)];
            if (!z || std::abs(*z - m) > 0.1) continue;
            errors += h - *z;
            count += 1.0;
        }
    }
    finishClearance(model, ceilings, absolem());
    EXPECT_LT(model.clearance.contactSd, 10.0) << "contacts tell something";
    EXPECT_NEAR(model.clearance.contactBias, errors / count, 1e-9);
}

TEST(ClearanceTraining, needsOneRowOfCeilingsPerScene)
{
    ModelData model = toy();
    EXPECT_THROW(prepareClearance(model, Eigen::MatrixXd::Zero(3, kBins)), std::invalid_argument);
}

TEST(Rows, areSplitByRegimeAndThinnedEvenly)
{
    const std::vector<unsigned> masks{1U, 0U, 1U, 3U};
    EXPECT_EQ(rowsOf(masks, {}, 0, true), (std::vector<int>{0, 2, 3}));
    EXPECT_EQ(rowsOf(masks, {}, 0, false), (std::vector<int>{1}));
    std::vector<int> many(2000);
    for (std::size_t k = 0; k < many.size(); ++k) many[k] = static_cast<int>(2 * k);
    const std::vector<int> chosen = inducingRows(many);
    ASSERT_EQ(chosen.size(), static_cast<std::size_t>(kInducing));
    EXPECT_EQ(chosen.front(), 0);
    EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
    EXPECT_GT(chosen.back(), 3980);
}

TEST(ClearanceTraining, residualsLeaveOutTheSdOfTheTruth)
{
    auto scenes = someScenes(10, 7);
    const auto residualSd = [](const std::vector<Scene>& of) {
        ModelData model = prepareTraining(of).model;
        trainToyClearances(model);
        return model.clearance.open[9].residualSd;
    };
    const double exact = residualSd(scenes);
    std::mt19937_64 rng(4);
    std::normal_distribution<double> normal;
    for (Scene& scene : scenes) *scene.truth[9] += 0.1 * normal(rng);
    const double untold = residualSd(scenes);
    for (Scene& scene : scenes) scene.truthSd[9] = 0.1;
    const double told = residualSd(scenes);
    EXPECT_GT(untold, exact + 0.02);
    EXPECT_NEAR(told, exact, 0.015);
}

}  // namespace
}  // namespace terratact
