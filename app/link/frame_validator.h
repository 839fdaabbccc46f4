#pragma once

#include <optional>
#include <vector>

#include "core/wire/can_codec.h"
#include "core/wire/e2e.h"
#include "core/wire/frame_trouble.h"

namespace terratact {

/// What a frame of resources/dbc/terratact.dbc says, and what to think of it.
struct JudgedFrame {
    FrameTrouble trouble = FrameTrouble::None;
    std::optional<FrameKind> kind{};    ///< of its identifier, where it is one of ours
    std::optional<FrameFault> fault{};  ///< why it has no content
    Unpacked content{};                 ///< where it has no fault
    FrameCheck check = FrameCheck::Ok;  ///< of its counter, where it has no fault
    std::optional<double>
        silence{};  ///< [s] before it, of its kind; empty before the first sound one

    /// May be used: only such frames have values.
    bool isSound() const { return trouble == FrameTrouble::None || trouble == FrameTrouble::Gap; }
};

/// Judges the frames of one bus in the order in which they came.
class FrameValidator {
public:
    FrameValidator();
    /// now: [s] on any clock.
    JudgedFrame judge(const CanFrame& frame, double now);

private:
    std::vector<E2eReceiver> receivers_;  // in the order of FrameKind
};

}  // namespace terratact
