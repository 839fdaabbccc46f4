// Tests where an estimate lies at later scenes of a recorded drive.
#include "core/log/later_poses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/infer/verdict/ghost_track.h"
#include "core/wire/telemetry_listener.h"
#include "tests/support/sessions/recorded_drive.h"

namespace terratact {
namespace {

/// Integrates all frames by hand, to know where a scene's estimate lies at the next scene.
TEST_F(Drive, estimatesAreFollowedToTheScenesBehindTheirs)
{
    const RobotModel robot = *readRobotModel(kRobot);
    const TerrainEstimate& estimate = reader.estimates()[1].estimate.side[0];
    const SceneRow &scene = reader.scenes()[0], &next = reader.scenes()[1];
    GhostTrack track(robot, estimate, scene.measurement);
    TelemetryListener listener(robot);
    for (std::size_t batch = 0; batch < reader.batches().size(); ++batch)
        for (const FrameRow& row : reader.frames(batch)) {
            const auto measurement = listener.receive(row.frame, secondsOf(row.time));
            if (measurement && row.time > scene.time && row.time <= next.time)
                track.add(*measurement);
        }
    ASSERT_TRUE(track.ghost());

    const std::array given{EstimateOfScene{0, &estimate},
                           EstimateOfScene{1, &reader.estimates()[3].estimate.side[0]}};
    const std::vector<LaterPose> poses = laterPoses(reader, robot, given);
    ASSERT_EQ(poses.size(), 1U) << "there is no scene behind the second";
    EXPECT_EQ(poses[0].estimate, 0U);
    EXPECT_EQ(poses[0].scene, 1U);
    const Ghost &ghost = poses[0].ghost, &expected = *track.ghost();
    EXPECT_NEAR(ghost.motion.forward, expected.motion.forward, 1e-12);
    EXPECT_NEAR(ghost.motion.forward, *next.measurement.travelled - *scene.measurement.travelled,
                0.01);
    for (std::size_t i = 0; i < kBins; ++i) {
        if (!expected.bin[i]) continue;
        ASSERT_TRUE(ghost.bin[i]) << i;
        EXPECT_NEAR(ghost.bin[i]->height, expected.bin[i]->height, 1e-9) << i;
    }
    const auto known = [](const Ghost& g) {
        return std::count_if(g.bin.begin(), g.bin.end(),
                             [](const auto& b) { return b.has_value(); });
    };
    EXPECT_GT(known(ghost), known(expected)) << "bins of the training set alone go along";
    const EstimateOfScene none{2, &estimate};
    EXPECT_THROW(laterPoses(reader, robot, {&none, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
