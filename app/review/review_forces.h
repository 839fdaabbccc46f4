#pragma once

#include <deque>
#include <vector>

#include "app/pages/force_arrays.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Forces before a time of a session, computed from the file alone. The same time always shows the same peaks, whatever
/// was shown before. Each batch of frames is read together with the previous one, so that no telemetry line is lost
/// between them. The reader must outlive the object.
class ReviewForces {
public:
    ReviewForces(SessionReader& reader, const RobotModel& robot) : reader_(reader), robot_(robot) {}

    /// Returns the forces of the last PeakHold::kHold seconds. A gap longer than kStaleAfter ends the range, because
    /// the console resets its peaks there. threshold: contact threshold [N].
    std::vector<TimedForces> before(SessionTime time, double threshold);

private:
    struct Batch {
        std::int64_t id = 0;
        double threshold = 0.0;
        std::vector<TimedForces> felt{};
    };
    const std::vector<TimedForces>& feltIn(std::size_t batch, double threshold);

    SessionReader& reader_;
    RobotModel robot_;
    std::deque<Batch> recent_{};  ///< newest first
};

}  // namespace terratact
