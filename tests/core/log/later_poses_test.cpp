// Tests where an estimate lies at later scenes of a recorded drive.
#include "core/log/later_poses.h"

#include <gtest/gtest.h>

#include <array>

#include "core/strip/carried_estimate.h"
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
    EstimateCarrier carrier(robot, estimate, scene.measurement);
    TelemetryListener listener(robot);
    for (std::size_t batch = 0; batch < reader.batches().size(); ++batch)
        for (const FrameRow& row : reader.frames(batch)) {
            const auto measurement = listener.receive(row.frame, secondsOf(row.time));
            if (measurement && row.time > scene.time && row.time <= next.time)
                carrier.add(*measurement);
        }
    ASSERT_TRUE(carrier.carried());

    const std::array given{EstimateOfScene{0, &estimate},
                           EstimateOfScene{1, &reader.estimates()[3].estimate.side[0]}};
    const std::vector<LaterPose> poses = laterPoses(reader, robot, given);
    ASSERT_EQ(poses.size(), 1U) << "there is no scene behind the second";
    EXPECT_EQ(poses[0].estimate, 0U);
    EXPECT_EQ(poses[0].scene, 1U);
    const CarriedEstimate &carried = poses[0].carried, &expected = *carrier.carried();
    const double forward = carried.motion.forward;
    EXPECT_NEAR(forward, expected.motion.forward, 1e-12);
    EXPECT_NEAR(forward, *next.measurement.travelled - *scene.measurement.travelled, 0.01);
    bool hasPriorOnly = false;
    for (int i = 0; i < static_cast<int>(kBins); ++i) hasPriorOnly |= estimate.priorOnly(i);
    ASSERT_TRUE(hasPriorOnly);
    for (std::size_t i = 0; i < kBins; ++i) {
        const bool isWithin =
            binCentre(static_cast<int>(i)) + forward <= binCentre(kBins - 1) + 1e-9;
        ASSERT_EQ(carried.bin[i].has_value(), isWithin)
            << "bins of the training set alone go along";
        ASSERT_EQ(expected.bin[i].has_value(), isWithin) << i;
        if (!isWithin) continue;
        EXPECT_NEAR(carried.bin[i]->height, expected.bin[i]->height, 1e-9) << i;
    }
    const EstimateOfScene none{2, &estimate};
    EXPECT_THROW(laterPoses(reader, robot, {&none, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
