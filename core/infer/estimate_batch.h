#pragma once

#include <cstddef>
#include <list>
#include <span>
#include <vector>

#include "core/infer/estimator.h"

namespace terratact {

/// Largest number of chains in a batch, unless one scene has more. The quadratic form takes so many
/// in one pass, and they fit the caches.
inline constexpr int kBatchChains = 64;

/// A scene with at most this many inducing rows and full groups of columns gains nothing from a
/// batch (docs/speed.md). Its factors fit the caches anyway.
inline constexpr int kFewRows = 700;

/// Estimates many scenes, several at a time. The chains of sampled scenes pass through the model's
/// factors together (GibbsRun::sweepTogether). A scene that has ended makes room for the next.
/// Every estimate equals estimateTerrain's bit for bit, whatever else is in the batch, unless a
/// time limit ends it.
/// One thread uses one batch; several threads may have one each, with the same models.
class EstimateBatch {
public:
    /// Finished estimate and the number that its scene was added with.
    struct Ready {
        std::size_t number = 0;
        TerrainEstimate estimate;
    };

    /// Robot and models must outlive the batch.
    EstimateBatch(const RobotModel& robot, const Models& models) : robot_(robot), models_(models) {}

    /// Returns true if one more scene gains from the batch. Its chains must fit in, and its scan
    /// order must be fixed. Its factors must be large, or its groups of columns not full
    /// (kFewRows). Always true for an empty batch, always false while an estimate is ready.
    bool hasRoomFor(const Settings& settings) const;
    bool empty() const { return scenes_.empty() && ready_.empty(); }

    /// Adds a scene. Takes and throws what estimateTerrain does; after an exception the batch is
    /// unchanged.
    void add(std::size_t number, const Proprioception& s, std::span<const ArmReading> arm,
             const Settings& settings, const Watch& watch = {});

    /// Sweeps until at least one scene has ended, and removes the ended scenes. Returns nothing
    /// only if the batch is empty. Throws as estimateTerrain; the batch cannot continue after that.
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
