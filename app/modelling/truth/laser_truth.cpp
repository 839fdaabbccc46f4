#include "app/modelling/truth/laser_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/modelling/truth/truth_sampling.h"
#include "app/modelling/truth/truth_scenes.h"
#include "core/base/text.h"
#include "core/clouds/cloud_messages.h"
#include "core/clouds/cloud_reader.h"
#include "core/clouds/cloud_span.h"
#include "core/clouds/scan_time.h"
#include "core/clouds/sensor_frames.h"
#include "core/log/session_reader.h"
#include "core/store/file_read.h"
#include "core/terrain/ground_lines.h"

namespace terratact {
namespace {

constexpr double kPassDistance = 0.1, kPassTurn = 0.05;  // [m], [rad] between two passes

class LaserTruthFinder {
public:
    explicit LaserTruthFinder(const LaserTruthOptions& options) : options_(options) {}

    Result<LaserTruth> run()
    {
        for (const auto step : {&LaserTruthFinder::readRobot, &LaserTruthFinder::readSceneFile,
                                &LaserTruthFinder::readStart, &LaserTruthFinder::readTracks,
                                &LaserTruthFinder::placeScenes, &LaserTruthFinder::addClouds})
            if (Status done = (this->*step)(); !done) return done.error();
        findHeights();
        if (Status near = checkNearness(); !near) return near.error();
        return std::move(truth_);
    }

private:
    Status readRobot()
    {
        auto robot = readRobotModel(options_.robot);
        if (!robot) return robot.error();
        truth_.robot = *std::move(robot);
        return Done{};
    }

    Status readSceneFile()
    {
        auto file = readTruthScenes(options_.scenes);
        if (!file) return file.error();
        truth_.isPlane = file->isPlane;
        truth_.plane = std::move(file->plane);
        truth_.tracks = std::move(file->tracks);
        truth_.drives = std::move(file->drives);
        for (const Message& notice : file->notices)
            truth_.remarks.push_back(fmt::format("{}: {}", options_.scenes, notice.english()));
        truth_.truths.resize(truth_.tracks.size());
        return Done{};
    }

    Status readStart()
    {
        start_ = options_.start.value_or(0.0);
        if (options_.session.empty()) return Done{};
        const auto session = SessionReader::open(options_.session);
        if (!session) return session.error();
        start_ = 1e-9 * static_cast<double>(session->start().wallTime);
        return Done{};
    }

    Status readTracks()
    {
        auto tracks = options_.mapping.empty() ? readPoses(options_.poses, options_.limits)
                                               : readRecordedPoses();
        if (!tracks) return tracks.error();
        tracks_ = *std::move(tracks);
        std::set<std::string> runs;
        for (std::size_t row = 0; row < truth_.scenes(); ++row)
            if (isWanted(row)) runs.insert(truth_.runOf(row));
        if (runs.empty())
            return fileError(options_.scenes, fmt::format("has no run {}", shown(options_.run)));
        if (tracks_.contains("") && runs.size() > 1)
            return fileError(
                options_.poses,
                fmt::format("names no runs, but {} holds {}: add a column run, or choose one "
                            "with --run",
                            options_.scenes, runs.size()));
        return Done{};
    }

    Result<PoseTracks> readRecordedPoses()
    {
        const auto mapping = readMapping(options_.mapping);
        if (!mapping) return mapping.error();
        if (mapping->odometry) poseFrames_ = *mapping->odometry;
        auto recording = openRecording(options_.poses, mapping->csv);
        if (!recording) return recording.error();
        auto tracks = readPoses(**recording, *mapping, options_.limits);
        for (const std::string& remark : (*recording)->consumeRemarks())
            truth_.remarks.push_back(fmt::format("{}: {}", options_.poses, remark));
        return tracks;
    }

    bool isWanted(std::size_t row) const
    {
        return options_.run.empty() || truth_.runOf(row) == options_.run;
    }

