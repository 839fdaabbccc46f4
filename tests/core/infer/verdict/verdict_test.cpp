#include "core/infer/verdict/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace terratact {
namespace {

constexpr double kLimit = 0.10;

/// 1000 draws, of which `steps` rise by 0.2 m at +0.5 m.
TerrainEstimate estimateWith(int steps)
{
    TerrainEstimate e;
    e.ess.fill(1000.0);
    for (int d = 0; d < 1000; ++d) {
        Heights h{};
        if (d < steps) h[8] = h[9] = h[10] = 0.2;
        e.draws.push_back(h);
    }
    return e;
}

StepVerdict stepVerdict(int steps)
{
    return verdictOf(estimateWith(steps), Measurement{}, {}, kLimit).stepVerdict;
}

TEST(Verdict, isClearOrBlockedTwoMonteCarloSdFromTheLimit)
{
    // sd of p = 0.038: 0.0060, so that p + 2 sd is 0.0501; of 0.037: 0.0490
    EXPECT_EQ(stepVerdict(0), StepVerdict::Clear);
    EXPECT_EQ(stepVerdict(37), StepVerdict::Clear);
    EXPECT_EQ(stepVerdict(38), StepVerdict::CannotTell);
    EXPECT_EQ(stepVerdict(500), StepVerdict::CannotTell);
    EXPECT_EQ(stepVerdict(962), StepVerdict::CannotTell);
    EXPECT_EQ(stepVerdict(963), StepVerdict::Blocked);
    EXPECT_EQ(stepVerdict(1000), StepVerdict::Blocked);
}

TEST(Verdict, namesTheLikeliestPairAhead)
{
    TerrainEstimate e = estimateWith(300);
    for (Heights& h : e.draws) h[0] = 1.0;  // behind the robot: not part of the question
    const Verdict v = verdictOf(e, Measurement{}, {}, kLimit);
    EXPECT_DOUBLE_EQ(v.step.p, 0.3);
    EXPECT_EQ(v.likeliest, 7);
    EXPECT_DOUBLE_EQ(v.likeliestP, 0.3);
    EXPECT_DOUBLE_EQ(verdictOf(e, Measurement{}, {}, 0.25).step.p, 0.0);
}

TEST(Verdict, namesTheBinsAheadThatAreNotFelt)
{
    TerrainEstimate e = estimateWith(0);
    e.ceiling.fill(0.1);
    EXPECT_EQ(verdictOf(e, Measurement{}, {}, kLimit).unfelt, (std::vector<int>{}));
    for (const std::size_t bin : {0U, 8U, 9U, 10U})
        e.ceiling[bin] = std::numeric_limits<double>::infinity();
    e.origin[8] = Origin::Contact;
    EXPECT_EQ(verdictOf(e, Measurement{}, {}, kLimit).unfelt, (std::vector<int>{9, 10}));
    e.touch.fill(Touch::Felt);
    e.touch[9] = Touch::Bounded;
    e.touch[10] = Touch::NotFelt;
    const Verdict v = verdictOf(e, Measurement{}, {}, kLimit);
    EXPECT_EQ(v.unfelt, (std::vector<int>{9, 10}));
    EXPECT_EQ(v.bounded, (std::vector<int>{9}));
    EXPECT_EQ(unfeltMessage(v).english(), "bounded: +0.6 m; not felt: +0.7 m");
}

/// Everything ahead is felt up to `last`, the rest is open. Ceilings end with the felt bins.
TerrainEstimate estimateFeltTo(int last)
{
    TerrainEstimate e = estimateWith(0);
    e.touch.fill(Touch::Felt);
    e.ceiling.fill(0.0);
    for (int bin = last + 1; bin < kBins; ++bin) {
        e.touch[static_cast<std::size_t>(bin)] = Touch::NotFelt;
        e.ceiling[static_cast<std::size_t>(bin)] = std::numeric_limits<double>::infinity();
    }
    return e;
}

TEST(Verdict, clearEndsAtTheFeltHorizon)
{
    const Verdict v = verdictOf(estimateFeltTo(8), Measurement{}, {}, kLimit);
    EXPECT_EQ(v.stepVerdict, StepVerdict::Clear);
    EXPECT_NEAR(v.horizon, 0.55, 1e-9);
    EXPECT_DOUBLE_EQ(v.feltTo, v.horizon);
    EXPECT_EQ(stepVerdictMessage(v).english(), "CLEAR to +0.55 m");
    EXPECT_EQ(v.unfelt, (std::vector<int>{9, 10}));
    EXPECT_GE(v.step.p, 1.0 - 0.95 * 0.95 - 1e-9);  // two bins that nobody felt
    EXPECT_DOUBLE_EQ(v.toHorizon.p, 0.0);
}

TEST(Verdict, hoveringFlipperIsNeverClear)
{
    TerrainEstimate e = estimateFeltTo(8);
    for (const std::size_t bin : {7U, 8U}) e.touch[bin] = Touch::Bounded;
    const Verdict v = verdictOf(e, Measurement{}, {}, kLimit);
    EXPECT_EQ(v.stepVerdict, StepVerdict::CannotTell);
    EXPECT_EQ(v.shortfall, Shortfall::ShortHorizon);
    EXPECT_NEAR(v.horizon, 0.35, 1e-9);
    e.touch[6] = Touch::Bounded;
    EXPECT_EQ(verdictOf(e, Measurement{}, {}, kLimit).shortfall, Shortfall::NothingFelt);
}

TEST(Verdict, aPressAtThePivotIsNoPressOnNothing)
{
    TerrainEstimate e = estimateFeltTo(8);
    e.touch[6] = Touch::FeltInPart;
    for (const std::size_t bin : {7U, 8U}) e.touch[bin] = Touch::Bounded;
    e.feltTo = 0.31;
    const Verdict v = verdictOf(e, Measurement{}, {}, kLimit);
    EXPECT_EQ(v.shortfall, Shortfall::ShortHorizon);
    EXPECT_LT(v.horizon, 0.3);
}

TEST(Verdict, spannedGroundNeedsALowRate)
{
    TerrainEstimate e = estimateFeltTo(8);
    e.touch[6] = e.touch[7] = Touch::Bounded;
    e.touch[8] = Touch::FeltInPart;
    e.feltTo = 0.563;
    Verdict v = verdictOf(e, Measurement{}, {}, kLimit);
    EXPECT_EQ(v.stepVerdict, StepVerdict::CannotTell);
    EXPECT_EQ(v.shortfall, Shortfall::Spanned);
    EXPECT_EQ(v.help, Help::DriveOn);
    e.settings.hazardRate = 0.01;
    v = verdictOf(e, Measurement{}, {}, kLimit);
    EXPECT_EQ(v.stepVerdict, StepVerdict::Clear);
    EXPECT_NEAR(v.toHorizon.p, 1.0 - 0.99 * 0.99 * 0.99, 1e-9);
    EXPECT_NEAR(v.horizon, 0.55, 1e-9);
    EXPECT_NEAR(v.feltTo, 0.25, 1e-9);
    EXPECT_EQ(stepVerdictMessage(v).english(), "CLEAR to +0.55 m, nothing felt ahead");
}

TEST(Verdict, steepFlippersGetTheHelpToLieFlatter)
{
    TerrainEstimate e = estimateFeltTo(6);
    Measurement m;
    m.frontLeft = m.frontRight = -0.9;
    const Verdict v = verdictOf(e, m, {}, kLimit);
    EXPECT_EQ(v.stepVerdict, StepVerdict::CannotTell);
    EXPECT_EQ(v.help, Help::Flatten);
}

TEST(Verdict, oldRecordingHasNoHorizon)
{
    TerrainEstimate e = estimateFeltTo(6);
    e.touch = unrecordedTouch();
    const Verdict v = verdictOf(e, Measurement{}, {}, kLimit);
    EXPECT_EQ(v.stepVerdict, StepVerdict::Clear);
    EXPECT_FALSE(v.touchRecorded);
    EXPECT_EQ(stepVerdictMessage(v).english(), "CLEAR");
}

TEST(Verdict, isWithheldForEachSingleReason)
{
    struct Case {
        WithholdReason reason;
        void (*make)(TerrainEstimate&, Measurement&, LinkSinceScene&);
    };
    const Case cases[]{
        {WithholdReason::Stale,
         [](TerrainEstimate&, Measurement&, LinkSinceScene& a) { a.telemetryFresh = false; }},
        {WithholdReason::SensorFault,
         [](TerrainEstimate&, Measurement&, LinkSinceScene& a) { a.sensorsSound = false; }},
        {WithholdReason::Contradiction,
         [](TerrainEstimate& e, Measurement&, LinkSinceScene&) { e.contradicts = true; }},
        {WithholdReason::TelemetryGap,
         [](TerrainEstimate&, Measurement&, LinkSinceScene& a) { a.unbroken = false; }},
        {WithholdReason::NotConverged,
         [](TerrainEstimate& e, Measurement&, LinkSinceScene&) { e.converged = false; }},
        {WithholdReason::UnlikeTraining,
         [](TerrainEstimate& e, Measurement&, LinkSinceScene&) { e.novelty = 1.01; }},
        {WithholdReason::Roll,
         [](TerrainEstimate&, Measurement& m, LinkSinceScene&) { m.roll = -0.11; }},
        {WithholdReason::Asymmetry,
         [](TerrainEstimate&, Measurement& m, LinkSinceScene&) { m.rearLeft = 0.11; }},
        {WithholdReason::Differential,
         [](TerrainEstimate&, Measurement& m, LinkSinceScene&) { m.differential = -0.021; }}};
    for (const Case& c : cases) {
        TerrainEstimate e = estimateWith(1000);
        Measurement m;
        LinkSinceScene since;
        c.make(e, m, since);
        const Verdict v = verdictOf(e, m, since, kLimit);
        EXPECT_EQ(v.stepVerdict, StepVerdict::CannotTell) << describe(c.reason).english;
        EXPECT_EQ(v.withheldFor, std::vector{c.reason});
        EXPECT_DOUBLE_EQ(v.step.p, 1.0);  // the probability is still given
        EXPECT_STRNE(describe(c.reason).english, "");
    }
}

TEST(Verdict, cannotTellWithoutDraws)
{
    TerrainEstimate e = estimateWith(0);
    e.draws.clear();
    const Verdict v = verdictOf(e, Measurement{}, {}, kLimit);
    EXPECT_EQ(v.stepVerdict, StepVerdict::CannotTell);
    EXPECT_EQ(v.step.monteCarloSd, 1.0);
}

TEST(Verdict, refusesAnInvalidLimit)
{
    for (const double limit : {-0.1, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_THROW(verdictOf(estimateWith(0), Measurement{}, {}, limit), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
