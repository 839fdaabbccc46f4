#include "core/clouds/pose_track.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/degree.h"
#include "core/base/text.h"
#include "core/clouds/cloud_fields.h"
#include "core/mapping/rotation.h"

namespace terratact {
namespace {

constexpr double kSameTime = 1e-3;  // [s]

}  // namespace

std::optional<CloudPose> mountFrom(std::string_view text)
{
    std::vector<std::string_view> fields;
    splitCloudFields(text, fields);
    if (fields.size() != 6) return std::nullopt;
    std::array<double, 6> values{};
    for (std::size_t i = 0; i < 6; ++i) {
        const auto value = cloudCoordinate(fields[i]);
        if (!value || !(std::abs(*value) < 1e4)) return std::nullopt;
        values.at(i) = *value;
    }
    const Rotation r =
        rotationOfAngles(values[3] * kDegree, values[4] * kDegree, values[5] * kDegree);
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            matrix(i, j) = r.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j));
    return CloudPose{{values[0], values[1], values[2]}, Eigen::Quaterniond(matrix)};
}

PoseTrack::PoseTrack(std::vector<Entry> entries, double maxGap)
    : entries_(std::move(entries)), maxGap_(maxGap)
{
    if (entries_.empty()) throw std::invalid_argument("PoseTrack: no pose");
    const auto falls = [](const Entry& a, const Entry& b) { return !(a.time < b.time); };
    if (std::ranges::adjacent_find(entries_, falls) != entries_.end())
        throw std::invalid_argument("PoseTrack: times must rise");
}

std::optional<CloudPose> PoseTrack::at(double time) const
{
    const auto after = std::ranges::lower_bound(entries_, time, {}, &Entry::time);
    if (after != entries_.end() && after->time - time <= kSameTime) return after->pose;
    if (after == entries_.begin()) return std::nullopt;
    const Entry& before = *(after - 1);
    if (time - before.time <= kSameTime) return before.pose;
    if (after == entries_.end() || after->time - before.time > maxGap_) return std::nullopt;
    return between(before.pose, after->pose, (time - before.time) / (after->time - before.time));
}

}  // namespace terratact
