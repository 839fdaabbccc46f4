// Tests the catalogue of plotted signals: names, values of telemetry, estimates and frames, the live store.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/plotting/live_signals.h"
#include "app/plotting/telemetry_signals.h"
#include "tests/support/estimates.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

constexpr const char* kGasFile =
    "BO_ 1280 Gas: 4 P\n SG_ Oxygen : 0|16@1+ (0.01,0) [0|0] \"%\" C\n"
    "BO_ 1281 Gas: 4 P\n SG_ Oxygen : 0|16@1+ (0.01,0) [0|0] \"%\" C\n";

std::shared_ptr<const DbcBook> gasBook()
{
    const TemporaryDirectory directory;
    auto book = std::make_shared<DbcBook>();
    const Status added = book->add(directory.write("gas.dbc", kGasFile));
    EXPECT_TRUE(added) << added.error().text;
    return book;
}

CanFrame gas(std::uint32_t id, std::uint16_t hundredths)
{
    return {.id = id,
            .length = 4,
            .data = {static_cast<std::uint8_t>(hundredths & 0xFFU),
                     static_cast<std::uint8_t>(hundredths >> 8U)}};
}

BusFrame received(const CanFrame& frame, double time)
{
    return {.frame = frame, .time = time};
}

JudgedFrame unknownFrame()
{
    return {.trouble = FrameTrouble::Unknown};
}

JudgedFrame attitude(double pitch, double roll)
{
    FrameValidator validator;
    Unpacked content{.kind = FrameKind::Attitude};
    const FrameLayout& layout = layoutOf(FrameKind::Attitude);
    for (std::size_t i = 0; i < layout.payload.size(); ++i) {
        if (layout.payload[i].name == "Measured") content.values[i] = 1.0;
        if (layout.payload[i].name == "Pitch") content.values[i] = pitch;
        if (layout.payload[i].name == "Roll") content.values[i] = roll;
    }
    return validator.judge(pack(content), 0.0);
}

Received line(const Measurement& m, double time)
{
    Received r;
    r.sample.measurement = m;
    r.arrived = SteadyTime(
        std::chrono::duration_cast<SteadyTime::duration>(std::chrono::duration<double>(time)));
    return r;
}

SeriesSummary all(LiveSignals& signals, const std::string& key)
{
    return signals.view(key, {.from = 0.0, .to = 1000.0, .columns = 10, .cursor = 0.0}).visible;
}

TEST(SignalCatalogue, everyKeyIsUniqueAndHasAName)
{
    SignalCatalogue catalogue;
    std::set<std::string> keys;
    for (const PlotSignal& signal : catalogue.all()) {
        EXPECT_TRUE(keys.insert(signal.key()).second) << signal.key();
        EXPECT_FALSE(signal.name.empty()) << signal.key();
        EXPECT_EQ(signal.frame.empty(),
                  signal.origin != SignalOrigin::Bus || signal.key() == frameRateKey());
    }
    for (const auto& row : SignalCatalogue::usualRows())
        for (const std::string& key : row) EXPECT_TRUE(keys.contains(key)) << key;
    EXPECT_TRUE(keys.contains("bus:Attitude.Pitch"));
}

TEST(SignalCatalogue, payloadComesWithItsFrames)
{
    SignalCatalogue catalogue;
    const std::size_t before = catalogue.all().size();
    EXPECT_FALSE(catalogue.add(gas(1280, 0))) << "no file describes it";
    catalogue.describe(gasBook());
    EXPECT_TRUE(catalogue.add(gas(1280, 0)));
    EXPECT_FALSE(catalogue.add(gas(1280, 0)));
    EXPECT_TRUE(catalogue.add(gas(1281, 0)));
    EXPECT_FALSE(catalogue.add(gas(1282, 0)));
    const auto signals = catalogue.all();
    ASSERT_EQ(signals.size(), before + 2);
    const auto found = std::find_if(signals.begin(), signals.end(), [](const PlotSignal& s) {
        return s.key() == "payload:501 Gas.Oxygen";
    });
    ASSERT_NE(found, signals.end()) << "equal names at two identifiers are two signals";
    EXPECT_EQ(found->unit, "%");
    EXPECT_EQ(found->frame, "501 Gas");
}

