#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/bags/time_unit.h"
#include "core/base/text.h"
#include "core/clouds/cloud_fields.h"
#include "core/clouds/cloud_file.h"
#include "core/clouds/cloud_reader.h"
#include "core/clouds/pose_track.h"
#include "core/mapping/recorded_transforms.h"
#include "core/store/csv_field.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxPoses = 5'000'000;
constexpr double kMinJump = 0.3;                   // [m] a shorter one is noise
constexpr std::int64_t kDisorder = 1'000'000'000;  // [ns]
constexpr double kUnitLength = 0.05;  // most difference of a quaternion's length from 1

/// Columns of a pose, in this order.
constexpr std::array<std::string_view, 8> kPoseColumns{"time", "x",  "y",  "z",
                                                       "qx",   "qy", "qz", "qw"};
using PoseNumbers = std::array<double, kPoseColumns.size()>;

/// Returns why such times are wrong: they may have another unit. step: between two; 0: there is none.
std::string unitDoubt(double first, double step)
{
    const std::string unit = timeUnitOf(first, step).name;
    if (unit == "s") return "seconds since 1970 or since the begin were expected";
    return fmt::format("are the times in {}? Seconds were expected", unit == "us" ? "µs" : unit);
}

/// Collects the poses of each run; refuses those that no drive has.
class PoseCollector {
public:
    explicit PoseCollector(const PoseLimits& limits) : limits_(limits) {}

    /// Returns the sentence about why a pose is refused; empty: it was added.
    std::string add(const std::string& run, const PoseNumbers& v)
    {
        for (std::size_t i = 0; i < v.size(); ++i)
            if (!std::isfinite(v.at(i)) || (i > 0 && std::abs(v.at(i)) > kFarthestPoint))
                return fmt::format("{} is {}: a finite number was expected; leave this pose out",
                                   kPoseColumns.at(i), v.at(i));
        Eigen::Quaterniond turn(v[7], v[4], v[5], v[6]);
        if (std::abs(turn.norm() - 1.0) > kUnitLength)
            return fmt::format(
                "the quaternion has the length {:.3f}: 1 was expected, in the order qx qy "
                "qz qw; correct the columns",
                turn.norm());
        turn.normalize();
        constexpr double kLatest = 1e10;  // [s] since 1970: the year 2286
        if (std::abs(v[0]) > kLatest)
            return fmt::format("the time {:.0f} s lies after the year 2286: {}", v[0],
                               unitDoubt(v[0], stepBefore(run)));
        if (++count_ > kMaxPoses) return fmt::format("there are more than {} poses", kMaxPoses);
        auto& entries = runs_[run];
        const Eigen::Vector3d place{v[1], v[2], v[3]};
        if (!entries.empty()) {
            const auto& last = entries.back();
            const double seconds = v[0] - last.time, way = (place - last.pose.place).norm();
            if (!(seconds > 0.0))
                return fmt::format(
                    "the time {:.3f} s does not rise from {:.3f} s before: sort the poses, "
                    "and leave double ones out",
                    v[0], last.time);
            if (way > kMinJump && way > limits_.maxSpeed * seconds)
                return fmt::format(
                    "the pose jumps {:.2f} m in {:.3f} s, faster than {:.2f} m/s: cut the poses "
                    "there, or raise --max-speed{}",
                    way, seconds, limits_.maxSpeed,
                    1e-3 * way <= limits_.maxSpeed * seconds ? "; or are the places in mm?" : "");
        }
        entries.push_back({v[0], {place, turn}});
        return {};
    }

    PoseTracks tracks() &&
    {
        PoseTracks tracks;
        for (auto& [run, entries] : runs_)
            tracks.emplace(run, PoseTrack(std::move(entries), limits_.maxGap));
        return tracks;
    }

private:
    /// Returns the last step between two poses of a run; 0: it has none.
    double stepBefore(const std::string& run) const
    {
        const auto found = runs_.find(run);
        if (found == runs_.end() || found->second.size() < 2) return 0.0;
        return found->second.back().time - found->second[found->second.size() - 2].time;
    }

    PoseLimits limits_;
    std::map<std::string, std::vector<PoseTrack::Entry>> runs_;
    std::size_t count_ = 0;
};

