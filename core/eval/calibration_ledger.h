#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/verdict/ghost.h"

namespace terratact {

/// One measurement beside the band that was shown before it.
struct LedgerEntry {
    int bin = 0;
    double pit =
        0.0;  ///< predictive probability of a lower measurement; uniform where bands are honest
    double z = 0.0;  ///< (measured − mean) / √(sd² + measuredSd²)
    bool in50 = false, in80 = false,
         in95 = false;  ///< within the predictive's central 50, 80, 95 %
    Origin by = Origin::Contact;
    bool operator==(const LedgerEntry&) const = default;
};

/// A share of n with its Wilson 95 % interval.
struct Coverage {
    double share = 0.0, low = 0.0, high = 1.0;
    bool operator==(const Coverage&) const = default;
};

/// (k/n + c²/2n ± c √(k/n (1 − k/n)/n + c²/4n²)) / (1 + c²/n), c = 1.96; 0 … 1 for n = 0.
/// Throws std::invalid_argument for k > n.  Source: Wilson, J. Am. Stat. Assoc. 22 (1927).
Coverage wilson(std::size_t k, std::size_t n);

/// Whether 80 % bands hold 80 % of the measurements: decided by the Wilson interval, once there are
/// kMinEntries.  An honest forecaster is called something else by chance in 4 to 7 %.
enum class Calibration : std::uint8_t { TooFew, TooNarrow, Honest, TooWide };

/// With fewer not even n hits of n would exclude 80 %: n > 4 c².
inline constexpr std::size_t kMinEntries = 16;

/// "too few", "too narrow", "honest", "too wide".
std::string_view name(Calibration calibration);

/// Zero means and open intervals when n is 0.
struct LedgerSummary {
    std::size_t n = 0;
    Coverage in50, in80, in95;
    double meanZ = 0.0;  ///< far from 0: bands lie too low (above 0) or too high
    double rmsZ = 0.0;   ///< above 1: bands too narrow
    Calibration verdict = Calibration::TooFew;
};

/// Scores every later measurement of a bin against the band shown before it, while the robot works and
/// without any ground truth.  The predictive of a measurement y of bin b is the shown draws with the
/// measurement's noise,
///   PIT = 1/n Σ_d Φ((y − h_b^d) / measuredSd),
/// so a wide instrument cannot make a narrow band look wrong; an estimate without draws counts as the
/// normal of its mean and sd.  Both estimates must be of the same pose, unless a ghost leads from one to the other.
/// Entries of one pose share their error and count as less than that many independent ones; so do a
/// probe's, which is sent where the band is widest.
class CalibrationLedger {
public:
    /// Takes a measurement `by` the arm or a contact; left out where `shownBefore` had measured the bin.
    /// measured, measuredSd: [m].  Throws std::invalid_argument for a bin outside 0 … 10, a height not
    /// finite, unless measuredSd > 0 and finite, and for Origin::Sampled, which measures nothing.
    void record(const TerrainEstimate& shownBefore, int bin, double measured, double measuredSd,
                Origin by);

    /// Takes every bin that was sampled in `before` and is a contact or the arm's in `after`, with mean and
    /// sd of `after` as the measurement.
    void record(const TerrainEstimate& before, const TerrainEstimate& after);

    /// Likewise at a later pose, where `moved` is the ghost of `before`: its bins are the shown ones, as normals.
    /// Left out are bins where the nearest of `before` was measured.
    void record(const TerrainEstimate& before, const Ghost& moved, const TerrainEstimate& after);

    void add(const CalibrationLedger& other);  ///< its entries behind these

    const std::vector<LedgerEntry>& entries() const { return entries_; }
    LedgerSummary summary() const;

private:
    std::vector<LedgerEntry> entries_;
};

}  // namespace terratact
