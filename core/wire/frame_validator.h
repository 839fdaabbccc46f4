#pragma once

#include <optional>
#include <vector>

#include "core/wire/can_codec.h"
#include "core/wire/e2e.h"
#include "core/wire/frame_trouble.h"

namespace terratact {

/// Content and verdict of a frame of resources/dbc/terratact.dbc.
struct JudgedFrame {
    FrameTrouble trouble = FrameTrouble::None;
    std::optional<FrameKind> kind{};    ///< kind of its identifier, if the protocol has it
    std::optional<FrameFault> fault{};  ///< reason that it has no content
    Unpacked content{};                 ///< valid without fault
    FrameCheck check = FrameCheck::Ok;  ///< result of the E2E counter check, without fault
    /// [s] since the previous frame of its kind; empty before the first valid one.
    std::optional<double> silence{};

    /// Returns true if the frame may be used; only such frames have values.
    bool isSound() const { return trouble == FrameTrouble::None || trouble == FrameTrouble::Gap; }
};

/// Checks the frames of one bus in the order received, and supervises the link of each kind. It is
/// the only judge of received telemetry: TelemetryListener and the pages use its verdicts.
class FrameValidator {
public:
    FrameValidator();

    /// Judges a frame. FrameFault (can_codec.h) and FrameCheck (e2e.h) list what is refused. Damaged
    /// bytes are an error of their link. Wrong content with a right checksum has a fault, and its frame
    /// counts as missing. now: time on any one clock [s].
    JudgedFrame judge(const CanFrame& frame, double now);

    LinkState link(FrameKind kind, double now) const { return receiver(kind).state(now); }
    /// Returns the time since the last usable frame of a kind [s], see E2eReceiver::age.
    std::optional<double> age(FrameKind kind, double now) const { return receiver(kind).age(now); }

private:
    const E2eReceiver& receiver(FrameKind kind) const
    {
        return receivers_[static_cast<std::size_t>(kind)];
    }

    std::vector<E2eReceiver> receivers_;  // indexed by FrameKind
};

}  // namespace terratact
