#pragma once

#include <limits>

#include "core/infer/estimate/two_track_estimate.h"
#include "core/robot/robot_model.h"

/// Fake results for tests that need one of every kind.
namespace terratact {

/// Returns an estimate with a step of 0.2 m at 0.45 m. Bins −0.3 … 0.4 are under the robot, 0.5 is a contact, 0.6 and
/// 0.7 are prior only. The sd is largest at 0.6 m.
inline TerrainEstimate stepEstimate()
{
    TerrainEstimate e;
    for (std::size_t i = 0; i < kBins; ++i) {
        const bool onStep = i >= 8;
        e.height[i] = onStep ? -0.05 : -0.25;
        e.sd[i] = i == 9 ? 0.09 : i == 10 ? 0.08 : 0.01;
        e.q10[i] = e.height[i] - 1.28 * e.sd[i];
        e.q90[i] = e.height[i] + 1.28 * e.sd[i];
        e.ceiling[i] = i <= 8 ? e.height[i] + 0.02 : std::numeric_limits<double>::infinity();
        e.origin[i] = i == 8 ? Origin::Contact : Origin::Sampled;
        e.rhat[i] = 1.0;
        e.ess[i] = 1000.0;
    }
    return e;
}

/// Returns stepEstimate() after the arm has touched bin 0.6.
inline TerrainEstimate probedEstimate()
{
    TerrainEstimate e = stepEstimate();
    e.origin[9] = Origin::Arm;
    e.sd[9] = e.sd[10] = 0.03;
    for (const std::size_t i : {std::size_t{9}, std::size_t{10}}) {
        e.q10[i] = e.height[i] - 0.04;
        e.q90[i] = e.height[i] + 0.04;
    }
    return e;
}

/// Returns an estimate of two sides: stepEstimate() at the left, felt to its last bin, and even ground at −0.25 m at
/// the right. The right side is not felt at 0.7 m.
inline TwoTrackEstimate leftStepEstimate()
{
    TwoTrackEstimate e{.side = {stepEstimate(), stepEstimate()}, .onePlane = false};
    for (TerrainEstimate& side : e.side) {
        side.touch.fill(Touch::Felt);
        for (std::size_t i = 0; i < kBins; ++i) side.ceiling[i] = side.height[i] + 0.02;
    }
    TerrainEstimate& right = e.side[1];
    right.height.fill(-0.25);
    for (std::size_t i = 0; i < kBins; ++i) {
        right.q10[i] = right.height[i] - 0.02;
        right.q90[i] = right.height[i] + 0.02;
    }
    right.touch[10] = Touch::NotFelt;
    right.ceiling[10] = std::numeric_limits<double>::infinity();
    return e;
}

/// Returns an estimate of even ground at −0.25 m that is felt up to bin 0.5, with draws. The verdict is CLEAR to +0.55
/// m. The sd of bin 0.6 exceeds the probe threshold.
inline TerrainEstimate clearEstimate()
{
    TerrainEstimate e;
    e.height.fill(-0.25);
    e.touch.fill(Touch::Felt);
    for (std::size_t i = 0; i < kBins; ++i) {
        e.sd[i] = i == 9 ? 0.09 : 0.01;
        e.q10[i] = e.height[i] - 1.28 * e.sd[i];
        e.q90[i] = e.height[i] + 1.28 * e.sd[i];
        e.ceiling[i] = i <= 8 ? e.height[i] + 0.02 : std::numeric_limits<double>::infinity();
        e.rhat[i] = 1.0;
        e.ess[i] = 1000.0;
        if (i > 8) e.touch[i] = Touch::NotFelt;
    }
    e.draws.assign(1000, e.height);
    return e;
}

}  // namespace terratact
