#pragma once

#include <optional>

#include "core/infer/ghost_track.h"
#include "core/log/review_moment.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {

/// The ghost of a session's last estimate (infer/ghost.h), at a moment at which none stands: as the console had it,
/// made of the file alone.  Times that go on
/// are quick; one before the last reads again from when the estimate came.
class ReviewGhost {
public:
    /// The reader must outlive it.
    ReviewGhost(SessionReader& reader, RobotModel robot);

    struct Sight {
        std::optional<Ghost> ghost{};
        std::optional<NoGhost> why{};  ///< where an estimate has one no longer
        bool operator==(const Sight&) const = default;
    };
    /// Neither where an estimate stands or is in the making, before the first, and after the operator forgot it or
    /// another model was loaded.
    Sight at(const ReviewMoment& moment);

private:
    struct Followed {
        std::int64_t estimate;  ///< its id
        GhostTrack track;
        TelemetryListener listener;
        SessionTime until;  ///< it was followed
    };

    const EstimateRow* lastUpTo(SessionTime time) const;
    std::optional<SessionTime> leftAt(const EstimateRow& row, SessionTime until) const;
    bool isForgotten(SessionTime left, SessionTime until) const;
    void begin(const EstimateRow& row, SessionTime left);
    void follow(SessionTime until);

    SessionReader& reader_;
    RobotModel robot_;
    std::optional<Followed> followed_;
};

}  // namespace terratact
