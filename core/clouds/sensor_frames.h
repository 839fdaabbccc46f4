#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/clouds/cloud_messages.h"
#include "core/clouds/pose_track.h"
#include "core/mapping/transform_tree.h"

namespace terratact {

/// Poses of the sensors of a recording's clouds in the base, from transforms: fixed or moving mounts.
class SensorFrames {
public:
    /// Reads the transforms of recordings. base: frame of the base; topic: of the clouds in `clouds`, whose first
    /// message names the sensor's frame; others: further recordings with transforms; maxGap: longest time between two
    /// transforms in which one is interpolated [s]. Errors name the file: it cannot be read, or no transforms join
    /// base and sensor.
    static Result<SensorFrames> read(const std::string& base,
                                     const std::vector<std::string>& clouds,
                                     const std::string& topic,
                                     const std::vector<std::string>& others, double maxGap);

    /// Returns the sensor's pose in the base at the time of a cloud. Empty if transforms do not know it then.
    std::optional<CloudPose> mountOf(const CloudMessage& cloud) const;

private:
    explicit SensorFrames(std::string base, double maxGap)
        : base_(std::move(base)), transforms_(maxGap)
    {
    }

    std::string base_;
    TransformTree transforms_;
};

}  // namespace terratact
