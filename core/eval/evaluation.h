#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/infer/estimate.h"
#include "core/learn/scene.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// One bin of one estimate beside the truth.
struct BinError {
    std::size_t scene = 0;  ///< index among the scenes of the evaluation
    Method method = Method::Pa;
    int bin = 0;
    double error = 0.0;   ///< [m] mean of the estimate − truth
    bool inBand = false;  ///< q10 ≤ truth ≤ q90
    Origin origin = Origin::Sampled;
    bool operator==(const BinError&) const = default;
};

/// The errors of one estimate, rear to front: all bins whose truth is known, the fixed ones too (the paper
/// counts them).  The method is the one in the estimate's settings.
std::vector<BinError> binErrors(std::size_t sceneIndex, const Scene& scene,
                                const TerrainEstimate& estimate);

/// What is said about a set of errors [m].  Zero everywhere when n is 0.
struct ErrorStatistics {
    std::size_t n = 0;
    double q1 = 0.0, median = 0.0, q3 = 0.0;  ///< of |error|, as the paper's Fig. 9
    double mean = 0.0;                        ///< of |error|
    double coverage = 0.0;                    ///< share with the truth in the 80 % band
    std::size_t sampled = 0;                  ///< how many were neither contact nor arm
    double sampledCoverage = 0.0;             ///< coverage of those alone
};
ErrorStatistics statistics(std::span<const BinError> errors);

struct MethodSummary {
    Method method = Method::Pa;
    std::array<ErrorStatistics, kBins> bin{};
    ErrorStatistics all;
};

/// One summary per method that has errors, in the order of kMethods: Fig. 9 of the paper.
std::vector<MethodSummary> summarise(std::span<const BinError> errors);

/// Bins whose centre lies under the front flippers, between the pivot and the far end of the tip circle.
/// Not fixed: it depends on pitch and flipper angle; none where the flippers stand upright between centres.
std::vector<int> binsUnderFrontFlipper(const RobotModel& robot, const Proprioception& s);

/// The errors in the bins listed for their scene.  bins: one list per scene, else std::invalid_argument.
std::vector<BinError> errorsInBins(std::span<const BinError> errors,
                                   std::span<const std::vector<int>> bins);

/// How often |error| fell into [k · width, (k + 1) · width); the last class has no upper end.
struct ErrorHistogram {
    Method method = Method::Pa;
    double width = 0.0;  ///< [m]
    std::vector<std::size_t> count;
    std::size_t n = 0;
};

/// One histogram per method that has errors, in the order of kMethods; of errorsInBins: Fig. 8 of the paper.
/// Throws std::invalid_argument unless width > 0 and classes ≥ 1.
std::vector<ErrorHistogram> histograms(std::span<const BinError> errors, double width, int classes);

}  // namespace terratact
