// Tests truth files: what they hold, and what is refused.
#include "app/modelling/truth/truth_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "app/modelling/truth/laser_truth_report.h"
#include "app/modelling/truth/truth_decisions.h"
#include "core/store/file_read.h"
#include "core/store/sqlite.h"
#include "tests/support/made_truth.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct TruthFiles : testing::Test {
    std::string written()
    {
        const std::string path = directory.file("drive.truth");
        if (const Status done = writeTruthFile(path, truth, kRobot); !done)
            throw std::runtime_error(done.error().text);
        return path;
    }
    /// Returns the path of a file that a statement has changed.
    std::string changed(const char* sql)
    {
        std::filesystem::remove(directory.file("drive.truth"));
        const std::string path = written();
        SqliteFile file = SqliteFile::fill(path);
        file.run(sql);
        file.close();
        return path;
    }

    static constexpr const char* kRobot = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml";
    TemporaryDirectory directory;
    LaserTruth truth = madeTruth(directory, 3);
};

TEST_F(TruthFiles, holdsScenesHeightsAndSlices)
{
    auto read = TruthFile::open(written());
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->truth().tracks, truth.tracks);
    EXPECT_EQ(truthScenesCsv(read->truth()), truthScenesCsv(truth));
    EXPECT_EQ(read->truth().knownHeights(), truth.knownHeights());
    ASSERT_TRUE(read->truth().truths[1].contact);
    EXPECT_EQ(read->truth().truths[1].contact->offset, truth.truths[1].contact->offset);
    const std::vector<SlicePoint> wanted = truthSlice(truth, 1);
    const auto slice = read->slice(1);
    ASSERT_TRUE(slice) << slice.error().text;
    ASSERT_EQ(slice->size(), wanted.size());
    EXPECT_EQ(*slice, wanted);
    EXPECT_FALSE(read->slice(3));
}

TEST_F(TruthFiles, heightsSampledAgainAreThoseOfTheGrid)
{
    truth.truths[1].correction = {.offset = 0.01, .tiltX = 0.02, .tiltY = 0.03};
    auto read = TruthFile::open(written());
    ASSERT_TRUE(read) << read.error().text;
    ASSERT_TRUE(read->hasCells());
    const std::vector<TruthDecision> decisions{
        {.row = 2, .run = "a", .offset = 0.005, .along = -0.06}};
    LaserTruth ofFile = read->truth();
    const Status done = applyTruthDecisions(ofFile, decisions, "decisions.csv",
                                            [&](std::size_t row) { return read->grid(row); });
    ASSERT_TRUE(done) << done.error().text;
    const std::string before = truthScenesCsv(truth);
    ASSERT_TRUE(applyTruthDecisions(truth, decisions, "decisions.csv"));
    EXPECT_EQ(truthScenesCsv(ofFile), truthScenesCsv(truth)) << "to the last digit";
    EXPECT_NE(truthScenesCsv(truth), before);
}

TEST_F(TruthFiles, filesOfTheFirstVersionAreReadWithoutCells)
{
    const std::string path = written();
    SqliteFile file = SqliteFile::fill(path);
    for (const char* const sql :
         {"ALTER TABLE scene RENAME TO newer",
          "CREATE TABLE scene(number INTEGER PRIMARY KEY, csv TEXT NOT NULL, gap TEXT NOT NULL, "
          "cloud_m REAL, slice BLOB NOT NULL) STRICT",
          "INSERT INTO scene SELECT number, csv, gap, cloud_m, x'0100e80338ff' FROM newer",
          "DROP TABLE newer", "DROP TABLE rule", "PRAGMA user_version = 1"})
        file.run(sql);
    file.close();
    auto read = TruthFile::open(path);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(truthScenesCsv(read->truth()), truthScenesCsv(truth));
    EXPECT_FALSE(read->hasCells());
    EXPECT_EQ(*read->slice(1), (std::vector<SlicePoint>{{TruthLine::LeftFlippers, 1.0, -0.2}}));
    EXPECT_TRUE(refused(read->grid(1), path,
                        {"earlier version and holds no cells of the cloud: write it again"}));
}

TEST_F(TruthFiles, gapsAreKept)
{
    truth.truths[2].gap = TruthGap::NoPose;
    auto read = TruthFile::open(written());
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->truth().truths[2].gap, TruthGap::NoPose);
    EXPECT_TRUE(read->slice(2)->empty());
}

TEST_F(TruthFiles, planeIsReadBack)
{
    truth.isPlane = true;
    truth.plane.resize(3);
    for (Scene& scene : truth.plane) {
        scene.run = "a";
        scene.truth[4] = -0.2;
        scene.truthSd[4] = 0.01;
    }
    const auto read = TruthFile::open(written());
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_TRUE(read->truth().isPlane);
    EXPECT_EQ(truthScenesCsv(read->truth()), truthScenesCsv(truth));
    EXPECT_EQ(read->truth().truths[0].plane[4].sd, 0.01);
}

TEST_F(TruthFiles, damagedFilesAreRefusedByName)
{
    for (const char* const sql :
         {"UPDATE scene SET csv = 'x'", "UPDATE scene SET gap = 'x'", "DELETE FROM scene",
          "DELETE FROM scene WHERE number = 2", "UPDATE meta SET value = 'x'",
          "UPDATE scene SET csv = csv || csv", "PRAGMA user_version = 3", "DELETE FROM rule",
          "UPDATE rule SET max_sd_m = -1.0", "UPDATE scene SET tilt_x = 9e999",
          "PRAGMA application_id = 7", "CREATE TABLE other(x)",
          "UPDATE scene SET cloud_m = 9e999"}) {
        const std::string path = changed(sql);
        EXPECT_TRUE(refused(TruthFile::open(path), path, {})) << sql;
    }
    for (const char* const sql :
         {"UPDATE scene SET cells = x'0102'", "UPDATE scene SET cells = substr(cells, 1, 4000)",
          "UPDATE scene SET cells = x'30000000ffffff7f'", "UPDATE scene SET roll_rad = 7.0",
          "UPDATE scene SET cells = CAST(substr(cells, 1, length(cells) - 4) || x'0000c07f' AS "
          "BLOB)"}) {
        auto read = TruthFile::open(changed(sql));
        ASSERT_TRUE(read) << read.error().text;
        EXPECT_FALSE(read->slice(0)) << sql;
        EXPECT_FALSE(read->grid(0)) << sql;
    }
    const std::string text = directory.write("x.truth", "no database at all");
    EXPECT_TRUE(refused(TruthFile::open(text), text, {}));
}

TEST_F(TruthFiles, nothingIsLeftOfARefusedFile)
{
    EXPECT_FALSE(writeTruthFile(directory.file("a.truth"), truth, directory.file("none.toml")));
    EXPECT_FALSE(std::filesystem::exists(directory.file("a.truth")));
}

}  // namespace
}  // namespace terratact
