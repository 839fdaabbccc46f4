#pragma once

#include <span>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Motion of the IMU since a moment. Axes along gravity, as in the DEM frame.
struct ImuMotion {
    double forward = 0.0, up = 0.0;  ///< [m]
    double way = 0.0;  ///< distance rolled by the tracks, forward and backward added [m]
    /// Displacement by one sd of slip along the ground [m]; the two are fully correlated.
    double slipForward = 0.0, slipUp = 0.0;
    double upSd = 0.0;  ///< further sd of the IMU's height [m]
    bool operator==(const ImuMotion&) const = default;
};

/// Returns the sd [m] that a motion adds to a height of ground with these slopes around it:
///   w² = (g · slipForward − slipUp)² + upSd²
/// g is the slope for which the first term is larger; without slopes it is 0.
double carriedSd(const ImuMotion& motion, std::span<const double> slopes);

/// Odometry of a line of telemetry.
struct OdometryLine {
    double travelled = 0.0;  ///< [m] along the tracks
    double pitch = 0.0;      ///< [rad]
    double roll = 0.0;       ///< [rad]
    double turned = 0.0;     ///< [rad] wrapped
};

/// Returns the odometry of a line that has `travelled`. A line without `turned` has not turned.
/// Throws std::invalid_argument for a line without `travelled`.
OdometryLine odometryOf(const Measurement& line);

/// Sums of dead reckoning up to a moment.
struct ReckonedState {
    OdometryLine line{};              ///< `travelled` up to the last step that counted
    double direction = 0.0;           ///< of that step: 1 forward, −1 backward; 0: none yet
    Vec2 rolled{};                    ///< [m] Σ ds (cos θ, sin θ)
    double way = 0.0;                 ///< [m] Σ |ds|
    Vec2 wayAlong{};                  ///< [m] Σ |ds| (cos θ, sin θ)
    double heading = 0.0;             ///< [rad] since the start, left positive, not wrapped
    double planX = 0.0, planY = 0.0;  ///< [m] the base from above; the start's heading is x
    Vec2 imu{};  ///< [m] the IMU; the origin is where the tracks were at the start
};

/// Largest change of the attitude [rad].
struct TiltRange {
    double pitch = 0.0, roll = 0.0;
};

/// Dead reckoning: adds up the steps between lines of telemetry. A step of ds along the tracks
/// moves the robot by ds (cos θ, sin θ). θ is the mean of its two pitches. The robot turns about a
/// point of the tracks' lower edge under the base origin. That point is uncertain along the track,
/// between its axles, and across, between the tracks:
///   slip  = share (Σ |ds| cos θ, Σ |ds| sin θ)
///   upSd² = (pitchSd Σ |ds|)² + (trackAxle / √12 · max |θ − θ₀|)² + (trackY / √3 · max |φ − φ₀|)²
/// share is RobotModel::travelledSdShare, pitchSd is the robot's, and φ is roll. The last two terms
/// are the sd of a point anywhere between the axles and between the tracks' middles.
/// The last digit of a standing robot's way may flicker. A step against the last one therefore waits
/// until the way has come back by more than kFlicker. Then the whole step counts. A way that only
/// rises, or only falls, counts line by line.
class Odometry {
public:
    static constexpr double kFlicker = 0.002;  ///< [m] two counts of the frame Odometry

    /// The functions throw std::invalid_argument for a number that is not finite.
    Odometry(const RobotModel& robot, const OdometryLine& start);

    void add(const OdometryLine& line) { now_ = after(line); }
    /// Returns the state after one more line.
    ReckonedState after(const OdometryLine& line) const;
    const ReckonedState& now() const { return now_; }

    /// Returns the motion between two states. tilt: the largest changes of the attitude between them.
    ImuMotion motion(const ReckonedState& from, const ReckonedState& to,
                     const TiltRange& tilt) const;

private:
    bool isFlicker(double step) const;
    Vec2 imuAt(const Vec2& rolled, double pitch) const;

    double share_, pitchSd_, pivotSd_, rollPivotSd_;
    Vec2 imu_;  ///< from the point of the tracks below the base origin to the IMU [m]
    ReckonedState now_;
};

/// Dead reckoning since one scene, in its plane.
class DeadReckoning {
public:
    /// travelled [m], pitch [rad]: of the scene. Both functions throw std::invalid_argument for a
    /// number that is not finite.
    DeadReckoning(const RobotModel& robot, double travelled, double pitch);

    void add(double travelled, double pitch);
    ImuMotion motion() const { return odometry_.motion(start_, odometry_.now(), {largestChange_}); }
    double pitchChange() const
    {
        return odometry_.now().line.pitch - start_.line.pitch;
    }  ///< [rad]

private:
    Odometry odometry_;
    ReckonedState start_;
    double largestChange_ = 0.0;  ///< largest change of the pitch [rad]
};

}  // namespace terratact
