// Tests that drives and scenes of the training are counted.
#include "app/modelling/trials/drive_trials.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "core/learn/data/drive_copies.h"
#include "core/learn/data/drive_file.h"
#include "core/trail/trail_model.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

/// Returns a drive of these scenes, without lines of the way.
DriveLines driveOf(const std::string& run, const std::vector<Scene>& scenes)
{
    DriveLines drive{.run = run, .onePlane = true, .lines = {}};
    for (const Scene& scene : scenes) {
        DriveLine line{.line = measurementOf(onBothSides(scene).s),
                       .isScene = true,
                       .truth = {scene.truth, scene.truth}};
        line.line.time = line.line.travelled.emplace(0.3 * static_cast<double>(drive.lines.size()));
        drive.lines.push_back(line);
    }
    return drive;
}

struct TrainingDrives : testing::Test {
    TrainingDrives() : bundle(absolem(), StoredModel{toyModel(4), {}})
    {
        TrailData networks;
        networks.plane.drives = {driveMarks(learnt)};
        bundle.models.trail = std::make_shared<const TrailModel>(networks);
    }
    DriveFindings findings(const std::vector<DriveLines>& drives)
    {
        std::string text = drivesHeader(true);
        for (const DriveLines& drive : drives) text += driveText(drive);
        const auto found = judgeDriveFile(directory.write("drives.csv", text), bundle, {}, {},
                                          [](const Message&) {});
        EXPECT_TRUE(found) << found.error().text;
        return found ? *found : DriveFindings{};
    }

    TemporaryDirectory directory;
    DriveLines learnt = driveOf("learnt", someScenes(4, 1));  // as toyModel(4)
    DriveLines unseen = driveOf("unseen", someScenes(2, 7));
    EstimatorBundle bundle;
};

TEST_F(TrainingDrives, areKnownAmongOthersAndWithOtherLines)
{
    DriveLines part = learnt;
    part.run = "saved again";
    part.lines.erase(part.lines.begin());
    const DriveFindings found = findings({unseen, part});
    EXPECT_EQ(found.drives, 2U);
    EXPECT_EQ(found.trainingDrives, 1U);
    EXPECT_EQ(found.trainingScenes, part.lines.size());
    EXPECT_EQ(found.scenes + found.early, part.lines.size() + unseen.lines.size());
}

TEST_F(TrainingDrives, areNotAmongUnseenDrives)
{
    const DriveFindings found = findings({unseen});
    EXPECT_EQ(found.trainingDrives, 0U);
    EXPECT_EQ(found.trainingScenes, 0U);
    bundle.models.trail.reset();
    EXPECT_EQ(findings({learnt}).trainingDrives, 0U) << "without networks";
}

}  // namespace
}  // namespace terratact
