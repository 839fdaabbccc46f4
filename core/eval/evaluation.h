#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/eval/scores.h"
#include "core/infer/estimate/estimate.h"
#include "core/learn/data/scene.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// What a method's results are called: its name.  Where one method is evaluated more than once, by settings
/// other than the method, what tells them apart belongs behind it after a '/'.
std::string labelOf(const Settings& settings);

/// One bin of one estimate beside the truth.
struct BinError {
    std::size_t scene = 0;  ///< index among the scenes of the evaluation
    std::string label;      ///< of the method or baseline
    int bin = 0;
    double error = 0.0;  ///< [m] height of the estimate − truth
    ForecastScores scores{};
    Origin origin = Origin::Sampled;
    double novelty = 0.0;  ///< of the scene, as the method judged it; 0: not judged
    bool operator==(const BinError&) const = default;
};

/// The errors of one estimate, rear to front: all bins whose truth is known, the fixed ones too (the paper
/// counts them).
std::vector<BinError> binErrors(std::size_t sceneIndex, const Scene& scene,
                                const std::string& label, const TerrainEstimate& estimate);

/// The labels, in the order in which they were evaluated.
std::vector<std::string> labelsOf(std::span<const BinError> errors);

/// The errors of one label.
std::vector<BinError> errorsOf(std::string_view label, std::span<const BinError> errors);

/// What is said about a set of errors [m].  Zero everywhere when n is 0.
struct ErrorStatistics {
    std::size_t n = 0;
    double q1 = 0.0, median = 0.0, q3 = 0.0;  ///< of |error|, as the paper's Fig. 9
    double mean = 0.0;                        ///< of |error|
    double crps = 0.0;                        ///< mean
    double coverage50 = 0.0;                  ///< share with the truth in the 50 % band
    double coverage = 0.0;                    ///< in the 80 % band
    double coverage95 = 0.0;                  ///< in the 95 % band
    double width = 0.0;                       ///< mean, of the 80 % band
    std::size_t sampled = 0;                  ///< how many were neither contact nor arm
    double sampledCoverage = 0.0;             ///< coverage of those alone
    bool operator==(const ErrorStatistics&) const = default;
};
ErrorStatistics statistics(std::span<const BinError> errors);

/// Bins −0.3 … 0.5: under or beside the robot, where touch can tell something.
inline constexpr int kLastNearBin = 8;

struct MethodSummary {
    std::string label;
    std::array<ErrorStatistics, kBins> bin{};
    ErrorStatistics all{};
    ErrorStatistics near{};  ///< bins up to kLastNearBin
};

/// One summary per label, in the order of labelsOf: Fig. 9 of the paper.
std::vector<MethodSummary> summarise(std::span<const BinError> errors);

/// Bins whose centre lies under the front flippers, between the pivot and the far end of the tip circle.
/// Not fixed: it depends on pitch and flipper angle; none where the flippers stand upright between centres.
std::vector<int> binsUnderFrontFlipper(const RobotModel& robot, const Proprioception& s);

/// The errors in the bins listed for their scene.  bins: one list per scene, else std::invalid_argument.
std::vector<BinError> errorsInBins(std::span<const BinError> errors,
                                   std::span<const std::vector<int>> bins);

/// How often a number fell into [k · width, (k + 1) · width); the last class has no upper end.
struct ErrorHistogram {
    std::string label;
    double width = 0.0;
    std::vector<std::size_t> count;
    std::size_t n = 0;
};

/// Of |error|: one histogram per label, in the order of labelsOf; of errorsInBins: Fig. 8 of the paper.
/// width: [m].  Throws std::invalid_argument unless width > 0 and classes ≥ 1.
std::vector<ErrorHistogram> histograms(std::span<const BinError> errors, double width, int classes);

/// Of the PIT values, `classes` equal classes of 0 … 1: level where the forecasts are calibrated, high at
/// both ends where the bands are too narrow.  Throws std::invalid_argument unless classes ≥ 1.
std::vector<ErrorHistogram> pitHistograms(std::span<const BinError> errors, int classes);

}  // namespace terratact
