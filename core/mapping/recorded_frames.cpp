#include "core/mapping/recorded_frames.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/text.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

/// Returns the number at the path as an integer of 0 … most; empty if it is none.
std::optional<std::uint32_t> wholeAt(const FieldValue& message, const std::string& path,
                                     std::uint32_t most)
{
    const auto number = numberAt(message, path);
    if (!number || !(*number >= 0.0 && *number <= most) || *number != std::floor(*number))
        return std::nullopt;
    return static_cast<std::uint32_t>(*number);
}

bool flagAt(const FieldValue& message, const std::string& path)
{
    return numberAt(message, path).value_or(0.0) != 0.0;
}

}  // namespace

RecordedFrames::RecordedFrames(Recording& recording, const FramesSource& source)
    : recording_(recording), source_(source)
{
    recording_.select({source.topic});
}

Result<std::optional<RecordedFrame>> RecordedFrames::next()
{
    RecordedMessage message;
    const auto more = recording_.read(message);
    if (!more) return more.error();
    if (!*more) return std::optional<RecordedFrame>();
    auto frame = frameOf(message);
    if (!frame) return frame.error();
    frame->time = follower_.add(frame->time);
    if (last_ && frame->time < *last_) {
        frame->time = *last_;
        ++falls_;
    }
    last_ = frame->time;
    return std::optional(*frame);
}

Result<RecordedFrame> RecordedFrames::frameOf(const RecordedMessage& message)
{
    constexpr std::uint32_t kMaxId = (1U << 29U) - 1U, kMaxStandardId = 0x7FF;
    const auto value = recording_.decode(message);
    if (!value) return value.error();
    const auto refuse = [&](const std::string& field, std::string_view expected) {
        return fileError(
            recording_.path(),
            fmt::format("topic {}: the field {} of the message at {} is not {}; correct "
                        "[frames] of the mapping",
                        printable(source_.topic), shown(field), message.offset, expected));
    };
    RecordedFrame row{.time = message.time};
    CanFrame& frame = row.frame;
    frame.extended = flagAt(*value, source_.extended);
    const auto id = wholeAt(*value, source_.id, kMaxId);
    if (!id || (!frame.extended && *id > kMaxStandardId))
        return refuse(source_.id, "an identifier of 11 bits, or 29 if extended");
    frame.id = *id;
    frame.remote = flagAt(*value, source_.remote);
    frame.error = flagAt(*value, source_.error);
    frame.fd = flagAt(*value, source_.fd);
    row.sent = flagAt(*value, source_.sent);
    const auto length = wholeAt(*value, source_.length, frame.fd ? kFdBytes : kClassicBytes);
    if (!length) return refuse(source_.length, "a length of at most 8 bytes, or 64 of CAN FD");
    frame.length = static_cast<std::uint8_t>(*length);
    for (std::size_t i = 0; i < *length && !frame.remote; ++i) {
        const auto byte = wholeAt(*value, fmt::format("{}[{}]", source_.data, i), 255);
        if (!byte) return refuse(source_.data, "an array of bytes as long as the length says");
        frame.data.at(i) = static_cast<std::uint8_t>(*byte);
    }
    return row;
}

std::string RecordedFrames::emptiness() const
{
    return fmt::format(
        "holds no message of topic {}, where [frames] of the mapping expects the frames; "
        "`terratact import --probe` lists the topics",
        printable(source_.topic));
}

}  // namespace terratact
