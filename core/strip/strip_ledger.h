#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/strip/height_band.h"

namespace terratact {

/// Touch that scores an earlier prediction of the strip.
enum class ScoredBy : std::uint8_t {
    Contact,  ///< the front flippers pressed on the bin at a later scene
    Probe,    ///< the arm measured it
    Pass,     ///< the tracks stood on it at a later scene
};
inline constexpr std::array kScoredBy{ScoredBy::Contact, ScoredBy::Probe, ScoredBy::Pass};

/// Returns "contact", "probe" or "pass".
std::string_view name(ScoredBy by);

/// Predicted heights against heights that were felt later.
struct StripScore {
    std::size_t n = 0;        ///< touches
    std::size_t in80 = 0;     ///< touches within the 80 % band of the predicted reading
    double sumZ = 0.0;        ///< Σ z,  z = (felt − predicted) / √(sd² + touchSd²)
    double sumSquares = 0.0;  ///< Σ z²

    StripScore& operator+=(const StripScore& other);
    double meanZ() const { return n > 0 ? sumZ / static_cast<double>(n) : 0.0; }
    double rmsZ() const;
    bool operator==(const StripScore&) const = default;
};

/// Counts how well the strip's bands held when their ground was touched again, for each kind of touch. The error of the
/// felt height widens the band (widened()). Touches of one scene share the error of its pose, so they are not
/// independent.
class StripLedger {
public:
    /// Returns true if a touch can score a band: the height is finite, and so is √(sd² + feltSd²), above 0.
    static bool canScore(const HeightBand& predicted, double felt, double feltSd);
    /// Scores a band against a height that is felt later with an sd. `predicted` must not depend on the touch. Throws
    /// std::invalid_argument unless canScore().
    void add(ScoredBy by, const HeightBand& predicted, double felt, double feltSd);

    StripLedger& operator+=(const StripLedger& other);
    const StripScore& of(ScoredBy by) const { return scores_[static_cast<std::size_t>(by)]; }
    StripScore all() const;
    bool operator==(const StripLedger&) const = default;

private:
    std::array<StripScore, kScoredBy.size()> scores_{};
};

}  // namespace terratact
