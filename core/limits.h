#pragma once

/// Time limits and thresholds that several parts obey, each written once.
namespace terratact {

/// Telemetry older than this [s] is stale: no verdict stands on it, and no value is shown as the present one.
inline constexpr double kStaleAfter = 0.15;

/// The link is lost after so long [s] without telemetry.  The robot's watchdog disarms it after as long without a
/// heartbeat of the console, and its dead-man ends a drive after as long without a Drive frame.
inline constexpr double kLinkLostAfter = 0.25;

/// Approval expiry [s]: how long a proposed probe waits for the operator, and how long the operator's word holds.
inline constexpr double kApprovalExpiry = 30.0;

/// Probe threshold [m]: a bin with a larger standard deviation asks for the arm.  Source: section 4.4 of the paper.
inline constexpr double kProbeThreshold = 0.06;

}  // namespace terratact
