// Tests the session commands: recomputed estimates, logs, tables, merged sessions, reports.
#include <cblas.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

#include "app/cli/session_commands.h"
#include "app/figures/canvas.h"
#include "app/figures/session_report.h"
#include "app/recording/mcap_writer.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "core/infer/verdict/ghost_track.h"
#include "core/learn/data/scene_file.h"
#include "core/log/later_poses.h"
#include "core/store/sha256.h"
#include "core/wire/telemetry_listener.h"
#include "tests/support/recorded_session.h"
#include "tests/support/refusal.h"
#include "tests/support/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

constexpr const char* kModel = TERRATACT_SOURCE_DIR "/resources/models/default.ttm";
constexpr const char* kRobot = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml";

/// Returns the largest of the numbers that follow `key` in the text.
double largest(const std::string& text, const std::string& key)
{
    double most = 0.0;
    for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1))
        most = std::max(most, std::strtod(text.c_str() + at + key.size(), nullptr));
    return most;
}

struct Tools : testing::Test {
    Tools() { openblas_set_num_threads(1); }

    /// Writes a session of the shipped robot with the rows that `fill` adds.
    template <class Fill>
    std::string session(const std::string& name, Fill fill, std::int64_t laterBy = 0)
    {
        const std::string path = directory.file(name);
        SessionStart start = someStart();
        start.wallTime += laterBy;
        start.robot = contentOf(kRobot);
        auto writer = SessionWriter::create(path, start);
        EXPECT_TRUE(writer) << writer.error().text;
        fill(*writer);
        EXPECT_TRUE(writer->seal());
        return path;
    }

    std::string exported(const std::string& path, const std::string& name,
                         std::optional<ExportKind> what = {})
    {
        auto reader = SessionReader::open(path);
        EXPECT_TRUE(reader);
        const std::string out = directory.file(name);
        counts = *writeExport(*reader, out, *exportFormatOf(out), {.what = what});
        return contentOf(out);
    }

    TemporaryDirectory directory;
    ExportCounts counts;
};

struct Drive : Tools {
    static void SetUpTestSuite()
    {
        openblas_set_num_threads(1);
        folder = new TemporaryDirectory;
        recordDrive(folder->file("drive.tts"));
        models = new Models(readModel(kModel)->data, *readRobotModel(kRobot));
    }
    static void TearDownTestSuite()
    {
        delete models;
        delete folder;
    }

    SessionReader reader = *SessionReader::open(folder->file("drive.tts"));

    static TemporaryDirectory* folder;
    static const Models* models;
};
TemporaryDirectory* Drive::folder = nullptr;
const Models* Drive::models = nullptr;

TEST_F(Drive, estimatesComeOutAgainBitForBit)
{
    ASSERT_GE(reader.estimates().size(), 3U);
    EXPECT_FALSE(reader.estimates().back().readings.empty()) << "no probe in this drive";
    for (const EstimateRow& row : reader.estimates()) {
        const auto before = recordedEstimate(reader, row);
        ASSERT_TRUE(before) << before.error().text;
        const auto again = estimateAgain(reader, row, *models, row.estimate.settings);
        ASSERT_TRUE(again) << again.error().text;
        const Measurement& scene = reader.scene(row.scene)->measurement;
        const Differences same = differencesBetween(*before, *again, scene, row.stepLimit);
        EXPECT_EQ(same.likeness, Match::Identical) << row.id;
        EXPECT_EQ(same.largest(), 0.0);
        EXPECT_EQ(same.before, same.after);

        Settings other = row.estimate.settings;
        other.seed += 1;
        const auto moved = estimateAgain(reader, row, *models, other);
        ASSERT_TRUE(moved);
        EXPECT_EQ(differencesBetween(*before, *moved, scene, row.stepLimit).likeness, Match::Other);
    }
}

TEST_F(Drive, recomputedEstimatesUseTheArmReadings)
{
    EstimateRow row = reader.estimates().back();
    const auto with = estimateAgain(reader, row, *models, row.estimate.settings);
    const std::size_t bin = static_cast<std::size_t>(row.readings.at(0).bin);
    row.readings.clear();
    const auto without = estimateAgain(reader, row, *models, row.estimate.settings);
    ASSERT_TRUE(with && without);
    EXPECT_EQ(with->origin[bin], Origin::Arm);
    EXPECT_NE(without->origin[bin], Origin::Arm);
}

