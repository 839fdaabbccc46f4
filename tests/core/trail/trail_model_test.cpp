#include "core/trail/trail_model.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <random>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/infer/estimate/hazards.h"
#include "core/infer/two_track_estimator.h"
#include "core/learn/model/file/model_file.h"
#include "core/trail/trail_file.h"
#include "core/trail/trail_inputs.h"
#include "core/trail/trail_record.h"
#include "tests/support/absolem.h"
#include "tests/support/small_trail.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(TrailModel, FileKeepsEveryBit)
{
    const TemporaryDirectory folder;
    const std::string path = folder.file("small.ttn");
    ASSERT_TRUE(writeTrail(path, smallTrail()));
    const auto stored = readTrail(path);
    ASSERT_TRUE(stored) << stored.error().message.english();
    EXPECT_EQ(stored->data.command, smallTrail().command);
    const TrailModel before(smallTrail()), after(stored->data);
    const Eigen::VectorXd inputs = Eigen::VectorXd::LinSpaced(kPlaneInputs, -1.0, 1.0);
    EXPECT_EQ(stored->data.side.errors.drive, smallTrail().side.errors.drive);
    EXPECT_EQ(stored->data.plane.drives, smallTrail().plane.drives);
    EXPECT_EQ(stored->data.side.drives, smallTrail().side.drives);
    EXPECT_EQ(before.plane(inputs, 0x1FF).mean, after.plane(inputs, 0x1FF).mean);
    EXPECT_EQ(before.plane(inputs, 0x1FF).errors.residual,
              after.plane(inputs, 0x1FF).errors.residual);
    const std::array<Eigen::VectorXd, 2> both{Eigen::VectorXd::LinSpaced(kSideInputs, -1.0, 1.0),
                                              Eigen::VectorXd::LinSpaced(kSideInputs, 1.0, -1.0)};
    EXPECT_EQ(before.sides(both, {0x1FF, 0xFF}).mean, after.sides(both, {0x1FF, 0xFF}).mean);
}

TEST(TrailModel, FilesWithoutTrainingDrivesAreRead)
{
    const auto shipped = readTrail(TERRATACT_SOURCE_DIR "/resources/models/default.ttn");
    ASSERT_TRUE(shipped) << shipped.error().message.english();
    EXPECT_TRUE(shipped->data.plane.drives.empty() && shipped->data.side.drives.empty());
    const TemporaryDirectory folder;
    const std::string path = folder.file("again.ttn");
    ASSERT_TRUE(writeTrail(path, shipped->data));
    const auto again = readTrail(path);
    ASSERT_TRUE(again) << again.error().message.english();
    EXPECT_EQ(again->contentHash, shipped->contentHash);
}

