#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "core/atem/command_gate.h"

namespace terratact {

using enum GateRefusal;

inline constexpr GateLimits kLimits;
inline constexpr std::uint8_t kEpoch = 77;
inline constexpr std::uint16_t kChallenge = 0xC0DE;
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using Change = std::function<void(GateView&)>;

/// Armed, halted, everything fresh, no exploration.
inline GateView ready(RobotActivity activity = RobotActivity::Halted, bool exploring = false)
{
    GateView view;
    view.link = LinkState::Good;
    view.statusAge = 0.05;
    view.answerAge = 0.1;
    view.challenge = kChallenge;
    view.operatorAge = 0.01;
    view.stopLatched = false;
    view.arming = {.phase = ArmingPhase::Armed, .epoch = kEpoch};
    view.robot =
        RobotStatus{.epoch = kEpoch, .activity = activity, .armed = true, .exploring = exploring};
    return view;
}

/// Like ready(), with an approved probe of bin 8.
inline GateView approved()
{
    GateView view = ready(RobotActivity::Pressed, true);
    view.approval = ProbeApproval{.bin = 8, .age = 2.0};
    return view;
}

/// Before arming: the operator has confirmed, and the robot has not answered yet.
inline GateView requested()
{
    GateView view = ready();
    view.arming = {.phase = ArmingPhase::Requested};
    view.robot->armed = false;
    return view;
}

inline GateRefusal verdict(const Command& command, const GateView& view,
                           const GateLimits& limits = kLimits)
{
    return judge(frameOf(command, kEpoch, 1, kChallenge), view, limits);
}

struct Case {
    Command command;
    GateView view;  ///< a view in which it passes
};

/// Every command that needs a state, with a view in which it passes.
inline std::vector<Case> conditional()
{
    GateView stopped = ready(RobotActivity::Stopped);
    stopped.arming = {};
    stopped.robot->armed = false;
    return {{ReleaseStopCommand{}, stopped},
            {ArmCommand{true}, requested()},
            {DriveCommand{0.2}, ready()},
            {BeginAtemCommand{}, ready()},
            {PressCommand{18.0}, ready(RobotActivity::Halted, true)},
            {HoldFlippersCommand{0.7, -0.2}, ready()},
            {ProbeCommand{8}, approved()},
            {AdvanceCommand{0.1}, ready()}};
}

inline const std::vector<Command>& safeCommands()
{
    static const std::vector<Command> all{StopCommand{}, HaltCommand{}, AbortAtemCommand{},
                                          ArmCommand{false}};
    return all;
}

}  // namespace terratact