TEST_F(Drive, rowsThatCannotBeEstimatedAreErrorsWithTheFile)
{
    EstimateRow row = reader.estimates().front();
    Settings wrong = row.estimate.settings;
    wrong.contactSd = 0.0;
    wrong.draws = 0;
    EXPECT_TRUE(refused(estimateAgain(reader, row, *models, wrong), reader.path(), {"estimate 1"}));
    row.scene = 77;
    EXPECT_TRUE(refused(estimateAgain(reader, row, *models, row.estimate.settings), reader.path(),
                        {"scene is not there"}));
}

/// Integrates all frames by hand, to know where a scene's estimate lies at the next scene.
TEST_F(Drive, estimatesAreFollowedToTheScenesBehindTheirs)
{
    const RobotModel robot = *readRobotModel(kRobot);
    const TerrainEstimate& estimate = reader.estimates()[1].estimate;
    const SceneRow &scene = reader.scenes()[0], &next = reader.scenes()[1];
    GhostTrack track(robot, estimate, scene.measurement);
    TelemetryListener listener(robot);
    for (std::size_t batch = 0; batch < reader.batches().size(); ++batch)
        for (const FrameRow& row : reader.frames(batch)) {
            const auto measurement = listener.receive(row.frame, secondsOf(row.time));
            if (measurement && row.time > scene.time && row.time <= next.time)
                track.add(*measurement);
        }
    ASSERT_TRUE(track.ghost());

    const std::array given{EstimateOfScene{0, &estimate},
                           EstimateOfScene{1, &reader.estimates()[3].estimate}};
    const std::vector<LaterPose> poses = laterPoses(reader, robot, given);
    ASSERT_EQ(poses.size(), 1U) << "there is no scene behind the second";
    EXPECT_EQ(poses[0].estimate, 0U);
    EXPECT_EQ(poses[0].scene, 1U);
    const Ghost &ghost = poses[0].ghost, &expected = *track.ghost();
    EXPECT_NEAR(ghost.motion.forward, expected.motion.forward, 1e-12);
    EXPECT_NEAR(ghost.motion.forward, *next.measurement.travelled - *scene.measurement.travelled,
                0.01);
    for (std::size_t i = 0; i < kBins; ++i) {
        if (!expected.bin[i]) continue;
        ASSERT_TRUE(ghost.bin[i]) << i;
        EXPECT_NEAR(ghost.bin[i]->height, expected.bin[i]->height, 1e-9) << i;
    }
    const auto known = [](const Ghost& g) {
        return std::count_if(g.bin.begin(), g.bin.end(),
                             [](const auto& b) { return b.has_value(); });
    };
    EXPECT_GT(known(ghost), known(expected)) << "bins of the training set alone go along";
    const EstimateOfScene none{2, &estimate};
    EXPECT_THROW(laterPoses(reader, robot, {&none, 1}), std::invalid_argument);
}

TEST_F(Drive, modelsAreFoundByTheirHash)
{
    const ModelRow& row = reader.models().front();
    const std::array both{std::string(kRobot), std::string(kModel)};
    EXPECT_EQ(*modelFileOf(row, both), kModel);
    const auto none = modelFileOf(row, std::span(both).first(1));
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().text.find("default.ttm"), std::string::npos);
    EXPECT_NE(none.error().text.find(sha256OfFile(kRobot)->substr(0, 12)), std::string::npos);
}

TEST_F(Drive, theReportHasWhatWasDecidedAndFitsItsPage)
{
    auto report = *reportOf(reader, 0);
    ASSERT_EQ(report.table.size(), 12U);
    ASSERT_TRUE(report.figure.previous);
    ASSERT_FALSE(report.events.empty());
    EXPECT_NE(report.events[0].find("approve"), std::string::npos);
    EXPECT_NE(report.events[0].find("on the screen"), std::string::npos);
    // Too many for the page; its last line counts the rest.
    report.events.assign(400, report.events[0]);
    const std::string path = directory.file("page.svg");
    ASSERT_TRUE(writeReport(path, report));
    const std::string page = contentOf(path);
    EXPECT_GT(largest(page, "y=\""), 1600.0) << "the page is not used";
    EXPECT_LT(largest(page, "\" y=\""), 1754.0 - 30.0);
    EXPECT_LT(largest(page, " x=\""), 1240.0 - 30.0);
    EXPECT_TRUE(refused(reportOf(reader, 9), reader.path(), {"no scene 9"}));
}

