#pragma once

#include <optional>
#include <vector>

#include "core/infer/verdict/ghost_track.h"
#include "core/log/review_moment.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {

/// The ghost of a session's last estimate (infer/verdict/ghost.h) at a moment at which none stands: as the console had it, made
/// of the file alone.  It is followed for kFollowed after the estimate was left, from kBefore before that or from when the
/// estimate came.  Times that go on, or a little back, are quick.
class ReviewGhost {
public:
    static constexpr double kFollowed = 600.0, kBefore = 60.0;  ///< [s]

    /// The reader must outlive it.
    ReviewGhost(SessionReader& reader, RobotModel robot);

    struct ViewState {
        std::optional<Ghost> ghost{};
        std::optional<NoGhost> why{};  ///< where an estimate has one no longer
        bool operator==(const ViewState&) const = default;
    };
    /// Neither where an estimate stands or is in the making, before the first, and after the operator forgot it,
    /// another model was loaded, or kFollowed.
    ViewState at(const ReviewMoment& moment);

private:
    struct Followed {
        std::int64_t estimate;  ///< its id
        GhostTrack track;
        TelemetryListener listener;
        SessionTime until;  ///< it was followed
    };

    const EstimateRow* lastUpTo(SessionTime time) const;
    std::optional<SessionTime> leftAt(const EstimateRow& row, SessionTime until) const;
    bool isForgotten(const EstimateRow& row, SessionTime left, SessionTime until) const;
    AtemPhase phaseAt(SessionTime time) const;
    void begin(const EstimateRow& row, SessionTime left);
    void goTo(SessionTime until);
    void follow(SessionTime until);

    SessionReader& reader_;
    RobotModel robot_;
    std::vector<Followed>
        followed_;  ///< the same estimate at a start, and some time apart; the last one moves on
};

}  // namespace terratact
