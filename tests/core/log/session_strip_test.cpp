#include "core/log/session_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/log/review_strip.h"
#include "tests/support/sessions/robot_session.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using At = RobotSessionTimes;

struct StripOfSession : testing::Test {
    void record(const std::vector<std::variant<EventRow, ModelRow>>& more)
    {
        const std::string path = directory.file(std::to_string(++recorded) + ".tts");
        auto writer = robotSession(path, 4.0);
        ASSERT_TRUE(writer) << writer.error().text;
        for (const auto& row : more)
            std::visit([&](const auto& r) { ASSERT_TRUE(writer->add(r)); }, row);
        ASSERT_TRUE(writer->seal());
        open(path);
    }
    void open(const std::string& path)
    {
        auto opened = SessionReader::open(path);
        ASSERT_TRUE(opened) << opened.error().text;
        reader.emplace(std::move(*opened));
    }
    EventRow event(double time, EventKind kind, const char* subject = "")
    {
        return {.id = ++id, .time = sessionTimeOf(time), .kind = kind, .subject = subject};
    }
    Strip at(double time)
    {
        SessionStrip strip(*reader, absolem());
        strip.goTo(sessionTimeOf(time));
        return strip.strip();
    }
    ReviewStrip::ViewState reviewed(double time)
    {
        ReviewMoments moments(*reader, absolem());
        return ReviewStrip(*reader, absolem()).at(moments.at(sessionTimeOf(time)));
    }

    TemporaryDirectory directory;
    std::optional<SessionReader> reader;
    std::int64_t id = 100;
    int recorded = 0;
};

constexpr double kStood = At::kForgotten - 0.2, kLater = At::kForgotten + 0.4;

TEST_F(StripOfSession, holdsTheEstimatesThatWereShown)
{
    record({});
    EXPECT_TRUE(at(At::kScene + 0.05).sections().empty());
    const Strip strip = at(kLater);
    ASSERT_EQ(strip.sections().size(), 1U);
    EXPECT_EQ(strip.sections()[0].columns.size(), std::size_t{kBins});
    const StripSource& source = strip.source(*strip.sections()[0].columns.begin()->second[0]);
    EXPECT_EQ(source.estimate, 2) << "that with the arm replaced the first";
    EXPECT_NEAR(source.time, At::kScene, 0.05);
    EXPECT_FALSE(strip.seen().isEmpty()) << "it stays when the estimate is left";
}

TEST_F(StripOfSession, aClearedEstimateIsTakenOutAndCanComeBack)
{
    record({event(kStood, EventKind::Decision, "forget")});
    EXPECT_TRUE(at(kStood + 0.05).sections().empty());
    record({event(kStood, EventKind::Decision, "forget"),
            event(kStood + 0.05, EventKind::Decision, "restore")});
    EXPECT_FALSE(at(kStood + 0.1).sections().empty());
    record({event(kLater - 0.1, EventKind::Decision, "forget")});
    EXPECT_FALSE(at(kLater).sections().empty()) << "the robot had left it before";
    EXPECT_EQ(at(kLater).whyNothing(), SectionStart::Cleared);
    record({event(kStood, EventKind::Decision, "abort")});
    EXPECT_TRUE(at(kLater).sections().empty());
    record({event(At::kAgain + 0.02, EventKind::Decision, "abort")});
    EXPECT_FALSE(at(kLater).sections().empty()) << "that ended the probe alone";
}

TEST_F(StripOfSession, aReviewCountsTouchesFromTheSessionsBegin)
{
    record({});
    const StripLedger ledger = at(kLater).ledger();
    EXPECT_GT(ledger.of(ScoredBy::Probe).n, 0U);
    EXPECT_EQ(reviewed(kLater).ledger, ledger);
    constexpr double kPart = 2.0 * (ReviewStrip::kMinLength + ReviewStrip::kStep);
    EXPECT_EQ(reviewed(kPart).ledger, std::nullopt) << "its strip begins later";
}

TEST_F(StripOfSession, aReviewReadsALongSessionFromItsBegin)
{
    constexpr double kLong = 1.5 * ReviewStrip::kWholes * ReviewStrip::kStep;
    record({event(kStood, EventKind::TelemetryGap), event(kLong, EventKind::Marker)});
    ReviewMoments moments(*reader, absolem());
    ReviewStrip strips(*reader, absolem());
    const auto shown = [&](double time) { return strips.at(moments.at(sessionTimeOf(time))); };
    EXPECT_TRUE(shown(kLong).earlier.empty()) << "it begins later";
    int changes = 0;
    for (int k = 0; k < 2 * kLong / ReviewStrip::kPart; ++k)
        changes += strips.readOn(sessionTimeOf(kLong)) ? 1 : 0;
    EXPECT_EQ(changes, 1);
    const Strip whole = at(kLong);
    ASSERT_EQ(whole.earlier().size(), 1U);
    const ReviewStrip::ViewState expected{whole.seen(), whole.earlier(), whole.whyNothing(),
                                          whole.ledger()};
    for (const double share : {1.0, 0.5, 0.999, 0.1, 1.0})
        EXPECT_EQ(shown(share * kLong), expected) << share;
}