TEST(Differences, tellsBitsApartThatCompareEqual)
{
    const TerrainEstimate zero = [] {
        TerrainEstimate e = stepEstimate();
        e.mean[3] = 0.0;
        return e;
    }();
    TerrainEstimate minus = zero;
    minus.mean[3] = -0.0;
    ASSERT_EQ(zero, minus);
    const auto likeness = [&](const TerrainEstimate& other) {
        return differencesBetween(zero, other, {}, 0.1).likeness;
    };
    EXPECT_EQ(likeness(zero), Match::Identical);
    EXPECT_EQ(likeness(minus), Match::LastBits);
    TerrainEstimate moved = zero;
    moved.height[8] += 0.02;
    moved.height[2] -= 0.05;
    const Differences d = differencesBetween(zero, moved, {}, 0.1);
    EXPECT_EQ(d.largestBin, 2);
    EXPECT_NEAR(d.largest(), 0.05, 1e-12);
    EXPECT_NEAR(d.bin[8].height, 0.02, 1e-12);
    EXPECT_EQ(d.likeness, Match::Other);
}

TEST(Differences, areLastBitsIfNumbersAreNearAndTextsEqual)
{
    TerrainEstimate recorded = stepEstimate();
    recorded.draws.assign(3, Heights{});
    recorded.ess.fill(400.0);
    const auto likenessAfter = [&](const auto& change) {
        TerrainEstimate other = recorded;
        change(other);
        return differencesBetween(recorded, other, {}, 0.1).likeness;
    };
    using Estimate = TerrainEstimate;
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.q90[2] += 0.9e-6; }), Match::LastBits);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.draws[2][5] -= 0.9e-6; }), Match::LastBits);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.ess[2] += 3e-4; }), Match::LastBits);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.q90[2] += 1.1e-6; }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.draws[2][5] -= 1.1e-6; }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.ess[2] += 5e-4; }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.sd[2] = std::nan(""); }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.draws.pop_back(); }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.warnings.emplace_back("other"); }), Match::Other);
}

TEST_F(Tools, logsHaveEveryFrameTheirFormatSupports)
{
    const std::string path = session("kinds.tts", [](SessionWriter& writer) {
        const auto add = [&](CanFrame frame, bool sent) {
            ASSERT_TRUE(writer.add(FrameRow{.time = 1'500'000, .frame = frame, .sent = sent}));
        };
        add({.id = 0x123, .length = 2, .data = {0x01, 0xAB}}, true);
        add({.id = 0x12345678, .extended = true, .length = 0}, false);
        add({.id = 0x123, .remote = true, .length = 4}, false);
        add({.id = 0x4, .error = true, .length = 8}, false);
        add({.id = 0x123, .fd = true, .length = 3, .data = {1, 2, 3}}, false);
        add({.id = 0x123, .fd = true, .length = 12, .data = {1, 2, 3, 4, 5, 6, 7, 8, 9}}, false);
        add({.id = 0x123, .fd = true, .length = 64, .isCut = true}, false);
    });
    EXPECT_EQ(exported(path, "a.log"), "(1793000000.001500) can0 123#01AB\n"
                                       "(1793000000.001500) can0 12345678#\n"
                                       "(1793000000.001500) can0 123#R4\n"
                                       "(1793000000.001500) can0 20000004#0000000000000000\n"
                                       "(1793000000.001500) can0 123##0010203\n"
                                       "(1793000000.001500) can0 "
                                       "123##0010203040506070809000000\n");
    EXPECT_EQ(counts.leftOut, 1U);
    const std::string asc = exported(path, "a.asc");
    EXPECT_EQ(
        asc.substr(asc.find("logged\n") + 7),
        "   0.001500 1  123             Tx   d 2 01 AB\n"
        "   0.001500 1  12345678x       Rx   d 0\n"
        "   0.001500 1  123             Rx   r 4\n"
        "   0.001500 1  ErrorFrame\n"
        "   0.001500 CANFD   1 Rx        123                                   1 0 3  3 01 02 "
        "03        0    0     3000        0        0        0        0        0\n"
        "   0.001500 CANFD   1 Rx        123                                   1 0 9 12 01 02 "
        "03 04 05 06 07 08 09 00 00 00        0    0     3000        0        0        0      "
        "  0        0\n");
    EXPECT_EQ(counts.leftOut, 1U) << "bytes that are not known have no line";
}