    const PoseTrack* trackOf(const std::string& run) const
    {
        const auto own = tracks_.find(run);
        if (own != tracks_.end()) return &own->second;
        const auto any = tracks_.find("");
        return any == tracks_.end() ? nullptr : &any->second;
    }

    /// Returns the pose of the base at a time of the poses' clock.
    std::optional<CloudPose> baseAt(const PoseTrack* track, double time) const
    {
        const auto pose = track ? track->at(time) : std::nullopt;
        if (!pose) return std::nullopt;
        return pose->with(options_.poseMount.inverse());
    }

    Status placeScenes()
    {
        std::vector<ScenePlace> places;
        for (std::size_t row = 0; row < truth_.scenes(); ++row) {
            SceneTruth& scene = truth_.truths[row];
            if (!isWanted(row)) {
                scene.gap = TruthGap::OtherRun;
                continue;
            }
            const auto base = baseAt(trackOf(truth_.runOf(row)), truth_.timeOf(row) + start_);
            if (!base) continue;
            scene.gap = TruthGap::None;
            scene.place = places.size();
            places.push_back(placeOf(truth_.robot, row, truth_.tracks[row].s, *base));
            if (truth_.isPlane) places.back().s.roll = places.back().poseRoll;
        }
        if (places.empty()) return noPose();
        auto grid = SceneGrid::over(truth_.robot, std::move(places), passes());
        if (!grid) return fileError(options_.scenes, grid.error().text);
        truth_.grid = *std::move(grid);
        return Done{};
    }

    /// Returns the error that no scene has a pose, with both spans of time.
    Error noPose() const
    {
        double first = 1e300, last = -1e300, begin = 1e300, end = -1e300;
        std::size_t matching = 0;
        for (std::size_t row = 0; row < truth_.scenes(); ++row) {
            if (!isWanted(row)) continue;
            first = std::min(first, truth_.timeOf(row) + start_);
            last = std::max(last, truth_.timeOf(row) + start_);
            matching += trackOf(truth_.runOf(row)) ? 1 : 0;
        }
        if (matching == 0)
            return fileError(
                options_.poses,
                fmt::format("its runs, such as {}, are none of those in {}: correct the column run",
                            shown(tracks_.begin()->first), options_.scenes));
        for (const auto& [run, track] : tracks_) {
            begin = std::min(begin, track.begin());
            end = std::max(end, track.end());
        }
        return fileError(
            options_.poses,
            fmt::format(
                "has poses from {:.3f} to {:.3f} s, but the scenes are from {:.3f} to {:.3f} s, "
                "or more than {} s from two poses: give the clock's time at t_s = 0 by --start "
                "or --session, or raise --max-gap",
                begin, end, first, last, options_.limits.maxGap));
    }

    /// Returns poses of the drive every few centimetres: the ground is nowhere inside the tracks there.
    std::vector<ScenePlace> passes() const
    {
        std::vector<ScenePlace> passes;
        for (const auto& [run, track] : tracks_) {
            for (const PoseTrack::Entry& entry : track.entries()) {
                ScenePlace pass =
                    placeOf(truth_.robot, 0, {}, entry.pose.with(options_.poseMount.inverse()));
                pass.s.pitch = pass.posePitch;
                pass.s.roll = pass.poseRoll;
                if (!passes.empty() && (pass.imu - passes.back().imu).norm() < kPassDistance
                    && std::abs(std::remainder(pass.heading - passes.back().heading, 6.283185307))
                           < kPassTurn)
                    continue;
                passes.push_back(pass);
            }
        }
        return passes;
    }

    Status addClouds()
    {
        if (Status done = readSensors(); !done) return done;
        for (const std::string& file : options_.clouds) {
            Status done = options_.topic.empty() ? addCloud(file) : addRecordedClouds(file);
            if (!done) return done;
        }
        if (truth_.leftOut > 0)
            truth_.remarks.push_back(
                fmt::format("{} of {} points are NaN, infinite or beyond 10000 km; they were "
                            "left out",
                            truth_.leftOut, truth_.points));
        return Done{};
    }

