#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/wire/can_codec.h"
#include "core/wire/can_frame.h"
#include "core/wire/e2e.h"
#include "core/wire/telemetry.h"

namespace terratact {

/// What became of the frames that a listener took: each is in exactly one of used, fromConsole, faults,
/// repeated and wrongSequence.
struct TelemetryCounters {
    std::uint64_t used = 0;                            ///< a robot's, sound and in order
    std::uint64_t fromConsole = 0;                     ///< sound, but a console's
    std::array<std::uint64_t, kFrameFaults> faults{};  ///< by FrameFault; unknown identifiers, too
    std::uint64_t repeated = 0, wrongSequence = 0;     ///< a robot's, refused for their counter

    std::uint64_t gaps = 0;        ///< of `used`: one or two frames were missing before it
    std::uint64_t lines = 0;       ///< telemetry lines that made a Measurement
    std::uint64_t unfinished = 0;  ///< lines that never became whole
    std::uint64_t partial = 0;     ///< whole lines without attitude or flipper angles
    std::uint64_t orphans = 0;     ///< whole lines without a status of at most 0.25 s beside them

    std::uint64_t of(FrameFault fault) const { return faults[static_cast<std::size_t>(fault)]; }
    bool operator==(const TelemetryCounters&) const = default;
};

/// Makes measurements of the frames a robot sends: the receiving half of a console, and all of a replay or
/// of a console that only listens.  Sends nothing, has no clock; `now` is the time [s] at which the frame
/// arrived, on any clock that does not run backwards (one that does is a lost link, see E2eReceiver).
///
/// A frame counts when it is ours in every bit and its counter follows that of its kind; what is refused is
/// counted.  Nothing here tells telemetry of now from a recording: see Freshness.
class TelemetryListener {
public:
    explicit TelemetryListener(RobotModel robot);

    /// The measurement that this frame completes; its time is `now`.  The status in it is the last sound one.
    /// Throws std::invalid_argument unless `now` is finite.
    std::optional<Measurement> take(const CanFrame& frame, double now);

    /// The last sound RobotStatus, however old; link() and age() say what it is worth.
    const std::optional<RobotStatus>& status() const { return status_; }

    /// Of the frames of one kind.  Throw std::invalid_argument for a kind that a console sends.
    LinkState link(FrameKind kind, double now) const;
    std::optional<double> age(FrameKind kind, double now) const;  ///< [s] see E2eReceiver::age

    /// The token of the last sound RobotHeartbeat, for Freshness::echoed.
    std::optional<std::uint16_t> token() const { return token_; }
    /// The challenge beside it; 0 for none.
    std::uint16_t challenge() const { return challenge_; }

    /// The last whole line of sensors, whether or not it made a measurement, and what its elements feel.
    const std::optional<SensorLine>& line() const { return line_; }
    const ElementForces& forces() const { return forces_; }

    TelemetryCounters counters() const;

private:
    void refuse(const CanFrame& frame, FrameFault fault, double now);
    bool isInOrder(const CanFrame& frame, FrameKind kind, double now);
    std::optional<Measurement> measured(const SensorLine& line, double now);

    RobotModel robot_;
    std::vector<E2eReceiver> receivers_;  ///< from Odometry to ArmResult
    SensorLineReader reader_;
    std::optional<RobotStatus> status_;
    std::optional<std::uint16_t> token_;
    std::uint16_t challenge_ = 0;
    std::optional<SensorLine> line_;
    ElementForces forces_;
    TelemetryCounters counters_;
};

}  // namespace terratact
