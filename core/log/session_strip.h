#pragma once

#include <cstdint>
#include <vector>

#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor_watch.h"
#include "core/strip/strip.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {

/// The strip of felt ground (core/strip/strip.h) of a session, computed from the file alone. It uses telemetry, scenes,
/// and the estimates that the console showed. Estimates of a second method are left out. An estimate that the operator
/// cleared is taken out. A new section begins when remembered ground is cleared or another model is loaded. It also
/// begins when this object's sensor watch suspects the odometry or the pitch.
class SessionStrip {
public:
    /// from: all rows up to this time are left out. The reader must outlive this object.
    SessionStrip(SessionReader& reader, const RobotModel& robot, SessionTime from = -1);

    /// Follows the session up to a time, forward only.
    void goTo(SessionTime until);
    SessionTime time() const { return at_; }  ///< time of the last goTo()
    /// Returns the strip. StripSource::time is that of the scene since the session's begin [s].
    const Strip& strip() const { return strip_; }

private:
    /// A row that changes the strip. Rows of equal time are applied in the order of their kinds.
    struct Act {
        enum class Kind : std::uint8_t { Gap, Model, Scene, Estimate, Clear, Abort, Left, Restore };
        SessionTime time = 0;
        Kind kind = Kind::Gap;
        const void* row = nullptr;
    };
    std::vector<Act> actsUpTo(SessionTime until) const;
    void apply(const Act& act);
    void enter(const EstimateRow* row);
    void follow(SessionTime until);
    bool isExploring(SessionTime time) const;

    SessionReader* reader_;
    Strip strip_;
    TelemetryListener listener_;
    SensorWatch sensors_;
    SessionTime at_;
    std::int64_t entered_ = 0;  ///< id of the estimate that was entered last
    bool stands_ = false;       ///< the robot has not left its place, and it was not cleared
};

}  // namespace terratact
