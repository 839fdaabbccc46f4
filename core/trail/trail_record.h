#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/strip/strip_way.h"
#include "core/trail/trail_history.h"

namespace terratact {

/// The robot's lower envelope over x = −0.7 … 1.0 m in steps of 0.05 m [m], DEM frame. It is
/// +infinity where the robot is not.
inline constexpr std::size_t kEnvelopePoints = 35;
inline constexpr double kEnvelopeBegin = -0.7, kEnvelopeStep = 0.05;
using TrailEnvelope = std::array<double, kEnvelopePoints>;

/// Record of the last stretch of way: attitude and envelope of the robot every kStep, and the forces
/// of every scene. Dead reckoning (core/strip/dead_reckoning.h) places them; a break of the way
/// (core/strip/strip_way.h) empties the record. It holds at most kLength of way, below 1 MB. It has no
/// clock. The record is that of a way forward. If the robot drives back, the record of the places
/// ahead is dropped, except the arm's readings. The networks learnt from ways forward only. On a way
/// that turns back, their heights are too low.
class TrailRecord {
public:
    static constexpr double kLength = 3.0;  ///< [m]
    /// A stretch felt earlier counts as felt while dead reckoning adds at most this sd to its heights
    /// [m]. Turning must move it sideways by at most half a flipper's width. Both its ends move inwards
    /// by one sd of the way since. A height that the arm measured is remembered. Its bin is not felt by
    /// that, because a fall may begin beside the point. Readings of one bin may differ by more than
    /// kArmContradiction of their sd. The lower height then stays, and the bin is not felt. Without the
    /// robot's heading, no stretch counts as felt.
    static constexpr double kRememberedSd = 0.03;
    static constexpr double kArmContradiction = 3.0;
    /// The ground between the arm's point and the bin's centre may rise or fall by this much.
    static constexpr double kArmSlope = 0.35;
    static constexpr double kStep = 0.02;  ///< [m] least way between two lines of the record

    /// A height that the arm measured earlier [m], as a later scene sees it.
    struct CarriedReading {
        double height = 0.0, sd = 0.0;
    };

    explicit TrailRecord(const RobotModel& robot, const WayLimits& limits = {});

    /// Adds the next line of telemetry.
    void add(const Measurement& line);
    /// Empties the record because telemetry was silent for too long by the caller's clock.
    void addSilence() { end(SectionStart::TelemetryGap); }
    /// Empties the record for this reason.
    void end(SectionStart why);

    /// Returns the memory of the way before a scene. The scene is the newest line, or one of the last
    /// lines while the robot stood. way: largest length to return [m]. Without odometry, or right after
    /// a break, it is an emptyHistory().
    TrailHistory before(const Measurement& scene, double way = kTrailReach) const;

    /// Keeps the forces of a scene for the scenes after it. A scene within kStep of the last one
    /// replaces it. It keeps its arm readings if the robot has neither tilted nor turned since.
    /// The scene counts as a line of telemetry.
    void addScene(const Measurement& scene);

    /// Keeps a reading of the arm at the newest scene that was added. It lies at its bin's centre. A
    /// later one of the same bin and side replaces it. Nothing is kept if the robot has left that scene.
    void addArm(const Measurement& scene, const ArmReading& reading);

    /// Returns the arm's readings that belong to the newest scene that was added: those before a press in
    /// place, too. None if that scene has no odometry.
    std::vector<ArmReading> armHere() const;

    /// Forgets what the flippers and the arm felt, because a sensor of theirs is suspected.
    void forgetFelt();

    /// Returns why nothing is remembered before the present stretch.
    SectionStart why() const { return way_.why(); }
    /// Returns how far the record reaches back along the tracks [m]; 0 without odometry.
    double length() const;

private:
    /// Attitude and envelopes at a place of the way.
    struct Place {
        double way = 0.0;
        double travelled = 0.0;  ///< [m] as the robot reported it, forward positive
        Vec2 imu;                ///< [m] frame of the segment
        double pitch = 0.0, roll = 0.0;
        std::array<TrailEnvelope, kTrailPlanes> envelope{};
        bool isScene = false;
    };
    /// An element that pressed at a scene: its place from the IMU, and its force.
    struct Element {
        double x = 0.0, z = 0.0, force = 0.0;
    };
    using Elements = std::array<Element, std::size_t{kForceElements}>;
    /// Where the robot stood when the arm measured.
    struct ArmPlace {
        WayPose pose;
        double pitch = 0.0, roll = 0.0;  ///< [rad]
    };
    struct Press {
        WayPose pose;
        ReckonedState at;
        TiltRange tilt;  ///< largest changes of the attitude since
        std::array<Elements, kTrailPlanes> elements{};
        std::array<std::vector<GroundStretch>, kTrailPlanes> pressed{};  ///< from the IMU [m]
        std::vector<ArmReading> arm{};
        std::optional<ArmPlace> armAt{};  ///< of its first reading; empty without readings
        bool isAhead =
            false;  ///< the robot has driven back from there: the arm's readings alone count
    };

    /// Returns true if a press is part of the history of a later pose.
    static bool isBefore(const Press& press, const Measurement& scene, const WayPose& pose,
                         double reach);
    bool isAside(const WayPose& then, const WayPose& now) const;
    bool standsAt(const ArmPlace& place, const Measurement& scene, const WayPose& pose) const;
    std::optional<WayPose> poseAt(const Measurement& scene) const;
    Place placeOf(const WayPose& pose, const Measurement& line, bool isScene) const;
    void forgetAfterBreak();
    void addOdometry(const Measurement& line);
    void dropAhead(double travelled);
    void dropOld(double way, double travelled);
    void writeAttitude(TrailHistory& history, double travelled) const;
    void writeLowest(TrailHistory& history, const Measurement& scene, const WayPose& pose) const;
    void writePressed(TrailHistory& history, const Measurement& scene, const WayPose& pose) const;
    /// Where a press lies as seen from a later pose.
    struct Carried {
        ImuMotion since;
        double dx = 0.0, dz = 0.0;  ///< [m] from that pose's IMU to the press's
        double sd = 0.0;            ///< [m] added to heights
        double slip = 0.0;          ///< [m] one sd along the way
    };
    /// Returns it; empty: its heights or its place are too uncertain, or it lies farther away than `reach`.
    std::optional<Carried> carried(const Press& press, double reach, const Measurement& scene,
                                   const WayPose& pose) const;
    void writeArm(TrailHistory& history, const Measurement& scene, const WayPose& pose) const;
    void writeFelt(TrailHistory& history, const Measurement& scene, const WayPose& pose) const;

    RobotModel robot_;
    StripWay way_;
    std::int64_t segment_ = 0;
    std::optional<double> newest_;      ///< time of the newest line [s]
    std::optional<double> begin_;       ///< `travelled` where the record begins [m]
    std::optional<Odometry> odometry_;  ///< since the first line of the record
    double lastLine_ = 0.0;             ///< way of the newest line of the record
    std::deque<Place> places_;
    std::deque<Press> presses_;
};

}  // namespace terratact
