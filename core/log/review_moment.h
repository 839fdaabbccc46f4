#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/atem/alarms.h"
#include "core/atem/arming.h"
#include "core/atem/atem_machine.h"
#include "core/base/message.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"
#include "core/wire/telemetry.h"

namespace terratact {

/// State of the console at one time of a session. Pointers to rows are null if there was no such
/// row. They are valid until the reader's next refresh().
struct ReviewMoment {
    SessionTime time = 0;

    std::optional<Measurement> measurement{};  ///< newest of the last kReviewWindow
    SessionTime measured = 0;                  ///< time at which it arrived
    ElementForces forces{};                    ///< forces of the line behind the measurement
    double linesPerSecond = 0.0;               ///< telemetry lines in the last second
    /// State of the link as recorded; before its first record, by frames at this time.
    bool linkAlive = false;
    bool telemetryAlone = false;  ///< the link is lost, but other frames of the robot came
    SessionTime linkSince = 0;    ///< time since which the link has this state
    bool unbroken = true;         ///< no silence of more than kMaxSilence has ended since the scene
    bool sensorsSound = true;     ///< kSensorAlarm was not raised at the scene or since
    Message overridden{};         ///< what the operator has overridden; empty: nothing
    std::optional<SessionDamage> damage{};  ///< damage that covers this time

    const ModelRow* model = nullptr;
    const SceneRow* scene = nullptr;
    std::shared_ptr<const EstimateRow> estimate{}, second{};  ///< estimates with their draws
    const ProposalRow* proposal = nullptr;                    ///< proposal of the estimate
    const EventRow* decision = nullptr;  ///< the operator's answer to the proposal
    /// Reason why the last estimate is not valid any more; empty: there was none.
    Message forgotten{};

    AtemState state{};  ///< `since` is on the session's clock [s]
    std::optional<ArmingPhase> arming{};
    std::vector<Alarm> alarms{};  ///< severity is not recorded
};

inline constexpr double kReviewWindow = 1.0;  ///< [s] of frames before a moment that are evaluated

/// Moments of a session, each computed from the file alone. The same time gives the same moment,
/// whatever was asked before; caches only avoid repeated reading. The reader must outlive this
/// object.
class ReviewMoments {
public:
    ReviewMoments(SessionReader& reader, RobotModel robot);

    ReviewMoment at(SessionTime time);

    /// Returns the time of the next or previous frame; empty if there is none.
    std::optional<SessionTime> frameAfter(SessionTime time);
    std::optional<SessionTime> frameBefore(SessionTime time);

private:
    struct Batch {
        std::int64_t id = 0;
        std::vector<FrameRow> frames;
    };
    const std::vector<FrameRow>& frames(std::size_t batch);
    std::shared_ptr<const EstimateRow> whole(const EstimateRow* row);
    void hear(ReviewMoment& moment);
    void addRows(ReviewMoment& moment);
    void addEvents(ReviewMoment& moment);

    SessionReader& reader_;
    RobotModel robot_;
    std::deque<Batch> recent_;                                ///< newest first
    std::deque<std::shared_ptr<const EstimateRow>> drawn_{};  ///< newest first
};

}  // namespace terratact
