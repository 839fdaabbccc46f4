#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {

struct SessionSpan {
    SessionTime first = 0, last = 0;
    bool operator==(const SessionSpan&) const = default;
};

/// What only all frames of a session together tell: when a force element felt the ground, and when no telemetry
/// came.  Goes through the file batch by batch, so that whoever shows it can do so while it goes on, and a file
/// that still grows is gone on with.
class SessionSurvey {
public:
    /// threshold: [N] above which an element is in contact.
    SessionSurvey(const RobotModel& robot, double threshold);

    /// Takes the next batch; false: there is none more now.
    bool takeNext(SessionReader& reader);

    std::size_t taken() const { return next_; }  ///< batches
    const std::vector<SessionSpan>& contacts() const { return contacts_; }
    const std::vector<SessionSpan>& silences() const { return silences_; }  ///< over 0.25 s

private:
    void take(const Measurement& measurement, SessionTime time);

    TelemetryListener listener_;
    double threshold_;
    std::size_t next_ = 0;
    std::optional<SessionTime> heard_;
    bool touches_ = false;
    std::vector<SessionSpan> contacts_, silences_;
};

}  // namespace terratact
