#include "core/atem/following.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "tests/support/benches/atem_loop.h"

namespace terratact {
namespace {

using enum AtemPhase;
using Activity = RobotActivity;
using atem_loop::kLimits;

/// One arrow of the diagram in passive_exploration.h, or one that must not be there.
struct Arrow {
    std::string name;
    AtemPhase from;
    FollowInput in;  // .now is seconds after the phase began
    AtemPhase to;
    AtemFailure failure = AtemFailure::None;
};

void PrintTo(const Arrow& arrow, std::ostream* out)
{
    *out << arrow.name;
}

AtemState at(AtemPhase phase)
{
    AtemState state = atem_loop::at(phase, AtemFailure::EstimateError);
    state.followed = true;
    return state;
}

class FollowedArrow : public testing::TestWithParam<Arrow> {};

TEST_P(FollowedArrow, leadsToTheStateInTheDiagram)
{
    const AtemState before = at(GetParam().from);
    FollowInput in = GetParam().in;
    in.now += before.since;
    const AtemState after = nextFollowed(before, in, kLimits);
    EXPECT_EQ(after.phase, GetParam().to) << describeFollowed(after.phase).english;
    EXPECT_TRUE(after.followed);
    const bool stayed = GetParam().to == GetParam().from && !in.newPress;
    if (stayed) {
        EXPECT_EQ(after, before) << "a state that stays keeps everything, its start too";
    } else {
        EXPECT_EQ(after.failure, GetParam().failure) << describe(after.failure).english;
        EXPECT_EQ(after.since, in.now);
    }
}

INSTANTIATE_TEST_SUITE_P(
    TheRobotsDoing, FollowedArrow,
    testing::Values(
        Arrow{"nothing", Idle, {.now = 1e6}, Idle},
        Arrow{"drives", Idle, {.now = 1, .activity = Activity::Driving}, Idle},
        Arrow{"pressing", Idle, {.now = 1, .activity = Activity::Pressing}, Pressing},
        Arrow{"stillPressing", Pressing, {.now = 1e6, .activity = Activity::Pressing}, Pressing},
        Arrow{"pressGivenUp", Pressing, {.now = 1, .activity = Activity::Halted}, Idle},
        Arrow{"pressed",
              Pressing,
              {.now = 1, .activity = Activity::Pressed, .newPress = true},
              Estimating},
        Arrow{"foundPressed",
              Idle,
              {.now = 1, .activity = Activity::Pressed, .newPress = true},
              Estimating},
        Arrow{"pressOnceOnly", Idle, {.now = 1, .activity = Activity::Pressed}, Idle},
        Arrow{
            "stillEstimating", Estimating, {.now = 29, .activity = Activity::Pressed}, Estimating},
        Arrow{"ready",
              Estimating,
              {.now = 1, .activity = Activity::Pressed, .estimateReady = true},
              Presenting},
        Arrow{"readyWhileProbing",
              Estimating,
              {.now = 1, .activity = Activity::Probing, .estimateReady = true},
              Presenting},
        Arrow{"readingWaitsForTheEstimate",
              Estimating,
              {.now = 1, .activity = Activity::Pressed, .newReading = true},
              Estimating},
        Arrow{"estimateFails",
              Estimating,
              {.now = 1, .activity = Activity::Pressed, .estimateFailed = true},
              Failed,
              AtemFailure::EstimateError},
        Arrow{"estimateTakesTooLong",
              Estimating,
              {.now = 30, .activity = Activity::Pressed},
              Failed,
              AtemFailure::EstimateTimeout},
        Arrow{"probing", Presenting, {.now = 1, .activity = Activity::Probing}, Probing},
        Arrow{"stillProbing", Probing, {.now = 1e6, .activity = Activity::Probing}, Probing},
        Arrow{"probeGivenUp", Probing, {.now = 1, .activity = Activity::Pressed}, Presenting},
        Arrow{"reading",
              Probing,
              {.now = 1, .activity = Activity::Pressed, .newReading = true},
              EstimatingAgain},
        Arrow{"readingOfAnUnseenProbe",
              Presenting,
              {.now = 1, .activity = Activity::Pressed, .newReading = true},
              EstimatingAgain},
        Arrow{"readyAgain",
              EstimatingAgain,
              {.now = 1, .activity = Activity::Pressed, .estimateReady = true},
              Presenting},
        Arrow{"failsAgain",
              EstimatingAgain,
              {.now = 1, .activity = Activity::Pressed, .estimateFailed = true},
              Failed,
              AtemFailure::EstimateError},
        Arrow{"standsThoughTheExplorationEnds",
              Presenting,
              {.now = 1e6, .activity = Activity::Halted},
              Presenting},
        Arrow{"pressesAgain", Presenting, {.now = 1, .activity = Activity::Pressing}, Pressing},
        Arrow{"pressesAgainUnseen",
              Presenting,
              {.now = 1, .activity = Activity::Pressed, .newPress = true},
              Estimating},
        Arrow{"aNewPressOvertakesAnEstimate",
              Estimating,
              {.now = 1, .activity = Activity::Pressed, .newPress = true, .estimateReady = true},
              Estimating}));

INSTANTIATE_TEST_SUITE_P(
    WhatEndsIt, FollowedArrow,
    testing::Values(
        Arrow{"movedWhileEstimating", Estimating, {.now = 1, .poseChanged = true}, Idle},
        Arrow{"movedWhileProbing",
              Probing,
              {.now = 1, .activity = Activity::Probing, .poseChanged = true},
              Idle},
        Arrow{"movedWhileEstimatingAgain", EstimatingAgain, {.now = 1, .poseChanged = true}, Idle},
        Arrow{"droveOn",
              Presenting,
              {.now = 1, .activity = Activity::Driving, .poseChanged = true},
              Idle},
        Arrow{"cleared",
              Presenting,
              {.now = 1, .activity = Activity::Pressed, .aborted = true},
              Idle},
        Arrow{"clearedWhileEstimating",
              Estimating,
              {.now = 1, .activity = Activity::Pressed, .aborted = true, .estimateReady = true},
              Idle},
        Arrow{"clearedFailure", Failed, {.now = 1, .aborted = true}, Idle},
        Arrow{"stopped", Presenting, {.now = 1, .activity = Activity::Stopped}, Stopped},
        Arrow{"stillStopped", Stopped, {.now = 1e6, .activity = Activity::Stopped}, Stopped},
        Arrow{"aStopIsNotCleared",
              Stopped,
              {.now = 1, .activity = Activity::Stopped, .aborted = true},
              Stopped},
        Arrow{"released", Stopped, {.now = 1, .activity = Activity::Halted}, Idle},
        Arrow{"nothingToLose", Idle, {.now = 1, .linkLost = true}, Idle},
        Arrow{"stoppedAndLost", Stopped, {.now = 1, .linkLost = true}, Stopped},
        Arrow{"lostWhilePressing",
              Pressing,
              {.now = 1, .activity = Activity::Pressing, .linkLost = true},
              Failed,
              AtemFailure::LinkLost},
        Arrow{"lostWithAnEstimate",
              Presenting,
              {.now = 1, .activity = Activity::Pressed, .linkLost = true, .newPress = true},
              Failed,
              AtemFailure::LinkLost},
        Arrow{"failureStaysInSight", Failed, {.now = 1e6, .activity = Activity::Driving}, Failed},
        Arrow{"failureEndsWithAPress",
              Failed,
              {.now = 1, .activity = Activity::Pressing},
              Pressing}));

TEST(PassiveExploration, keepsProbedUntilTheNextPress)
{
    AtemState state = nextFollowed(
        at(Probing), {.now = 101, .activity = Activity::Pressed, .newReading = true}, kLimits);
    EXPECT_TRUE(state.probed);
    state = nextFollowed(state, {.now = 102, .activity = Activity::Pressed, .estimateReady = true},
                         kLimits);
    EXPECT_EQ(state.phase, Presenting);
    EXPECT_TRUE(state.probed);
    state =
        nextFollowed(state, {.now = 103, .activity = Activity::Pressed, .newPress = true}, kLimits);
    EXPECT_FALSE(state.probed);
}

TEST(PassiveExploration, onlyAnEstimateHasATimeLimit)
{
    for (const AtemPhase phase : {Idle, Pressing, Probing, Presenting, Stopped, Failed})
        EXPECT_FALSE(deadline(at(phase), kLimits)) << describeFollowed(phase).english;
    for (const AtemPhase phase : {Estimating, EstimatingAgain})
        EXPECT_EQ(deadline(at(phase), kLimits), 130.0) << describeFollowed(phase).english;
}

TEST(PassiveExploration, refusesATimeThatIsNotFinite)
{
    EXPECT_THROW(nextFollowed({}, {.now = std::numeric_limits<double>::quiet_NaN()}, kLimits),
                 std::invalid_argument);
}

}  // namespace
}  // namespace terratact
