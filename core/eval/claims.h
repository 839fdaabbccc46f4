#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/eval/cluster_bootstrap.h"
#include "core/eval/evaluation.h"
#include "core/infer/estimate/variant.h"

namespace terratact {

/// One claim of the paper's section 5.2: in bins first … last, `better` has smaller errors than
/// `base`.
struct Claim {
    std::string_view text;
    Method base = Method::Pa;
    Method better = Method::Pac;
    int firstBin = 0;
    int lastBin = 0;
};

/// The paper's three claims. 1. Ceilings improve bins −0.3 … 0.2. 2. Forces improve bins 0.3 … 0.5.
/// 3. The arm improves bins 0.6 and 0.7.
inline constexpr std::array kClaims{
    Claim{"the body's ceilings improve bins -0.3 to 0.2", Method::Pa, Method::Pac, 0, 5},
    Claim{"the flipper forces improve bins 0.3 to 0.5", Method::Pac, Method::Pafc, 6, 8},
    Claim{"the arm improves bins 0.6 and 0.7", Method::Pafc, Method::Pafac, 9, 10},
};

enum class ClaimVerdict : std::uint8_t { Holds, DoesNotHold, NotDecided };

/// Returns "holds", "does not hold" or "not decided".
std::string_view name(ClaimVerdict verdict);

struct ClaimResult {
    Claim claim;
    ClaimVerdict verdict = ClaimVerdict::NotDecided;
    std::size_t n = 0;     ///< compared errors: bins that both methods estimated
    std::size_t runs = 0;  ///< drives of these errors
    double baseMedian = 0.0, betterMedian = 0.0;  ///< [m] median |error|
    double low = 0.0,
           high = 0.0;  ///< 95 % interval of betterMedian − baseMedian [m]; 0 without a bootstrap
};

/// Judges a claim by the difference of the two medians of |error|. Its 95 % interval is the
/// percentile bootstrap over whole drives (Scene::run), with the same drives for both methods. An
/// interval below 0: holds; above 0: does not hold; else, or with fewer than kMinRuns drives: not
/// decided.
/// A method's errors are those labelled with its name. The same errors, scenes and seed give the
/// same result. Throws std::invalid_argument if an error's scene is not among the scenes, or
/// resamples < 1. Source: see core/eval/cluster_bootstrap.h.
ClaimResult judge(const Claim& claim, std::span<const BinError> errors,
                  std::span<const Scene> scenes, std::uint64_t seed, int resamples = 2000);

}  // namespace terratact
