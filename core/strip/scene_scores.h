#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/infer/estimate/two_track_estimate.h"
#include "core/robot/measurement.h"
#include "core/strip/strip_ledger.h"

namespace terratact {

/// Bands of an estimate that is shown.
struct ShownBands {
    struct Bin {
        HeightBand band;
        bool isProbed = false;
    };
    std::array<std::array<Bin, kBins>, 2> side{};
    bool onePlane = false;
};

/// Scores of the strip's bands, with those of the last scene kept apart, because they may be taken out. Contacts and
/// passes of a scene count once, by its first estimate. A probe scores the estimate of its scene that was shown before
/// it, unless the arm had measured that bin.
class SceneScores {
public:
    /// Begins a scene: the scores of the scenes before it are final.
    void beginScene();
    /// Scores the readings that were not scored yet in this scene against the last estimate shown in it.
    void addProbes(std::span<const ArmReading> arm);
    /// Adds contacts and passes of the scene. hasTouches(): they were added already.
    void addTouches(const StripLedger& touches) { touches_ = touches; }
    bool hasTouches() const { return touches_.has_value(); }
    /// Notes that an estimate of the scene is shown.
    void show(const TwoTrackEstimate& estimate);
    /// Takes contacts and passes of the scene out, because its estimate was taken back. A probe stays: it was made.
    void takeBack();

    StripLedger all() const;

private:
    StripLedger before_, probes_;
    std::optional<StripLedger> touches_;
    std::optional<ShownBands> shown_;
    std::vector<ArmReading> scored_;
};

}  // namespace terratact
