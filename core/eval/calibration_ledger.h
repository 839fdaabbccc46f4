#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/strip/carried_estimate.h"

namespace terratact {

/// A measurement and the band that was shown before it.
struct LedgerEntry {
    int bin = 0;
    /// Predictive probability of a lower measurement; uniform for calibrated bands.
    double pit = 0.0;
    double z = 0.0;  ///< (measured − mean) / √(sd² + measuredSd²)
    bool in50 = false, in80 = false,
         in95 = false;  ///< the measurement is within the predictive's central 50, 80, 95 %
    Origin by = Origin::Contact;
    bool operator==(const LedgerEntry&) const = default;
};

/// A share of n with its Wilson 95 % interval.
struct Coverage {
    double share = 0.0, low = 0.0, high = 1.0;
    bool operator==(const Coverage&) const = default;
};

/// Returns the Wilson interval: (k/n + c²/2n ± c √(k/n (1 − k/n)/n + c²/4n²)) / (1 + c²/n), c =
/// 1.96; 0 … 1 for n = 0. Throws std::invalid_argument for k > n. Source: Wilson, J. Am. Stat.
/// Assoc. 22 (1927).
Coverage wilson(std::size_t k, std::size_t n);

/// Calibration of the 80 % bands: whether they hold 80 % of the measurements. The Wilson interval
/// decides, once there are kMinEntries. A calibrated forecaster gets another verdict by chance in 4
/// to 7 %.
enum class Calibration : std::uint8_t { TooFew, TooNarrow, Calibrated, TooWide };

/// Least number of entries: with fewer, not even n hits of n would exclude 80 % (n > 4 c²).
inline constexpr std::size_t kMinEntries = 16;

/// Returns "too few", "too narrow", "calibrated" or "too wide".
std::string_view name(Calibration calibration);

/// Summary of a ledger; zero means and open intervals if n is 0.
struct LedgerSummary {
    std::size_t n = 0;
    Coverage in50, in80, in95;
    double meanZ = 0.0;  ///< far from 0: bands lie too low (above 0) or too high (below 0)
    double rmsZ = 0.0;   ///< above 1: bands are too narrow
    Calibration verdict = Calibration::TooFew;
};

/// Scores later measurements of a bin against the band shown before them, while the robot works and
/// without ground truth. The predictive of a measurement y of bin b is the shown draws with the
/// measurement's noise:
///   PIT = 1/n Σ_d Φ((y − h_b^d) / measuredSd)
/// A noisy instrument therefore cannot make a narrow band look wrong. An estimate without draws
/// counts as the normal of its mean and sd. Both estimates must be of the same pose, unless the
/// earlier one is carried to the later pose.
/// Entries of one pose share their error, so they are not independent. Entries of a probe are not
/// representative, because the probe goes where the band is widest.
class CalibrationLedger {
public:
    /// Adds a measurement `by` the arm or a contact; ignored if `shownBefore` had measured the bin.
    /// measured, measuredSd: [m]. Throws std::invalid_argument for a bin outside 0 … 10, and for
    /// Origin::Sampled, which measures nothing. It also throws unless the height is finite, and
    /// measuredSd is finite and above 0.
    void record(const TerrainEstimate& shownBefore, int bin, double measured, double measuredSd,
                Origin by);

    /// Adds every bin that was sampled in `before` and is measured in `after`. Its mean and sd in
    /// `after` are the measurement.
    void record(const TerrainEstimate& before, const TerrainEstimate& after);

    /// Adds measurements at a later pose, to which `before` was carried. Its carried bins count as
    /// shown, as normals. Bins whose nearest bin of `before` was measured are left out.
    void record(const TerrainEstimate& before, const CarriedEstimate& carried,
                const TerrainEstimate& after);

    void add(const CalibrationLedger& other);  ///< appends the entries of another ledger

    const std::vector<LedgerEntry>& entries() const { return entries_; }
    LedgerSummary summary() const;

private:
    std::vector<LedgerEntry> entries_;
};

}  // namespace terratact