TEST_F(Tools, framesBeforeTimeZeroAreInEveryLog)
{
    const std::string path = session("early.tts", [](SessionWriter& writer) {
        for (const SessionTime time : {-200'000'000, 300'000'000})
            ASSERT_TRUE(writer.add(FrameRow{.time = time, .frame = {.id = 1, .length = 0}}));
    });
    EXPECT_EQ(exported(path, "a.log"), "(1792999999.800000) can0 001#\n"
                                       "(1793000000.300000) can0 001#\n");
    const std::string asc = exported(path, "a.asc");
    EXPECT_NE(asc.find(":19 2026\n"), std::string::npos) << asc;
    EXPECT_NE(asc.find("   0.800000 1  1 "), std::string::npos) << asc;
    EXPECT_NE(asc.find("   1.300000 1  1 "), std::string::npos) << asc;
}

TEST_F(Tools, textsOfAForeignFileStayInTheirFields)
{
    const std::string path = session("words.tts", [](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(EventRow{.id = 1,
                                        .kind = EventKind::Marker,
                                        .text = "a, \"b\"\nc\xFF\x01",
                                        .shown = "</script>"}));
    });
    EXPECT_NE(exported(path, "a.csv", ExportKind::Events).find("\"a, \"\"b\"\"\nc"),
              std::string::npos);
    EXPECT_NE(exported(path, "a.mcap")
                  .find(R"("text":"a, \"b\"\u000ac)"
                        "\xEF\xBF\xBD"
                        R"(\u0001")"),
              std::string::npos);
}

TEST(Json, keepsUtf8AndReplacesInvalidBytes)
{
    EXPECT_EQ(jsonText("±0.5 m → \xF0\x9F\xA4\x96"), "\"±0.5 m → \xF0\x9F\xA4\x96\"");
    for (const char* wrong : {"\x80", "\xC0\xAF", "\xE2\x82", "\xED\xA0\x80", "\xF5\x80\x80\x80"})
        EXPECT_EQ(jsonText(wrong).find_first_not_of("\"\xEF\xBF\xBD"), std::string::npos) << wrong;
    EXPECT_EQ(crc32("123456789"), 0xCBF43926U) << "the check value of CRC-32";
}

TEST_F(Tools, rotatedFilesMergeWithoutDuplicateRows)
{
    const auto row = [](std::int64_t id, SessionTime time) { return someEstimate(id, time); };
    const std::string first = session("1.tts", [&](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
        ASSERT_TRUE(writer.add(someFrame(0)));
        ASSERT_TRUE(writer.add(someScene(1, 5'000'000)));
        ASSERT_TRUE(writer.add(row(1, 6'000'000)));
        ASSERT_TRUE(writer.add(someFrame(10)));
    });
    const std::string second = session("2.tts", [&](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
        ASSERT_TRUE(writer.add(someScene(1, 5'000'000)));
        ASSERT_TRUE(writer.add(row(1, 6'000'000)));
        ASSERT_TRUE(writer.add(someFrame(20)));
        ASSERT_TRUE(writer.add(someProposal(21'000'000)));
        EventRow decision = someDecision(22'000'000);
        ASSERT_TRUE(writer.add(decision));
        ASSERT_TRUE(writer.add(someScene(4, 30'000'000)));
        EstimateRow again = row(7, 31'000'000);
        again.scene = 4;
        ASSERT_TRUE(writer.add(again));
    });
    const std::string out = directory.file("whole.tts");
    const Status merged = mergeSessions({.files = {second, first}, .out = out});
    ASSERT_TRUE(merged) << merged.error().text;
    auto reader = *SessionReader::open(out);
    EXPECT_TRUE(reader.verify().damage.empty());
    EXPECT_EQ(reader.frameCount(), 3);
    EXPECT_EQ(reader.models().size(), 1U);
    ASSERT_EQ(reader.scenes().size(), 2U);
    ASSERT_EQ(reader.estimates().size(), 2U);
    EXPECT_EQ(reader.estimates()[1].scene, 2);
    EXPECT_EQ(*reader.draws(2), someEstimate(7, 0).estimate.draws);
    ASSERT_EQ(reader.proposals().size(), 1U);
    const EventRow& decision = reader.events().back();
    EXPECT_EQ(decision.kind, EventKind::Decision);
    EXPECT_EQ(decision.proposal, 1);
    EXPECT_EQ(decision.estimate, 1);
}

