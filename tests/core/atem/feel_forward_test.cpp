#include "core/atem/feel_forward.h"

#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "core/atem/advance_watch.h"
#include "core/atem/atem_machine.h"
#include "core/robot/attitude.h"
#include "core/terrain/step.h"
#include "tests/support/benches/atem_loop.h"

namespace terratact {
namespace {

using enum AtemPhase;

/// A state of the loop that began at 100 s.
AtemState loopAt(AtemPhase phase, bool loops = true)
{
    AtemState state = atem_loop::at(phase);
    state.loops = loops;
    return state;
}

/// Input with the control held and nothing that forbids an advance.
AtemInput held(std::vector<bool AtemInput::*> flags = {}, double now = 1.0)
{
    AtemInput in{.now = now, .held = true, .forbids = LoopEnd::None};
    for (bool AtemInput::*flag : flags) in.*flag = true;
    return in;
}

AtemInput without(bool AtemInput::*flag, std::vector<bool AtemInput::*> flags = {})
{
    AtemInput in = held(std::move(flags));
    in.*flag = false;
    return in;
}

AtemInput forbidden(LoopEnd why, std::vector<bool AtemInput::*> flags = {})
{
    AtemInput in = held(std::move(flags));
    in.forbids = why;
    return in;
}

struct LoopArrow {
    std::string name;
    AtemState from;
    AtemInput in;  // .now is seconds after the phase began
    AtemPhase to;
    bool loops;
    LoopEnd end = LoopEnd::None;
    AtemFailure failure = AtemFailure::None;
};

void PrintTo(const LoopArrow& arrow, std::ostream* out)
{
    *out << arrow.name;
}

class FeelForwardArrow : public testing::TestWithParam<LoopArrow> {};

TEST_P(FeelForwardArrow, leadsToItsStateAndReason)
{
    const LoopArrow& arrow = GetParam();
    AtemInput in = arrow.in;
    in.now += arrow.from.since;
    const AtemState after = nextState(arrow.from, in, atem_loop::kLimits);
    EXPECT_EQ(name(after.phase), name(arrow.to));
    EXPECT_EQ(after.loops, arrow.loops);
    EXPECT_EQ(name(after.loopEnd), name(arrow.end));
    EXPECT_EQ(name(after.failure), name(arrow.failure));
    EXPECT_EQ(after.since, after.phase == arrow.from.phase ? arrow.from.since : in.now);
}

const auto kNameOf = [](const auto& row) { return row.param.name; };
const auto kBegun = &AtemInput::loopRequested;

INSTANTIATE_TEST_SUITE_P(
    Loop, FeelForwardArrow,
    testing::Values(
        LoopArrow{"begins", loopAt(Idle, false), held({kBegun}), Halting, true},
        LoopArrow{"beginsAfterAFailure", loopAt(Failed, false), held({kBegun}), Halting, true},
        LoopArrow{"heldAloneBeginsNothing", loopAt(Idle, false), held(), Idle, false},
        LoopArrow{"heldAloneResumesNothing", loopAt(Presenting, false), held(), Presenting, false},
        LoopArrow{"letGoBeforeItBegan", loopAt(Idle, false), without(&AtemInput::held, {kBegun}),
                  Idle, false},
        LoopArrow{"notWhileStopped", loopAt(Stopped, false), held({kBegun}), Stopped, false},
        LoopArrow{"notWhileAProbeIsProposed", loopAt(ProposingProbe, false), held({kBegun}),
                  ProposingProbe, false},
        LoopArrow{"beginsAtAClearResult", loopAt(Presenting, false), held({kBegun}), Advancing,
                  true},
        LoopArrow{"pressesAgainIfNotClear", loopAt(Presenting, false),
                  forbidden(LoopEnd::Blocked, {kBegun}), Halting, true},
        LoopArrow{"pressesAgainIfTheRobotHasMoved", loopAt(Presenting, false),
                  held({kBegun, &AtemInput::poseChanged}), Halting, true},
        LoopArrow{"beginsWhereTheRobotHasMoved", loopAt(Idle, false),
                  held({kBegun, &AtemInput::poseChanged}), Halting, true},
        LoopArrow{"anExplorationIsNoLoop", loopAt(Idle, false),
                  held({kBegun, &AtemInput::requested}), Halting, false},
        LoopArrow{"halts", loopAt(Halting), held({&AtemInput::halted}), Pressing, true},
        LoopArrow{"waitsForTheRobotToBegin", loopAt(Halting), held({&AtemInput::unbegun}), Halting,
                  true},
        LoopArrow{"presses", loopAt(Pressing), held({&AtemInput::pressed}), Estimating, true},
        LoopArrow{"estimates", loopAt(Estimating), held({&AtemInput::estimateReady}), Presenting,
                  true},
        LoopArrow{"goesOn", loopAt(Presenting), held(), Advancing, true},
        LoopArrow{"stillAdvances", loopAt(Advancing), held(), Advancing, true},
        LoopArrow{"advanced", loopAt(Advancing), held({&AtemInput::advanced}), Halting, true}),
    kNameOf);

INSTANTIATE_TEST_SUITE_P(
    LetGo, FeelForwardArrow,
    testing::Values(
        LoopArrow{"whileHalting", loopAt(Halting), without(&AtemInput::held, {&AtemInput::halted}),
                  Idle, false, LoopEnd::LetGo},
        LoopArrow{"whilePressing", loopAt(Pressing),
                  without(&AtemInput::held, {&AtemInput::pressed}), Idle, false, LoopEnd::LetGo},
        LoopArrow{"whileEstimating", loopAt(Estimating), without(&AtemInput::held), Estimating,
                  false, LoopEnd::LetGo},
        LoopArrow{"asTheEstimateIsReady", loopAt(Estimating),
                  without(&AtemInput::held, {&AtemInput::estimateReady}), Presenting, false,
                  LoopEnd::LetGo},
        LoopArrow{"atTheResult", loopAt(Presenting), without(&AtemInput::held), Presenting, false,
                  LoopEnd::LetGo},
        LoopArrow{"whileAdvancing", loopAt(Advancing), without(&AtemInput::held), Idle, false,
                  LoopEnd::LetGo},
        LoopArrow{"asItHasAdvanced", loopAt(Advancing),
                  without(&AtemInput::held, {&AtemInput::advanced}), Idle, false, LoopEnd::LetGo}),
    kNameOf);

INSTANTIATE_TEST_SUITE_P(
    Results, FeelForwardArrow,
    testing::Values(LoopArrow{"aProbeWouldDecide", loopAt(Estimating),
                              held({&AtemInput::estimateReady, &AtemInput::probeWanted}),
                              ProposingProbe, false, LoopEnd::ProbeProposed},
                    LoopArrow{"blocked", loopAt(Presenting), forbidden(LoopEnd::Blocked),
                              Presenting, false, LoopEnd::Blocked},
                    LoopArrow{"notFelt", loopAt(Presenting), forbidden(LoopEnd::NotFelt),
                              Presenting, false, LoopEnd::NotFelt},
                    LoopArrow{"bounded", loopAt(Presenting), forbidden(LoopEnd::Bounded),
                              Presenting, false, LoopEnd::Bounded},
                    LoopArrow{"horizonShorterThanTheAdvance", loopAt(Presenting),
                              forbidden(LoopEnd::ShortHorizon), Presenting, false,
                              LoopEnd::ShortHorizon},
                    LoopArrow{"tiltedAtTheResult", loopAt(Presenting), forbidden(LoopEnd::Attitude),
                              Presenting, false, LoopEnd::Attitude},
                    LoopArrow{"staleAtTheResult", loopAt(Presenting), forbidden(LoopEnd::Stale),
                              Presenting, false, LoopEnd::Stale},
                    LoopArrow{"tiltsWhileAdvancing", loopAt(Advancing), held({&AtemInput::tilted}),
                              Idle, false, LoopEnd::Attitude},
                    LoopArrow{"odometryEndsWhileAdvancing", loopAt(Advancing),
                              held({&AtemInput::noOdometry}), Idle, false, LoopEnd::NoOdometry},
                    LoopArrow{"anExplorationIsRequested", loopAt(Advancing),
                              held({&AtemInput::requested}), Idle, false, LoopEnd::Aborted},
                    LoopArrow{"exploresOnceAtTheResult", loopAt(Presenting),
                              held({&AtemInput::requested}), Halting, false}),
    kNameOf);

INSTANTIATE_TEST_SUITE_P(
    LoopFaults, FeelForwardArrow,
    testing::Values(
        LoopArrow{"doesNotHalt", loopAt(Halting), held({}, 3.0), Failed, false, LoopEnd::Fault,
                  AtemFailure::HaltTimeout},
        LoopArrow{"doesNotBegin", loopAt(Halting), held({&AtemInput::unbegun}, 3.0), Failed, false,
                  LoopEnd::Fault, AtemFailure::BeginTimeout},
        LoopArrow{"pressNotSent", loopAt(Pressing), held({&AtemInput::notSent}), Failed, false,
                  LoopEnd::Fault, AtemFailure::NotSent},
        LoopArrow{"advanceNotSent", loopAt(Advancing), held({&AtemInput::notSent}), Failed, false,
                  LoopEnd::Fault, AtemFailure::NotSent},
        LoopArrow{"advanceNotSentAsItIsLetGo", loopAt(Advancing),
                  without(&AtemInput::held, {&AtemInput::notSent}), Idle, false, LoopEnd::LetGo},
        LoopArrow{"pressRefused", loopAt(Pressing), held({&AtemInput::pressRefused}), Failed, false,
                  LoopEnd::Fault, AtemFailure::PressRefused},
        LoopArrow{"pressTooLong", loopAt(Pressing), held({}, 15.0), Failed, false, LoopEnd::Fault,
                  AtemFailure::PressTimeout},
        LoopArrow{"estimateError", loopAt(Estimating), held({&AtemInput::estimateFailed}), Failed,
                  false, LoopEnd::Fault, AtemFailure::EstimateError},
        LoopArrow{"estimateTooSlow", loopAt(Estimating), held({}, 30.0), Failed, false,
                  LoopEnd::Fault, AtemFailure::EstimateTimeout},
        LoopArrow{"movedWhileEstimating", loopAt(Estimating), held({&AtemInput::poseChanged}),
                  Failed, false, LoopEnd::Fault, AtemFailure::PoseChanged},
        LoopArrow{"movedAtTheResult", loopAt(Presenting), held({&AtemInput::poseChanged}), Failed,
                  false, LoopEnd::Fault, AtemFailure::PoseChanged},
        LoopArrow{"linkLostAtTheResult", loopAt(Presenting), without(&AtemInput::linkAlive), Failed,
                  false, LoopEnd::Fault, AtemFailure::LinkLost},
        LoopArrow{"disarmedAtTheResult", loopAt(Presenting), without(&AtemInput::armed), Failed,
                  false, LoopEnd::Fault, AtemFailure::Disarmed},
        LoopArrow{"beginsWithoutLink", loopAt(Idle, false),
                  without(&AtemInput::linkAlive, {kBegun}), Failed, false, LoopEnd::Fault,
                  AtemFailure::LinkLost},
        LoopArrow{"beginsDisarmedAtAResult", loopAt(Presenting, false),
                  without(&AtemInput::armed, {kBegun}), Failed, false, LoopEnd::Fault,
                  AtemFailure::Disarmed},
        LoopArrow{"staleWhileAdvancing", loopAt(Advancing), without(&AtemInput::telemetryFresh),
                  Failed, false, LoopEnd::Fault, AtemFailure::LinkLost},
        LoopArrow{"advanceRefused", loopAt(Advancing), held({&AtemInput::advanceRefused}), Failed,
                  false, LoopEnd::Fault, AtemFailure::AdvanceRefused},
        LoopArrow{"didNotMove", loopAt(Advancing), held({&AtemInput::notMoved}), Failed, false,
                  LoopEnd::Fault, AtemFailure::NotMoved},
        LoopArrow{"ranOn", loopAt(Advancing), held({&AtemInput::ranOn, &AtemInput::advanced}),
                  Failed, false, LoopEnd::Fault, AtemFailure::RanOn},
        LoopArrow{"advanceTooLong", loopAt(Advancing), held({}, 10.0), Failed, false,
                  LoopEnd::Fault, AtemFailure::AdvanceTimeout}),
    kNameOf);

TEST(FeelForward, stopAbortLinkAndDisarmEndItInEveryPhase)
{
    for (const AtemPhase phase : {Halting, Pressing, Estimating, Presenting, Advancing}) {
        const auto after = [&](AtemInput in) {
            in.now = 101.0;
            return nextState(loopAt(phase), in, atem_loop::kLimits);
        };
        const AtemState stopped = after(held({&AtemInput::stop}));
        EXPECT_EQ(stopped.phase, Stopped) << name(phase);
        EXPECT_EQ(stopped.loopEnd, LoopEnd::Stop) << name(phase);
        EXPECT_EQ(after(held({&AtemInput::aborted})).phase, Idle) << name(phase);
        EXPECT_EQ(after(held({&AtemInput::aborted})).loopEnd, LoopEnd::Aborted) << name(phase);
        EXPECT_EQ(after(without(&AtemInput::linkAlive)).failure, AtemFailure::LinkLost)
            << name(phase);
        EXPECT_EQ(after(without(&AtemInput::armed)).failure, AtemFailure::Disarmed) << name(phase);
        for (const AtemInput& in : {held({&AtemInput::stop}), held({&AtemInput::aborted}),
                                    without(&AtemInput::linkAlive), without(&AtemInput::armed)})
            EXPECT_FALSE(after(in).loops) << name(phase);
    }
}

/// Tests every phase × every combination of the loop's flags × before and after the deadline.
TEST(FeelForward, movesOnlyWhileItIsHeldAndNothingForbidsIt)
{
    constexpr std::array kFlags{
        &AtemInput::requested,      &AtemInput::stop,          &AtemInput::linkAlive,
        &AtemInput::armed,          &AtemInput::estimateReady, &AtemInput::probeWanted,
        &AtemInput::poseChanged,    &AtemInput::loopRequested, &AtemInput::held,
        &AtemInput::telemetryFresh, &AtemInput::advanced,      &AtemInput::advanceRefused,
        &AtemInput::notMoved,       &AtemInput::ranOn,         &AtemInput::tilted,
        &AtemInput::noOdometry,     &AtemInput::notSent};
    const auto mayLoop = [](AtemPhase phase) {
        return phase == Halting || phase == Pressing || phase == Estimating || phase == Presenting
            || phase == Advancing;
    };
    int advances = 0;
    for (const AtemPhase phase : atem_loop::kPhases)
        for (unsigned bits = 0; bits < 1U << kFlags.size(); ++bits)
            for (const bool loops : {false, true}) {
                if (loops && !mayLoop(phase)) continue;
                AtemInput in;
                for (std::size_t i = 0; i < kFlags.size(); ++i)
                    in.*kFlags[i] = ((bits >> i) & 1U) != 0;
                // Results are judged without these two flags.
                in.now = in.tilted ? 101.0 : 1000.0;
                in.forbids = in.noOdometry ? LoopEnd::None : LoopEnd::Undecided;
                const AtemState next = nextState(loopAt(phase, loops), in, atem_loop::kLimits);
                ASSERT_FALSE(next.loops && next.loopEnd != LoopEnd::None);
                ASSERT_FALSE(next.loops && in.notSent && exploring(phase));
                if (next.loops) {
                    ASSERT_TRUE(mayLoop(next.phase) && in.held && !in.stop && in.linkAlive
                                && in.armed);
                }
                if (next.phase != Advancing || phase == Advancing) continue;
                ++advances;
                ASSERT_TRUE(next.loops && in.held && in.armed && in.linkAlive && !in.poseChanged
                            && phase == Presenting && in.forbids == LoopEnd::None);
            }
    EXPECT_GT(advances, 0) << "the test reaches what it forbids";
}

/// A verdict of one plane that is CLEAR to the front border of this bin.
TwoTrackVerdict clearTo(int bin)
{
    Verdict plane;
    plane.stepVerdict = StepVerdict::Clear;
    plane.horizon = binEnd(bin);
    plane.touchRecorded = true;
    return equalSides(plane);
}

FeltAhead ready(TwoTrackVerdict verdict)
{
    return {.verdict = std::move(verdict),
            .telemetryFresh = true,
            .odometry = true,
            .attitude = AttitudeLevel::Level};
}

TEST(WhyNotAdvancing, allowsAClearWayThatIsLongerThanTheAdvance)
{
    EXPECT_EQ(whyNotAdvancing(ready(clearTo(kFirstAhead + 1))), LoopEnd::None);
    EXPECT_EQ(whyNotAdvancing(ready(clearTo(kFirstAhead))), LoopEnd::ShortHorizon)
        << "felt as far as the advance, and no further";
    EXPECT_NEAR(clearWay(clearTo(kFirstAhead + 2)), 0.3, 1e-12);
    EXPECT_EQ(whyNotAdvancing(ready(clearTo(kFirstAhead + 1)), 0.25), LoopEnd::ShortHorizon);
}

TEST(WhyNotAdvancing, theNearerHorizonCounts)
{
    TwoTrackVerdict verdict = clearTo(kFirstAhead + 3);
    verdict.side[1].horizon = binEnd(kFirstAhead);
    EXPECT_EQ(whyNotAdvancing(ready(verdict)), LoopEnd::ShortHorizon);
}

TEST(WhyNotAdvancing, namesEveryReason)
{
    const TwoTrackVerdict clear = clearTo(kFirstAhead + 3);
    const auto with = [&](void (*change)(FeltAhead&)) {
        FeltAhead ahead = ready(clear);
        change(ahead);
        return whyNotAdvancing(ahead);
    };
    EXPECT_EQ(with([](FeltAhead& a) { a.telemetryFresh = false; }), LoopEnd::Stale);
    EXPECT_EQ(with([](FeltAhead& a) { a.odometry = false; }), LoopEnd::NoOdometry);
    EXPECT_EQ(with([](FeltAhead& a) { a.attitude = AttitudeLevel::Amber; }), LoopEnd::Attitude);
    EXPECT_EQ(with([](FeltAhead& a) { a.attitude = AttitudeLevel::Red; }), LoopEnd::Attitude);
    EXPECT_EQ(with([](FeltAhead& a) { a.verdict.reset(); }), LoopEnd::NoVerdict);
    EXPECT_EQ(with([](FeltAhead& a) { a.verdict->both = StepVerdict::Blocked; }), LoopEnd::Blocked);
    EXPECT_EQ(with([](FeltAhead& a) { a.verdict->both = StepVerdict::CannotTell; }),
              LoopEnd::Undecided);
    EXPECT_EQ(with([](FeltAhead& a) { a.verdict->side[1].touchRecorded = false; }),
              LoopEnd::NotFelt);
    EXPECT_EQ(whyNotAdvancing({}), LoopEnd::Stale) << "nothing is known";

    const std::array<std::pair<WithholdReason, LoopEnd>, 6> withheld{
        {{WithholdReason::Stale, LoopEnd::Stale},
         {WithholdReason::TelemetryGap, LoopEnd::Stale},
         {WithholdReason::SensorFault, LoopEnd::SensorFault},
         {WithholdReason::Contradiction, LoopEnd::Contradiction},
         {WithholdReason::Roll, LoopEnd::Withheld},
         {WithholdReason::NotConverged, LoopEnd::Withheld}}};
    for (const auto& [reason, end] : withheld) {
        FeltAhead ahead = ready(clear);
        ahead.verdict->both = StepVerdict::CannotTell;
        ahead.verdict->side[1].stepVerdict = StepVerdict::CannotTell;
        ahead.verdict->side[1].withheldFor = {reason};
        EXPECT_EQ(name(whyNotAdvancing(ahead)), name(end));
    }
    const std::array<std::pair<Shortfall, LoopEnd>, 4> short_{
        {{Shortfall::None, LoopEnd::Undecided},
         {Shortfall::NothingFelt, LoopEnd::NotFelt},
         {Shortfall::ShortHorizon, LoopEnd::ShortReach},
         {Shortfall::Spanned, LoopEnd::Bounded}}};
    for (const auto& [shortfall, end] : short_) {
        FeltAhead ahead = ready(clear);
        ahead.verdict->both = StepVerdict::CannotTell;
        ahead.verdict->side[1].stepVerdict = StepVerdict::CannotTell;
        ahead.verdict->side[1].shortfall = shortfall;
        EXPECT_EQ(name(whyNotAdvancing(ahead)), name(end));
    }
}

TEST(LoopEndNames, areUnique)
{
    for (int i = 0; i <= static_cast<int>(LoopEnd::NoOdometry); ++i) {
        const auto end = static_cast<LoopEnd>(i);
        for (int j = 0; j < i; ++j) {
            const auto other = static_cast<LoopEnd>(j);
            EXPECT_NE(name(end), name(other));
            EXPECT_STRNE(describe(end).english, describe(other).english);
        }
    }
}

Measurement reading(double travelled, RobotActivity activity)
{
    Measurement m;
    m.travelled = travelled;
    m.activity = activity;
    return m;
}

TEST(AdvanceWatch, comparesTheWayWithTheCommand)
{
    using enum AdvanceWatch::Result;
    using enum RobotActivity;
    const auto watch = [] { return AdvanceWatch(reading(5.0, Pressed), 0.1); };
    AdvanceWatch whole = watch();
    EXPECT_EQ(whole.poll(reading(5.0, Halted)), Running) << "it has not begun";
    EXPECT_EQ(whole.poll(reading(5.0, Driving)), Running);
    EXPECT_EQ(whole.poll(reading(5.06, Driving)), Running);
    EXPECT_EQ(whole.poll(reading(5.11, Halted)), Advanced);
    EXPECT_NEAR(whole.way(), 0.11, 1e-12);
    AdvanceWatch missed = watch();
    EXPECT_EQ(missed.poll(reading(5.1, Halted)), Advanced) << "the drive lay between two readings";
    AdvanceWatch stuck = watch();
    (void)stuck.poll(reading(5.0, Driving));
    EXPECT_EQ(stuck.poll(reading(5.02, Halted)), NotMoved);
    EXPECT_EQ(watch().poll(reading(5.16, Driving)), RanOn) << "it is still driving";
    EXPECT_EQ(watch().poll(reading(4.8, Driving)), RanOn) << "backwards";
    Measurement silent = reading(5.0, Driving);
    silent.travelled.reset();
    EXPECT_EQ(watch().poll(silent), NoOdometry);
    EXPECT_EQ(AdvanceWatch(silent, 0.1).poll(reading(5.0, Driving)), NoOdometry);
    EXPECT_THROW(AdvanceWatch(silent, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
