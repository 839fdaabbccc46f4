#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/bags/recording.h"

namespace terratact {

/// What a test file held.
struct ReadRecording {
    std::vector<std::string> messages;  ///< "topic time value"; an error's text for a value
    std::vector<std::string> remarks;
};

/// Reads a recording of std_msgs/Float64 to its end. The test fails if it cannot be opened.
inline ReadRecording readRecording(const std::string& path,
                                   const std::optional<std::set<std::string>>& topics = {})
{
    auto recording = openRecording(path);
    EXPECT_TRUE(recording) << recording.error().text;
    if (!recording) return {};
    if (topics) (*recording)->select(*topics);
    ReadRecording read;
    for (RecordedMessage message;;) {
        const auto more = (*recording)->next(message);
        EXPECT_TRUE(more);
        if (!more || !*more) break;
        const auto value = (*recording)->decode(message);
        read.messages.push_back((*recording)->topics()[message.topic].name + " "
                                + std::to_string(message.time) + " "
                                + (value ? std::to_string(numberAt(*value, "data").value_or(-1.0))
                                         : value.error().text));
    }
    read.remarks = (*recording)->consumeRemarks();
    return read;
}

}  // namespace terratact
