#include "core/learn/model/side_training.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <stdexcept>

#include "core/learn/data/side_features.h"
#include "core/learn/model/model_file.h"
#include "core/learn/model/reduced_clearances.h"
#include "tests/support/random_model.h"
#include "tests/support/refusal.h"
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

void execute(const std::string& path, const std::string& sql)
{
    sqlite3* file = nullptr;
    sqlite3_open(path.c_str(), &file);
    const int code = sqlite3_exec(file, sql.c_str(), nullptr, nullptr, nullptr);
    sqlite3_close(file);
    ASSERT_EQ(code, SQLITE_OK) << sql;
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
        execute(path, sql);
        EXPECT_TRUE(refused(readModel(path), path, {part})) << sql;
    }
}

}  // namespace
}  // namespace terratact
