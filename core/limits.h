#pragma once

/// Time limits and thresholds that several rooms share; each is defined here only.
namespace terratact {

/// Telemetry older than this [s] is stale: no verdict rests on it, and no value is shown as
/// current. The verdict is withheld: WithholdReason::Stale in core/infer/verdict/verdict.h. The
/// console mutes the picture: app/pages/terrain_page_show.cpp.
inline constexpr double kStaleAfter = 0.15;

/// The link is lost after this time [s] without telemetry. The robot's watchdog disarms it after
/// the same time without a heartbeat of the console. Its dead-man ends a drive after the same time
/// without a Drive frame.
inline constexpr double kLinkLostAfter = 0.25;

/// Approval expiry [s]: a proposed probe waits this long for the operator, and an approval is valid
/// for less than this. Then the probe counts as refused, and the exploration ends with the estimate
/// that it has: AtemState::approvalExpired in core/atem/atem_machine.h.
inline constexpr double kApprovalExpiry = 30.0;

/// Returns true if an approval of this age [s] is valid. One of negative or unknown (NaN) age is not. The gate and the
/// exploration both ask this.
constexpr bool isApprovalValid(double age, double expiry)
{
    return age >= 0.0 && age < expiry;
}

/// Longest silence of telemetry [s] during which the robot counts as observed. It may have moved in
/// a longer one.
inline constexpr double kMaxSilence = 1.0;

/// Odometry that is faster [m/s] is no motion of the tracks. The gate lets a robot drive at 0.6 m/s
/// (GateLimits::speed); the rest allows for slip and for late lines. The sensor watch and the memory of
/// the way both ask this.
inline constexpr double kFastestTracks = 1.5;

/// Range of the operator's step limit [m]. Its default is kStepLimit (core/terrain/step.h).
inline constexpr double kLowestStepLimit = 0.02, kHighestStepLimit = 0.60;

/// Most that the robot may advance in feel forward [m].
inline constexpr double kMaxAdvance = 0.1;

/// Probe threshold [m]: the arm is proposed for a bin with a larger standard deviation. It is the
/// default of Settings::probeAbove, which proposeProbe() compares (core/atem/probe/arm_choice.h).
/// Source: section 4.4 of the paper.
inline constexpr double kProbeThreshold = 0.06;

}  // namespace terratact
