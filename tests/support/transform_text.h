#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "core/mapping/frame_pose.h"

namespace terratact {

/// Returns a message of one transform as JSON.
inline std::string transformText(std::string_view parent, std::string_view child,
                                 const FramePose& pose, std::int64_t stamp)
{
    return fmt::format(
        R"({{"transforms":[{{"header":{{"frame_id":"{}","stamp":{{"sec":{},"nanosec":{}}}}},)"
        R"("child_frame_id":"{}","transform":{{"translation":{{"x":{},"y":{},"z":{}}},)"
        R"("rotation":{{"x":{},"y":{},"z":{},"w":{}}}}}}}]}})",
        parent, stamp / 1'000'000'000, stamp % 1'000'000'000, child, pose.place.x(), pose.place.y(),
        pose.place.z(), pose.turn.x(), pose.turn.y(), pose.turn.z(), pose.turn.w());
}

}  // namespace terratact
