#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/bags/field_value.h"
#include "core/mapping/rotation.h"

namespace terratact {

/// Rotations between frames from tf2_msgs/TFMessage. Of each frame the first transform counts: only
/// fixed ones, such as an IMU's mounting, are looked up.
class TransformTree {
public:
    /// Adds the transforms of a message of /tf or /tf_static; others are ignored.
    void add(const FieldValue& message);

    /// Returns R with v_from = R v_to. Empty if no chain of transforms joins both frames.
    std::optional<Rotation> rotation(const std::string& from, const std::string& to) const;

private:
    struct Link {
        std::string parent;
        Rotation rotation{};  ///< v_parent = R v_child
    };
    static constexpr std::size_t kMaxFrames = 10'000;
    static constexpr int kLongest = 100;  ///< links of a chain

    /// Returns the rotation from the root of the frame's tree, and sets `root`.
    Rotation fromRoot(std::string frame, std::string& root) const;

    std::map<std::string, Link> links_;  ///< by child
};

}  // namespace terratact
