#pragma once

#include <cstddef>
#include <list>
#include <span>
#include <vector>

#include "core/infer/estimator.h"

namespace terratact {

/// Chains of all scenes of a batch together, unless one scene has more: what the quadratic form takes in one
/// pass, and fits the caches.
inline constexpr int kBatchChains = 64;

/// Up to so many inducing rows a scene whose chains fill whole groups of columns gains nothing from others
/// (docs/speed.md): its factors fit the caches without them.
inline constexpr int kFewRows = 700;

/// Estimates of many scenes, several at a time: the chains of those that a method samples pass through the model's
/// factors side by side (GibbsRun::sweepTogether).  A scene that has ended makes room for the next.  Every estimate
/// is that of estimateTerrain, bit for bit, whatever is beside it, where time does not end it.
/// For one thread; several may have one each, of the same models.
class EstimateBatch {
public:
    /// An estimate with the number that its scene was added with.
    struct Ready {
        std::size_t number = 0;
        TerrainEstimate estimate;
    };

    /// Both must live as long as this does.
    EstimateBatch(const RobotModel& robot, const Models& models) : robot_(robot), models_(models) {}

    /// Whether one more scene gains from those that are there: its chains fit in, it visits bins in their order, and its
    /// factors are large or its groups of columns not full (kFewRows).
    /// Always where the batch is empty, never where an estimate is ready.
    bool hasRoomFor(const Settings& settings) const;
    bool empty() const { return scenes_.empty() && ready_.empty(); }

    /// Takes up a scene; the arguments are as estimateTerrain's, and so is what it throws.  Then the batch is as before.
    void add(std::size_t number, const Proprioception& s, std::span<const ArmReading> arm,
             const Settings& settings, const Watch& watch = {}, const WeakHeights& weak = {});

    /// Sweeps until one scene or more have ended, which leave; empty only where the batch is.
    /// Throws as estimateTerrain; the batch cannot go on then.
    std::vector<Ready> next();

private:
    struct InWork {
        InWork(std::size_t number, SceneSampling sampling, const Watch& watch);
        std::size_t number;
        SceneSampling sampling;
        Watch watch;
        GibbsRun run;
    };
    void collect();

    const RobotModel& robot_;
    const Models& models_;
    std::list<InWork> scenes_;
    std::vector<Ready> ready_;
    PredictionRoom room_;
};

}  // namespace terratact
