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

/// Returns the label of a method's results: its name. If a method is evaluated several times with
/// other settings, the caller appends them after a '/'.
std::string labelOf(const Settings& settings);

/// Error of one bin of one estimate.
struct BinError {
    std::size_t scene = 0;  ///< index among the scenes of the evaluation
    std::string label;      ///< label of the method or the baseline
    int bin = 0;
    double error = 0.0;  ///< [m] height of the estimate − truth
    ForecastScores scores{};
    Origin origin = Origin::Sampled;
    double novelty = 0.0;  ///< novelty of the scene by this method; 0: not judged
    double truthSd = 0.0;  ///< [m] of the true height, which the scores count; 0: exact
    bool operator==(const BinError&) const = default;
};

/// Returns the errors of one estimate, rear to front: all bins whose truth is known. Fixed bins
/// count too, as in the paper.
std::vector<BinError> binErrors(std::size_t sceneIndex, const Scene& scene,
                                const std::string& label, const TerrainEstimate& estimate);

/// Returns the labels, in the order of their evaluation.
std::vector<std::string> labelsOf(std::span<const BinError> errors);

/// Returns the errors of one label.
std::vector<BinError> errorsOf(std::string_view label, std::span<const BinError> errors);

/// Statistics of a set of errors [m]. All are zero if n is 0.
struct ErrorStatistics {
    std::size_t n = 0;
    double q1 = 0.0, median = 0.0, q3 = 0.0;  ///< quartiles of |error|, as in the paper's Fig. 9
    double mean = 0.0;                        ///< mean |error|
    double crps = 0.0;                        ///< mean CRPS
    double coverage50 = 0.0;                  ///< share with the truth in the 50 % band
    double coverage = 0.0;                    ///< share with the truth in the 80 % band
    double coverage95 = 0.0;                  ///< share with the truth in the 95 % band
    double width = 0.0;                       ///< mean width of the 80 % band
    std::size_t sampled = 0;                  ///< number of bins that were neither contact nor arm
    double sampledCoverage = 0.0;             ///< coverage of the sampled bins
    bool operator==(const ErrorStatistics&) const = default;
};
ErrorStatistics statistics(std::span<const BinError> errors);

/// Part of a measured truth in the errors.
struct TruthShare {
    std::size_t n = 0;         ///< errors
    std::size_t measured = 0;  ///< of them against a truth with an sd
    double sd = 0.0;           ///< [m] root mean square of the truth's sd
    double share = 0.0;        ///< Σ sd² / Σ error²: what remains with a perfect estimate
};
/// Bands and scores already count this sd (forecastScores).
TruthShare truthShare(std::span<const BinError> errors);

/// Last bin near the robot: bins −0.3 … 0.5 are under or beside it, where touch can give
/// information.
inline constexpr int kLastNearBin = 8;

struct MethodSummary {
    std::string label;
    std::array<ErrorStatistics, kBins> bin{};
    ErrorStatistics all{};
    ErrorStatistics near{};  ///< bins up to kLastNearBin
};

/// Returns one summary per label, in the order of labelsOf: Fig. 9 of the paper.
std::vector<MethodSummary> summarise(std::span<const BinError> errors);

/// Returns the bins whose centre lies under the front flippers, between pivot and far end of the
/// tip circle. They depend on pitch and flipper angle; there is none if upright flippers lie
/// between centres.
std::vector<int> binsUnderFrontFlipper(const RobotModel& robot, const Proprioception& s);

/// Returns the errors in the bins listed for their scene. bins: one list per scene. Throws
/// std::invalid_argument otherwise.
std::vector<BinError> errorsInBins(std::span<const BinError> errors,
                                   std::span<const std::vector<int>> bins);

/// Counts of values in [k · width, (k + 1) · width); the last class has no upper end.
struct ErrorHistogram {
    std::string label;
    double width = 0.0;
    std::vector<std::size_t> count;
    std::size_t n = 0;
};

/// Returns histograms of |error|, one per label, in the order of labelsOf. With errorsInBins: Fig.
/// 8 of the paper. width: [m]. Throws std::invalid_argument unless width > 0 and classes ≥ 1.
std::vector<ErrorHistogram> histograms(std::span<const BinError> errors, double width, int classes);

/// Returns histograms of the PIT values in `classes` equal classes of 0 … 1. They are level for
/// calibrated forecasts, and high at both ends for bands that are too narrow. Throws
/// std::invalid_argument unless classes ≥ 1.
std::vector<ErrorHistogram> pitHistograms(std::span<const BinError> errors, int classes);

}  // namespace terratact
