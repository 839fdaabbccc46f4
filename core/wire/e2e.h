#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/limits.h"

namespace terratact {

// AUTOSAR End-to-End protection, Profile 5: bytes 0 and 1 hold a checksum, low byte first, byte 2 a counter,
// the rest is payload.  The checksum runs over bytes 2 to the end and then the data ID, low byte first:
// whoever takes a frame for another one gets a wrong checksum.

inline constexpr std::size_t kE2eHeader = 3;  ///< bytes

/// CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, nothing reflected, nothing inverted.
std::uint16_t crc16(std::span<const std::uint8_t> bytes, std::uint16_t start = 0xFFFF);

/// Writes counter and checksum into the first three bytes.  Throws std::invalid_argument for fewer.
void protect(std::span<std::uint8_t> bytes, std::uint8_t counter, std::uint16_t dataId);

/// Whether the checksum is right; false for fewer than three bytes.
bool isIntact(std::span<const std::uint8_t> bytes, std::uint16_t dataId);

/// What became of one frame.
enum class FrameCheck : std::uint8_t {
    Ok,             ///< the next one, or the first one, or another one after the link was lost
    SomeLost,       ///< up to two are missing before it
    Repeated,       ///< the counter stood still
    WrongSequence,  ///< more are missing, or it is an old one
    WrongCrc,
};

/// What a receiver thinks of its sender.  Only Good may be relied on.
enum class LinkState : std::uint8_t {
    Unknown,   ///< nothing came yet
    Starting,  ///< fewer good frames than the window holds, or an error among them
    Good,
    Bad,    ///< was good; two errors in the window
    Stale,  ///< was good; the last sound frame is over Limits::stale old
    Lost,   ///< over Limits::lost
};

/// Supervises the frames of one identifier.  `now` is any monotonic clock [s]; time that runs backwards
/// counts as a lost link.  A value: copy it freely.  NaN and infinite times throw std::invalid_argument.
class E2eReceiver {
public:
    struct Limits {
        double stale = kStaleAfter;    ///< [s] since the last sound frame
        double lost = kLinkLostAfter;  ///< [s]; the next sound frame begins anew
    };
    static constexpr int kMaxDelta = 3;  ///< of the counter; more is a wrong sequence
    static constexpr int kWindow = 10;   ///< frames; Good begins with a window without error
    static constexpr int kErrors = 2;    ///< in the window end Good

    explicit E2eReceiver(std::uint16_t dataId) : E2eReceiver(dataId, Limits{}) {}
    /// Throws std::invalid_argument unless 0 < stale ≤ lost.
    E2eReceiver(std::uint16_t dataId, Limits limits);

    /// Judges a frame's bytes.  Only Ok and SomeLost may be used, whatever the state.
    FrameCheck receive(std::span<const std::uint8_t> bytes, double now);

    LinkState state(double now) const;

    /// Since the last frame that was Ok or SomeLost [s]; empty before the first.
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
