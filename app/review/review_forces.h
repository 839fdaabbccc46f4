#pragma once

#include <deque>
#include <vector>

#include "app/pages/force_arrays.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// What the force elements felt before a time of a session, made of the file alone: the same time shows the same
/// peaks, however one came there.  Each batch of frames is read with the one before it, so that no line of telemetry
/// is lost between them.  The reader must outlive it.
class ReviewForces {
public:
    ReviewForces(SessionReader& reader, const RobotModel& robot) : reader_(reader), robot_(robot) {}

    /// Of the last PeakHold::kHold seconds, but not of before a silence of kStaleAfter, where the console lets go of
    /// its peaks.  threshold: [N] of contact.
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
    std::deque<Batch> recent_{};  ///< the newest in front
};

}  // namespace terratact
