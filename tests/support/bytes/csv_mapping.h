#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "core/mapping/mapping.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Columns of the pose in a CSV file.
inline constexpr const char* kPoseColumns = "pitch,front_left,front_right,rear_left,rear_right";

/// Returns a mapping of a CSV file with these columns, and with more tables.
inline std::string csvMapping(const std::string& more = {})
{
    std::string text = "name = \"test\"\n" + more;
    for (const char* const table :
         {"pitch", "front_left", "front_right", "rear_left", "rear_right"})
        if (more.find(fmt::format("[{}]", table)) == std::string::npos)
            text += fmt::format("\n[{0}]\nfield = \"{0}\"\n", table);
    return text;
}

inline Mapping parsedMapping(const std::string& text)
{
    auto mapping = mappingFrom("m.toml", text);
    EXPECT_TRUE(mapping) << mapping.error().text;
    return mapping ? std::move(*mapping) : Mapping{};
}

inline const RobotModel& shippedRobot()
{
    static const RobotModel robot =
        *readRobotModel(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
    return robot;
}

}  // namespace terratact
