#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/limits.h"
#include "core/strip/dead_reckoning.h"
#include "core/strip/pose_covariance.h"
#include "core/strip/strip_match.h"
#include "core/strip/strip_section.h"
#include "core/strip/turn_watch.h"

namespace terratact {

/// Limits of a stretch of the way.
struct WayLimits {
    double turn = 0.10;             ///< [rad] change of heading within turnWay that ends it
    double turnWay = 0.30;          ///< [m]
    double silence = kMaxSilence;   ///< [s] between two lines of telemetry
    double jump = 1.0;              ///< [m] largest way between two lines, and at most
    double speed = kFastestTracks;  ///< [m/s] times the time between them
    double leap = 0.15;             ///< [m] plus this: a robot that tips over rolls so far at once

    /// Returns the largest way between two lines that are this far apart [s].
    double wayWithin(double seconds) const { return std::min(jump, speed * seconds + leap); }
};

/// The way of the robot, by dead reckoning between the scenes. Each scene corrects it by the ground that it shares
/// with the scenes before. A break begins a new segment with a new frame.
class StripWay {
public:
    /// Sums since the begin of a segment, up to the last scene that was entered.
    struct Chain {
        ReckonedState from{};             ///< at that scene
        TiltRange tilt{};                 ///< largest changes of the attitude since
        Vec2 shift{};                     ///< [m] corrections
        double planX = 0.0, planY = 0.0;  ///< [m] the same from above
        PoseCovariance drift{};           ///< what stays uncertain of the way
    };
    /// The pose of a scene, before it is corrected.
    struct ScenePose {
        double time = 0.0;
        std::int64_t segment = 0;
        SectionStart why = SectionStart::First;  ///< reason of its segment
        ReckonedState at{};
        Chain chain{};      ///< up to the scene
        TiltRange since{};  ///< largest changes of the attitude after it
    };

    StripWay(const RobotModel& robot, const WayLimits& limits);

    /// Adds the next line of telemetry. A silence, a jump of the reported way, a turn or a line without
    /// odometry ends the segment.
    void add(const Measurement& line);
    /// Begins a new segment.
    void end(SectionStart why);

    /// Marks a scene. It may be one of the last lines, while the robot stands. Without odometry there is no scene, nor
    /// directly behind SectionStart::Suspected.
    void beginScene(const Measurement& scene);
    const std::optional<ScenePose>& scene() const { return scene_; }
    /// Returns the prior covariance of the way to the scene.
    PoseCovariance prior() const;
    /// Returns the pose of the scene by odometry since the scene before, without its own correction.
    WayPose scenePose() const { return poseAt(scene_->at, scene_->chain, prior()); }
    /// Corrects the way to the scene and returns its pose. Does nothing to the way if the segment has ended since.
    WayPose settle(const PoseOffset& offset);
    /// Takes the correction back.
    void unsettle();

    /// Returns the pose at the newest line; empty: there is no odometry.
    std::optional<WayPose> now() const;
    std::int64_t segment() const { return segment_; }
    SectionStart why() const { return why_; }  ///< reason of the present segment

private:
    void endWithoutOdometry();
    void begin(const OdometryLine& line);
    WayPose poseAt(const ReckonedState& state, const Chain& chain,
                   const PoseCovariance& link) const;

    RobotModel robot_;
    WayLimits limits_;
    Odometry model_;  ///< its errors
    std::optional<Odometry> odometry_;
    std::optional<double> newest_;  ///< time of the newest line [s]
    TurnWatch turns_;
    std::int64_t segment_ = 0;
    SectionStart why_ = SectionStart::First;
    Chain chain_;
    std::optional<ScenePose> scene_;
};

}  // namespace terratact
