#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/eval/claims.h"
#include "core/eval/confidence.h"
#include "core/eval/evaluation.h"
#include "core/eval/groups.h"
#include "core/eval/probes.h"
#include "core/eval/step_forecasts.h"

namespace terratact {

/// Computation time of a method.
struct MethodTime {
    std::string label;
    double perScene = 0.0;  ///< [s]
};

// CSV files. The column `method` holds the label; lengths are in metres, shares are fractions of 1.

/// One row per method, scene and bin:
///   run,t_s,method,bin_m,error_m,abs_error_m,in_band,source,crps_m,pit,in_50,in_95,width_m,novelty
/// error_m: height − truth; in_band, in_50, in_95: 1 if the truth is in the 80, 50, 95 % band; width_m: width of the 80
/// % band; novelty: empty if not computed.
/// Throws std::invalid_argument if an error's scene is not among the scenes.
std::string errorsCsv(std::span<const BinError> errors, std::span<const Scene> scenes);

/// One row per method and class: method,from_m,to_m,count,share. to_m of the last class is empty: unbounded.
std::string fig8Csv(std::span<const ErrorHistogram> histograms);

/// One row per method and bin:
///   method,bin_m,n,q1_m,median_m,q3_m,mean_m,coverage,sampled,sampled_coverage,crps_m
/// Quartiles and mean are those of |error|. coverage: of the 80 % band; sampled_coverage: of sampled bins only. Bins
/// without errors have no row.
std::string fig9Csv(std::span<const MethodSummary> summaries);

/// One row per method and class: method,from,to,count,share.
std::string pitCsv(std::span<const ErrorHistogram> histograms);

/// One row per method and bin, and one for "all": method,bin_m,n,in_50,in_80,in_95,width_m.
std::string coverageCsv(std::span<const MethodSummary> summaries);

/// One row per method over all bins. Intervals are 95 %, and empty for fewer than kMinRuns drives:
///   method,n,drives,near_median_m,near_median_low_m,near_median_high_m,median_m,…,mean_m,…,crps_m,…,
///   coverage,…,coverage_50,coverage_95,width_m,scene_s
std::string scoresCsv(std::span<const MethodSummary> summaries,
                      std::span<const Confidence> confidences, std::span<const MethodTime> times);

/// One row per group and method: <kind>,method,scenes,n,median_m,mean_m,crps_m,coverage.
std::string groupsCsv(std::string_view kind, std::span<const GroupSummary> groups);

/// One row per method and place, with the interval of scoresCsv:
///   method,place,n,observed_share,brier,brier_low,brier_high,reliability,resolution,uncertainty
std::string brierCsv(std::span<const BrierSummary> summaries);

/// One row per method, place and non-empty class of forecasts:
///   method,place,from,to,n,mean_forecast,observed_share
std::string reliabilityCsv(std::span<const BrierSummary> summaries);

/// One row per method and rule:
///   method,rule,scenes,probed,ahead_before_m,ahead_after_m,all_before_m,all_after_m,probes_needed,settled
std::string probesCsv(std::span<const ProbeSummary> summaries);

// Tables for the terminal [mm].

/// Returns the median (quartiles) of |error| per method and bin, and mean and coverage over all bins.
std::string evaluationTable(std::span<const MethodSummary> summaries);

/// Returns the scores of each method over all bins with intervals, and its time.
std::string scoresTable(std::span<const MethodSummary> summaries,
                        std::span<const Confidence> confidences, std::span<const MethodTime> times);

/// Returns the coverage of the 80 % band per method and bin.
std::string coverageTable(std::span<const MethodSummary> summaries);

/// Returns median, mean, CRPS and coverage per group and method.
std::string groupsTable(std::string_view kind, std::span<const GroupSummary> groups);

/// Returns the Brier score and its parts per place and method, and the reliability of each class.
std::string stepsTable(std::span<const BrierSummary> summaries, double limit);

/// Returns the gain of one probe and the number of probes needed, per method and rule.
std::string probesTable(std::span<const ProbeSummary> summaries, const ProbeLimits& limits);

/// Returns the verdict on each claim of the paper, with medians and interval in a second line.
std::string claimsText(std::span<const ClaimResult> results);

}  // namespace terratact