    Status addCloud(const std::string& file)
    {
        std::optional<CloudPose> base;
        if (options_.scans) {
            const auto time = scanTimeIn(file);
            if (!time)
                return fileError(
                    file,
                    "its name holds no time: name scans by the seconds of the poses' clock, such "
                    "as 1436509052.25.pcd");
            base = baseAt(onlyTrack(), *time);
            if (!base) {
                truth_.remarks.push_back(
                    fmt::format("{}: no poses around {:.3f} s; left out", file, *time));
                return Done{};
            }
        }
        auto cloud = openCloud(file);
        if (!cloud) return cloud.error();
        for (std::vector<CloudPoint> block;;) {
            const auto more = (*cloud)->next(block);
            if (!more) return more.error();
            if (!*more) break;
            if (base)
                truth_.grid->addScan(block, *base, options_.sensorMount.value_or(CloudPose()));
            else
                addMap(block);
        }
        if (const std::string& text = (*cloud)->remark(); !text.empty())
            truth_.remarks.push_back(file + ": " + text);
        return count(file, 1, (*cloud)->points(), (*cloud)->leftOut());
    }

    void addMap(const std::vector<CloudPoint>& points)
    {
        span_.add(points);
        truth_.grid->add(points);
    }

    /// Counts the points of a file; refuses one whose points cannot be used.
    Status count(const std::string& file, std::size_t clouds, std::uint64_t points,
                 std::uint64_t leftOut)
    {
        truth_.clouds += clouds;
        truth_.points += points;
        truth_.leftOut += leftOut;
        if (leftOut < points) return Done{};
        return fileError(file, fmt::format("all of its {} points are NaN, infinite or beyond 10000 "
                                           "km, or it has none: write it again, in m",
                                           points));
    }

    /// Returns the track of scans: the chosen run's, or the only one.
    const PoseTrack* onlyTrack() const
    {
        if (!options_.run.empty()) return trackOf(options_.run);
        return tracks_.size() == 1 ? &tracks_.begin()->second : nullptr;
    }

    /// Reads the transforms that place the sensors of clouds of a topic.
    Status readSensors()
    {
        const std::string& base = options_.tfBase.empty() ? poseFrames_.baseFrame : options_.tfBase;
        if (options_.topic.empty() || options_.sensorMount || base.empty()) return Done{};
        std::vector<std::string> others;
        if (!options_.mapping.empty()) others.push_back(options_.poses);
        auto sensors = SensorFrames::read(base, options_.clouds, options_.topic, others,
                                          options_.limits.maxGap);
        if (!sensors) return sensors.error();
        sensors_ = *std::move(sensors);
        return Done{};
    }

    /// Returns false if no pose of base or sensor is known at the cloud's time. Clouds in the poses' frame are maps.
    bool addRecordedCloud(const CloudMessage& cloud)
    {
        if (poseFrames_.isTransform() && cloud.frame == poseFrames_.frame) {
            addMap(cloud.points);
            return true;
        }
        const auto base = baseAt(onlyTrack(), cloud.stamp);
        const auto mount =
            sensors_ ? sensors_->mountOf(cloud) : options_.sensorMount.value_or(CloudPose());
        if (!base || !mount) return false;
        truth_.grid->addScan(cloud.points, *base, *mount);
        return true;
    }

    Status addRecordedClouds(const std::string& file)
    {
        std::size_t without = 0;
        double first = 0.0, last = 0.0;
        const auto read = readCloudMessages(file, options_.topic, [&](const CloudMessage& cloud) {
            if (!addRecordedCloud(cloud) && ++without == 1) first = cloud.stamp;
            last = cloud.stamp;
            return true;
        });
        if (!read) return read.error();
        if (Status some = count(file, read->clouds, read->points, read->leftOut); !some)
            return some;
        for (const std::string& remark : read->remarks)
            truth_.remarks.push_back(fmt::format("{}: {}", file, remark));
        if (without > 0 && without == read->clouds)
            return fileError(
                file, fmt::format("topic {}: its clouds are from {:.3f} to {:.3f} s, but no poses "
                                  "are known then: correct the clocks, or raise --max-gap",
                                  printable(options_.topic), first, last));
        if (without > 0)
            truth_.remarks.push_back(
                fmt::format("{}: {} of {} clouds have no poses around their time; left out", file,
                            without, read->clouds));
        return Done{};
    }

