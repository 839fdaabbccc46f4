// Tests sessions made of recordings: the round trip of our own exports, and bad input.
#include "app/recording/recording_import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/log/review_moment.h"
#include "core/log/session_strip.h"
#include "core/wire/telemetry.h"
#include "core/wire/telemetry_listener.h"
#include "tests/support/bytes/csv_mapping.h"
#include "tests/support/sessions/session_files.h"

namespace terratact {
namespace {

constexpr const char* kDemo = TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts";
constexpr const char* kShippedRobotFile = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml";

std::string shippedMapping(const std::string& name)
{
    return TERRATACT_SOURCE_DIR "/resources/mappings/" + name + ".toml";
}

struct ImportedSessions : SessionFiles {
    std::vector<FrameRow> framesOfSession(const std::string& path)
    {
        auto reader = SessionReader::open(path);
        EXPECT_TRUE(reader) << reader.error().text;
        std::vector<FrameRow> rows;
        for (std::size_t batch = 0; batch < reader->batches().size(); ++batch)
            for (const FrameRow& row : reader->frames(batch)) rows.push_back(row);
        return rows;
    }

    std::vector<Measurement> linesOfSession(const std::string& path)
    {
        TelemetryListener listener(shippedRobot());
        std::vector<Measurement> lines;
        for (const FrameRow& row : framesOfSession(path))
            if (!row.sent)
                if (auto m = listener.receive(row.frame, secondsOf(row.time))) lines.push_back(*m);
        return lines;
    }

    Result<ImportedSession> imported(const std::string& file, const std::string& mapping,
                                     const std::string& out)
    {
        return importRecording({.file = file,
                                .mapping = mapping,
                                .robot = kShippedRobotFile,
                                .out = directory.file(out)});
    }

