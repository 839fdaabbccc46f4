#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "core/robot/watch/driven_ground.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Compares presses of the flippers with the ground that the tracks drive over (DrivenGround). It
/// uses three one-sided CUSUMs (Page 1954) of log-likelihood ratios:
///   front angles  The contact point of a press is the forces' centroid on the flippers' edge. It lies
///                 higher than the tracks leave room for, as if the angles were too large by kOffset.
///                 Angles that are too small look like hollow ground and are not suspected.
///   forces        The contact point fits the ground worse than its mirror image, counted from the other
///                 end. A press that loads only the first element adds to the sum: presses that load only
///                 the last one are far more common.
///   rear angles   The flippers lie under the ground, or carry a load above it. Angles of the other sign
///                 would fit. This needs ground that the tracks have passed from end to end, and
///                 angles of kMinRear or more: the map has errors of 5 cm.
/// A sum that falls to half its limit clears its sensors. The watch needs odometry, and forces for
/// the first two sums. It begins a new map when the robot turns by more than kTurn. It has no
/// clock.
class GroundWatch {
public:
    static constexpr double kOffset = 0.17;     ///< [rad]
    static constexpr double kFrontLimit = 3.8;  ///< limit of the sum
    static constexpr double kOrderLimit = 6.0;
    static constexpr double kRearLimit = 0.85;  ///< [m]
    static constexpr double kMinRear = 0.2;     ///< [rad]
    static constexpr double kTurn = 0.15;       ///< [rad]
    static constexpr double kHold = 600.0;  ///< [s] duration of a suspicion, unless it is cleared

    explicit GroundWatch(const RobotModel& robot);
    void add(const Measurement& line);
    /// Suspicions of the last line.
    const std::vector<SensorSuspicion>& found() const { return found_; }
    /// Returns true if no evidence supports the suspicion any more.
    bool isCleared(const SensorSuspicion& suspicion) const;
    /// Forgets the ground and the contacts. The sums stay.
    void reset();

private:
    /// Contact point of a press, and the same point counted from the other end of the elements.
    struct Contact {
        Vec2 felt, mirrored;       ///< frame of DrivenGround [m]
        double share = 0.0;        ///< share of the edge's length, from the pivot end
        double pitch = 0.0;        ///< [rad]
        double pitchChange = 0.0;  ///< largest change of pitch since the press [rad]
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
    DrivenGround flipped_;  ///< the map if the rear angles had the other sign
    std::deque<Contact> contacts_;
    std::optional<Press> press_;
    std::optional<double> turned_;
    double judgedAt_ = 0.0;  ///< way at the last check of the rear flippers [m]
    double tooHigh_ = 0.0, wrongOrder_ = 0.0, wrongRear_ = 0.0;
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
