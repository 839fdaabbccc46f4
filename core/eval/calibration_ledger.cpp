#include "core/eval/calibration_ledger.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/named.h"
#include "core/base/normal.h"

namespace terratact {
namespace {

constexpr auto kCalibrationNames =
    namesOf<Calibration>("too few", "too narrow", "calibrated", "too wide");

constexpr double kWilson = 1.959963984540054;  // Φ⁻¹(0.975)
constexpr double kPromised = 0.80;             // nominal coverage of the shown bands

/// Returns the predictive probability of a measurement below `measured`.
double pitOf(const TerrainEstimate& shown, std::size_t bin, double measured, double measuredSd)
{
    if (shown.draws.empty())
        return normalCdf((measured - shown.mean[bin]) / std::hypot(shown.sd[bin], measuredSd));
    double sum = 0.0;
    for (const Heights& h : shown.draws) sum += normalCdf((measured - h[bin]) / measuredSd);
    return sum / static_cast<double>(shown.draws.size());
}

Calibration verdictOf(std::size_t n, const Coverage& in80)
{
    if (n < kMinEntries) return Calibration::TooFew;
    if (in80.high < kPromised) return Calibration::TooNarrow;
    if (in80.low > kPromised) return Calibration::TooWide;
    return Calibration::Calibrated;
}

}  // namespace

Coverage wilson(std::size_t k, std::size_t n)
{
    if (k > n) throw std::invalid_argument("wilson: more hits than trials");
    if (n == 0) return {};
    const auto count = static_cast<double>(n);
    const double share = static_cast<double>(k) / count;
    const double c2 = kWilson * kWilson / count;
    const double middle = share + 0.5 * c2;
    const double half = std::sqrt(c2 * (share * (1.0 - share) + 0.25 * c2));
    return {share, (middle - half) / (1.0 + c2), (middle + half) / (1.0 + c2)};
}

std::string_view name(Calibration calibration)
{
    return nameIn(kCalibrationNames, calibration);
}

void CalibrationLedger::record(const TerrainEstimate& shownBefore, int bin, double measured,
                               double measuredSd, Origin by)
{
    if (bin < 0 || bin >= kBins) throw std::invalid_argument("CalibrationLedger: no such bin");
    if (!std::isfinite(measured) || !(measuredSd > 0.0) || !std::isfinite(measuredSd))
        throw std::invalid_argument("CalibrationLedger: not a measurement");
    if (by == Origin::Sampled)
        throw std::invalid_argument("CalibrationLedger: a sampled height is no measurement");
    const auto i = static_cast<std::size_t>(bin);
    if (shownBefore.origin[i] != Origin::Sampled) return;

    const double pit = pitOf(shownBefore, i, measured, measuredSd);
    const double z = (measured - shownBefore.mean[i]) / std::hypot(shownBefore.sd[i], measuredSd);
    const auto within = [pit](double share) { return std::abs(pit - 0.5) <= 0.5 * share; };
    entries_.push_back({.bin = bin,
                        .pit = pit,
                        .z = z,
                        .in50 = within(0.50),
                        .in80 = within(0.80),
                        .in95 = within(0.95),
                        .by = by});
}

void CalibrationLedger::record(const TerrainEstimate& before, const TerrainEstimate& after)
{
    for (std::size_t i = 0; i < kBins; ++i)
        if (before.origin[i] == Origin::Sampled && after.origin[i] != Origin::Sampled)
            record(before, static_cast<int>(i), after.mean[i], after.sd[i], after.origin[i]);
}

void CalibrationLedger::record(const TerrainEstimate& before, const CarriedEstimate& carried,
                               const TerrainEstimate& after)
{
    TerrainEstimate shown;
    for (std::size_t i = 0; i < kBins; ++i) {
        const double x = binCentre(static_cast<int>(i)) + carried.motion.forward;
        const auto nearest = std::lround((x - binCentre(0)) / kBinWidth);
        const auto& bin = carried.bin[i];
        const bool counts = bin && nearest >= 0 && nearest < kBins
                         && before.origin[static_cast<std::size_t>(nearest)] == Origin::Sampled;
        shown.origin[i] = counts ? Origin::Sampled : Origin::Contact;
        if (!counts) continue;
        shown.mean[i] = bin->height;
        shown.sd[i] = bin->sd;
    }
    record(shown, after);
}

void CalibrationLedger::add(const CalibrationLedger& other)
{
    entries_.insert(entries_.end(), other.entries_.begin(), other.entries_.end());
}

LedgerSummary CalibrationLedger::summary() const
{
    LedgerSummary s;
    s.n = entries_.size();
    if (s.n == 0) return s;
    std::size_t in50 = 0, in80 = 0, in95 = 0;
    double squares = 0.0;
    for (const LedgerEntry& e : entries_) {
        in50 += e.in50 ? 1U : 0U;
        in80 += e.in80 ? 1U : 0U;
        in95 += e.in95 ? 1U : 0U;
        s.meanZ += e.z / static_cast<double>(s.n);
        squares += e.z * e.z / static_cast<double>(s.n);
    }
    s.rmsZ = std::sqrt(squares);
    s.in50 = wilson(in50, s.n);
    s.in80 = wilson(in80, s.n);
    s.in95 = wilson(in95, s.n);
    s.verdict = verdictOf(s.n, s.in80);
    return s;
}

}  // namespace terratact
