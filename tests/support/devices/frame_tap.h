#pragma once

#include <gtest/gtest.h>

#include "app/link/frame_history.h"

/// A frame history that a test feeds.
namespace terratact {

struct Tapping : testing::Test {
    FrameHistory tap;
    FrameValidator validator;
    std::uint8_t counter = 0;

    BusFrame attitude(double pitch, double time)
    {
        return {
            .frame = pack(
                {.kind = FrameKind::Attitude, .counter = ++counter, .values = {pitch, -0.1, 1.0}}),
            .time = time};
    }
    void add(const BusFrame& frame) { tap.add(frame, validator.judge(frame.frame, frame.time)); }
    /// Runs at 20 Hz from `from` to `to` [s], with ticks in between.
    void run(double from, double to, double pitch)
    {
        for (double t = from; t < to - 1e-9; t += 0.05) {
            add(attitude(pitch, t));
            tap.tick(t);
        }
    }
    TappedFrame of(FrameKind kind, double now) const
    {
        for (const TappedFrame& frame : tap.frames(now))
            if (frame.kind == kind) return frame;
        ADD_FAILURE() << "no such frame";
        return {};
    }
};

}  // namespace terratact
