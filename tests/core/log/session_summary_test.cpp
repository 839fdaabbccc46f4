#include "core/log/session_summary.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <set>

#include "tests/core/log/session_fixture.h"
#include "tests/support/sessions/sessions.h"

namespace terratact {
namespace {

namespace fs = std::filesystem;

struct Summary : Session {
    SessionSummary summary() const
    {
        auto found = summarizeSession(path);
        EXPECT_TRUE(found) << found.error().text;
        return found ? *found : SessionSummary{};
    }
    std::string refusal() const
    {
        const auto found = summarizeSession(path);
        return found ? "it was read" : found.error().text;
    }
    std::set<std::string> names() const
    {
        std::set<std::string> all;
        for (const auto& entry : fs::directory_iterator(fs::path(path).parent_path()))
            all.insert(entry.path().filename().string());
        return all;
    }
};

std::string demonstration(const char* name)
{
    return std::string(TERRATACT_SOURCE_DIR "/resources/sessions/") + name;
}

TEST_F(Summary, countsWhatTheReaderCounts)
{
    seal(path, 1000);
    const auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader);
    const SessionSummary found = summary();
    EXPECT_EQ(found.closing, SessionClosing::Sealed);
    EXPECT_EQ(found.wallTime, reader->start().wallTime);
    EXPECT_EQ(found.begin, reader->begin());
    EXPECT_EQ(found.end, reader->end());
    EXPECT_EQ(found.frames, reader->frameCount());
    EXPECT_EQ(found.scenes, 2);
    EXPECT_EQ(found.estimates, 2);
    EXPECT_EQ(found.proposals, 1);
    EXPECT_EQ(found.probes, 1);
    EXPECT_EQ(found.source, "SIMULATED ROBOT");
    EXPECT_EQ(found.program, "terratact-console test");
    EXPECT_FALSE(found.damage);
    ASSERT_TRUE(found.last);
    EXPECT_EQ(found.last->time, reader->estimates().back().time);
    EXPECT_EQ(found.last->estimate, reader->estimates().back().estimate);
}

TEST_F(Summary, judgesTheLastEstimateOfEachScene)
{
    for (const char* const file : {"demo.tts", "two_tracks.tts"}) {
        auto reader = SessionReader::open(demonstration(file));
        ASSERT_TRUE(reader);
        const auto found = summarizeSession(demonstration(file));
        ASSERT_TRUE(found) << found.error().text;
        EXPECT_EQ(found->robot, "Absolem");
        EXPECT_EQ(found->scenes, 1);
        EXPECT_EQ(found->estimates, 2);
        EXPECT_EQ(found->probes, 1);
        EXPECT_EQ(found->marks, 1);
        EXPECT_EQ(found->verdicts, (SessionVerdicts{.blocked = 1})) << file;
        ASSERT_TRUE(found->last);
        EXPECT_EQ(found->last->verdict, StepVerdict::Blocked);
        EXPECT_TRUE(found->last->estimate.side[0].draws.empty());
        EXPECT_EQ(found->last->estimate.onePlane, reader->estimates()[1].estimate.onePlane);
        EXPECT_EQ(found->last->estimate.side[0].mean, reader->estimates()[1].estimate.side[0].mean);
    }
}

/// Returns true if this process holds a lock, as another process sees it.
bool isLocked(const std::string& path, off_t from, off_t length)
{
    const pid_t child = ::fork();
    if (child == 0) {
        struct flock lock = {};
        lock.l_type = F_WRLCK;
        lock.l_start = from;
        lock.l_len = length;
        const int file = ::open(path.c_str(), O_RDONLY);
        ::_exit(::fcntl(file, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK ? 0 : 1);
    }
    int status = -1;
    return ::waitpid(child, &status, 0) == child && status == 0;
}

/// Writes a scene and an estimate whose draws hold a step, and between them an event.
void sealBlocked(const std::string& path, EventRow between)
{
    auto writer = SessionWriter::create(path, someStart());
    ASSERT_TRUE(writer);
    ASSERT_TRUE(writer->add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
    SceneRow scene = someScene(1, 1'000);
    scene.measurement.pitch = 0.0;
    ASSERT_TRUE(writer->add(scene));
    between.time = 2'000;
    ASSERT_TRUE(writer->add(between));
    EstimateRow row = someEstimate(1, 3'000);
    TerrainEstimate plane = stepEstimate();
    plane.touch.fill(Touch::Felt);
    plane.converged = true;
    plane.draws.assign(1000, plane.height);
    plane.settings.draws = 1000;
    row.estimate = equalSides(std::move(plane));
    ASSERT_TRUE(writer->add(row));
    ASSERT_TRUE(writer->seal());
}

TEST_F(Summary, withholdsAVerdictForASilenceOrASensor)
{
    sealBlocked(path, {.kind = EventKind::Marker, .text = "at the door"});
    const SessionSummary sound = summary();
    EXPECT_EQ(sound.verdicts, (SessionVerdicts{.blocked = 1}));
    EXPECT_EQ(sound.marks, 1);
    EXPECT_EQ(sound.notes, std::vector<std::string>{"at the door"});

    fs::remove(path);
    sealBlocked(path, {.kind = EventKind::TelemetryGap});
    EXPECT_EQ(summary().verdicts, (SessionVerdicts{.cannotTell = 1}));

    fs::remove(path);
    sealBlocked(path, {.kind = EventKind::Alarm, .subject = "sensor-fault", .number = 3.0});
    const SessionSummary suspected = summary();
    EXPECT_EQ(suspected.verdicts, (SessionVerdicts{.cannotTell = 1}));
    EXPECT_EQ(suspected.alarms, 1);

    fs::remove(path);
    sealBlocked(path, {.kind = EventKind::Alarm, .subject = "link", .number = 3.0});
    EXPECT_EQ(summary().verdicts, (SessionVerdicts{.blocked = 1}));
}

TEST_F(Summary, boundsTheJudgedScenesAndTheNotes)
{
    auto writer = SessionWriter::create(path, someStart());
    ASSERT_TRUE(writer);
    ASSERT_TRUE(writer->add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
    const auto scenes = static_cast<std::int64_t>(SessionSummary::kMaxJudged) + 7;
    for (std::int64_t id = 1; id <= scenes; ++id) {
        ASSERT_TRUE(writer->add(someScene(id, id * 1000)));
        ASSERT_TRUE(writer->add(someEstimate(id, id * 1000 + 1)));
        ASSERT_TRUE(
            writer->add(EventRow{.kind = EventKind::Marker, .text = std::string(900, 'x')}));
    }
    ASSERT_TRUE(writer->seal());
    const SessionSummary found = summary();
    EXPECT_EQ(found.verdicts.notRead, 7);
    EXPECT_EQ(found.verdicts.clear + found.verdicts.blocked + found.verdicts.cannotTell,
              scenes - 7);
    EXPECT_EQ(found.marks, scenes);
    EXPECT_EQ(found.notes.size(), SessionSummary::kMaxNotes);
    EXPECT_EQ(found.notes.front().size(), SessionSummary::kMaxNoteBytes);
    EXPECT_EQ(found.last->time, scenes * 1000 + 1);
}

TEST_F(Summary, nothingIsLeftBesideAnOpenSession)
{
    {
        auto writer = someSession(path, 1000);
        ASSERT_TRUE(writer);
        for (const char* const end : {"", "-wal"})
            fs::copy_file(path + end, directory.file("dead.tts") + end);
    }
    path = directory.file("dead.tts");
    const std::set<std::string> before = names();
    ASSERT_FALSE(before.contains("dead.tts-shm"));
    const SessionSummary found = summary();
    EXPECT_EQ(found.closing, SessionClosing::Open);
    EXPECT_EQ(found.frames, 1000);
    EXPECT_EQ(found.estimates, 2);
    EXPECT_EQ(names(), before);
    std::ofstream(path + "-shm") << std::string(32'768, '\0');  // a dead program leaves its index
    EXPECT_EQ(summary(), found);
    EXPECT_EQ(contentOf(path + "-shm"), std::string(32'768, '\0'));
}

TEST_F(Summary, readsBesideItsWriterAndTakesNoLockAway)
{
    auto writer = someSession(path, 1000);
    ASSERT_TRUE(writer);
    const std::set<std::string> before = names();
    const SessionSummary found = summary();
    EXPECT_EQ(found.closing, SessionClosing::Open);
    EXPECT_EQ(found.frames, 1000);
    EXPECT_EQ(names(), before);
    // Another process would close the session if its writer's locks were gone.
    EXPECT_TRUE(isLocked(path, 0x40000002, 510)) << "SQLite's range of shared locks";
    EXPECT_TRUE(isLocked(path + "-shm", 128, 1)) << "SQLite's lock of every connection";
    ASSERT_TRUE(writer->add(someFrame(1000)));
    ASSERT_TRUE(writer->commit());
    EXPECT_EQ(summary().frames, 1001);
    ASSERT_TRUE(writer->seal());
    EXPECT_EQ(summary().closing, SessionClosing::Sealed);
}

TEST_F(Summary, saysWhatIsTorn)
{
    {
        auto writer = someSession(path, 1000);
        ASSERT_TRUE(writer);
        fs::copy_file(path, directory.file("torn.tts"));
        fs::copy_file(path, directory.file("damaged.tts"));
    }
    std::ofstream(directory.file("damaged.tts-wal")) << std::string(5000, 'x');
    path = directory.file("damaged.tts");
    EXPECT_EQ(summary().closing, SessionClosing::Torn);
    path = directory.file("torn.tts");
    const auto torn = summarizeSession(path);
    if (torn)
        EXPECT_EQ(torn->closing, SessionClosing::Torn);
    else
        EXPECT_NE(torn.error().text.find("torn.tts-wal"), std::string::npos) << torn.error().text;
}

TEST_F(Summary, aFileThatIsNoSessionIsRefusedWithItsReason)
{
    EXPECT_NE(refusal().find("cannot be opened"), std::string::npos) << refusal();
    std::ofstream(path) << "some text that is longer than the header of an SQLite file has to be, "
                           "which is a hundred bytes";
    EXPECT_NE(refusal().find("is not an SQLite file"), std::string::npos) << refusal();
    std::ofstream(path) << "";
    EXPECT_NE(refusal().find("is empty"), std::string::npos) << refusal();
    std::ofstream(path + "-wal") << "";
    EXPECT_NE(refusal(), "it was read");
    fs::remove(path + "-wal");
    fs::remove(path);
    seal(path, 1000);
    fs::resize_file(path, fs::file_size(path) / 2);
    EXPECT_NE(refusal().find("truncated"), std::string::npos) << refusal();
}

TEST_F(Summary, aRefusedRowIsNamedAndTheRestIsRead)
{
    seal(path, 1000);
    change(path, "UPDATE scene SET activity = 99 WHERE id = 2");
    const SessionSummary found = summary();
    ASSERT_TRUE(found.damage);
    EXPECT_NE(found.damage->english().find("row 2 of its table scene"), std::string::npos)
        << found.damage->english();
    EXPECT_EQ(found.scenes, 2);
    EXPECT_EQ(found.verdicts.notRead, 1);
}

TEST_F(Summary, flippedBytesGiveASummaryOrAReason)
{
    seal(path, 500);
    const std::string whole = contentOf(path);
    std::mt19937 random(11);
    for (int i = 0; i < countFrom("TERRATACT_FLIPS", 500); ++i) {
        std::string damaged = whole;
        const std::size_t at = random() % damaged.size();
        damaged[at] = static_cast<char>(damaged[at] ^ static_cast<char>(1U << random() % 8));
        std::ofstream(path, std::ios::binary) << damaged;
        const auto found = summarizeSession(path);
        if (found) continue;
        ASSERT_EQ(found.error().text.find(path), 0U) << found.error().text;
    }
}

TEST_F(Summary, readingIsCancelled)
{
    seal(path, 1000);
    std::stop_source stop;
    stop.request_stop();
    const auto found = summarizeSession(path, stop.get_token());
    ASSERT_FALSE(found);
    EXPECT_NE(found.error().text.find("cancelled"), std::string::npos);
}

}  // namespace
}  // namespace terratact