/// Column of a header; kPoseColumns.size(): the run; larger: another one.
std::size_t poseColumn(std::string_view name)
{
    const std::string text = lowerCase(withoutBlanks(name, " \t\"#"));
    if (text == "run") return kPoseColumns.size();
    for (const char* time : {"t_s", "t", "timestamp", "stamp", "time_s", "__time"})
        if (text == time) return 0;
    for (std::size_t i = 0; i < kPoseColumns.size(); ++i)
        if (text == kPoseColumns.at(i) || text == std::string(kPoseColumns.at(i)) + "_m") return i;
    return kPoseColumns.size() + 1;
}

/// Reads a file of poses line by line.
class PoseFileReader {
public:
    PoseFileReader(CloudFile file, const PoseLimits& limits)
        : file_(std::move(file)), collector_(limits), maxGap_(limits.maxGap)
    {
        for (std::size_t i = 0; i < columns_.size(); ++i) columns_.at(i) = i;
    }

    Result<PoseTracks> read()
    {
        for (;;) {
            const auto more = file_.line(line_);
            if (!more) return more.error();
            if (!*more) break;
            if (line_.find('\0') != std::string::npos)
                return file_.lineError(
                    "holds bytes that are no text: poses as TUM or CSV were expected; for a "
                    "bag, name its --mapping");
            if (line_.starts_with('#')) continue;
            splitCloudFields(line_, fields_);
            if (fields_.empty()) continue;
            const bool isFirst = std::exchange(first_, false);
            if (isFirst && !cloudCoordinate(fields_[0])) {
                if (Status done = readHeader(); !done) return done.error();
                continue;
            }
            if (Status done = addLine(); !done) return done.error();
        }
        auto tracks = std::move(collector_).tracks();
        if (tracks.empty())
            return file_.error("holds no pose: lines with time x y z qx qy qz qw were expected");
        for (const auto& [run, track] : tracks)
            if (const double apart = middleInterval(track); apart > std::max(kFarApart, maxGap_))
                return file_.error(fmt::format("its poses are {:.0f} s apart in the middle: {}",
                                               apart,
                                               unitDoubt(track.entries().front().time, apart)));
        return tracks;
    }

private:
    static constexpr double kFarApart = 60.0;  // [s] between poses: no drive

    static double middleInterval(const PoseTrack& track)
    {
        std::vector<double> intervals;
        intervals.reserve(track.entries().size());
        for (std::size_t i = 1; i < track.entries().size(); ++i)
            intervals.push_back(track.entries()[i].time - track.entries()[i - 1].time);
        if (intervals.empty()) return 0.0;
        const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
        std::ranges::nth_element(intervals, middle);
        return *middle;
    }

    Status readHeader()
    {
        std::array<bool, kPoseColumns.size()> known{};
        for (std::size_t i = 0; i < fields_.size(); ++i) {
            const std::size_t column = poseColumn(fields_[i]);
            if (column == kPoseColumns.size()) run_ = i;
            if (column >= kPoseColumns.size() || known.at(column)) continue;
            known.at(column) = true;
            columns_.at(column) = i;
        }
        for (std::size_t i = 0; i < known.size(); ++i)
            if (!known.at(i))
                return file_.lineError(
                    fmt::format("names no column {}: time (or t_s), x, y, z, qx, qy, qz "
                                "and qw were expected",
                                kPoseColumns.at(i)));
        return Done{};
    }

    Status addLine()
    {
        PoseNumbers numbers{};
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const auto value = columns_.at(i) < fields_.size()
                                 ? cloudCoordinate(fields_[columns_.at(i)])
                                 : std::nullopt;
            if (!value)
                return file_.lineError(
                    fmt::format("{} is missing or no number: time x y z qx qy qz qw were "
                                "expected",
                                kPoseColumns.at(i)));
            numbers.at(i) = *value;
        }
        const bool hasRun = run_ && *run_ < fields_.size();
        const std::string refusal = collector_.add(
            hasRun ? std::string(withoutBlanks(fields_[*run_], " \t\"")) : "", numbers);
        if (!refusal.empty()) return file_.lineError(refusal);
        return Done{};
    }

    CloudFile file_;
    PoseCollector collector_;
    double maxGap_;  ///< [s]
    std::string line_;
    std::vector<std::string_view> fields_;
    std::array<std::size_t, kPoseColumns.size()> columns_{};
    std::optional<std::size_t> run_;
    bool first_ = true;
};

