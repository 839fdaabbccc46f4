#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/eval/claims.h"
#include "core/eval/evaluation.h"

namespace terratact {

/// One row per method, scene and bin:
///   run,t_s,method,bin_m,error_m,abs_error_m,in_band,source
/// error_m: mean − truth; in_band: 1 where the truth lies in the 80 % band.
/// Throws std::invalid_argument where an error's scene is not among the scenes.
std::string errorsCsv(std::span<const BinError> errors, std::span<const Scene> scenes);

/// One row per method and class: method,from_m,to_m,count,share.  to_m of the last class is empty: no end.
std::string fig8Csv(std::span<const ErrorHistogram> histograms);

/// One row per method and bin:
///   method,bin_m,n,q1_m,median_m,q3_m,mean_m,coverage,sampled,sampled_coverage
/// Of |error|; coverage of the 80 % band, and of sampled bins alone.  Bins without errors have no row.
std::string fig9Csv(std::span<const MethodSummary> summaries);

/// For a person: per method and bin the median (quartiles) of |error| [mm], then mean and coverage over all.
std::string evaluationTable(std::span<const MethodSummary> summaries);

/// For a person: per claim of the paper the verdict, and in a second line medians and interval [mm].
std::string claimsText(std::span<const ClaimResult> results);

}  // namespace terratact
