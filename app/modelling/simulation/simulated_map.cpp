#include "app/modelling/simulation/simulated_map.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "app/modelling/simulation/simulated_recording.h"
#include "core/store/csv_text.h"

namespace terratact {
namespace {

constexpr double kSeenBehind = 1.0, kSeenAhead = 1.3;  // [m] of ground around the poses
constexpr double kTurnOfDrive = 0.7;                   // [rad] between the headings of two drives

}  // namespace

void SimulatedMap::add(const std::string& run, const GroundLines& ground,
                       std::vector<TwoTrackPose> poses, std::vector<TwoTrackScene> scenes)
{
    if (poses.size() != scenes.size())
        throw std::invalid_argument("SimulatedMap: every pose needs a scene");
    if (!isWanted() || poses.empty()) return;
    const auto [first, last] =
        std::ranges::minmax(poses, {}, [](const TwoTrackPose& pose) { return pose.base.x; });
    drives_.push_back({run, ground, std::move(poses), std::move(scenes), first.base.x - kSeenBehind,
                       last.base.x + kSeenAhead});
}

CloudPose SimulatedMap::placeOf(std::size_t drive) const
{
    double longest = 0.0;
    for (const Drive& d : drives_) longest = std::max(longest, std::abs(d.begin) + std::abs(d.end));
    const auto columns =
        static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(drives_.size()))));
    const std::size_t column = drive % columns, line = drive / columns;
    const double spacing = std::ceil(longest) + 2.0;
    const double heading = kTurnOfDrive * static_cast<double>(drive);
    const CloudPose map{Eigen::Vector3d::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(
                                                     options_.tilt, Eigen::Vector3d::UnitY()))};
    return map.with(
        {{spacing * static_cast<double>(column), spacing * static_cast<double>(line), 0.0},
         Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()))});
}

Result<std::size_t> SimulatedMap::write(const RobotModel& robot, FileGroup& files) const
{
    std::mt19937_64 rng(options_.seed);
    std::vector<CloudPoint> cloud;
    std::vector<RecordedStop> stops;
    std::string poses = "run,t_s,x_m,y_m,z_m,qx,qy,qz,qw\n";
    for (std::size_t i = 0; i < drives_.size(); ++i) {
        const Drive& d = drives_[i];
        const CloudPose place = placeOf(i);
        const auto ground = groundCloud(robot, d.ground, place, d.begin, d.end, options_.made, rng);
        cloud.insert(cloud.end(), ground.begin(), ground.end());
        for (std::size_t k = 0; k < d.poses.size(); ++k) {
            const CloudPose base = place.with(basePose(robot, d.poses[k]));
            CloudPose seen = base;
            seen.place.z() += options_.made.offset;
            const auto own = robotCloud(robot, seen, options_.made.own, rng);
            cloud.insert(cloud.end(), own.begin(), own.end());
            stops.push_back({d.run, base, d.scenes[k].s});
            const Eigen::Vector3d& p = base.place;
            const Eigen::Quaterniond& q = base.turn;
            poses +=
                csvLine({d.run, d.scenes[k].time, p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()});
        }
    }
    if (Status done = files.add(options_.poses, poses); !done) return done.error();
    if (Status done = files.add(options_.cloud, pcdText(cloud)); !done) return done.error();
    if (!options_.recording.empty())
        if (Status done = addSimulatedRecording(files, options_.recording, robot, stops,
                                                options_.floorPoses, options_.seed);
            !done)
            return done.error();
    return cloud.size();
}

}  // namespace terratact