    /// Refuses maps without a point under any scene.
    Status checkNearness() const
    {
        if (span_.isEmpty() || truth_.grid->hasPoints()) return Done{};
        CloudSpan robot;
        for (const ScenePlace& place : truth_.grid->places())
            robot.add({{CloudPoint{place.imu.x(), place.imu.y(), place.imu.z()}}});
        return fileError(options_.clouds.front(), span_.farFrom(robot));
    }

    void findHeights()
    {
        TruthRule rule = options_.rule;
        truth_.alignment = alignmentOf(*truth_.grid, truth_.robot, rule);
        if (truth_.alignment) {
            const CloudAlignment& a = *truth_.alignment;
            rule.placeSd = options_.align ? std::hypot(a.scatter, a.offsetSd)
                                          : std::hypot(a.scatter, a.correction.offset);
            for (const SceneContact& c : a.contacts)
                truth_.truths[truth_.grid->places()[c.place].row].contact = c.correction;
            for (const std::size_t place : a.off)
                truth_.truths[truth_.grid->places()[place].row].gap = TruthGap::OffCloud;
        }
        truth_.rule = rule;
        for (std::size_t row = 0; row < truth_.scenes(); ++row) {
            if (truth_.truths[row].gap == TruthGap::None) findSides(truth_.truths[row]);
            compare(row);
            putTruth(truth_, row);
        }
        truth_.under.finish();
        truth_.ahead.finish();
    }

    void findSides(SceneTruth& scene)
    {
        if (options_.align && truth_.alignment)
            scene.correction = truth_.alignment->at(truth_.grid->places()[scene.place].heading);
        sampleTruth(scene, truth_.robot, *truth_.grid, scene.place, truth_.rule);
    }

    /// Compares the heights of a row with those that its scene has in the file.
    void compare(std::size_t row)
    {
        const SceneTruth& scene = truth_.truths[row];
        const auto add = [&](const OptionalHeights& before, const SideTruth& found) {
            for (std::size_t i = 0; i < kBins; ++i)
                if (before.at(i) && found.at(i).height)
                    (static_cast<int>(i) < kFirstFlipperBin ? truth_.under : truth_.ahead)
                        .add(*found.at(i).height - *before.at(i), found.at(i).sd);
        };
        if (truth_.isPlane) return add(truth_.plane[row].truth, scene.plane);
        for (const std::size_t side : {0U, 1U})
            add(truth_.tracks[row].truth.at(side), scene.side.at(side));
    }

    const LaserTruthOptions& options_;
    LaserTruth truth_;
    PoseTracks tracks_;
    OdometrySource poseFrames_;  ///< of a recording
    std::optional<SensorFrames> sensors_;
    CloudSpan span_;  ///< of maps
    double start_ = 0.0;
};

}  // namespace

const std::string& LaserTruth::runOf(std::size_t row) const
{
    return tracks.at(row).run;
}

double LaserTruth::timeOf(std::size_t row) const
{
    return tracks.at(row).time;
}

std::size_t LaserTruth::count(TruthGap gap) const
{
    return static_cast<std::size_t>(std::ranges::count(truths, gap, &SceneTruth::gap));
}

std::size_t LaserTruth::knownHeights() const
{
    std::size_t known = 0;
    for (const SceneTruth& scene : truths)
        for (std::size_t i = 0; i < kBins; ++i)
            known += isPlane ? (scene.plane.at(i).height ? 1U : 0U)
                             : (scene.side[0].at(i).height ? 1U : 0U)
                                   + (scene.side[1].at(i).height ? 1U : 0U);
    return known;
}

Result<LaserTruth> laserTruth(const LaserTruthOptions& options)
{
    return LaserTruthFinder(options).run();
}

}  // namespace terratact
