#include "app/modelling/trials/feel_forward_simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/infer/two_track_estimator.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/sim/ground/hazard_terrain.h"
#include "core/sim/two_track_check.h"
#include "core/terrain/step.h"

namespace terratact {
namespace {

constexpr double kTick = 0.04;               // [s]
constexpr double kPressTorque = 18.0;        // [N m] as the console presses
constexpr double kEnd = kHazardEnd + 0.3;    // [m] the drive ends here
constexpr int kLastUnder = kFirstAhead - 1;  // foremost bin under the tracks

bool standsStill(RobotActivity activity)
{
    return activity == RobotActivity::Halted || activity == RobotActivity::Pressed;
}

/// Returns the largest rise, or the largest fall as a negative number, from the bins before `bin` to it.
double stepAt(const Heights& heights, int bin)
{
    double step = 0.0;
    for (int i = std::max(0, bin - kStepBins); i < bin; ++i) {
        const double rise =
            heights[static_cast<std::size_t>(bin)] - heights[static_cast<std::size_t>(i)];
        if (std::abs(rise) > std::abs(step)) step = rise;
    }
    return step;
}

std::vector<Heights> truths(const SimulatedRobot& robot)
{
    if (!robot.stance().tracks()) return {robot.truth()};
    return {robot.truth(ProbeSide::Left), robot.truth(ProbeSide::Right)};
}

}  // namespace

FeelForwardSimulation::FeelForwardSimulation(const EstimatorBundle& bundle,
                                             const FeelForwardTrial& trial, GroundLines ground,
                                             const SimulatedRobot::Options& options)
    : bundle_(bundle), trial_(trial), robot_(bundle.robot, std::move(ground), options),
      line_(robot_.measure()), way_(bundle.robot)
{
    counts_.drives = 1;
}

FeelForwardCounts FeelForwardSimulation::run()
{
    do hold();
    while (driveByHand());
    return counts_;
}

void FeelForwardSimulation::hold()
{
    const double began = now_;
    tick(true);
    while (state_.loops && counts_.falls + counts_.collisions == 0) tick(false);
    counts_.seconds += now_ - began;
    ++counts_.ends[state_.loopEnd];
    if (state_.phase == AtemPhase::Failed) ++counts_.failures[state_.failure];
}

/// Adds the newest line to the memory of the way.
void FeelForwardSimulation::follow()
{
    if (trial_.settings.method == Method::Trail) way_.add(line_);
}

void FeelForwardSimulation::tick(bool begins)
{
    robot_.step(kTick);
    line_ = robot_.measure();
    follow();
    now_ += kTick;
    if (state_.phase == AtemPhase::Advancing) judgeGround();
    AtemInput in = poll();
    in.loopRequested = begins;
    if (advance_ && state_.phase == AtemPhase::Advancing) {
        const AdvanceWatch::Result result = advance_->poll(line_);
        in.advanced = result == AdvanceWatch::Result::Advanced;
        in.notMoved = result == AdvanceWatch::Result::NotMoved;
        in.ranOn = result == AdvanceWatch::Result::RanOn;
    }
    const AtemPhase before = state_.phase;
    state_ = nextState(state_, in, {});
    if (state_.phase == before) return;
    if (before == AtemPhase::Advancing) {
        counts_.advanced += robot_.pose().base.x - advancedFrom_;
        counts_.touches += touched_ ? 1 : 0;
    }
    enter(state_.phase);
}

AtemInput FeelForwardSimulation::poll() const
{
    const AttitudeLevel attitude = attitudeOf(line_, bundle_.robot, {}).worst();
    AtemInput in{.now = now_, .held = true};
    in.halted = standsStill(line_.activity);
    in.pressed = line_.activity == RobotActivity::Pressed;
    in.pressRefused = line_.refusal != Refusal::None;
    in.estimateReady = now_ - state_.since >= trial_.estimateSeconds;
    in.forbids = whyNotAdvancing({.verdict = verdict_,
                                  .telemetryFresh = true,
                                  .odometry = line_.travelled.has_value(),
                                  .attitude = attitude});
    if (trial_.isBlind) in.forbids = LoopEnd::None;
    in.tilted = attitude != AttitudeLevel::Level;
    in.advanceRefused = line_.refusal != Refusal::None;
    return in;
}

void FeelForwardSimulation::enter(AtemPhase phase)
{
    switch (phase) {
    case AtemPhase::Halting:
        verdict_.reset();
        robot_.command(BeginAtemCommand{});
        break;
    case AtemPhase::Pressing:
        ++counts_.presses;
        robot_.command(PressCommand{.torque = kPressTorque});
        break;
    case AtemPhase::Estimating: estimate(); break;
    case AtemPhase::Advancing:
        ++counts_.advances;
        touched_ = false;
        advancedFrom_ = robot_.pose().base.x;
        advance_.emplace(line_, kAdvance);
        robot_.command(AdvanceCommand{.distance = kAdvance});
        break;
    case AtemPhase::Presenting:
    case AtemPhase::Idle:
    case AtemPhase::Failed: robot_.command(AbortAtemCommand{}); break;
    case AtemPhase::ProposingProbe:
    case AtemPhase::Probing:
    case AtemPhase::EstimatingAgain:
    case AtemPhase::Stopped: break;
    }
}

void FeelForwardSimulation::estimate()
{
    const TrailHistory memory = way_.before(line_);
    TwoTrackEstimate estimate =
        estimateMeasured(line_, {}, bundle_.robot, bundle_.models, trial_.settings, {}, &memory);
    if (trial_.settings.method == Method::Trail) way_.addScene(line_);
    writePosteriorCheck(estimate, line_, bundle_.robot);
    verdict_ = verdictOf(estimate, bundle_.robot, line_, {}, trial_.stepLimit);
}

void FeelForwardSimulation::judgeGround()
{
    // Without a rest pose the robot would tip over.
    const bool tips = line_.refusal == Refusal::NoRestPose
                   || attitudeOf(line_, bundle_.robot, {}).worst() == AttitudeLevel::Red;
    double fall = 0.0, rise = 0.0;
    for (const Heights& heights : truths(robot_))
        for (const int bin : {kLastUnder - 1, kLastUnder}) {
            fall = std::max(fall, -stepAt(heights, bin));
            rise = std::max(rise, stepAt(heights, bin));
        }
    if (tips || fall > trial_.stepLimit)
        counts_.falls = 1;
    else if (rise > trial_.stepLimit)
        counts_.collisions = 1;
    touched_ = touched_ || flipperTouches();
}

bool FeelForwardSimulation::flipperTouches() const
{
    const RobotStance& stance = robot_.stance();
    // A step above the tracks' foremost wheels, along gravity.
    const double ground = robot_.truth()[static_cast<std::size_t>(kLastUnder)]
                        + imuPosition(bundle_.robot, robot_.pose()).z;
    const auto touches = [&](const std::vector<GroundContact>& contacts) {
        return std::ranges::any_of(contacts, [&](const GroundContact& contact) {
            return contact.part == GroundContact::Part::Front
                && contact.point.z > ground + trial_.stepLimit;
        });
    };
    if (!stance.tracks()) return touches(stance.plane().contacts);
    return touches(stance.tracks()->contacts[0]) || touches(stance.tracks()->contacts[1]);
}

/// Returns true if a true step lies where the tracks would be after an advance, or just before them.
bool FeelForwardSimulation::isStepNear() const
{
    return std::ranges::any_of(truths(robot_), [&](const Heights& heights) {
        return hasStep(heights, trial_.stepLimit, kLastUnder - 1, kFirstAhead + 2);
    });
}

bool FeelForwardSimulation::driveByHand()
{
    if (counts_.falls + counts_.collisions > 0 || state_.phase == AtemPhase::Failed) return false;
    if (isStepNear()) {
        ++counts_.beforeHazard;
        return false;
    }
    const double from = robot_.pose().base.x;
    robot_.command(AbortAtemCommand{});
    robot_.command(AdvanceCommand{.distance = kAdvance});
    for (int i = 0; i < 500 && robot_.activity() == RobotActivity::Driving; ++i) {
        robot_.step(kTick);
        if (trial_.settings.method != Method::Trail) continue;
        line_ = robot_.measure();
        follow();
    }
    line_ = robot_.measure();
    const double moved = robot_.pose().base.x - from;
    counts_.byHand += moved;
    state_ = {};
    verdict_.reset();
    if (robot_.pose().base.x < kEnd && moved > 0.01) return true;
    ++counts_.atEnd;
    return false;
}

}  // namespace terratact
