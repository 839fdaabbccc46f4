#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/atem/alarms.h"
#include "core/atem/arming.h"
#include "core/atem/atem_machine.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"
#include "core/wire/telemetry.h"

namespace terratact {

/// What the console showed at a time of a session.  Rows that stood then; null: none did.  Valid until the
/// reader's next refresh().
struct ReviewMoment {
    SessionTime time = 0;

    std::optional<Measurement> measurement{};  ///< the newest of the last kReviewWindow
    SessionTime measured = 0;                  ///< when it arrived
    std::optional<SensorLine> line{};          ///< of the bus, that it was made of
    double linesPerSecond = 0.0;               ///< of telemetry, of the last second
    bool linkAlive = false;                    ///< as it was told; before it was, as heard now
    bool telemetryAlone = false;               ///< where it is not: other frames of the robot came
    SessionTime linkSince = 0;                 ///< it has been so
    bool unbroken = true;      ///< no silence of more than kMaxSilence has ended since the scene
    bool sensorsSound = true;  ///< kSensorAlarm did not stand at the scene, nor since
    std::string overridden{};  ///< what the operator had overridden, in words; empty: nothing
    std::optional<SessionDamage> damage{};  ///< in which this time lies

    const ModelRow* model = nullptr;
    const SceneRow* scene = nullptr;
    std::shared_ptr<const EstimateRow> estimate{}, second{};  ///< with their draws
    const ProposalRow* proposal = nullptr;                    ///< of the estimate
    const EventRow* decision = nullptr;                       ///< the operator's answer to it
    std::string forgotten{};  ///< why the last estimate no longer stands; empty: there was none

    AtemState state{};  ///< `since` [s] on the session's clock
    std::optional<ArmingPhase> arming{};
    std::vector<Alarm> alarms{};  ///< severity is not recorded
};

inline constexpr double kReviewWindow = 1.0;  ///< [s] of frames before a moment that it is made of

/// Moments of a session, each made of the file alone: the same time shows the same, however one came there.  What
/// is kept between two of them only spares reading it again.  The reader must outlive it.
class ReviewMoments {
public:
    ReviewMoments(SessionReader& reader, RobotModel robot);

    ReviewMoment at(SessionTime time);

    /// The frame after, or before, a time; empty where there is none.
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
    void takeRows(ReviewMoment& moment);
    void takeEvents(ReviewMoment& moment);

    SessionReader& reader_;
    RobotModel robot_;
    std::deque<Batch> recent_;                                ///< the newest in front
    std::deque<std::shared_ptr<const EstimateRow>> drawn_{};  ///< likewise
};

/// The phase an event of kind Phase names; empty for another word.
std::optional<AtemPhase> phaseFrom(std::string_view subject);

}  // namespace terratact
