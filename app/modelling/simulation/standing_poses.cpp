#include "app/modelling/simulation/standing_poses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/log/session_reader.h"
#include "core/store/file_read.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {
namespace {

constexpr double kPoseSeconds = 0.5;  // [s]
constexpr double kPoseTurn = 0.02;    // [rad]
constexpr std::array kMeans{&Measurement::frontLeft,        &Measurement::frontRight,
                            &Measurement::rearLeft,         &Measurement::rearRight,
                            &Measurement::frontLeftCurrent, &Measurement::frontRightCurrent,
                            &Measurement::rearLeftCurrent,  &Measurement::rearRightCurrent};
constexpr std::size_t kMeanAngles = 4;  // of these, the first

double secondsFrom(std::int64_t nanoseconds)
{
    return 1e-9 * static_cast<double>(nanoseconds);
}

/// Sums the lines of one pose.
class PoseSum {
public:
    void add(const Measurement& m)
    {
        if (lines_ == 0) sum_ = m;
        if (lines_ > 0)
            for (const auto value : kMeans) sum_.*value += m.*value;
        sum_.missing |= m.missing;
        sum_.missingMotors |= m.missingMotors;
        pitch_[0] += m.pitch, pitch_[1] += m.pitch * m.pitch;
        roll_[0] += m.roll, roll_[1] += m.roll * m.roll;
        ++lines_;
    }
    /// Returns true if the line is in the same pose, apart from noise of pitch and roll.
    bool holds(const Measurement& m) const
    {
        const double n = static_cast<double>(lines_);
        for (std::size_t a = 0; a < kMeanAngles; ++a)
            if (std::abs(m.*kMeans[a] - sum_.*kMeans[a] / n) > kPoseTurn) return false;
        const double wide = 0.06;  // [rad] noise of one line
        return std::abs(m.pitch - pitch_[0] / n) < wide && std::abs(m.roll - roll_[0] / n) < wide;
    }
    std::size_t lines() const { return lines_; }
    StandingPose pose() const
    {
        StandingPose pose{.mean = sum_, .lines = lines_};
        const double n = static_cast<double>(lines_);
        for (const auto value : kMeans) pose.mean.*value /= n;
        setCurrents(pose.mean, motorCurrents(pose.mean));  // 0 where a line lacks one
        pose.mean.pitch = pitch_[0] / n;
        pose.mean.roll = roll_[0] / n;
        pose.pitchSd = sdOfMean(pitch_);
        pose.rollSd = sdOfMean(roll_);
        return pose;
    }

private:
    double sdOfMean(const std::array<double, 2>& sums) const
    {
        const double n = static_cast<double>(lines_), mean = sums[0] / n;
        return std::sqrt(std::max(0.0, sums[1] / n - mean * mean) / n);
    }
    Measurement sum_{};
    std::array<double, 2> pitch_{}, roll_{};
    std::size_t lines_ = 0;
};

Status addLines(const std::string& path, const RobotModel& robot, std::vector<StandingPose>& poses)
{
    auto session = SessionReader::open(path);
    if (!session) return session.error();
    TelemetryListener listener(robot);
    std::vector<TelemetryLine> lines;
    for (std::size_t i = 0; i < session->batches().size(); ++i)
        for (const FrameRow& row : session->frames(i))
            if (const auto m = listener.receive(row.frame, secondsOf(row.time)))
                if (lines.empty() || row.time >= lines.back().time) lines.push_back({row.time, *m});
    if (lines.empty())
        return fileError(path, "holds no line of telemetry, expected a drive over a flat floor");
    const std::vector<StandingPose> found = standingPoses(lines);
    poses.insert(poses.end(), found.begin(), found.end());
    return Done{};
}

}  // namespace

std::vector<StandingPose> standingPoses(const std::vector<TelemetryLine>& lines)
{
    std::vector<StandingPose> poses;
    PressRule rule;
    rule.maxTurn = 0.05;  // noise of half a window
    const std::vector<bool> moved = movedAt(lines, rule);
    PoseSum sum;
    std::int64_t first = 0, last = 0;
    const auto end = [&] {
        if (sum.lines() >= 5 && secondsFrom(last - first) >= kPoseSeconds)
            poses.push_back(sum.pose());
        sum = {};
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Measurement& m = lines[i].measurement;
        const bool far =
            sum.lines() > 0 && (secondsFrom(lines[i].time - last) > kPoseSeconds || !sum.holds(m));
        if (moved[i] || far) end();
        if (moved[i]) continue;
        if (sum.lines() == 0) first = lines[i].time;
        last = lines[i].time;
        sum.add(m);
    }
    end();
    return poses;
}

Result<std::vector<StandingPose>> standingPosesOf(const std::vector<std::string>& sessions,
                                                  const RobotModel& robot)
{
    std::vector<StandingPose> poses;
    for (const std::string& path : sessions)
        if (Status added = addLines(path, robot, poses); !added) return added.error();
    return poses;
}

}  // namespace terratact