    std::string whyNot(const std::string& content, const std::string& mapping)
    {
        const auto done = imported(directory.write("bad", content),
                                   directory.write("m.toml", mapping), "bad.tts");
        EXPECT_EQ(directory.entries(), (std::set<std::string>{"bad", "m.toml"}))
            << "nothing is left";
        return done ? "" : done.error().text;
    }
};

TEST_F(ImportedSessions, framesComeBackBitForBit)
{
    exported(kDemo, "demo.mcap");
    const auto done =
        imported(directory.file("demo.mcap"), shippedMapping("terratact"), "back.tts");
    ASSERT_TRUE(done) << done.error().text;
    EXPECT_TRUE(done->remarks.empty());
    const auto before = framesOfSession(kDemo), after = framesOfSession(directory.file("back.tts"));
    ASSERT_EQ(after.size(), before.size());
    const SessionTime shift = before.front().time;
    for (std::size_t i = 0; i < before.size(); ++i) {
        ASSERT_EQ(after[i].frame, before[i].frame) << i;
        ASSERT_EQ(after[i].sent, before[i].sent) << i;
        ASSERT_EQ(after[i].time, before[i].time - shift) << i;
    }
    EXPECT_EQ(done->scenes, 1) << "the robot pressed once";
    auto reader = SessionReader::open(directory.file("back.tts"));
    EXPECT_FALSE(reader->verify().broken);
    EXPECT_TRUE(reader->sealed());
}

TEST_F(ImportedSessions, signalsLoseNothingOfTheTelemetry)
{
    exported(kDemo, "demo.mcap", ExportKind::Signals);
    const auto done =
        imported(directory.file("demo.mcap"), shippedMapping("terratact_signals"), "back.tts");
    ASSERT_TRUE(done) << done.error().text;
    EXPECT_TRUE(done->remarks.empty()) << done->remarks.front();
    auto before = linesOfSession(kDemo);
    const auto after = linesOfSession(directory.file("back.tts"));
    ASSERT_EQ(after.size(), before.size());
    const double begin = before.front().time;
    for (std::size_t i = 0; i < before.size(); ++i) {
        Measurement& a = before[i];
        const Measurement& b = after[i];
        EXPECT_NEAR(b.time, a.time - begin, 1e-8) << i;
        // A voltage below that of the bias is no force, so that it comes back as the bias.
        for (std::size_t e = 0; e < kForceElements; ++e) {
            EXPECT_NEAR(*a.sides.left[e], *b.sides.left[e], 1e-3) << i;
            EXPECT_NEAR(*a.sides.right[e], *b.sides.right[e], 1e-3) << i;
        }
        a.time = b.time;
        a.sides = b.sides;
        a.force = b.force;
        a.arm = b.arm;  // not a signal of the export
        ASSERT_EQ(a, b) << i;
    }
}

TEST_F(ImportedSessions, signalsKeepAMissingCurrent)
{
    const std::string path = session("lost.tts", [](SessionWriter& writer) {
        for (int i = 0; i < 40; ++i) {
            Measurement m;
            m.pitch = 0.01 * (i % 2);
            m.travelled = 0.01 * i;
            m.turned = 0.0;
            setCurrents(m, {std::nullopt, 1.0, 0.5, 0.25});
            const auto counter = static_cast<std::uint8_t>(i);
            std::vector<CanFrame> frames = framesOf(sensorLineOf(m, shippedRobot()), counter);
            frames.insert(frames.begin(), frameOf(RobotStatus{}, counter));
            SessionTime time = SessionTime{50'000'000} * i;
            for (const CanFrame& frame : frames) {
                time += 100'000;
                ASSERT_TRUE(writer.add(FrameRow{.time = time, .frame = frame}));
            }
        }
    });
    exported(path, "lost.mcap", ExportKind::Signals);
    const auto done =
        imported(directory.file("lost.mcap"), shippedMapping("terratact_signals"), "back.tts");
    ASSERT_TRUE(done) << done.error().text;
    const auto lines = linesOfSession(directory.file("back.tts"));
    ASSERT_EQ(lines.size(), 40U);
    for (const Measurement& m : lines) {
        const MotorCurrents currents = motorCurrents(m);
        ASSERT_FALSE(currents[0]);
        ASSERT_NEAR(currents[1].value(), 1.0, 1e-9);
        ASSERT_NEAR(currents[3].value(), 0.25, 1e-9);
    }
    exported(path, "frames.mcap");
    ASSERT_TRUE(imported(directory.file("frames.mcap"), shippedMapping("terratact"), "frames.tts"));
    const auto before = framesOfSession(path);
    const auto after = framesOfSession(directory.file("frames.tts"));
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        ASSERT_EQ(after[i].frame, before[i].frame) << "unmeasured signals are null, " << i;
}

TEST_F(ImportedSessions, csvBecomesASessionWithScenes)
{
    std::string rows = fmt::format("t,{},front_current,s\n", kPoseColumns);
    for (int i = 0; i < 100; ++i) {
        const bool presses = i >= 50;
        rows +=
            fmt::format("{},{},0.2,0.2,0.1,0.1,{},{}\n", 0.05 * i, presses ? 0.1 : 0.05 * (i % 2),
                        presses ? 2.0 : 0.0, presses ? 1.0 : 0.02 * i);
    }
    std::string more;
    for (const char* const side : {"left", "right"})
        more += fmt::format("[front_{}_current]\nfield = \"front_current\"\n", side);
    more += "[travelled]\nfield = \"s\"\n";
    const std::string out = directory.file("a.tts");
    const auto done = imported(directory.write("a.csv", rows),
                               directory.write("m.toml", csvMapping(more)), "a.tts");
    ASSERT_TRUE(done) << done.error().text;
    EXPECT_EQ(done->lines, 100U);
    EXPECT_EQ(done->scenes, 1);
    auto reader = SessionReader::open(out);
    ASSERT_TRUE(reader);
    const Measurement& scene = reader->scenes().at(0).measurement;
    EXPECT_NEAR(scene.pitch, 0.1, 1e-4);
    EXPECT_EQ(scene.activity, RobotActivity::Pressed);
    EXPECT_FALSE(scene.missing[kFrontCurrentFeature]);
    EXPECT_TRUE(scene.missing[kRearCurrentFeature]);
    EXPECT_TRUE(scene.missing[kFirstForceFeature]);
    ReviewMoments moments(*reader, shippedRobot());
    const ReviewMoment moment = moments.at(2'000'000'000);
    ASSERT_TRUE(moment.measurement);
    EXPECT_EQ(moment.measurement->activity, RobotActivity::Driving);
    EXPECT_TRUE(moment.linkAlive);
}

TEST_F(ImportedSessions, aWayWithoutAHeadingIsNoOdometry)
{
    std::string rows = fmt::format("t,{},s,heading\n", kPoseColumns);
    for (int i = 0; i < 40; ++i) rows += fmt::format("{},0,0,0,0,0,{},0.1\n", 0.05 * i, 0.01 * i);
    const std::string file = directory.write("a.csv", rows), way = "[travelled]\nfield = \"s\"\n";
    const auto said = [](const ImportedSession& session) {
        return std::ranges::any_of(session.remarks, [](const std::string& remark) {
            return remark.find("the way is left out") != std::string::npos;
        });
    };
    const auto alone = imported(file, directory.write("m.toml", csvMapping(way)), "a.tts");
    ASSERT_TRUE(alone) << alone.error().text;
    EXPECT_TRUE(said(*alone));
    EXPECT_FALSE(linesOfSession(directory.file("a.tts")).back().travelled);
    auto reader = SessionReader::open(directory.file("a.tts"));
    ASSERT_TRUE(reader);
    SessionStrip strip(*reader, shippedRobot());
    strip.goTo(reader->end());
    EXPECT_EQ(strip.strip().whyNothing(), SectionStart::NoOdometry);

    const std::string heading = way + "[turned]\nfield = \"heading\"\n";
    const auto both = imported(file, directory.write("m.toml", csvMapping(heading)), "b.tts");
    ASSERT_TRUE(both) << both.error().text;
    EXPECT_FALSE(said(*both));
    const Measurement last = linesOfSession(directory.file("b.tts")).back();
    EXPECT_NEAR(last.travelled.value(), 0.39, 1e-3);
    EXPECT_NEAR(last.turned.value(), 0.1, 1e-3);
}

TEST_F(ImportedSessions, badInputLeavesNothing)
{
    EXPECT_NE(whyNot("t,pitch\n0,1\n", csvMapping()).find("has the field 'front_left'"),
              std::string::npos);
    const std::string head = fmt::format("t,{}\n", kPoseColumns);
    EXPECT_NE(whyNot(head + "-5,0,0,0,0,0\n", csvMapping()).find("begins at -5.000 s since 1970"),
              std::string::npos);
    EXPECT_NE(whyNot(head + "0,0,0,0,0,0\n1,x,0,0,0,0\ny,0,0,0,0,0\n", csvMapping()).find("line 4"),
              std::string::npos);
    EXPECT_NE(whyNot(head + "0,0,0,0,0,0\n", "name = \"f\"\n[frames]\ntopic = \"/can\"\n")
                  .find("holds no message of topic /can"),
              std::string::npos);
    EXPECT_NE(whyNot("id,length,data,t\n5000,8,1,0\n", "name = \"f\"\n[frames]\ntopic = \"/csv\"\n")
                  .find("the field 'id' of the message at 2 is not an identifier"),
              std::string::npos);
    EXPECT_NE(whyNot("", csvMapping()).find("is empty"), std::string::npos);
}

TEST_F(ImportedSessions, anExistingSessionIsKept)
{
    const std::string file =
        directory.write("a.csv", fmt::format("t,{}\n0,0,0,0,0,0\n", kPoseColumns));
    const std::string mapping = directory.write("m.toml", csvMapping());
    directory.write("a.tts", "mine");
    EXPECT_FALSE(imported(file, mapping, "a.tts"));
    EXPECT_EQ(contentOf(directory.file("a.tts")), "mine");
}

TEST_F(ImportedSessions, remarksNameLeftOutAndDoubtfulData)
{
    const auto remarksOf = [this](const std::string& rows, const std::string& name) {
        const auto done =
            imported(directory.write("a.csv", fmt::format("t,{}\n{}", kPoseColumns, rows)),
                     directory.write("m.toml", csvMapping()), name);
        EXPECT_TRUE(done) << done.error().text;
        return done ? done->remarks : std::vector<std::string>{};
    };
    EXPECT_EQ(remarksOf("0,0,0,0,0,0\n0,0,0,0,0,0\n0.1,0,0,0,0,0\n", "a.tts"),
              std::vector<std::string>{
                  "1 of 3 values of the pitch have the time of another one and are left out: are "
                  "the times rounded, or is their unit another one?"});
    const auto unknown = remarksOf("0,0,0,0,0,0\n1,0,,0,0,0\n", "b.tts");
    ASSERT_EQ(unknown.size(), 2U);
    EXPECT_EQ(unknown[1], "1 of 2 values of the pitch are left out, because a flipper angle is not "
                          "known within 0.5 s (max_gap_s)");
    const auto degrees = remarksOf("0,0,45,0,0,0\n", "c.tts");
    ASSERT_EQ(degrees.size(), 1U);
    EXPECT_EQ(degrees[0].find("[front_left]: reaches 45.000 rad, more than 6.283: degrees may be"),
              0U);
}

TEST_F(ImportedSessions, aSetClockIsAnEventAndNoLongSession)
{
    std::string rows = fmt::format("t,{}\n", kPoseColumns);
    for (int i = 0; i < 20; ++i)
        rows += fmt::format("{},0,0,0,0,0\n", 0.1 * i + (i < 10 ? 7200.0 : 0.0));
    const auto done =
        imported(directory.write("a.csv", rows), directory.write("m.toml", csvMapping()), "a.tts");
    ASSERT_TRUE(done) << done.error().text;
    EXPECT_NEAR(done->seconds, 1.9, 1e-6);
    auto reader = SessionReader::open(directory.file("a.tts"));
    const auto events = reader->events();
    const auto step = std::ranges::find(events, EventKind::Gap, &EventRow::kind);
    ASSERT_NE(step, events.end());
    EXPECT_EQ(step->text,
              "the recording's clock was set back by 7199.900 s; the session continues evenly");
    EXPECT_NEAR(secondsOf(step->time), 1.0, 1e-6);
}

TEST_F(ImportedSessions, aClockOfACsvSetBackALittleIsAnEvent)
{
    std::string rows = fmt::format("t,{}\n", kPoseColumns);
    for (int i = 0; i < 40; ++i)
        rows += fmt::format("{:.3f},{},0,0,0,0\n", 0.05 * i + (i < 20 ? 1000.0 : 999.52), 0.01 * i);
    const auto done =
        imported(directory.write("a.csv", rows), directory.write("m.toml", csvMapping()), "a.tts");
    ASSERT_TRUE(done) << done.error().text;
    EXPECT_EQ(done->lines, 40U);
    double pitch = -1.0;
    for (const Measurement& line : linesOfSession(directory.file("a.tts"))) {
        EXPECT_GT(line.pitch, pitch) << "the order of the file is kept";
        pitch = line.pitch;
    }
    auto reader = SessionReader::open(directory.file("a.tts"));
    const auto events = reader->events();
    const auto step = std::ranges::find(events, EventKind::Gap, &EventRow::kind);
    ASSERT_NE(step, events.end());
    EXPECT_EQ(step->text,
              "the recording's clock was set back by 0.430 s; the session continues evenly");
}

}  // namespace
}  // namespace terratact