TEST(TelemetrySignals, giveEachValueOfALine)
{
    Measurement m;
    m.pitch = 0.1;
    m.rearRight = 0.6;
    m.force[3] = 44.0;
    m.frontLeftCurrent = 3.0;
    m.travelled = 7.5;
    m.rearSides.right[5] = 12.0;
    m.missing.set(kRearCurrentFeature);
    m.missingMotors.set(1);
    m.missing.set(kFirstForceFeature + 1);
    const auto value = [&](const std::string& id) {
        const auto signals = telemetrySignals();
        const auto found = std::find_if(signals.begin(), signals.end(),
                                        [&](const PlotSignal& s) { return s.id == id; });
        EXPECT_NE(found, signals.end()) << id;
        return telemetryValue(static_cast<std::size_t>(found - signals.begin()), m);
    };
    EXPECT_EQ(value("pitch"), 0.1);
    EXPECT_EQ(value("rear_right"), 0.6);
    EXPECT_EQ(value("force4"), 44.0);
    EXPECT_EQ(value("front_current_left"), 3.0);
    EXPECT_EQ(value("front_current_right"), std::nullopt) << "not measured";
    EXPECT_EQ(value("travelled"), 7.5);
    EXPECT_EQ(value("rear_right_force6"), 12.0);
    EXPECT_EQ(value("rear_right_force5"), std::nullopt);
    EXPECT_EQ(value("rear_current_left"), std::nullopt) << "not measured";
    EXPECT_EQ(value("force2"), std::nullopt) << "not measured";
    EXPECT_EQ(value("turned"), std::nullopt);
    EXPECT_THROW(telemetryValue(telemetrySignals().size(), m), std::out_of_range);
}

TEST(EstimateSignals, knowErrorsOnlyWithTheTruth)
{
    const TwoTrackEstimate estimate = equalSides(stepEstimate());
    EstimateFacts facts{.estimate = estimate, .seconds = 0.5};
    const auto value = [&](const std::string& id) {
        const auto signals = estimateSignals();
        const auto found = std::find_if(signals.begin(), signals.end(),
                                        [&](const PlotSignal& s) { return s.id == id; });
        EXPECT_NE(found, signals.end()) << id;
        return estimateValues(facts).at(static_cast<std::size_t>(found - signals.begin()));
    };
    ASSERT_EQ(estimateValues(facts).size(), estimateSignals().size());
    EXPECT_EQ(value("p_step"), std::nullopt);
    EXPECT_EQ(value("seconds"), 0.5);
    EXPECT_EQ(value("sd_max.left"), 0.09);
    EXPECT_EQ(value("sd.right+0.7"), 0.08);
    EXPECT_EQ(value("height.left-0.3"), -0.25);
    EXPECT_EQ(value("error_mean.left"), std::nullopt);
    Heights truth = estimate.side[0].height;
    truth[4] += 0.11;
    facts.truth = truthOf(true, truth, std::nullopt);
    EXPECT_NEAR(*value("error_mean.right"), 0.01, 1e-12);
    EXPECT_NEAR(*value("error_max.left"), 0.11, 1e-12);
    EXPECT_NEAR(*value("error.left+0.1"), -0.11, 1e-12);
    facts.verdict = TwoTrackVerdict{};
    facts.verdict->either.p = 0.25;
    EXPECT_EQ(value("p_step"), 0.25);
    EXPECT_FALSE(truthOf(false, truth, std::nullopt)[0]) << "of both sides, not of one plane";
}

