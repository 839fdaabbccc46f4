#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/base/for_each.h"
#include "core/infer/estimate/estimate.h"
#include "core/learn/model/model.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// A simple guess at the heights of one scene and how far off it usually is, both [m].
struct BandForecast {
    Heights height{};
    Heights sd{};  ///< above 0
};

/// What a method has to beat.  Immutable once fitted; safe to share between threads.
class Baseline {
public:
    virtual ~Baseline() = default;
    virtual std::string_view name() const = 0;
    /// Throws std::invalid_argument where s lacks a feature of missingFeature(needs(), s).
    virtual BandForecast forecast(const Proprioception& s) const = 0;
    virtual FeatureSet needs() const { return FeatureSet::Paf; }
};

/// The four baselines, fitted on a model's training rows (heights U × 11, features U × 11):
///   flat     the plane of the tracks' lower edge at the measured pitch; sd: root mean square of the
///            residuals per bin
///   linear   least squares of each height on [1, s]; sd: √(residual sum of squares / (U − rank))
///   nearest  the heights of the row with the least Euclidean distance in s, every feature divided by its
///            sd over the rows; sd: root mean square of what the 20 nearest differ from it
///   gp-s     one exact Gaussian process per bin on s alone, hyper-parameters from at most 400 evenly
///            chosen rows, prediction from at most 1000; sd: its own
/// A feature that never varies takes no part.  An sd is at least 1 mm.
/// forEach runs the eleven searches of gp-s.  Throws std::invalid_argument for fewer than 30 rows.
std::vector<std::unique_ptr<Baseline>> fitBaselines(const RobotModel& robot, const ModelData& model,
                                                    const ForEach& forEach);

/// A forecast in the form of an estimate: height = mean, a Gaussian band, and `draws` joint draws, the
/// bins independent; ceilings of the robot's body.  s: throws as Baseline::forecast.
TerrainEstimate baselineEstimate(const Baseline& baseline, const RobotModel& robot,
                                 const Proprioception& s, std::uint64_t seed, int draws = 200);

}  // namespace terratact
