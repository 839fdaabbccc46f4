#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Detects a pitch with the wrong sign. Flippers that press down lift the nose; when they come up
/// again while the tracks rest, the nose sinks. Each such change z of pitch, in units of its noise
/// and limited to ±kCut, updates
///   S ← max(0, S − z).
/// z of a rising flipper has its sign reversed. S is a one-sided CUSUM (Page 1954) that suspects
/// the sign above kLimit. On simulated drives z has a mean of about +1.5, and one in a hundred is
/// below −2.
class PitchSignWatch {
public:
    static constexpr double kCut = 7.0;
    static constexpr double kLimit = 18.0;
    /// [s] duration of a suspicion, unless the CUSUM falls to half of kLimit.
    static constexpr double kHold = 600.0;

    explicit PitchSignWatch(const RobotModel& robot) : pitchSd_(robot.pitchSd) {}
    void add(const Measurement& line);
    /// Suspicions of the last line.
    const std::vector<SensorSuspicion>& found() const { return found_; }
    bool isCleared() const { return sum_ < kLimit / 2.0; }
    void reset();

private:
    /// Mean pitch of a phase's last lines.
    class Recent {
    public:
        void add(double pitch);
        void clear() { lines_.clear(); }
        bool isEmpty() const { return lines_.empty(); }
        double mean() const;
        double count() const { return static_cast<double>(lines_.size()); }

    private:
        std::deque<double> lines_;
    };
    void judge(const Recent& down, const Recent& up, double now);

    double pitchSd_;
    double sum_ = 0.0;
    std::optional<Measurement> before_;
    Recent free_, pressed_, raised_;
    bool isRising_ = false;  ///< the flippers come up from a press while the tracks rest
    double lowest_ = 0.0;    ///< front flippers at the lowest point of that press [rad]
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
