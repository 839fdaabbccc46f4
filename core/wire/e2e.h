#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/limits.h"

namespace terratact {

// AUTOSAR End-to-End protection, Profile 5. Bytes 0 and 1 hold a checksum, low byte first, and byte
// 2 a counter; the rest is payload. The checksum covers byte 2 to the end and then the data ID, low
// byte first. A frame that is taken for another one therefore has a wrong checksum.

inline constexpr std::size_t kE2eHeader = 3;  ///< bytes

/// Returns the CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, not reflected, not inverted.
std::uint16_t crc16(std::span<const std::uint8_t> bytes, std::uint16_t start = 0xFFFF);

/// Writes counter and checksum into the first three bytes. Throws std::invalid_argument for fewer
/// bytes.
void protect(std::span<std::uint8_t> bytes, std::uint8_t counter, std::uint16_t dataId);

/// Returns true if the checksum is right; false for fewer than three bytes.
bool isIntact(std::span<const std::uint8_t> bytes, std::uint16_t dataId);

/// Verdict on one frame.
enum class FrameCheck : std::uint8_t {
    Ok,             ///< the next frame, or the first one at the start or after a lost link
    SomeLost,       ///< one or two frames are missing before it
    Repeated,       ///< the counter did not change
    WrongSequence,  ///< more frames are missing, or it is an old one
    WrongCrc,
};

/// State of the link to a sender. Only Good may be relied on.
enum class LinkState : std::uint8_t {
    Unknown,   ///< nothing has come yet
    Starting,  ///< fewer valid frames than the window holds, or an error among them
    Good,
    Bad,    ///< was Good; two errors in the window
    Stale,  ///< was Good; the last valid frame is older than Limits::stale
    Lost,   ///< the last valid frame is older than Limits::lost
};

/// Supervises the frames of one identifier. `now` is any monotonic clock [s]; time that runs
/// backwards counts as a lost link. The object is a value and may be copied. Throws
/// std::invalid_argument for NaN and infinite times.
class E2eReceiver {
public:
    struct Limits {
        double stale = kStaleAfter;  ///< [s] since the last valid frame
        /// [s] since the last valid frame; the next one restarts the supervision
        double lost = kLinkLostAfter;
    };
    static constexpr int kMaxDelta = 3;  ///< largest step of the counter; more is a wrong sequence
    static constexpr int kWindow = 10;   ///< frames; Good needs one window without an error
    static constexpr int kErrors = 2;    ///< errors in the window that end Good

    explicit E2eReceiver(std::uint16_t dataId) : E2eReceiver(dataId, Limits{}) {}
    /// Throws std::invalid_argument unless 0 < stale ≤ lost.
    E2eReceiver(std::uint16_t dataId, Limits limits);

    /// Judges a frame's bytes. Only frames with Ok or SomeLost may be used, whatever the state.
    FrameCheck receive(std::span<const std::uint8_t> bytes, double now);

    LinkState state(double now) const;

    /// Returns the time since the last frame with Ok or SomeLost [s]; empty before the first.
    std::optional<double> age(double now) const;

private:
    FrameCheck judge(std::span<const std::uint8_t> bytes, bool anew);
    void remember(FrameCheck check);
    int errors() const;

    std::uint16_t dataId_;
    Limits limits_;
    std::optional<double> lastSound_;
    std::optional<std::uint8_t> counter_;
    std::uint32_t history_ = 0;  ///< bit 0: the newest frame; set: it was an error
    int seen_ = 0;               ///< frames in history_
    bool wasGood_ = false, good_ = false;
};

}  // namespace terratact
