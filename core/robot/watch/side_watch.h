#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/robot/measurement.h"
#include "core/robot/watch/sensor.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Compares the force elements of the left and the right front flipper at each press. A press counts
/// if both flippers have the same angle (kAngle) and the same current (kCurrent). The ground then
/// carries the same moment on both sides. A difference that the other elements do not share is a
/// fault of an element:
///   NoLoad       One element, or several on the same side, feel less than the other side: nothing.
///   LoadedFree   The element that feels more also feels a load in nearly all lines with raised
///                flippers.
///   SidesDiffer  Neither holds. Both elements are named.
///   WrongOrder   Two elements each have the load of the other. Of elements 1 and 6 the side that
///                feels 1 is named, of 2 and 5 both sides.
///   Late         One side alone still changes after the flippers rest.
/// Elements that differ in both directions touch different ground and are not judged. A suspicion
/// needs kPresses more presses with a fault than loaded presses without it. As many without it clear
/// the suspicion. The watch needs both sides, and kMinRaised lines of driving with raised flippers.
/// A press is not judged if one of its compared lines lacks a front current. The watch has no clock.
class SideWatch {
public:
    static constexpr double kAngle = 0.05;         ///< [rad] largest difference of left and right
    static constexpr double kCurrent = 0.25;       ///< the same, as a share of the larger current
    static constexpr double kMinDifference = 2.0;  ///< [N] least difference that counts
    static constexpr double kShare = 0.4;          ///< the same, as a share of the larger force
    static constexpr double kLoaded = 3.0;         ///< [N] an element that carries a load
    static constexpr double kNothing = 1.0;        ///< [N] one that does not
    static constexpr double kSettle = 0.6;         ///< [s] of a press, after which all is at rest
    static constexpr double kWatched = 1.2;        ///< [s] of a press, after which nothing is read
    static constexpr double kPresses = 2.0;
    static constexpr int kMinRaised = 10;
    static constexpr double kHold = 600.0;  ///< [s] duration of a suspicion, unless it is cleared

    void add(const Measurement& line);
    /// Suspicions of the last line.
    const std::vector<SensorSuspicion>& found() const { return found_; }
    /// Returns true if later presses contradict the suspicion.
    bool isCleared(const SensorSuspicion& suspicion) const;
    void reset();

private:
    using Forces = std::array<double, kForceElements>;  ///< [N]
    /// Mean of lines with both sides.
    struct Mean {
        int lines = 0;
        Forces left{}, right{};
        double leftCurrent = 0.0, rightCurrent = 0.0, angle = 0.0;  ///< [A], [rad] left less right
        bool lacksCurrent = false;                                  ///< a line lacks a current
        std::array<bool, kForceElements> isMissing{};
        void add(const Measurement& line);
    };
    struct Press {
        double began = 0.0;  ///< [s] the first line at rest
        Mean early, settled;
        bool wasJudged = false;
    };
    /// Number of presses that support a fault, less those that contradict it.
    struct Count {
        std::array<double, kForceElements> left{}, right{};
    };
    void follow(const Measurement& line);
    void followRaised(const Measurement& line);
    void judge(const Press& press, double now);
    void judgeLoads(const Mean& rest, double now);
    void judgeLate(const Press& press, double now);
    void judgeOrder(const Mean& rest, std::size_t e, double now);
    void blame(const Mean& rest, std::size_t e, double now);
    void suspect(Sensor sensor, SensorTrouble trouble, double now, double amount);

    std::optional<Press> press_;
    int raisedLines_ = 0;
    Forces freeLeft_{}, freeRight_{};  ///< share of the newest raised lines that feel nothing
    Count lower_, late_;
    std::array<double, kForceElements> order_{};
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
