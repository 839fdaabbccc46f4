#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/bags/field_value.h"
#include "core/mapping/recorded_transforms.h"
#include "core/mapping/rotation.h"

namespace terratact {

/// Pose of a message: a position, if there is one, and a rotation.
struct PoseSample {
    std::int64_t time = 0;   ///< [ns] of the mapping's clock
    std::int64_t stamp = 0;  ///< [ns] header.stamp; else as `time`
    std::array<double, 3> position{};
    Rotation rotation{};  ///< all 0: not measured

    bool isMeasured() const { return rotation != Rotation{}; }
};

/// Returns the rotation of the quaternion at the path. Empty if a number is missing; all 0 if it has no direction.
std::optional<Rotation> quaternionAt(const FieldValue& message, const std::string& path);

/// Returns the finite position at the path.
std::optional<std::array<double, 3>> positionAt(const FieldValue& message, const std::string& path);

/// Returns poses of transforms as samples.
std::vector<PoseSample> samplesOf(const SentPoses& sent);

}  // namespace terratact
