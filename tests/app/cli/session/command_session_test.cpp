// Tests the export of scenes from sessions.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "app/cli/session/session_commands.h"
#include "core/learn/data/scene_file.h"
#include "tests/support/sessions/session_files.h"
#include "tests/support/sessions/sessions.h"

namespace terratact {
namespace {

TEST_F(SessionFiles, withoutTruthScenesHaveTheHeightsThatWereMeasured)
{
    const std::string path = session("touched.tts", [](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
        SceneRow scene = someScene(1, 1'000'000);
        scene.truth = std::nullopt;
        scene.measurement.force = {0.0, 0.0, 0.0, 0.0, 0.0, 7.0};
        ASSERT_TRUE(writer.add(scene));
        EstimateRow row = someEstimate(1, 2'000'000);
        row.readings = {{.bin = 10, .height = 0.123, .sd = 0.03}};
        ASSERT_TRUE(writer.add(row));
    });
    const std::string csv = directory.file("scenes.csv");
    ASSERT_TRUE(exportScenes({.files = {path}, .out = csv}));
    const auto plain = readScenes(csv)->scenes.at(0);
    ASSERT_TRUE(exportScenes({.files = {path}, .out = csv, .measured = true}));
    const auto touched = readScenes(csv)->scenes.at(0);
    const auto known = [](const Scene& scene) {
        return std::count_if(scene.truth.begin(), scene.truth.end(),
                             [](const auto& h) { return h.has_value(); });
    };
    EXPECT_EQ(known(plain), 0);
    EXPECT_EQ(known(touched), 2) << "one contact and the arm";
    EXPECT_EQ(touched.truth[10], 0.123);
}

TEST_F(SessionFiles, aCopyOfADriveIsTakenOnce)
{
    const std::string drive = TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts";
    const std::string copy = directory.file("copy.tts"), csv = directory.file("drives.csv");
    std::filesystem::copy_file(drive, copy);
    ASSERT_TRUE(exportScenes({.files = {drive}, .out = csv, .drives = true}));
    const std::string once = contentOf(csv);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const Status done = exportScenes({.files = {drive, copy}, .out = csv, .drives = true});
    const std::string said = testing::internal::GetCapturedStderr();
    const std::string counted = testing::internal::GetCapturedStdout();
    ASSERT_TRUE(done) << done.error().text;
    EXPECT_EQ(contentOf(csv), once);
    EXPECT_NE(counted.find(" 1 scenes of 1 drives written"), std::string::npos) << counted;
    EXPECT_NE(said.find(copy + ": 1 of its 1 scenes are in " + drive
                        + " too, which is the same recording: they are taken once"),
              std::string::npos)
        << said;
}

}  // namespace
}  // namespace terratact