TEST(LiveSignals, keepEveryFrameOfChosenSignals)
{
    LiveSignals signals(0.0);
    signals.choose({"bus:Attitude.Pitch", "payload:500 Gas.Oxygen", "telemetry:roll"});
    signals.describe(gasBook());
    const JudgedFrame judged = attitude(0.25, -0.5);
    ASSERT_TRUE(judged.isSound());
    for (int i = 0; i < 750; ++i) signals.add(received({}, 10.0 + 0.001 * i), judged);
    JudgedFrame refused = judged;
    refused.trouble = FrameTrouble::WrongChecksum;
    signals.add(received({}, 11.0), refused);
    signals.add(received(gas(0x500, 2050), 11.0), unknownFrame());
    signals.add(received(gas(0x501, 100), 11.0), unknownFrame());
    Measurement m;
    m.roll = 0.125;
    signals.add(line(m, 12.0));
    EXPECT_EQ(all(signals, "bus:Attitude.Pitch").count, 750U);
    EXPECT_NEAR(all(signals, "bus:Attitude.Pitch").mean, 0.25, 1e-3);
    EXPECT_EQ(all(signals, "payload:500 Gas.Oxygen").count, 1U);
    EXPECT_NEAR(all(signals, "payload:500 Gas.Oxygen").last, 20.5, 1e-9);
    EXPECT_EQ(all(signals, "telemetry:roll").last, 0.125);
    EXPECT_EQ(all(signals, "telemetry:pitch").count, 0U) << "not chosen";
}

TEST(LiveSignals, omitAMissingCurrent)
{
    LiveSignals signals(0.0);
    signals.choose({"bus:FrontCurrents.Left", "bus:FrontCurrents.Right"});
    FrameValidator validator;
    const CanFrame frame = pack({.kind = FrameKind::FrontCurrents, .values = {0.0, 1.7, 1.0, 1.0}});
    signals.add(received(frame, 1.0), validator.judge(frame, 1.0));
    EXPECT_EQ(all(signals, "bus:FrontCurrents.Left").count, 0U);
    EXPECT_EQ(all(signals, "bus:FrontCurrents.Right").count, 1U);
}

TEST(LiveSignals, aNewChoiceKeepsTheSignalsOfBoth)
{
    LiveSignals signals(0.0);
    Measurement m;
    m.pitch = 1.0;
    signals.choose({"telemetry:roll", "telemetry:pitch"});
    signals.add(line(m, 1.0));
    const std::uint64_t version = signals.version();
    signals.choose({"telemetry:pitch", "estimate:seconds"});
    EXPECT_NE(signals.version(), version);
    signals.add(line(m, 2.0));
    EXPECT_EQ(all(signals, "telemetry:pitch").count, 2U);
    EXPECT_EQ(all(signals, "telemetry:roll").count, 0U);
    const TwoTrackEstimate estimate = equalSides(stepEstimate());
    signals.add({.estimate = estimate, .seconds = 0.5}, 3.0);
    signals.choose({"estimate:seconds", "estimate:sd_max.left"});
    EXPECT_EQ(all(signals, "estimate:seconds").count, 1U);
    EXPECT_EQ(all(signals, "estimate:sd_max.left").last, static_cast<double>(0.09F))
        << "the newest estimate is known to a signal chosen later";
    signals.choose(std::vector<std::string>(100, "telemetry:pitch"));
    signals.add(line(m, 4.0));
    EXPECT_EQ(all(signals, "telemetry:pitch").count, 1U) << "at most 12, and no crash";
}

TEST(LiveSignals, linesBridgeUsualPausesOnly)
{
    LiveSignals signals(0.0);
    signals.choose({"telemetry:pitch"});
    for (int i = 0; i <= 100; ++i) signals.add(line({}, 0.1 * i));
    const SeriesView view =
        signals.view("telemetry:pitch", {.from = 0.0, .to = 10.0, .columns = 1001, .cursor = 5.0});
    EXPECT_NEAR(view.breakAfter, 0.5, 1e-6);
    EXPECT_EQ(view.atCursor, 0.0);
    EXPECT_TRUE(signals.view("no:such", {}).columns.empty());
}

}  // namespace
}  // namespace terratact
