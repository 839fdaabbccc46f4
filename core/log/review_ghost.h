#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/infer/verdict/ghost_track.h"
#include "core/log/review_moment.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {

/// Ghost of a session's last estimate (infer/verdict/ghost.h) at a moment without an estimate. It
/// is what the console showed, computed from the file alone. It is followed for kFollowed after the
/// estimate was left. It starts kBefore that time, or when the estimate came, whichever is later.
/// Moving forward or a little back in time is fast.
class ReviewGhost {
public:
    static constexpr double kFollowed = 600.0, kBefore = 60.0;  ///< [s]

    /// The reader must outlive this object.
    ReviewGhost(SessionReader& reader, RobotModel robot);

    struct ViewState {
        std::optional<Ghost> ghost{};  ///< of one plane, or of the left side
        std::optional<NoGhost> why{};  ///< reason why an estimate has no ghost any more
        std::optional<Ghost> right{};  ///< of the right side; empty for an estimate of one plane
        bool onePlane = true;          ///< the estimate is of one plane
        bool operator==(const ViewState&) const = default;
    };
    /// Returns the ghost at a moment. All are empty while an estimate is shown or computed,
    /// before the first estimate, and after kFollowed. They are also empty once the operator
    /// discarded the estimate or loaded another model.
    ViewState at(const ReviewMoment& moment);

private:
    struct Followed {
        std::int64_t estimate;             ///< its id
        std::array<GhostTrack, 2> tracks;  ///< left, right
        bool onePlane;
        TelemetryListener listener;
        SessionTime until;  ///< time up to which it was followed
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
    /// The same estimate at several times: at its start, and at some later times. The last one
    /// moves on.
    std::vector<Followed> followed_;
};

}  // namespace terratact
