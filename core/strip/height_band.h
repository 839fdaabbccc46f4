#pragma once

namespace terratact {

/// A height and its uncertainty [m].
struct HeightBand {
    double height = 0.0, sd = 0.0, q10 = 0.0, q90 = 0.0;
    bool operator==(const HeightBand&) const = default;
};

/// Returns the band with an independent error of sd w [m] added:
///   sd² → sd² + w²,   |q − height|² → |q − height|² + (1.28 w)²
HeightBand widened(const HeightBand& band, double w);

/// Returns the band moved up by `up` [m].
HeightBand raised(const HeightBand& band, double up);

/// Rule for a place that is in two estimates.
enum class Fusion {
    /// the newer one, unless only the older one was felt and is more certain (core/strip/strip.h)
    FeltFirst,
    Newest,       ///< the newer one
    MoreCertain,  ///< the one with the smaller sd: covariance intersection of two scalars
    /// the mean by precision, with the sd of covariance intersection at equal weights:
    /// 1/sd² = ½ (1/sd_a² + 1/sd_b²)
    Intersection,
    Independent,  ///< the mean by precision, as if the errors were independent
};

/// Returns the band of two bands of one height. Both are of the same frame and moment.
HeightBand fused(const HeightBand& older, const HeightBand& newer, Fusion fusion);

}  // namespace terratact
