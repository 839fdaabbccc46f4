#include "core/learn/model/side_training.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <stdexcept>

#include "core/learn/data/scene_copies.h"
#include "core/learn/data/side_features.h"
#include "core/learn/model/file/model_file.h"
#include "core/learn/model/reduced_clearances.h"
#include "tests/support/random_model.h"
#include "tests/support/refusal.h"
#include "tests/support/sessions/execute_sql.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/toy_sides.h"

namespace terratact {
namespace {

const SurfaceData& toy()
{
    static const SurfaceData sides = toySides(12);
    return sides;
}

ModelData withSides()
{
    ModelData model = randomModel(3);
    model.sides = toy();
    model.sidesHash = std::string(64, 'b');
    model.sidesCommand = "terratact train --tracks two.csv --out model.ttm";
    return model;
}

TEST(SideTraining, learnsFromBothSidesOfEveryScene)
{
    std::vector<TwoTrackScene> scenes = someTrackScenes(6, 3);
    scenes[0].s.currents[0].reset();
    const SideTrainingSet set = prepareSides(scenes);
    EXPECT_EQ(set.leftOut, 1);
    ASSERT_EQ(set.rows.heights.rows(), 2 * set.used);
    EXPECT_NEAR(set.rows.features(1, 1), -set.rows.features(0, 1), 1e-15);
    EXPECT_NEAR(set.rows.heights(1, 4), *scenes[1].truth[1][4], kHeightStep);
    scenes.resize(5);
    EXPECT_THROW((void)prepareSides(scenes), std::invalid_argument);
}

/// Returns scenes of different places: level ground may look the same at two stops.
std::vector<TwoTrackScene> differentScenes()
{
    const std::vector<TwoTrackScene> all = someTrackScenes(6, 3);
    std::vector<const TwoTrackScene*> pointers;
    for (const TwoTrackScene& scene : all) pointers.push_back(&scene);
    std::vector<TwoTrackScene> different;
    for (const TwoTrackScene* const scene : withoutCopies(pointers).kept)
        different.push_back(*scene);
    EXPECT_GE(different.size(), all.size() * 9 / 10);
    return different;
}

TEST(SideTraining, leavesCopiesOut)
{
    const std::vector<TwoTrackScene> once = differentScenes();
    const SideTrainingSet single = prepareSides(once);
    EXPECT_EQ(single.exactCopies + single.nearCopies, 0);
    std::vector<TwoTrackScene> more = once;
    for (std::size_t k = 0; k < once.size(); ++k) {
        TwoTrackScene copy = k % 2 == 0 ? once[k] : mirrored(once[k]);
        copy.run = "again";
        if (k % 3 == 0) {
            copy.s.pitch += 0.01;
            copy.s.forces[0][2] = copy.s.forces[0][2].value_or(0.0) + 0.2;
            copy.truth[1][3] = *copy.truth[1][3] + 0.005;
        }
        more.push_back(copy);
    }
    const SideTrainingSet set = prepareSides(more);
    EXPECT_EQ(set.rows.features, single.rows.features);
    EXPECT_EQ(set.rows.heights, single.rows.heights);
    EXPECT_EQ(set.leftOut, 0);
    EXPECT_EQ(set.nearCopies, static_cast<int>((once.size() + 2) / 3));
    EXPECT_EQ(set.exactCopies + set.nearCopies, static_cast<int>(once.size()));
    EXPECT_EQ(set.runsWithCopies, std::set<std::string>{"again"});
}

/// Returns scenes in which every third right side does not know bins 5 and 10.
std::vector<TwoTrackScene> withHoles(std::vector<TwoTrackScene> scenes)
{
    for (std::size_t k = 0; k < scenes.size(); k += 3) {
        scenes[k].truth[1][5].reset();
        scenes[k].truth[1][10].reset();
    }
    return scenes;
}

TEST(SideTraining, learnsTheKnownBinsOfScenesWithHoles)
{
    const std::vector<TwoTrackScene> scenes = differentScenes();
    const SideTrainingSet whole = prepareSides(scenes), holed = prepareSides(withHoles(scenes));
    EXPECT_EQ(whole.withHoles, 0);
    EXPECT_TRUE(whole.rows.unknownBins.empty());
    EXPECT_EQ(holed.leftOut, 0);
    EXPECT_EQ(holed.withHoles, (whole.used + 2) / 3);
    const unsigned hole = 1U << 5U | 1U << 10U;
    EXPECT_EQ(holed.rows.unknownBins[0], 0U);
    EXPECT_EQ(holed.rows.unknownBins[1], hole);
    EXPECT_EQ(std::ssize(completeRows(holed.rows)), 2 * holed.used - holed.withHoles);
    EXPECT_EQ(holed.rows.heights.col(4), whole.rows.heights.col(4));
    EXPECT_EQ(holed.rows.heights(1, 5), 0.0);
    EXPECT_EQ(holed.rows.heights(0, 5), whole.rows.heights(0, 5));
}

TEST(SideTraining, namesTheBinThatTooFewScenesKnow)
{
    std::vector<TwoTrackScene> scenes = differentScenes();
    for (std::size_t k = 12; k < scenes.size(); ++k)
        for (OptionalHeights& side : scenes[k].truth) side[10].reset();
    try {
        (void)prepareSides(scenes);
        FAIL() << "12 scenes are too few";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("bin +0.7 m on one side, found 12"),
                  std::string::npos)
            << error.what();
    }
}

TEST(SideTraining, aHoleTouchesItsOwnBinsOnly)
{
    const SurfaceData holed = toySides(withHoles(someTrackScenes(8, 1)));
    const SurfaceData whole = toySides(someTrackScenes(8, 1));
    const ClearanceData &with = holed.clearance, &without = whole.clearance;
    for (const std::size_t bin : {0U, 4U, 6U, 9U}) {
        EXPECT_EQ(with.covered[bin].weights, without.covered[bin].weights) << bin;
        EXPECT_EQ(with.open[bin].weights, without.open[bin].weights) << bin;
    }
    EXPECT_EQ(with.residuals.col(4), without.residuals.col(4));
    EXPECT_EQ(with.residuals(1, 5), 0.0);
    const double shift = with.open[10].mean - without.open[10].mean;
    EXPECT_NE(shift, 0.0);
    EXPECT_LT(std::abs(shift), 0.25 * without.open[10].residualSd) << "0 was no height";
    EXPECT_NEAR(with.open[10].residualSd, without.open[10].residualSd,
                0.3 * without.open[10].residualSd);
}

TEST(SideTraining, aHoleTakesTheResidualOfAnotherScene)
{
    const SurfaceData holed = toySides(withHoles(someTrackScenes(8, 1)));
    const ClearanceModel model(holed);
    const auto& covered = holed.clearance.coveredBins;
    const ResidualSample sample =
        model.sideResiduals(model, holed.features.row(0).transpose(), {covered[0], covered[1]});
    Eigen::Index nearest = 0;  // the scene itself
    sample.weight.maxCoeff(&nearest);
    EXPECT_EQ(sample.residual(4, nearest), holed.clearance.residuals(0, 4));
    EXPECT_EQ(sample.residual(kBins + 4, nearest), holed.clearance.residuals(1, 4));
    const double borrowed = sample.residual(kBins + 10, nearest);
    EXPECT_NE(borrowed, 0.0);
    EXPECT_TRUE((holed.clearance.residuals.col(10).array() == borrowed).any());
    const Eigen::MatrixXd c = model.sideCovariance(model, {covered[0], covered[1]});
    EXPECT_TRUE(c.allFinite() && (c.diagonal().array() > 0.0).all());
}

TEST(SideTraining, estimatesWithoutAnyCompleteScene)
{
    std::vector<TwoTrackScene> scenes = someTrackScenes(8, 1);
    for (std::size_t k = 0; k < scenes.size(); ++k) scenes[k].truth[k % 2][k % kBins].reset();
    const SurfaceData holed = toySides(scenes);
    const ClearanceModel model(holed);
    const auto& covered = holed.clearance.coveredBins;
    const Eigen::MatrixXd c = model.sideCovariance(model, {covered[0], covered[1]});
    EXPECT_TRUE(c.allFinite() && (c.diagonal().array() > 0.0).all());
    const double sd = holed.clearance.open[10].residualSd;
    EXPECT_NEAR(std::sqrt(c(10, 10)), sd, 1e-12);
}

TEST(SideTraining, aFileKeepsItsHoles)
{
    const TemporaryDirectory dir;
    ModelData sent = withSides();
    sent.sides = toySides(withHoles(someTrackScenes(8, 1)));
    ASSERT_TRUE(writeModel(dir.file("tracks.ttm"), sent));
    const auto read = readModel(dir.file("tracks.ttm"));
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->data.sides.unknownBins, sent.sides.unknownBins);
    EXPECT_EQ(read->contentHash, contentHash(sent));
    executeSql(dir.file("tracks.ttm"),
               "UPDATE side_unknown_bins_row SET unknown_bins = 1 WHERE row = 1");
    EXPECT_TRUE(refused(readModel(dir.file("tracks.ttm")), dir.file("tracks.ttm"),
                        {"a number for a height that is unknown"}));
}

