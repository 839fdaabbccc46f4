#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "core/robot/watch/driven_ground.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Compares what the flippers felt with the ground that the tracks drive over (DrivenGround), in three one-sided
/// CUSUMs (Page 1954) of log-likelihood ratios:
///   front angles  the point where a press was felt (the forces' centroid on the flippers' edge) lies higher than the
///                 tracks leave room for, as if the angles were too large by kOffset.  Angles that are too small look
///                 like hollow ground, and are not suspected.
///   forces        that point fits the ground worse than the same point counted from the other end; and a press that
///                 loads the first element alone, where one that loads the last alone is far more common
///   rear angles   lie under the ground, or carry a load above it, while angles of the other sign would fit; only over
///                 ground that the tracks have passed from end to end, and of kLeastRear or more: the map errs by
///                 5 cm, and angles nearer to 0 differ by less from those of the other sign
/// A sum that has fallen to half its limit clears its sensors.  Needs odometry; forces for the first two.  Begins a new map where
/// the robot turns by more than kTurn.  No clock.
class GroundWatch {
public:
    static constexpr double kOffset = 0.17;     ///< [rad]
    static constexpr double kFrontLimit = 3.8;  ///< of the sums
    static constexpr double kOrderLimit = 6.0;
    static constexpr double kRearLimit = 0.85;  ///< [m]
    static constexpr double kLeastRear = 0.2;   ///< [rad]
    static constexpr double kTurn = 0.15;       ///< [rad]
    static constexpr double kHold = 600.0;      ///< [s] suspected for, unless cleared

    explicit GroundWatch(const RobotModel& robot);
    void take(const Measurement& line);
    const std::vector<SensorSuspicion>& found() const { return found_; }  ///< by the last line
    /// Whether nothing speaks for that any more.
    bool isCleared(const SensorSuspicion& suspicion) const;
    /// Forgets the ground, and what was felt; the sums stay.
    void reset();

private:
    /// Where a press was felt, and the same point counted from the other end of the elements.
    struct Contact {
        Vec2 felt, mirrored;       ///< frame of DrivenGround [m]
        double share = 0.0;        ///< of the edge's length, from the pivot end
        double pitch = 0.0;        ///< [rad]
        double pitchChange = 0.0;  ///< [rad] the largest since
    };
    /// Sums over the first lines of a press.
    struct Press {
        int lines = 0;
        double pitch = 0.0, front = 0.0;
        std::array<double, kForceElements> force{};
    };
    void follow(const Measurement& line);
    void feel(const Press& press);
    void judgePassed(double now);
    void judgeContact(const Contact& contact, double now);
    void judgeRear(double now);
    std::optional<double> rearGap(const DrivenGround& ground) const;
    void suspect(Sensor first, Sensor last, SensorTrouble trouble, double now, double amount);

    RobotModel robot_;
    RearLoad rear_;
    DrivenGround ground_;
    DrivenGround flipped_;  ///< as if the rear angles had the other sign
    std::deque<Contact> contacts_;
    std::optional<Press> press_;
    std::optional<double> turned_;
    double judgedAt_ = 0.0;  ///< [m] way of the last look at the rear flippers
    double tooHigh_ = 0.0, wrongOrder_ = 0.0, wrongRear_ = 0.0;
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
