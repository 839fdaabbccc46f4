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
    /// [s] since the previous frame of its kind; empty before the first sound one.
    std::optional<double> silence{};

    /// Returns true if the frame may be used; only such frames have values.
    bool isSound() const { return trouble == FrameTrouble::None || trouble == FrameTrouble::Gap; }
};

/// Checks the frames of one bus in the order received.
class FrameValidator {
public:
    FrameValidator();
    /// now: time on any one clock [s].
    JudgedFrame judge(const CanFrame& frame, double now);

private:
    std::vector<E2eReceiver> receivers_;  // indexed by FrameKind
};

}  // namespace terratact
