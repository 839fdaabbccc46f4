// Tests truth files: what they hold, and what is refused.
#include "app/modelling/truth_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "app/modelling/laser_truth_report.h"
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
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        ASSERT_EQ((*slice)[i].line, wanted[i].line);
        ASSERT_LT(std::hypot((*slice)[i].x - wanted[i].x, (*slice)[i].z - wanted[i].z), 0.00075);
    }
    EXPECT_FALSE(read->slice(3));
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
          "UPDATE scene SET csv = csv || csv", "PRAGMA user_version = 2",
          "PRAGMA application_id = 7", "CREATE TABLE other(x)",
          "UPDATE scene SET cloud_m = 9e999"}) {
        const std::string path = changed(sql);
        EXPECT_TRUE(refused(TruthFile::open(path), path, {})) << sql;
    }
    for (const char* const sql :
         {"UPDATE scene SET slice = x'0102'", "UPDATE scene SET slice = x'ffff00000000'"}) {
        auto read = TruthFile::open(changed(sql));
        ASSERT_TRUE(read) << read.error().text;
        EXPECT_FALSE(read->slice(0)) << sql;
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
