#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/wire/can_codec.h"
#include "core/wire/can_frame.h"
#include "core/wire/frame_trouble.h"

namespace terratact {

/// Whose frames are on the bus: ours (resources/dbc/terratact.dbc), or those of a real Absolem's drives.
enum class CanProtocol : std::uint8_t { Terratact, Absolem };
std::optional<CanProtocol> canProtocolFromName(std::string_view name);  ///< "terratact", "absolem"

/// A number or a word with its name: "Pitch", "0.2100", "rad".
struct NamedValue {
    std::string name, value, unit;
    std::string exact{};  ///< with all its digits, for files; empty: `value` has them

    const std::string& forFiles() const { return exact.empty() ? value : exact; }
    bool operator==(const NamedValue&) const = default;
};

/// A frame in words for people.
struct FrameWords {
    std::string name{};                     ///< empty where the identifier is unknown
    std::optional<std::uint8_t> counter{};  ///< of its E2E protection
    std::string verdict{};                  ///< "ok", "wrong checksum"
    FrameTrouble trouble = FrameTrouble::None;
    std::vector<NamedValue> values{};  ///< of a frame that says something
};

/// Puts the frames of one bus into words, in the order in which they came.
class FrameReader {
public:
    virtual ~FrameReader() = default;
    /// now: [s] on any clock.
    virtual FrameWords read(const CanFrame& frame, double now) = 0;
};
std::unique_ptr<FrameReader> frameReader(CanProtocol protocol);

/// The value of one signal for people: "0.2100", "yes", "driving".
std::string wordOf(const SignalLayout& signal, double value);

/// All that a frame of ours says is that nothing was measured.
bool isNotMeasured(const std::vector<NamedValue>& values);

/// "Pitch 0.2100 rad, Roll -0.0500 rad"
std::string wordsOf(const std::vector<NamedValue>& values);

/// What a frame says, and where it says nothing that is understood, its bytes; empty for a sound frame that has
/// nothing to say but its name.
std::string contentText(const CanFrame& frame, const FrameWords& words);

/// "044", "00000044", "error 004"; "044 FD", "044 remote"
std::string idText(const CanFrame& frame);

/// Why a frame is none of a protocol of standard data frames: "extended frame", "CAN FD frame".
std::string kindText(const CanFrame& frame);

/// "[5] 2A 36 6C 2B BA"; of a frame that is cut the bytes that are known, and "…".
std::string bytesText(const CanFrame& frame);

}  // namespace terratact
