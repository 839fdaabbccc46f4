#include "core/eval/calibration_ledger.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/support/distributions.h"

namespace terratact {
namespace {

constexpr double kSd = 0.05;
constexpr double kMeasuredSd = 0.02;

/// Returns bins of a normal with `sd` around 0, given by draws.
TerrainEstimate shown(double sd, int draws, unsigned seed)
{
    std::mt19937_64 rng(seed);
    std::normal_distribution<double> normal(0.0, sd);
    TerrainEstimate e;
    e.sd.fill(sd);
    e.draws.resize(static_cast<std::size_t>(draws));
    for (Heights& h : e.draws)
        for (double& value : h) value = normal(rng);
    return e;
}

/// Returns `n` measurements of heights from N(0, kSd²) against bands that claim claimedSd.
CalibrationLedger ledgerOf(double claimedSd, int n, unsigned seed)
{
    std::mt19937_64 rng(seed);
    std::normal_distribution<double> normal;
    const TerrainEstimate before = shown(claimedSd, 2000, seed + 1000);
    CalibrationLedger ledger;
    for (int k = 0; k < n; ++k)
        ledger.record(before, k % kBins, kSd * normal(rng) + kMeasuredSd * normal(rng), kMeasuredSd,
                      k % 2 == 0 ? Origin::Arm : Origin::Contact);
    return ledger;
}

TEST(CalibrationLedger, acceptsACalibratedForecaster)
{
    const CalibrationLedger ledger = ledgerOf(kSd, 1000, 1);
    const LedgerSummary s = ledger.summary();
    EXPECT_EQ(s.n, 1000U);
    EXPECT_NEAR(s.in50.share, 0.50, 4.0 * std::sqrt(0.25 / 1000));
    EXPECT_NEAR(s.in80.share, 0.80, 4.0 * std::sqrt(0.16 / 1000));
    EXPECT_NEAR(s.in95.share, 0.95, 4.0 * std::sqrt(0.0475 / 1000));
    EXPECT_NEAR(s.meanZ, 0.0, 4.0 / std::sqrt(1000.0));
    EXPECT_NEAR(s.rmsZ, 1.0, 4.0 / std::sqrt(2000.0));

    std::vector<double> pit;
    for (const LedgerEntry& e : ledger.entries()) pit.push_back(e.pit);
    EXPECT_LT(kolmogorov(pit, [](double u) { return u; }), 2.23);
}

TEST(CalibrationLedger, seldomMisjudgesACalibratedForecaster)
{
    // The Wilson interval of 40 entries excludes the true 80 % in 7.2 % of cases: in 14.3 ± 3.7 of
    // 200 ledgers.
    int wronged = 0;
    for (unsigned seed = 1; seed <= 200; ++seed)
        wronged += ledgerOf(kSd, 40, seed).summary().verdict != Calibration::Calibrated ? 1 : 0;
    EXPECT_LE(wronged, 29);
}

TEST(CalibrationLedger, findsBandsTooNarrowOrTooWide)
{
    const LedgerSummary narrow = ledgerOf(kSd / 3.0, 200, 2).summary();
    EXPECT_EQ(narrow.verdict, Calibration::TooNarrow);
    EXPECT_GT(narrow.rmsZ, 1.5);
    EXPECT_LT(narrow.in80.high, 0.8);
    const LedgerSummary wide = ledgerOf(3.0 * kSd, 200, 2).summary();
    EXPECT_EQ(wide.verdict, Calibration::TooWide);
    EXPECT_LT(wide.rmsZ, 0.6);
    EXPECT_GT(wide.in80.low, 0.8);
}

TEST(CalibrationLedger, givesNoVerdictFromFewEntries)
{
    EXPECT_EQ(CalibrationLedger().summary().verdict, Calibration::TooFew);
    EXPECT_EQ(CalibrationLedger().summary().in80, Coverage{});
    EXPECT_EQ(ledgerOf(kSd / 20.0, 15, 3).summary().verdict, Calibration::TooFew);
    EXPECT_EQ(ledgerOf(kSd / 20.0, 16, 3).summary().verdict, Calibration::TooNarrow);
    EXPECT_EQ(ledgerOf(20.0 * kSd, 16, 3).summary().verdict, Calibration::TooWide);
}

TEST(CalibrationLedger, scoresOneMeasurementExactly)
{
    TerrainEstimate before;
    before.mean[4] = -0.1;
    before.sd[4] = 0.03;
    CalibrationLedger ledger;
    ledger.record(before, 4, -0.05, 0.04, Origin::Arm);  // without draws: N(−0.1, 0.05²)
    before.draws.assign(3, {});
    before.draws[2][4] = -0.2;
    ledger.record(before, 4, 0.0, 0.01, Origin::Contact);
    ASSERT_EQ(ledger.entries().size(), 2U);
    const LedgerEntry& first = ledger.entries()[0];
    EXPECT_EQ(first.bin, 4);
    EXPECT_EQ(first.by, Origin::Arm);
    EXPECT_DOUBLE_EQ(first.z, 1.0);
    EXPECT_NEAR(first.pit, 0.841344746, 1e-9);
    EXPECT_FALSE(first.in50);
    EXPECT_TRUE(first.in80 && first.in95);
    EXPECT_NEAR(ledger.entries()[1].pit, 2.0 / 3.0, 1e-12);  // draws at 0, 0 and −0.2
}

TEST(CalibrationLedger, countsOnlyBinsThatWereNotMeasuredBefore)
{
    TerrainEstimate before = shown(kSd, 100, 4);
    before.origin[5] = Origin::Contact;
    TerrainEstimate after = before;
    after.origin[7] = Origin::Contact;
    after.mean[7] = 0.04;
    after.sd[7] = 0.02;
    after.origin[9] = Origin::Arm;
    after.mean[9] = -0.2;
    after.sd[9] = 0.03;
    after.origin[5] = Origin::Arm;
    CalibrationLedger ledger;
    ledger.record(before, 5, 0.0, 0.03, Origin::Arm);
    EXPECT_TRUE(ledger.entries().empty());
    ledger.record(before, after);
    ASSERT_EQ(ledger.entries().size(), 2U);
    EXPECT_EQ(ledger.entries()[0].bin, 7);
    EXPECT_EQ(ledger.entries()[0].by, Origin::Contact);
    EXPECT_DOUBLE_EQ(ledger.entries()[0].z, 0.04 / std::hypot(kSd, 0.02));
    EXPECT_EQ(ledger.entries()[1].bin, 9);
    EXPECT_FALSE(ledger.entries()[1].in95);
    EXPECT_EQ(ledger.entries()[1].by, Origin::Arm);
}

TEST(CalibrationLedger, scoresTheCarriedBandAtALaterPose)
{
    TerrainEstimate before;
    before.sd.fill(kSd);
    before.origin[5] = Origin::Contact;
    CarriedEstimate carried;
    carried.motion.forward = 1.04 * kBinWidth;  // bin 4 of now is nearest to the earlier bin 5
    for (int bin = 0; bin + 1 < kBins; ++bin)
        carried.bin[static_cast<std::size_t>(bin)] = HeightBand{0.01 * bin, 0.06, 0.0, 0.0};
    TerrainEstimate after;
    for (const int bin : {4, 6, 10}) {
        const auto i = static_cast<std::size_t>(bin);
        after.origin[i] = Origin::Contact;
        after.mean[i] = 0.1;
        after.sd[i] = 0.02;
    }
    CalibrationLedger ledger;
    ledger.record(before, carried, after);
    ASSERT_EQ(ledger.entries().size(), 1U) << "bin 4 had been measured, bin 10 is not carried";
    EXPECT_EQ(ledger.entries()[0].bin, 6);
    EXPECT_EQ(ledger.entries()[0].by, Origin::Contact);
    EXPECT_DOUBLE_EQ(ledger.entries()[0].z, (0.1 - 0.06) / std::hypot(0.06, 0.02));

    CalibrationLedger both = ledger;
    both.add(ledger);
    EXPECT_EQ(both.entries().size(), 2U);
    EXPECT_EQ(both.entries()[1], ledger.entries()[0]);
}

TEST(CalibrationLedger, refusesWhatIsNoMeasurement)
{
    CalibrationLedger ledger;
    const TerrainEstimate e = shown(kSd, 10, 5);
    const double endless = std::numeric_limits<double>::infinity();
    EXPECT_THROW(ledger.record(e, -1, 0.0, 0.03, Origin::Arm), std::invalid_argument);
    EXPECT_THROW(ledger.record(e, kBins, 0.0, 0.03, Origin::Arm), std::invalid_argument);
    EXPECT_THROW(ledger.record(e, 0, endless, 0.03, Origin::Arm), std::invalid_argument);
    EXPECT_THROW(ledger.record(e, 0, 0.0, 0.0, Origin::Arm), std::invalid_argument);
    EXPECT_THROW(ledger.record(e, 0, 0.0, endless, Origin::Arm), std::invalid_argument);
    EXPECT_THROW(ledger.record(e, 0, 0.0, 0.03, Origin::Sampled), std::invalid_argument);
}

TEST(Wilson, matchesPublishedValues)
{
    // Newcombe, Stat. Med. 17 (1998), table I, method 3: 81 of 263, 15 of 148, 0 of 20, 1 of 29.
    EXPECT_NEAR(wilson(81, 263).low, 0.2553, 5e-5);
    EXPECT_NEAR(wilson(81, 263).high, 0.3662, 5e-5);
    EXPECT_NEAR(wilson(15, 148).low, 0.0624, 5e-5);
    EXPECT_NEAR(wilson(15, 148).high, 0.1605, 5e-5);
    EXPECT_NEAR(wilson(0, 20).low, 0.0, 1e-15);
    EXPECT_NEAR(wilson(0, 20).high, 0.1611, 5e-5);
    EXPECT_NEAR(wilson(1, 29).high, 0.1718, 5e-5);
    EXPECT_GT(wilson(16, 16).low, 0.8);
    EXPECT_LT(wilson(15, 15).low, 0.8);
    EXPECT_THROW(wilson(2, 1), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