TEST_F(Tools, sessionsOfDifferentMonthsAreNotOneDrive)
{
    const auto oneFrame = [](SessionWriter& writer) { ASSERT_TRUE(writer.add(someFrame(0))); };
    const std::string now = session("now.tts", oneFrame);
    const std::string ages =
        session("ages.tts", oneFrame, (std::int64_t{1} << 62U) - someStart().wallTime);
    const std::string out = directory.file("whole.tts");
    EXPECT_TRUE(
        refused(mergeSessions({.files = {now, ages}, .out = out}), ages, {"a month apart"}));
    EXPECT_FALSE(directory.entries().contains("whole.tts"));
}

TEST_F(Tools, withoutTruthScenesHaveTheHeightsThatWereMeasured)
{
    const std::string path = session("touched.tts", [](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
        SceneRow scene = someScene(1, 1'000'000);
        scene.truth = std::nullopt;
        scene.measurement.force = {0.0, 0.0, 0.0, 0.0, 0.0, 7.0};
        ASSERT_TRUE(writer.add(scene));
        EstimateRow row = someEstimate(1, 2'000'000);
        row.readings = {{.bin = 10, .height = 0.123, .sd = 0.03}};
        ASSERT_TRUE(writer.add(row));
    });
    const std::string csv = directory.file("scenes.csv");
    ASSERT_TRUE(exportScenes({.files = {path}, .out = csv}));
    const auto plain = readScenes(csv)->scenes.at(0);
    ASSERT_TRUE(exportScenes({.files = {path}, .out = csv, .measured = true}));
    const auto touched = readScenes(csv)->scenes.at(0);
    const auto known = [](const Scene& scene) {
        return std::count_if(scene.truth.begin(), scene.truth.end(),
                             [](const auto& h) { return h.has_value(); });
    };
    EXPECT_EQ(known(plain), 0);
    EXPECT_EQ(known(touched), 2) << "one contact and the arm";
    EXPECT_EQ(touched.truth[10], 0.123);
}

TEST(SessionText, timesOfAnyFileAreDates)
{
    EXPECT_EQ(utcText(1'793'000'000'123'456'789), "2026-10-26 07:33:20.123 UTC");
    EXPECT_EQ(nanosecondText(1'793'000'000'000'000'123), "1793000000.000000123");
    constexpr auto kMax = std::numeric_limits<std::int64_t>::max();
    EXPECT_EQ(wallTimeOf({.wallTime = kMax}, 1), kMax);
    EXPECT_EQ(wallTimeOf({.wallTime = 5}, -6), 0);
    EXPECT_EQ(wallTimeOf({.wallTime = 5}, 6), 11);
    EXPECT_EQ(driveName("/a/b, c\".tts"), "b_ c_");
}

TEST(Canvas, wrapsWordsAndBreaksThoseThatAreTooLong)
{
    std::vector<std::string> lines, broken;
    (void)svgText(100, 100, [&](Canvas& canvas) {
        const TextStyle style{.colour = {}, .size = 10.0};
        lines = canvas.wrapped("one two three four", canvas.textWidth("one two ", style), style);
        broken = canvas.wrapped(std::string("a ").append(64, 'f'), 100.0, style);
        for (const std::string& line : broken) EXPECT_LE(canvas.textWidth(line, style), 100.0);
        EXPECT_TRUE(canvas.wrapped("", 100.0, style).empty());
        EXPECT_EQ(canvas.wrapped("wide", 0.0, style).size(), 1U);
    });
    EXPECT_EQ(lines, (std::vector<std::string>{"one two", "three", "four"}));
    std::string joined;
    for (const std::string& line : broken) joined += line;
    EXPECT_EQ(joined, std::string("a").append(64, 'f'));
}

}  // namespace
}  // namespace terratact