TEST_F(StripOfSession, gapsAndModelsEndASection)
{
    record({event(kStood, EventKind::TelemetryGap)});
    EXPECT_EQ(at(kLater).whyNothing(), SectionStart::TelemetryGap);
    record({ModelRow{
        .id = 2, .time = sessionTimeOf(kStood), .name = "mine.ttm", .hash = std::string(64, 'd')}});
    EXPECT_EQ(at(kLater).whyNothing(), SectionStart::Cleared);
    EXPECT_EQ(at(kStood - 0.05).whyNothing(), std::nullopt);
}

/// Writes a session of a robot that drives 3 m at 0.2 m/s. Its pitch never changes by one count. It is explored at
/// the begin.
void recordStuckPitch(const std::string& path)
{
    const RobotModel robot = absolem();
    SessionStart start = someStart();
    start.robot = *readFile(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml", 1U << 16U);
    auto writer = SessionWriter::create(path, start);
    ASSERT_TRUE(writer) << writer.error().text;
    ASSERT_TRUE(
        writer->add(ModelRow{.id = 1, .name = "default.ttm", .hash = std::string(64, 'c')}));
    Measurement line;
    line.pitch = 0.05;
    line.turned = 0.0;
    for (int k = 0; k < 300; ++k) {
        const SessionTime time = sessionTimeOf(0.05 * k);
        line.travelled = 0.01 * k;
        const RobotStatus status{.epoch = 1, .activity = RobotActivity::Driving};
        std::vector<CanFrame> frames =
            framesOf(sensorLineOf(line, robot), static_cast<std::uint8_t>(k), lineExtent(robot));
        frames.insert(frames.begin(), frameOf(status, static_cast<std::uint8_t>(k)));
        for (const CanFrame& frame : frames)
            ASSERT_TRUE(writer->add(FrameRow{.time = time, .frame = frame}));
        if (k == 1) {
            SceneRow scene = someScene(1, time);
            scene.measurement.travelled = line.travelled;
            ASSERT_TRUE(writer->add(scene));
            ASSERT_TRUE(writer->add(someEstimate(1, time)));
        }
        ASSERT_TRUE(writer->commit());
    }
    ASSERT_TRUE(writer->seal());
}

TEST_F(StripOfSession, aStuckPitchEndsASection)
{
    const std::string path = directory.file("stuck.tts");
    ASSERT_NO_FATAL_FAILURE(recordStuckPitch(path));
    open(path);
    EXPECT_FALSE(at(0.5).seen().isEmpty());
    const Strip later = at(10.0);
    EXPECT_TRUE(later.seen().isEmpty());
    EXPECT_EQ(later.whyNothing(), SectionStart::Suspected);
}

TEST_F(StripOfSession, bothSidesOfARecordedDriveDiffer)
{
    open(TERRATACT_SOURCE_DIR "/resources/sessions/two_tracks.tts");
    const Strip strip = at(secondsOf(reader->end()));
    ASSERT_FALSE(strip.sections().empty());
    const auto& columns = strip.sections().back().columns;
    EXPECT_TRUE(std::ranges::any_of(columns, [](const auto& entry) {
        const auto& [left, right] = entry.second;
        return left && right && left->band != right->band;
    }));
}

TEST_F(StripOfSession, feelForwardLeavesALongStrip)
{
    const std::string path = TERRATACT_SOURCE_DIR "/resources/sessions/feel_forward.tts";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "make_feel_forward.sh records it";
    open(path);
    const SeenStrip seen = reviewed(secondsOf(reader->end())).seen;
    ASSERT_FALSE(seen.side[0].empty());
    EXPECT_GT(seen.side[0].back().x - seen.side[0].front().x, 2.0);
}

TEST_F(StripOfSession, aReviewedMomentIsTheSameForAnyOrderOfRequests)
{
    record({event(kLater - 0.1, EventKind::TelemetryGap)});
    ReviewMoments moments(*reader, absolem());
    ReviewStrip strips(*reader, absolem());
    for (const double time : {kLater, kStood, 0.1, kStood + 0.05, kStood, kLater})
        EXPECT_EQ(strips.at(moments.at(sessionTimeOf(time))), reviewed(time)) << time;
    EXPECT_EQ(reviewed(kLater).why, SectionStart::TelemetryGap);
    EXPECT_FALSE(reviewed(kStood).seen.isEmpty());
}

}  // namespace
}  // namespace terratact