TEST(SideTraining, aModelPredictsTheGroundItLearnt)
{
    const ClearanceModel model(toy());
    double squares = 0.0, variance = 0.0;
    const double mean = toy().heights.col(10).mean();
    for (Eigen::Index u = 0; u < toy().heights.rows(); ++u) {
        const Heights y = model.predict(toy().features.row(u).transpose(),
                                        toy().clearance.coveredBins[static_cast<std::size_t>(u)]);
        squares += std::pow(y[10] - toy().heights(u, 10), 2.0);
        variance += std::pow(mean - toy().heights(u, 10), 2.0);
    }
    EXPECT_LT(squares, 0.8 * variance);
}

TEST(SideTraining, residualsOfBothSidesStayTogether)
{
    const ClearanceModel model(toy());
    const auto& covered = toy().clearance.coveredBins;
    const ResidualSample sample =
        model.sideResiduals(model, toy().features.row(8).transpose(), {covered[8], covered[9]});
    ASSERT_EQ(sample.residual.rows(), 2 * kBins);
    EXPECT_NEAR(sample.weight.sum(), 1.0, 1e-12);
    Eigen::Index nearest = 0;  // the scene itself
    sample.weight.maxCoeff(&nearest);
    EXPECT_TRUE(sample.residual.col(nearest).head(kBins).isApprox(
        toy().clearance.residuals.row(8).transpose()));
    EXPECT_TRUE(sample.residual.col(nearest).tail(kBins).isApprox(
        toy().clearance.residuals.row(9).transpose()));
    const Eigen::MatrixXd c = model.sideCovariance(model, {covered[8], covered[9]});
    EXPECT_TRUE(c.allFinite() && (c.diagonal().array() > 0.0).all());
    EXPECT_THROW((void)ClearanceModel(randomModel(40)).sideResiduals(model, {}, {}),
                 std::invalid_argument);
}

