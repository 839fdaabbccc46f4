#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/wire/can_codec.h"
#include "core/wire/can_frame.h"
#include "core/wire/frame_trouble.h"

namespace terratact {

/// Protocol on the bus: ours (resources/dbc/terratact.dbc), or that of a real Absolem's drives.
enum class CanProtocol : std::uint8_t { Terratact, Absolem };
/// Accepts "terratact", "absolem".
std::optional<CanProtocol> canProtocolFromName(std::string_view name);

/// A named value as text: "Pitch", "0.2100", "rad".
struct NamedValue {
    std::string name, value, unit;
    std::string exact{};  ///< all digits, for files; empty: `value` has them
    Message shown{};      ///< `value` for the operator; empty: the same in every language

    const std::string& forFiles() const { return exact.empty() ? value : exact; }
    bool operator==(const NamedValue&) const = default;
};

/// A decoded frame as text.
struct FrameWords {
    std::string name{};                     ///< empty if the identifier is unknown
    std::optional<std::uint8_t> counter{};  ///< counter of its E2E protection
    std::string verdict{};                  ///< "ok", "wrong checksum"
    FrameTrouble trouble = FrameTrouble::None;
    std::vector<NamedValue> values{};  ///< values of a frame with content
};

/// Decodes the frames of one bus into text, in the order received.
class FrameReader {
public:
    virtual ~FrameReader() = default;
    /// now: time on any one clock [s].
    virtual FrameWords read(const CanFrame& frame, double now) = 0;
};
std::unique_ptr<FrameReader> frameReader(CanProtocol protocol);

/// Returns a signal's value as text: "0.2100", "yes", "driving".
Message wordOf(const SignalLayout& signal, double value);

/// Returns true if a frame of our protocol states only that nothing was measured.
bool isNotMeasured(const std::vector<NamedValue>& values);

/// Returns "Pitch 0.2100 rad, Roll -0.0500 rad".
std::string wordsOf(const std::vector<NamedValue>& values);

/// Returns the content of a frame, or its bytes if it was not decoded. Returns an empty text for a valid frame without
/// content.
std::string contentText(const CanFrame& frame, const FrameWords& words);

/// Returns "044", "00000044", "error 004"; "044 FD", "044 remote".
std::string idText(const CanFrame& frame);

/// Returns why a frame does not belong to a protocol of standard data frames: "extended frame", "CAN FD frame".
std::string kindText(const CanFrame& frame);

/// Returns "[5] 2A 36 6C 2B BA"; a truncated frame shows its known bytes and "…".
std::string bytesText(const CanFrame& frame);

}  // namespace terratact
