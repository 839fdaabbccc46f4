#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/wire/can_codec.h"
#include "core/wire/can_frame.h"
#include "core/wire/frame_validator.h"
#include "core/wire/telemetry.h"

namespace terratact {

/// Counters of the frames that a listener received. Each frame is in exactly one of used,
/// fromConsole, faults, repeated and wrongSequence.
struct TelemetryCounters {
    std::uint64_t used = 0;         ///< valid frame of a robot, in order
    std::uint64_t fromConsole = 0;  ///< valid frame of a console
    /// indexed by FrameFault, with unknown identifiers
    std::array<std::uint64_t, kFrameFaults> faults{};
    std::uint64_t repeated = 0, wrongSequence = 0;  ///< frame of a robot, refused for its counter

    std::uint64_t gaps = 0;        ///< part of `used`: one or two frames are missing before it
    std::uint64_t lines = 0;       ///< telemetry lines that became a Measurement
    std::uint64_t unfinished = 0;  ///< lines that never became complete
    std::uint64_t partial = 0;     ///< complete lines without attitude or flipper angles
    std::uint64_t orphans = 0;     ///< complete lines without a status of at most kLinkLostAfter

    std::uint64_t of(FrameFault fault) const { return faults[static_cast<std::size_t>(fault)]; }
    bool operator==(const TelemetryCounters&) const = default;
};

/// Makes measurements from a robot's frames. It is the receiving half of a console, and the whole
/// of a replay or of a receive-only console. It sends nothing and has no clock; `now` is the
/// arrival time of the frame [s]. A clock that runs backwards is a lost link, see E2eReceiver.
///
/// A frame counts if every bit is valid and its counter follows the last one of its kind. Refused
/// frames are counted. This class cannot distinguish live telemetry from a recording: see
/// Freshness.
class TelemetryListener {
public:
    explicit TelemetryListener(RobotModel robot);

    /// Adds a frame. Returns the measurement that it completes, with the time `now` and the last
    /// valid status. Throws std::invalid_argument unless `now` is finite.
    std::optional<Measurement> receive(const CanFrame& frame, double now);

    /// Judges a frame without using it: one that this console sent itself. Throws as receive() does.
    const JudgedFrame& judge(const CanFrame& frame, double now);
    /// Returns the verdict on the last frame.
    const JudgedFrame& judged() const { return judged_; }

    /// Returns the last valid RobotStatus, however old. link() and age() show whether it is
    /// current.
    const std::optional<RobotStatus>& status() const { return status_; }

    /// Return the link and age of one kind of frame. Throw std::invalid_argument for a kind that a
    /// console sends.
    LinkState link(FrameKind kind, double now) const;
    std::optional<double> age(FrameKind kind, double now) const;  ///< [s], see E2eReceiver::age

    /// Returns the token of the last valid RobotHeartbeat, for Freshness::echoed.
    std::optional<std::uint16_t> token() const { return token_; }
    /// Returns the challenge beside that token; 0: none.
    std::uint16_t challenge() const { return challenge_; }

    /// Returns the forces of the last complete line of sensors, even without a measurement.
    const ElementForces& forces() const { return forces_; }

    TelemetryCounters counters() const;

private:
    bool isInOrder(FrameCheck check);
    std::optional<Measurement> measured(const SensorLine& line, double now);

    RobotModel robot_;
    FrameValidator validator_;
    JudgedFrame judged_;  ///< the last frame
    SensorLineReader reader_;
    std::optional<RobotStatus> status_;
    std::optional<std::uint16_t> token_;
    std::uint16_t challenge_ = 0;
    ElementForces forces_;
    TelemetryCounters counters_;
};

}  // namespace terratact
