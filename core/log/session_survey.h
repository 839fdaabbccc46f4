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

/// Survey of all frames of a session: when a force element felt the ground, and when telemetry was
/// silent. It reads the file batch by batch. A caller can show results meanwhile, and continue in a
/// file that still grows.
class SessionSurvey {
public:
    /// threshold: force above which an element is in contact [N].
    SessionSurvey(const RobotModel& robot, double threshold);

    /// Adds the next batch. Returns false if there is none now.
    bool addNext(SessionReader& reader);

    std::size_t batchesRead() const { return next_; }  ///< number of batches read
    const std::vector<SessionSpan>& contacts() const { return contacts_; }
    const std::vector<SessionSpan>& silences() const { return silences_; }  ///< longer than 0.25 s

private:
    void add(const Measurement& measurement, SessionTime time);

    TelemetryListener listener_;
    double threshold_;
    std::size_t next_ = 0;
    std::optional<SessionTime> newestTelemetry_;
    bool touches_ = false;
    std::vector<SessionSpan> contacts_, silences_;
};

}  // namespace terratact