TEST(SideTraining, processesWorkWithoutAnyArray)
{
    const ReducedClearances reduced(toy(), absolem());
    AbsentFeatures absent;
    for (std::size_t d = kFirstSideForce; d < kSideFeatures; ++d) absent[d] = true;
    const auto model = reduced.without(absent);
    Eigen::VectorXd s = toy().features.row(4).transpose();
    const unsigned covered = toy().clearance.coveredBins[4];
    const Heights before = model->predict(s, covered);
    s.tail(12).setConstant(500.0);
    EXPECT_EQ(model->predict(s, covered), before);
    absent[1] = true;  // roll
    EXPECT_THROW((void)reduced.without(absent), std::invalid_argument);
}

TEST(SideTraining, aFileKeepsEveryBit)
{
    const TemporaryDirectory dir;
    const std::string path = dir.file("tracks.ttm");
    const ModelData sent = withSides();
    ASSERT_TRUE(writeModel(path, sent));
    const auto read = readModel(path);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->contentHash, contentHash(sent));
    EXPECT_NE(read->contentHash, contentHash(randomModel(3)));
    EXPECT_EQ(read->data.sidesCommand, sent.sidesCommand);
    const SurfaceData& sides = read->data.sides;
    EXPECT_EQ(sides.features, toy().features);
    EXPECT_EQ(sides.heights, toy().heights);
    EXPECT_EQ(sides.clearance.residuals, toy().clearance.residuals);
    EXPECT_EQ(sides.clearance.coveredBins, toy().clearance.coveredBins);
    EXPECT_EQ(sides.clearance.covered[3].weights, toy().clearance.covered[3].weights);
}

TEST(SideTraining, aDamagedFileIsRefused)
{
    const TemporaryDirectory dir;
    const std::string path = dir.file("tracks.ttm");
    for (const auto& [sql, part] :
         {std::pair("UPDATE side_row SET pitch = 900000 WHERE row = 1", "row 2 of two tracks"),
          std::pair("UPDATE side_row SET left_covered_bins = 4096 WHERE row = 0", "covers a bin"),
          std::pair("DELETE FROM side_row WHERE row = 2", "not numbered from 0"),
          std::pair("UPDATE side_surface SET mean = mean + 1", "altered"),
          std::pair("DELETE FROM side_surface_input WHERE position = 21", "ends too early"),
          std::pair("DROP TABLE side_row", "tables"),
          std::pair("PRAGMA user_version = 3", "tables"),
          std::pair("PRAGMA user_version = 5", "terratact train")}) {
        ASSERT_TRUE(writeModel(path, withSides()));
        executeSql(path, sql);
        EXPECT_TRUE(refused(readModel(path), path, {part})) << sql;
    }
}

}  // namespace
}  // namespace terratact
