#include "core/atem/atem_machine.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/benches/atem_loop.h"

namespace terratact {
namespace {

using enum AtemPhase;
using atem_loop::at;
using atem_loop::kLimits;
using atem_loop::kPhases;

/// One arrow of the diagram in atem_machine.h, or one that must not exist.
struct Arrow {
    std::string name;
    AtemPhase from;
    AtemInput in;  // .now is seconds after the phase began
    AtemPhase to;
    AtemFailure failure = AtemFailure::None;
};

/// An approval `now` seconds after the question, given `age` seconds ago for the present grounds.
AtemInput approval(double now, double age = 0.0)
{
    return {.now = now, .approved = true, .approvalAge = age, .approvedFor = "a", .grounds = "a"};
}

AtemInput approvalWith(double now, bool AtemInput::*more)
{
    AtemInput in = approval(now);
    in.*more = true;
    return in;
}

AtemInput approvalOf(const std::string& approved, const std::string& stands)
{
    AtemInput in = approval(1);
    in.approvedFor = approved;
    in.grounds = stands;
    return in;
}

void PrintTo(const Arrow& arrow, std::ostream* out)
{
    *out << arrow.name;
}

class AtemArrow : public testing::TestWithParam<Arrow> {};

TEST_P(AtemArrow, leadsToTheStateInTheDiagram)
{
    const AtemState before = at(GetParam().from);
    AtemInput in = GetParam().in;
    in.now += before.since;
    const AtemState after = nextState(before, in, kLimits);
    EXPECT_EQ(after.phase, GetParam().to) << describe(after.phase).english;
    const bool stayed = GetParam().to == GetParam().from && GetParam().failure == AtemFailure::None;
    if (stayed) {
        EXPECT_EQ(after, before) << "a state that stays keeps everything, its start too";
    } else {
        EXPECT_EQ(after.failure, GetParam().failure) << describe(after.failure).english;
        EXPECT_EQ(after.since, in.now);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Algorithm1, AtemArrow,
    testing::Values(Arrow{"idleStaysIdle", Idle, {.now = 1e6}, Idle},
                    Arrow{"request", Idle, {.requested = true}, Halting},
                    Arrow{"stillRolling", Halting, {.now = 1}, Halting},
                    Arrow{"halted", Halting, {.now = 1, .halted = true}, Pressing},
                    Arrow{"stillPressing", Pressing, {.now = 1}, Pressing},
                    Arrow{"pressed", Pressing, {.now = 1, .pressed = true}, Estimating},
                    Arrow{"stillEstimating", Estimating, {.now = 1}, Estimating},
                    Arrow{
                        "certainEnough", Estimating, {.now = 1, .estimateReady = true}, Presenting},
                    Arrow{"ambiguous",
                          Estimating,
                          {.now = 1, .estimateReady = true, .probeWanted = true},
                          ProposingProbe},
                    Arrow{"undecided", ProposingProbe, {.now = 1}, ProposingProbe},
                    Arrow{"approved", ProposingProbe, approval(1), Probing},
                    Arrow{"refused", ProposingProbe, {.now = 1, .refused = true}, Presenting},
                    Arrow{"stillProbing", Probing, {.now = 44}, Probing},
                    Arrow{"probed", Probing, {.now = 45, .probeDone = true}, EstimatingAgain},
                    Arrow{"stillEstimatingAgain", EstimatingAgain, {.now = 1}, EstimatingAgain},
                    Arrow{"done", EstimatingAgain, {.now = 1, .estimateReady = true}, Presenting},
                    Arrow{"oneProbeOnly",
                          EstimatingAgain,
                          {.now = 1, .estimateReady = true, .probeWanted = true},
                          Presenting},
                    Arrow{"resultStands", Presenting, {.now = 1e6}, Presenting},
                    Arrow{"droveOn", Presenting, {.now = 1, .poseChanged = true}, Idle},
                    Arrow{"askAgain", Presenting, {.now = 1, .requested = true}, Halting}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Faults, AtemArrow,
    testing::Values(
        Arrow{"doesNotHalt", Halting, {.now = 3}, Failed, AtemFailure::HaltTimeout},
        Arrow{"doesNotBegin",
              Halting,
              {.now = 3, .unbegun = true},
              Failed,
              AtemFailure::BeginTimeout},
        Arrow{"beginsLate", Halting, {.now = 2.9, .unbegun = true}, Halting},
        Arrow{"haltsAtTheLastMoment", Halting, {.now = 3, .halted = true}, Pressing},
        Arrow{"pressRefused",
              Pressing,
              {.now = 1, .pressed = true, .pressRefused = true},
              Failed,
              AtemFailure::PressRefused},
        Arrow{"haltNotSent",
              Halting,
              {.now = 1, .notSent = true, .halted = true},
              Failed,
              AtemFailure::NotSent},
        Arrow{"pressNotSent", Pressing, {.now = 1, .notSent = true}, Failed, AtemFailure::NotSent},
        Arrow{"probeNotSent", Probing, {.now = 1, .notSent = true}, Failed, AtemFailure::NotSent},
        Arrow{"nothingWaitsForIt", Presenting, {.now = 1, .notSent = true}, Presenting},
        Arrow{"findsNothingToPress", Pressing, {.now = 15}, Failed, AtemFailure::PressTimeout},
        Arrow{"estimateError",
              Estimating,
              {.now = 1, .estimateReady = true, .estimateFailed = true},
              Failed,
              AtemFailure::EstimateError},
        Arrow{"estimateTooSlow", Estimating, {.now = 30}, Failed, AtemFailure::EstimateTimeout},
        Arrow{"movedWhileEstimating",
              Estimating,
              {.now = 1, .estimateReady = true, .poseChanged = true},
              Failed,
              AtemFailure::PoseChanged},
        Arrow{"movedWhileDeciding", ProposingProbe, approvalWith(1, &AtemInput::poseChanged),
              Failed, AtemFailure::PoseChanged},
        Arrow{"movedWhileProbing",
              Probing,
              {.now = 1, .probeDone = true, .poseChanged = true},
              Failed,
              AtemFailure::PoseChanged},
        Arrow{"movedWhileEstimatingAgain",
              EstimatingAgain,
              {.now = 1, .poseChanged = true},
              Failed,
              AtemFailure::PoseChanged},
        Arrow{"movingIsExpectedWhileHalting", Halting, {.now = 1, .poseChanged = true}, Halting},
        Arrow{"movingIsExpectedWhilePressing", Pressing, {.now = 1, .poseChanged = true}, Pressing},
        Arrow{"probeRefused",
              Probing,
              {.now = 1, .probeRefused = true},
              Failed,
              AtemFailure::ProbeRefused},
        Arrow{"armStuck", Probing, {.now = 90}, Failed, AtemFailure::ProbeTimeout},
        Arrow{"secondEstimateError",
              EstimatingAgain,
              {.now = 1, .estimateFailed = true},
              Failed,
              AtemFailure::EstimateError},
        Arrow{"secondEstimateTooSlow",
              EstimatingAgain,
              {.now = 30},
              Failed,
              AtemFailure::EstimateTimeout},
        Arrow{"failedStays", Failed, {.now = 1e6}, Failed},
        Arrow{"failedRetry", Failed, {.requested = true}, Halting},
        Arrow{"failedAcknowledged", Failed, {.now = 1, .aborted = true}, Idle},
        Arrow{"requestWithoutLink",
              Idle,
              {.requested = true, .linkAlive = false},
              Failed,
              AtemFailure::LinkLost},
        Arrow{"askAgainWithoutLink",
              Presenting,
              {.requested = true, .linkAlive = false},
              Failed,
              AtemFailure::LinkLost},
        Arrow{"retryWithoutLink",
              Failed,
              {.now = 1, .requested = true, .linkAlive = false},
              Failed,
              AtemFailure::LinkLost}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Answers, AtemArrow,
    testing::Values(
        Arrow{"noAnswerMeansNo", ProposingProbe, {.now = 20}, Presenting},
        Arrow{"lateApprovalMeansNo", ProposingProbe, approval(20), Presenting},
        Arrow{"oldApprovalMeansNo", ProposingProbe, approval(1, 20.0), Presenting},
        Arrow{"approvalOfTheFutureMeansNo", ProposingProbe, approval(1, -0.1), Presenting},
        Arrow{"approvalOfUnknownAgeMeansNo", ProposingProbe, approval(1, std::nan("")), Presenting},
        Arrow{"approvalOfOtherGrounds", ProposingProbe, approvalOf("a", "b"), Failed,
              AtemFailure::ApprovalVoid},
        Arrow{"approvalOfNothing", ProposingProbe, approvalOf("", ""), Failed,
              AtemFailure::ApprovalVoid},
        Arrow{"requestDisarmed",
              Idle,
              {.now = 1, .requested = true, .armed = false},
              Failed,
              AtemFailure::Disarmed},
        Arrow{"disarmedWhileHalting",
              Halting,
              {.now = 1, .armed = false},
              Failed,
              AtemFailure::Disarmed},
        Arrow{"disarmedWhilePressing",
              Pressing,
              {.now = 1, .armed = false},
              Failed,
              AtemFailure::Disarmed},
        Arrow{"disarmedWhileEstimating",
              Estimating,
              {.now = 1, .armed = false},
              Failed,
              AtemFailure::Disarmed},
        Arrow{"disarmedWhileAsking",
              ProposingProbe,
              {.now = 1, .armed = false},
              Failed,
              AtemFailure::Disarmed},
        Arrow{"disarmedWhileProbing",
              Probing,
              {.now = 1, .armed = false},
              Failed,
              AtemFailure::Disarmed},
        Arrow{"disarmedWhileEstimatingAgain",
              EstimatingAgain,
              {.now = 1, .armed = false},
              Failed,
              AtemFailure::Disarmed},
        Arrow{"disarmedWhilePresenting", Presenting, {.now = 1, .armed = false}, Presenting},
        Arrow{"disarmedWhileIdle", Idle, {.now = 1, .armed = false}, Idle},
        Arrow{"approvalJustInTime", ProposingProbe, approval(19.99), Probing},
        Arrow{"yesAndNoMeansNo", ProposingProbe, approvalWith(1, &AtemInput::refused), Presenting},
        Arrow{"approvalWithoutProposal", Presenting, approval(1), Presenting},
        Arrow{"earlyApproval", Estimating, approval(1), Estimating},
        Arrow{"secondRequestWhileBusy", Probing, {.now = 1, .requested = true}, Probing},
        Arrow{"requestWhileStopped", Stopped, {.now = 1, .requested = true}, Stopped},
        Arrow{"abortDoesNotReleaseStop", Stopped, {.now = 1, .aborted = true}, Stopped},
        Arrow{"release", Stopped, {.now = 1, .stopReleased = true}, Idle},
        Arrow{"stopOutranksRelease",
              Stopped,
              {.now = 1, .stop = true, .stopReleased = true},
              Stopped},
        Arrow{"releaseWithoutStop", Probing, {.now = 1, .stopReleased = true}, Probing},
        Arrow{"abortOutranksRequest", Idle, {.requested = true, .aborted = true}, Idle},
        Arrow{
            "abortOutranksFault", Probing, {.now = 99, .aborted = true, .linkAlive = false}, Idle}),
    [](const auto& row) { return row.param.name; });

TEST(AtemMachine, stopEndsEveryPhaseForAnyOtherInput)
{
    for (const AtemPhase phase : kPhases) {
        const AtemInput in{
            .now = 1e9, .requested = true, .aborted = true, .stop = true, .linkAlive = false};
        EXPECT_EQ(nextState(at(phase), in, kLimits).phase, Stopped) << describe(phase).english;
    }
}

TEST(AtemMachine, aLostLinkFailsEveryExploringPhaseAndNoOther)
{
    for (const AtemPhase phase : kPhases) {
        const AtemState after = nextState(at(phase), {.now = 101.0, .linkAlive = false}, kLimits);
        if (exploring(phase)) {
            EXPECT_EQ(after.phase, Failed) << describe(phase).english;
            EXPECT_EQ(after.failure, AtemFailure::LinkLost) << describe(phase).english;
        } else {
            EXPECT_EQ(after, at(phase)) << describe(phase).english;
        }
    }
}

TEST(AtemMachine, abortEndsEveryExploringPhase)
{
    for (const AtemPhase phase : kPhases)
        if (exploring(phase)) {
            EXPECT_EQ(nextState(at(phase), {.now = 101.0, .aborted = true}, kLimits).phase, Idle)
                << describe(phase).english;
        }
}

TEST(AtemMachine, anExpiredProposalIsRememberedUntilTheNextRequest)
{
    AtemState state = nextState(at(ProposingProbe), {.now = 120.0}, kLimits);
    EXPECT_TRUE(state.approvalExpired);
    state = nextState(state, {.now = 130.0, .requested = true}, kLimits);
    EXPECT_FALSE(state.approvalExpired);
}

TEST(AtemMachine, probedIsKeptUntilTheNextRequest)
{
    AtemState state = nextState(at(Probing), {.now = 145.0, .probeDone = true}, kLimits);
    state = nextState(state, {.now = 146.0, .estimateReady = true}, kLimits);
    EXPECT_TRUE(state.probed);
    EXPECT_FALSE(nextState(state, {.now = 147.0, .requested = true}, kLimits).probed);
}

/// Tests every state × every combination of flags × before and after the deadline.
TEST(AtemMachine, keepsItsInvariantsForEveryInput)
{
    for (const AtemPhase phase : kPhases) {
        const AtemState before = at(phase);
        for (unsigned bits = 0; bits < 1U << 16U; ++bits) {
            unsigned rest = bits;
            const auto flag = [&rest] {
                const bool set = (rest & 1U) != 0;
                rest >>= 1U;
                return set;
            };
            AtemInput in;
            in.approvedFor = in.grounds = "a";
            for (bool* b : {&in.requested, &in.aborted, &in.stop, &in.stopReleased, &in.approved,
                            &in.refused, &in.linkAlive, &in.halted, &in.pressed, &in.pressRefused,
                            &in.estimateReady, &in.estimateFailed, &in.probeWanted, &in.probeDone,
                            &in.probeRefused, &in.poseChanged})
                *b = flag();
            for (const double after : {1.0, 1000.0}) {
                in.now = before.since + after;
                const AtemState next = nextState(before, in, kLimits);
                ASSERT_EQ(next.phase == Failed, next.failure != AtemFailure::None);
                if (next.phase != before.phase) {
                    ASSERT_EQ(next.since, in.now);
                    if (next.phase == Probing) {
                        ASSERT_TRUE(before.phase == ProposingProbe && in.approved && !in.refused
                                    && !in.poseChanged && in.linkAlive && after < kLimits.approval)
                            << "the arm moves only with a timely, unopposed approval of a standing "
                               "proposal";
                    }
                    if (before.phase == Stopped) {
                        ASSERT_TRUE(next.phase == Idle && in.stopReleased && !in.stop);
                    }
                } else if (exploring(next.phase)) {
                    ASSERT_LT(after, kLimits.probe) << "no exploring phase outlives its time limit";
                }
            }
        }
    }
}

TEST(AtemMachine, everyExploringPhaseHasADeadlineAndNoOtherHas)
{
    for (const AtemPhase phase : kPhases)
        EXPECT_EQ(deadline(at(phase), kLimits).has_value(), exploring(phase))
            << describe(phase).english;
    EXPECT_DOUBLE_EQ(*deadline(at(ProposingProbe), kLimits), 120.0);
}

TEST(AtemMachine, refusesATimeThatIsNotFinite)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)nextState(at(Idle), {.now = nan}, kLimits), std::invalid_argument);
}

TEST(AtemMachine, hasWordsForEveryPhaseAndFailure)
{
    std::vector<std::string> words;
    for (const AtemPhase phase : kPhases) words.push_back(describe(phase).english);
    for (int f = 0; f <= static_cast<int>(AtemFailure::BeginTimeout); ++f)
        words.push_back(describe(static_cast<AtemFailure>(f)).english);
    for (std::size_t i = 0; i < words.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(words[i], words[j]);
}

}  // namespace
}  // namespace terratact
