#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/bags/recording.h"
#include "core/base/result.h"
#include "core/mapping/even_clock.h"
#include "core/mapping/mapping.h"
#include "core/wire/can_frame.h"

namespace terratact {

/// A CAN frame of a recording.
struct RecordedFrame {
    std::int64_t time = 0;  ///< [ns], never before the frame ahead
    CanFrame frame{};
    bool sent = false;
};

/// Reads the messages of one topic as CAN frames, such as /can of our own MCAP export or can_msgs/Frame.
/// Neither object may be destroyed before this one.
class RecordedFrames {
public:
    RecordedFrames(Recording& recording, const FramesSource& source);

    /// Returns the next frame; empty after the last. Errors name the file, the topic and the message. It
    /// cannot be decoded, lacks id or data, or they are beyond a frame's range.
    Result<std::optional<RecordedFrame>> next();

    std::uint64_t falls() const { return falls_; }  ///< frames whose time was raised
    /// Returns where the clock was set; times continue evenly from there.
    const std::vector<ClockStep>& clockSteps() const { return clock_.steps(); }
    std::string emptiness() const;  ///< sentence about a file without such a frame

private:
    Result<RecordedFrame> frameOf(const RecordedMessage& message);

    Recording& recording_;
    const FramesSource& source_;
    EvenClock clock_;
    EvenClock::Follower follower_{clock_};
    std::optional<std::int64_t> last_;
    std::uint64_t falls_ = 0;
};

}  // namespace terratact