TEST(TrailModel, DamagedFilesAreRefused)
{
    const TemporaryDirectory folder;
    const std::string path = folder.file("small.ttn");
    ASSERT_TRUE(writeTrail(path, smallTrail()));
    const std::string hash = readTrail(path)->contentHash;
    std::string bytes;
    {
        std::ifstream in(path, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
    }
    std::mt19937_64 rng(5);
    int refused = 0;
    for (int k = 0; k < 60; ++k) {
        std::string spoilt = bytes;
        spoilt[rng() % spoilt.size()] ^= static_cast<char>(1U << (rng() % 8U));
        std::ofstream(path, std::ios::binary) << spoilt;
        const auto read = readTrail(path);
        if (read) {  // a bit in the unused bytes of a page
            EXPECT_EQ(read->contentHash, hash);
            continue;
        }
        ++refused;
        EXPECT_NE(read.error().message.english().find("small.ttn"), std::string::npos);
    }
    EXPECT_GT(refused, 20);
    EXPECT_FALSE(readTrail(folder.file("none.ttn")));
    EXPECT_FALSE(readTrail(TERRATACT_SOURCE_DIR "/resources/models/one_plane.ttm"));
}

TEST(TrailModel, HostileRowsAreRefused)
{
    const TemporaryDirectory folder;
    const std::string path = folder.file("small.ttn");
    for (const char* change : {"UPDATE layer SET network = -1",
                               "DELETE FROM layer WHERE layer = 0",
                               "UPDATE layer SET outputs = 1000000, inputs = 1000000",
                               "UPDATE scale SET sd = -1.0",
                               "UPDATE input SET kind = 'other' WHERE kind = 'plane'",
                               "DELETE FROM layer",
                               "UPDATE error SET covered_left = -5",
                               "UPDATE error SET residual = x'00'",
                               "DELETE FROM layer WHERE kind = 'side'",
                               "DELETE FROM layer WHERE network = 2",
                               "UPDATE layer SET outputs = 1 WHERE network = 2",
                               "DELETE FROM drive WHERE drive = 0",
                               "UPDATE drive SET scenes = x''",
                               "UPDATE drive SET scenes = x'00'",
                               "UPDATE drive SET scenes = x'0000000000000000'",
                               "UPDATE drive SET kind = 'other'",
                               "UPDATE drive SET drive = drive + 1",
                               "DROP TABLE drive",
                               "PRAGMA user_version = 3",
                               "UPDATE meta SET value = 'x' WHERE key = 'seed'"}) {
        ASSERT_TRUE(writeTrail(path, smallTrail()));
        {
            sqlite3* file = nullptr;
            ASSERT_EQ(sqlite3_open(path.c_str(), &file), SQLITE_OK);
            EXPECT_EQ(sqlite3_exec(file, change, nullptr, nullptr, nullptr), SQLITE_OK) << change;
            sqlite3_close(file);
        }
        const auto read = readTrail(path);
        ASSERT_FALSE(read) << change;
        EXPECT_NE(read.error().message.english().find("small.ttn"), std::string::npos) << change;
    }
}

TEST(TrailModel, ARegimeThatWasNeverTrainedIsNotKnown)
{
    TrailData data = smallTrail();
    data.plane.covered[2].sd = 0.0;
    const TrailModel model(data);
    EXPECT_FALSE(model.knowsPlane(0x1FF));
    EXPECT_EQ(model.knowsPlane(0x1FB), TrailModel(smallTrail()).knowsPlane(0x1FB));
}

TEST(TrailModel, AMirroredSceneHasAMirroredPrediction)
{
    const TrailModel model(smallTrail());
    const Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(kSideInputs, -1.0, 1.0);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(kSideInputs, 0.5, -0.2);
    const TrailPrediction one = model.sides({a, b}, {0x1FF, 0xFF});
    const TrailPrediction other = model.sides({b, a}, {0xFF, 0x1FF});
    EXPECT_EQ(one.mean.head(kBins), other.mean.tail(kBins));
    EXPECT_NEAR(
        (one.errors.residual.array().square().matrix() * one.errors.weight).head(kBins).sum(),
        (other.errors.residual.array().square().matrix() * other.errors.weight).tail(kBins).sum(),
        1e-9);
}

/// Returns errors of this many scenes in each of some drives. The error of a scene is the number of its drive.
TrailErrors errorsByDrive(int drives, int scenes)
{
    const Eigen::Index n = Eigen::Index{drives} * scenes;
    TrailErrors errors{Eigen::MatrixXf::Zero(kBins, n), Eigen::MatrixXf(kBins, n), {}, {}};
    for (int k = 0; k < static_cast<int>(n); ++k) {
        errors.drive.push_back(k / scenes);
        errors.residual.col(k).setConstant(static_cast<float>(errors.drive.back()));
        errors.covered.push_back({0x1FF, 0x1FF});
    }
    return errors;
}

/// Returns how many different errors form those of a scene, and how many scenes.
std::pair<std::size_t, Eigen::Index> differentErrors(TrailErrors errors)
{
    TrailData data = smallTrail();
    data.plane.errors = std::move(errors);
    const Eigen::VectorXd inputs = Eigen::VectorXd::LinSpaced(kPlaneInputs, -1.0, 1.0);
    const TrailPrediction prediction = TrailModel(data).plane(inputs, 0x1FF);
    const Eigen::VectorXd last = prediction.errors.residual.row(kBins - 1);
    return {std::set<double>(last.begin(), last.end()).size(), last.size()};
}

TEST(TrailModel, EachDriveGivesOneErrorIfThereAreEnough)
{
    EXPECT_EQ(differentErrors(errorsByDrive(80, 40)), std::pair(std::size_t{60}, Eigen::Index{60}));
    EXPECT_EQ(differentErrors(errorsByDrive(60, 1)), std::pair(std::size_t{60}, Eigen::Index{60}));
}

TEST(TrailModel, FewDrivesGiveAnEqualShareOfTheErrors)
{
    EXPECT_EQ(differentErrors(errorsByDrive(20, 40)), std::pair(std::size_t{20}, Eigen::Index{60}));
    EXPECT_EQ(differentErrors(errorsByDrive(2, 40)), std::pair(std::size_t{2}, Eigen::Index{60}));
}

TEST(TrailModel, ErrorsSurroundThePrediction)
{
    const TrailModel model(smallTrail());
    const TrailPrediction plane =
        model.plane(Eigen::VectorXd::LinSpaced(kPlaneInputs, -1.0, 1.0), 0x1FF);
    EXPECT_LT((plane.errors.residual * plane.errors.weight).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(TrailModel, ErrorsHaveTheirExpectedSize)
{
    TrailData doubled = smallTrail();
    const float more = std::log(2.0F);
    doubled.plane.size.layers[0].bias.array() += more;
    doubled.side.size.layers[0].bias[3] += more;
    const TrailModel before(smallTrail()), after(doubled);
    const Eigen::VectorXd inputs = Eigen::VectorXd::LinSpaced(kPlaneInputs, -1.0, 1.0);
    const Eigen::MatrixXd residual = before.plane(inputs, 0x1FF).errors.residual;
    EXPECT_TRUE(after.plane(inputs, 0x1FF).errors.residual.isApprox(2.0 * residual, 1e-5));
    const std::array<Eigen::VectorXd, 2> both{Eigen::VectorXd::LinSpaced(kSideInputs, -1.0, 1.0),
                                              Eigen::VectorXd::LinSpaced(kSideInputs, 1.0, -1.0)};
    Eigen::MatrixXd sides = before.sides(both, {0x1FF, 0xFF}).errors.residual;
    sides.row(3) *= 2.0;
    sides.row(kBins + 3) *= 2.0;
    EXPECT_TRUE(after.sides(both, {0x1FF, 0xFF}).errors.residual.isApprox(sides, 1e-5));
}

TEST(TrailModel, MirroredReadingsHaveMirroredInputs)
{
    const DriveLines drive = driveOnSides(3);
    TrailRecord record(absolem());
    for (const DriveLine& line : drive.lines)
        if (!line.isScene) record.add(line.line);
    const Measurement& last = drive.lines.back().line;
    TrailHistory history = record.before(last);
    TrailHistory swapped = history;
    std::swap(swapped.ground[1], swapped.ground[2]);
    for (double& roll : swapped.roll) roll = -roll;
    const TwoTrackReadings s = twoTrackReadings(last);
    Heights ceiling{};
    EXPECT_EQ(sideInputs(s, Side::Left, history, ceiling),
              sideInputs(mirrored(s), Side::Right, swapped, ceiling));
}

/// The shipped model with the small networks.
const Models& modelsWithTrail()
{
    static const std::unique_ptr<const Models> models = [] {
        const StoredModel stored = *readModel(TERRATACT_SOURCE_DIR "/resources/models/default.ttm");
        auto own = std::make_unique<Models>(stored.data, absolem());
        own->trail = std::make_shared<const TrailModel>(smallTrail());
        return own;
    }();
    return *models;
}

TEST(TrailModel, EstimatesPlanesAndSidesWithAHistory)
{
    const Models& models = modelsWithTrail();
    Settings settings;
    settings.method = Method::Trail;
    for (const DriveLines& drive : {driveOnPlane(90), driveOnSides(91)}) {
        TrailRecord record(absolem());
        int scenes = 0;
        for (const DriveLine& line : drive.lines) {
            if (!line.isScene) {
                record.add(line.line);
                continue;
            }
            const TrailHistory history = record.before(line.line);
            const TwoTrackEstimate estimate =
                estimateMeasured(line.line, {}, absolem(), models, settings, {}, &history);
            const bool isFirst = history.way == 0.0;
            EXPECT_EQ(estimate.side[0].settings.method, Method::Trail);
            bool isForgotten = false;
            for (const Message& warning : estimate.side[0].warnings)
                isForgotten = isForgotten || warning.source.starts_with("nothing of the way");
            EXPECT_EQ(isForgotten, isFirst);
            for (std::size_t i = 0; i < kBins; ++i)
                EXPECT_LE(estimate.side[0].q10[i], estimate.side[0].q90[i]);
            record.addScene(line.line);
            ++scenes;
        }
        EXPECT_GT(scenes, 3);
    }
}

TEST(TrailModel, WithoutAHistoryLocalEstimates)
{
    const Models& models = modelsWithTrail();
    const DriveLines drive = driveOnPlane(90);
    const auto scene = std::find_if(drive.lines.begin(), drive.lines.end(),
                                    [](const DriveLine& line) { return line.isScene; });
    ASSERT_NE(scene, drive.lines.end());
    Settings settings;
    settings.method = Method::Trail;
    const TwoTrackEstimate forgotten =
        estimateMeasured(scene->line, {}, absolem(), models, settings);
    settings.method = Method::Local;
    const TwoTrackEstimate local = estimateMeasured(scene->line, {}, absolem(), models, settings);
    EXPECT_EQ(forgotten.side[0].height, local.side[0].height);
    EXPECT_EQ(forgotten.side[0].q90, local.side[0].q90);
    ASSERT_FALSE(forgotten.side[0].warnings.empty());
    EXPECT_EQ(forgotten.side[0].warnings.front().source,
              "nothing of the way is remembered: this scene alone counts");
}

/// The first scene of a drive behind 0.5 m of way, and what is remembered before it.
struct RememberedScene {
    Measurement scene;
    TrailHistory history;
};

RememberedScene rememberedScene()
{
    TrailRecord record(absolem());
    for (const DriveLine& line : driveOnPlane(92).lines) {
        if (!line.isScene)
            record.add(line.line);
        else if (record.length() > 0.5)
            return {line.line, record.before(line.line)};
        else
            record.addScene(line.line);
    }
    throw std::runtime_error("the drive is shorter than 0.5 m");
}

TwoTrackEstimate estimateOf(const RememberedScene& at, std::span<const ArmReading> readings = {})
{
    Settings settings;
    settings.method = Method::Trail;
    return estimateMeasured(at.scene, readings, absolem(), modelsWithTrail(), settings, {},
                            &at.history);
}

TEST(TrailModel, AProbeMovesItsBin)
{
    const RememberedScene at = rememberedScene();
    const double target = estimateOf(at).side[0].height[9] - 0.1;
    const ArmReading reading{.bin = 9, .height = target, .sd = 0.01};
    const TwoTrackEstimate after = estimateOf(at, {&reading, 1});
    EXPECT_NEAR(after.side[0].height[9], target, 0.02);
    EXPECT_EQ(after.side[0].origin[9], Origin::Arm);
}

TEST(TrailModel, AnEarlierProbeMovesItsBin)
{
    RememberedScene at = rememberedScene();
    const double target = estimateOf(at).side[0].height[9] - 0.1;
    for (TrailGround& ground : at.history.ground) {
        ground.armHeight[9] = target;
        ground.armSd[9] = 0.015;
        ground.felt[9] = kAllCells;
    }
    const TwoTrackEstimate after = estimateOf(at);
    for (const TerrainEstimate& side : after.side) {
        EXPECT_NEAR(side.height[9], target, 0.03);
        EXPECT_EQ(side.origin[9], Origin::Sampled) << "this scene did not measure it";
        EXPECT_EQ(side.touch[9], Touch::Remembered);
    }
    const ArmReading now{.bin = 9, .height = target + 0.05, .sd = 0.01};
    EXPECT_NEAR(estimateOf(at, {&now, 1}).side[0].height[9], target + 0.05, 0.02);
}

TEST(TrailModel, GroundFeltEarlierHasNoHazard)
{
    RememberedScene at = rememberedScene();
    for (TrailGround& ground : at.history.ground) ground.felt = {};
    const TerrainEstimate before = estimateOf(at).side[0];
    const auto unfelt = std::ranges::find_if(
        before.touch.begin() + kFirstAhead, before.touch.end(),
        [](Touch touch) { return touch == Touch::Bounded || touch == Touch::NotFelt; });
    ASSERT_NE(unfelt, before.touch.end());
    const auto bin = static_cast<std::size_t>(unfelt - before.touch.begin());
    for (TrailGround& ground : at.history.ground) ground.felt[bin] = kAllCells;
    const TerrainEstimate after = estimateOf(at).side[0];
    EXPECT_EQ(after.touch[bin], Touch::Remembered);
    EXPECT_LT(after.sd[bin], before.sd[bin]);
    EXPECT_LT(unfeltStepRate(after, kFirstAhead, kBins - 1),
              unfeltStepRate(before, kFirstAhead, kBins - 1));
}

}  // namespace
}  // namespace terratact
