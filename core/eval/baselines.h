#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/base/for_each.h"
#include "core/infer/estimate/estimate.h"
#include "core/learn/model/model.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Baseline forecast of one scene's heights, and its usual error [m].
struct BandForecast {
    Heights height{};
    Heights sd{};  ///< above 0
};

/// A simple predictor that a method has to beat. Immutable once fitted; may be shared between
/// threads.
class Baseline {
public:
    virtual ~Baseline() = default;
    virtual std::string_view name() const = 0;
    /// Throws std::invalid_argument if s lacks a feature of missingFeature(needs(), s).
    virtual BandForecast forecast(const Proprioception& s) const = 0;
    virtual FeatureSet needs() const { return FeatureSet::Paf; }
};

/// Fits the four baselines to a model's training rows (heights U × 11, features U × 11):
///   flat     the plane of the tracks' lower edge at the measured pitch; sd: root mean square of the
///            residuals per bin
///   linear   least squares of each height on [1, s]; sd: √(residual sum of squares / (U − rank))
///   nearest  the heights of the row with the least Euclidean distance in s, every feature divided by
///            its sd over the rows; sd: root mean square difference of the 20 nearest rows
///   gp-s     one exact Gaussian process per bin on s alone, hyperparameters from at most 400 evenly
///            chosen rows, prediction from at most 1000; sd: its own
/// A feature that never varies is ignored. An sd is at least 1 mm. forEach runs the eleven searches
/// of gp-s. Throws std::invalid_argument for fewer than 30 rows.
std::vector<std::unique_ptr<Baseline>> fitBaselines(const RobotModel& robot, const ModelData& model,
                                                    const ForEach& forEach);

/// Returns a forecast as an estimate. height = mean, the band is Gaussian, and `draws` joint draws
/// have independent bins. Ceilings are those of the robot's body. s: throws as Baseline::forecast.
TerrainEstimate baselineEstimate(const Baseline& baseline, const RobotModel& robot,
                                 const Proprioception& s, std::uint64_t seed, int draws = 200);

}  // namespace terratact