/// Returns the numbers of a message of odometry; empty if a field is missing.
std::optional<PoseNumbers> poseOf(const FieldValue& message, const OdometrySource& source,
                                  double time)
{
    PoseNumbers numbers{time};
    std::size_t i = 0;
    const std::string& turn = source.orientation;
    for (const std::string& path :
         {source.source.field + ".x", source.source.field + ".y", source.source.field + ".z",
          turn + ".x", turn + ".y", turn + ".z", turn + ".w"}) {
        const auto value = numberAt(message, path);
        if (!value) return std::nullopt;
        numbers.at(++i) = *value;
    }
    return numbers;
}

/// Reads the poses of transforms.
Result<PoseTracks> readSentPoses(Recording& recording, const Mapping& mapping,
                                 const PoseLimits& limits)
{
    const OdometrySource& source = *mapping.odometry;
    TransformTree transforms(limits.maxGap);
    transforms.want(source.frame);
    transforms.want(source.baseFrame);
    if (Status read = readTransforms(recording, transforms); !read) return read.error();
    const auto sent = sentPoses(transforms, source, mapping.byHeader);
    if (!sent) return fileError(recording.path(), sent.error().text);
    PoseCollector collector(limits);
    std::optional<std::int64_t> last;
    for (const SentPose& p : sent->poses) {
        // Recorders write messages of one moment in any order.
        if (last && p.time <= *last && *last - p.time < kDisorder) continue;
        last = p.time;
        const Eigen::Vector3d& at = p.pose.place;
        const Eigen::Quaterniond& q = p.pose.turn;
        const std::string refusal = collector.add("", {1e-9 * static_cast<double>(p.time), at.x(),
                                                       at.y(), at.z(), q.x(), q.y(), q.z(), q.w()});
        if (!refusal.empty())
            return fileError(recording.path(),
                             fmt::format("transforms from {} to {}: {}", shown(source.frame),
                                         shown(source.baseFrame), refusal));
    }
    return std::move(collector).tracks();
}

}  // namespace

Result<PoseTracks> readPoses(const std::string& path, const PoseLimits& limits)
{
    auto file = CloudFile::open(path);
    if (!file) return file.error();
    return PoseFileReader(*std::move(file), limits).read();
}

Result<PoseTracks> readPoses(Recording& recording, const Mapping& mapping, const PoseLimits& limits)
{
    if (!mapping.odometry)
        return fileError(recording.path(),
                         "the mapping has no table [odometry]: it says where poses are");
    const OdometrySource& source = *mapping.odometry;
    if (source.isTransform()) return readSentPoses(recording, mapping, limits);
    recording.select({source.source.topic});
    PoseCollector collector(limits);
    std::size_t messages = 0;
    for (RecordedMessage message;;) {
        const auto more = recording.next(message);
        if (!more) return more.error();
        if (!*more) break;
        if (recording.topics().at(message.topic).name != source.source.topic) continue;
        const auto value = recording.decode(message);
        if (!value) return value.error();
        const auto stamp = mapping.byHeader ? stampOf(*value) : std::nullopt;
        const double time = 1e-9 * static_cast<double>(stamp.value_or(message.time));
        const auto numbers = poseOf(*value, source, time);
        const std::string place = fmt::format("topic {}: {} {}", printable(source.source.topic),
                                              recording.offsetUnit(), message.offset);
        if (!numbers)
            return fileError(recording.path(),
                             fmt::format("{}: has no {} or {}: correct [odometry] of the mapping",
                                         place, source.source.field, source.orientation));
        const std::string refusal = collector.add("", *numbers);
        if (!refusal.empty())
            return fileError(recording.path(), fmt::format("{}: {}", place, refusal));
        ++messages;
    }
    if (messages == 0)
        return fileError(
            recording.path(),
            fmt::format("has no message of topic {}: correct [odometry] of the mapping",
                        printable(source.source.topic)));
    return std::move(collector).tracks();
}

}  // namespace terratact
