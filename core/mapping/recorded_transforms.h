#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/bags/recording.h"
#include "core/base/result.h"
#include "core/mapping/mapping.h"
#include "core/mapping/transform_tree.h"

namespace terratact {

/// Adds all transforms of a recording to a tree. Other topics are not read from then on. Errors are those of the file;
/// messages that cannot be decoded are refused if they are the most.
Status readTransforms(Recording& recording, TransformTree& transforms);

/// A pose at a time of the mapping.
struct SentPose {
    std::int64_t time =
        0;  ///< [ns]: header.stamp if the mapping selects it, else the recorder's time
    FramePose pose{};
};

/// Poses of a base from transforms.
struct SentPoses {
    std::vector<SentPose> poses{};  ///< in the order of stamps
    std::size_t without =
        0;  ///< left out: another transform of the chain has none around that time
};

/// Returns the poses of source.baseFrame in source.frame, one for each transform that moves it. Errors are causes
/// without the file: no transforms join the frames, they have no time in common, or there are too many.
Result<SentPoses> sentPoses(const TransformTree& transforms, const OdometrySource& source,
                            bool byHeader);

}  // namespace terratact
