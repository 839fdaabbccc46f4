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

/// How long a method took.
struct MethodTime {
    std::string label;
    double perScene = 0.0;  ///< [s]
};

// Files.  A column `method` holds the label; lengths are in metres, shares of 1.

/// One row per method, scene and bin:
///   run,t_s,method,bin_m,error_m,abs_error_m,in_band,source,crps_m,pit,in_50,in_95,width_m,novelty
/// error_m: height − truth; in_band, in_50, in_95: 1 where the truth lies in the 80, 50, 95 % band; width_m
/// of the 80 % band; novelty: empty where it was not judged.
/// Throws std::invalid_argument where an error's scene is not among the scenes.
std::string errorsCsv(std::span<const BinError> errors, std::span<const Scene> scenes);

/// One row per method and class: method,from_m,to_m,count,share.  to_m of the last class is empty: no end.
std::string fig8Csv(std::span<const ErrorHistogram> histograms);

/// One row per method and bin:
///   method,bin_m,n,q1_m,median_m,q3_m,mean_m,coverage,sampled,sampled_coverage,crps_m
/// Of |error|; coverage of the 80 % band, and of sampled bins alone.  Bins without errors have no row.
std::string fig9Csv(std::span<const MethodSummary> summaries);

/// One row per method and class: method,from,to,count,share.
std::string pitCsv(std::span<const ErrorHistogram> histograms);

/// One row per method and bin, and one for "all": method,bin_m,n,in_50,in_80,in_95,width_m.
std::string coverageCsv(std::span<const MethodSummary> summaries);

/// One row per method over all bins, intervals of 95 %, empty for fewer than kMinRuns drives:
///   method,n,drives,near_median_m,near_median_low_m,near_median_high_m,median_m,…,mean_m,…,crps_m,…,
///   coverage,…,coverage_50,coverage_95,width_m,scene_s
std::string scoresCsv(std::span<const MethodSummary> summaries,
                      std::span<const Confidence> confidences, std::span<const MethodTime> times);

/// One row per group and method: <kind>,method,scenes,n,median_m,mean_m,crps_m,coverage.
std::string groupsCsv(std::string_view kind, std::span<const GroupSummary> groups);

/// One row per method and place, the interval as in scoresCsv:
///   method,place,n,observed_share,brier,brier_low,brier_high,reliability,resolution,uncertainty
std::string brierCsv(std::span<const BrierSummary> summaries);

/// One row per method, place and class of the forecasts that is not empty:
///   method,place,from,to,n,mean_forecast,observed_share
std::string reliabilityCsv(std::span<const BrierSummary> summaries);

/// One row per method and rule:
///   method,rule,scenes,probed,ahead_before_m,ahead_after_m,all_before_m,all_after_m,probes_needed,settled
std::string probesCsv(std::span<const ProbeSummary> summaries);

// Tables for a person, [mm].

/// Per method and bin the median (quartiles) of |error|, then mean and coverage over all.
std::string evaluationTable(std::span<const MethodSummary> summaries);

/// Per method the scores over all bins with their intervals, and its time.
std::string scoresTable(std::span<const MethodSummary> summaries,
                        std::span<const Confidence> confidences, std::span<const MethodTime> times);

/// Per method and bin how often the 80 % band covers.
std::string coverageTable(std::span<const MethodSummary> summaries);

/// Per group and method median, mean, CRPS and coverage.
std::string groupsTable(std::string_view kind, std::span<const GroupSummary> groups);

/// Per place and method the Brier score and its parts, then the reliability of each class.
std::string stepsTable(std::span<const BrierSummary> summaries, double limit);

/// Per method and rule what one probe gains, and how many are needed.
std::string probesTable(std::span<const ProbeSummary> summaries, const ProbeLimits& limits);

/// Per claim of the paper the verdict, and in a second line medians and interval.
std::string claimsText(std::span<const ClaimResult> results);

}  // namespace terratact
