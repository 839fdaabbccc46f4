#include "core/mapping/pose_samples.h"

#include <cmath>

namespace terratact {

std::optional<Rotation> quaternionAt(const FieldValue& message, const std::string& path)
{
    const auto part = [&](const char* member) {
        return numberAt(message, path.empty() ? member : path + '.' + member);
    };
    const auto x = part("x"), y = part("y"), z = part("z"), w = part("w");
    if (!x || !y || !z || !w) return std::nullopt;
    const double length = *x * *x + *y * *y + *z * *z + *w * *w;
    if (!(length > 1e-6 && length < 1e6)) return Rotation{};
    return rotationOf(*x, *y, *z, *w);
}

std::optional<std::array<double, 3>> positionAt(const FieldValue& message, const std::string& path)
{
    constexpr std::array kAxes{".x", ".y", ".z"};
    std::array<double, 3> position{};
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
        const auto number = numberAt(message, path + kAxes.at(i));
        if (!number || !std::isfinite(*number)) return std::nullopt;
        position.at(i) = *number;
    }
    return position;
}

std::vector<PoseSample> samplesOf(const SentPoses& sent)
{
    std::vector<PoseSample> samples;
    samples.reserve(sent.poses.size());
    for (const SentPose& p : sent.poses) {
        const Eigen::Quaterniond& q = p.pose.turn;
        samples.push_back({.time = p.time,
                           .stamp = p.time,
                           .position = {p.pose.place.x(), p.pose.place.y(), p.pose.place.z()},
                           .rotation = rotationOf(q.x(), q.y(), q.z(), q.w())});
    }
    return samples;
}

}  // namespace terratact
