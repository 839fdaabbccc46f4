// Tests that the recorder blocks nobody, counts what it drops, and resumes when it can.
#include "app/recording/session_recorder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <thread>

#include "app/recording/session_folder.h"
#include "app/recording/session_merge.h"
#include "app/runtime/steady_now.h"
#include "core/log/session_reader.h"
#include "tests/support/sessions/session_paths.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace {

/// While set, writing to the disk blocks.
std::atomic<bool> stalled{false};

}  // namespace

// Replaces the C library's function for SQLite: a disk that stalls.
extern "C" int fdatasync(int file)
{
    stalled.wait(true);
    return static_cast<int>(::syscall(SYS_fdatasync, file));
}

namespace terratact {
namespace {

using namespace std::chrono_literals;

std::vector<BusFrame> busFrames(std::int64_t from, std::size_t count)
{
    std::vector<BusFrame> frames(count);
    for (std::size_t i = 0; i < count; ++i)
        frames[i] = {.frame = someFrame(from + static_cast<std::int64_t>(i)).frame,
                     .time = steadyNow(),
                     .echo = i % 2 == 0};
    return frames;
}

template <class Condition>
bool eventually(Condition condition)
{
    for (const double end = steadyNow() + 20.0; steadyNow() < end;) {
        if (condition()) return true;
        std::this_thread::sleep_for(5ms);
    }
    return false;
}

struct Recorder : testing::Test {
    TemporaryDirectory directory;
    std::string folder = directory.file("state/sessions");
    SessionRecorder::Options options{.folder = folder, .start = someStart(), .batch = 10ms};
};

TEST_F(Recorder, makesASealedFileOfEverything)
{
    {
        SessionRecorder recorder(options);
        recorder.add(busFrames(0, 1000));
        const std::int64_t model = recorder.record(ModelRow{.id = 0, .name = "default.ttm"});
        SceneRow scene = someScene(1, 0);
        const std::int64_t sceneId = recorder.record(scene);
        EstimateRow estimate = someSides(1, 0);
        estimate.model = model;
        estimate.scene = sceneId;
        const std::int64_t id = recorder.record(estimate);
        recorder.record(
            EventRow{.kind = EventKind::Decision, .subject = "explore", .estimate = id});
        ASSERT_TRUE(eventually([&] { return recorder.state().frames == 1000; }));
        EXPECT_TRUE(recorder.state().recording);
        EXPECT_EQ(recorder.state().trouble.english(), "");
        EXPECT_EQ(recoverDeadSessions(sessionsIn(folder)).size(), 0U)
            << "a file that is written is left alone";
    }
    const auto files = filesIn(folder);
    ASSERT_EQ(files.size(), 1U) << "no journal is left";
    auto reader = SessionReader::open(files.front());
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_TRUE(reader->sealed());
    EXPECT_EQ(numbersIn(*reader).size(), 1000U);
    ASSERT_EQ(reader->estimates().size(), 1U);
    TwoTrackEstimate recorded = reader->estimates()[0].estimate;
    setDraws(recorded, *reader->draws(1));
    EXPECT_EQ(recorded, someSides(1, 0).estimate) << "both sides are recorded";
    EXPECT_TRUE(hasEvent(*reader, EventKind::Session, "begun"));
    EXPECT_TRUE(hasEvent(*reader, EventKind::Decision, "explore"));
    EXPECT_TRUE(hasEvent(*reader, EventKind::Session, "ended"));
    EXPECT_FALSE(reader->verify().broken);
}

TEST_F(Recorder, countsDroppedFrames)
{
    options.mostFrames = 100;
    options.batch = 200ms;
    {
        SessionRecorder recorder(options);
        recorder.add(busFrames(0, 1000));
        EXPECT_GE(recorder.state().missing, 800);
        ASSERT_TRUE(eventually([&] { return recorder.state().frames >= 100; }));
    }
    auto reader = SessionReader::open(filesIn(folder).front());
    ASSERT_TRUE(reader);
    double missing = 0.0;
    for (const EventRow& event : reader->events())
        if (event.kind == EventKind::Gap) missing += *event.number;
    const auto numbers = numbersIn(*reader);
    EXPECT_EQ(static_cast<double>(numbers.size()) + missing, 1000.0);
    for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], i);
}

TEST_F(Recorder, reportsWhyRecordingFailsAndResumes)
{
    std::filesystem::create_directories(directory.file("state"));
    std::ofstream(folder) << "a file where the folder should be";
    SessionRecorder recorder(options);
    ASSERT_TRUE(eventually([&] { return !recorder.state().trouble.empty(); }));
    EXPECT_NE(recorder.state().trouble.english().find(folder), std::string::npos);
    EXPECT_FALSE(recorder.state().recording);
    recorder.add(busFrames(0, 10));
    recorder.record(EventRow{.kind = EventKind::Decision, .subject = "stop"});
    std::filesystem::remove(folder);
    ASSERT_TRUE(eventually([&] { return recorder.state().frames == 10; })) << "what waited is kept";
    EXPECT_EQ(recorder.state().trouble.english(), "");
    auto reader = SessionReader::open(recorder.state().path);
    ASSERT_TRUE(reader);
    EXPECT_TRUE(hasEvent(*reader, EventKind::Decision, "stop"));
}

/// Records 12,000 frames into several files.
void recordOn(const SessionRecorder::Options& options)
{
    const std::string& folder = options.folder;
    {
        SessionRecorder recorder(options);
        recorder.record(ModelRow{.id = 0, .name = "default.ttm"});
        recorder.record(someScene(1, 0));
        recorder.record(someEstimate(1, 0));
        for (int turn = 0; turn < 6; ++turn) {
            recorder.add(busFrames(2000 * turn, 2000));
            ASSERT_TRUE(eventually([&] { return recorder.state().frames == 2000 * (turn + 1); }));
        }
        recorder.record(EventRow{.kind = EventKind::Decision, .subject = "approve", .estimate = 1});
    }
    const auto files = filesIn(folder);
    ASSERT_GE(files.size(), 2U);
    std::vector<std::uint64_t> numbers;
    for (const std::string& file : files) {
        auto reader = SessionReader::open(file);
        ASSERT_TRUE(reader) << reader.error().text;
        EXPECT_TRUE(reader->sealed());
        EXPECT_FALSE(reader->verify().broken);
        EXPECT_NE(reader->estimate(1), nullptr) << file;
        EXPECT_EQ(hasEvent(*reader, EventKind::Session, "continued"), file != files.front());
        for (const std::uint64_t n : numbersIn(*reader)) numbers.push_back(n);
    }
    ASSERT_EQ(numbers.size(), 12'000U);
    for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], i);
}

TEST_F(Recorder, goesOnInTheNextFileWithWhatIsReferredTo)
{
    options.mostBytes = 200'000;
    recordOn(options);
}

TEST_F(Recorder, goesOnInTheNextFileWhereOneHasAsManyBatchesAsItMay)
{
    options.mostBatches = 4;
    recordOn(options);
    for (const std::string& file : filesIn(folder)) {
        auto reader = SessionReader::open(file);
        ASSERT_TRUE(reader) << reader.error().text;
        EXPECT_LE(reader->batches().size(), 4U);
    }
}

/// Stalls the disk for three seconds at the rate of a full bus, and ends the stall itself: a caller that had to wait
/// for the disk would wait forever. The trouble is reported meanwhile. Queued frames are kept; dropped ones are counted
/// in the file.
TEST_F(Recorder, aStalledDiskBlocksNoCallerAndIsReported)
{
    constexpr int kTurns = 150;
    constexpr std::size_t kPerTurn = 180;
    bool told = false;
    {
        SessionRecorder recorder(options);
        ASSERT_TRUE(eventually([&] { return recorder.state().recording; }));
        stalled = true;
        for (int turn = 0; turn < kTurns; ++turn) {
            recorder.add(busFrames(static_cast<std::int64_t>(kPerTurn) * turn, kPerTurn));
            recorder.record(EventRow{.kind = EventKind::Decision, .subject = "refuse"});
            const std::string trouble = recorder.state().trouble.english();
            told = told || trouble.find("the disk is slow") != std::string::npos;
            std::this_thread::sleep_for(
                20ms);  // the rate of a full bus, and more than `patience` together
        }
        stalled = false;
        stalled.notify_all();
        const bool over = eventually([&] { return recorder.state().trouble.empty(); });
        EXPECT_TRUE(over) << recorder.state().trouble.english();
    }
    EXPECT_TRUE(told) << "before the stall was over";
    const auto files = filesIn(folder);
    ASSERT_EQ(files.size(), 1U);
    auto reader = SessionReader::open(files.front());
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_FALSE(reader->verify().broken);
    double missing = 0.0;
    for (const EventRow& event : reader->events())
        if (event.kind == EventKind::Gap) missing += event.number.value_or(0.0);
    EXPECT_GT(missing, 0.0);
    EXPECT_EQ(static_cast<double>(reader->frameCount()) + missing, 1.0 * kTurns * kPerTurn);
    EXPECT_EQ(std::count_if(reader->events().begin(), reader->events().end(),
                            [](const EventRow& e) { return e.kind == EventKind::Decision; }),
              kTurns);
}

TEST_F(Recorder, keepsNothingWhileItIsOff)
{
    SessionRecorder recorder(options);
    ASSERT_TRUE(eventually([&] { return recorder.state().recording; }));
    const std::string first = recorder.state().path;
    recorder.setOn(false);
    ASSERT_TRUE(eventually([&] { return !recorder.state().recording; }));
    EXPECT_EQ(recorder.state().trouble.english(), "");
    EXPECT_TRUE(SessionReader::open(first)->sealed());
    recorder.add(busFrames(0, 10));
    recorder.setOn(true);
    recorder.add(busFrames(10, 10));
    ASSERT_TRUE(eventually([&] { return recorder.state().frames == 10; }));
    auto reader = SessionReader::open(recorder.state().path);
    ASSERT_TRUE(reader);
    EXPECT_EQ(numbersIn(*reader).front(), 10U);
}

TEST_F(Recorder, everyFileHasTheStateFromBeforeItsStart)
{
    options.on = false;
    {
        SessionRecorder recorder(options);
        recorder.record(ModelRow{.id = 0, .name = "default.ttm"});
        recorder.record(someScene(1, 0));
        recorder.record(someEstimate(1, 0));
        recorder.record(someProposal(0));
        // The recorder does not report when its thread has taken the rows. This gives it ten turns. A later turn hides
        // a fault but fails no test.
        std::this_thread::sleep_for(100ms);
        for (const char* const what : {"approve", "stop"}) {
            recorder.setOn(true);
            recorder.record(EventRow{
                .kind = EventKind::Decision, .subject = what, .estimate = 1, .proposal = 1});
            ASSERT_TRUE(eventually([&] { return recorder.state().recording; }));
            EstimateRow second = someEstimate(1, 0);
            second.role = EstimateRole::Second;
            recorder.record(second);
            const std::int64_t before = recorder.state().frames;
            recorder.add(busFrames(0, 10));
            ASSERT_TRUE(eventually([&] { return recorder.state().frames == before + 10; }));
            recorder.setOn(false);
            ASSERT_TRUE(eventually([&] { return !recorder.state().recording; }));
        }
    }
    const auto files = filesIn(folder);
    ASSERT_EQ(files.size(), 2U);
    for (const std::string& file : files) {
        auto reader = SessionReader::open(file);
        ASSERT_TRUE(reader) << reader.error().text;
        const auto found = reader->verify();
        EXPECT_FALSE(found.broken) << found.broken->why.english();
        EXPECT_NE(reader->proposal(1), nullptr) << file;
        EXPECT_NE(reader->estimate(1), nullptr) << file;
        EXPECT_NE(reader->estimate(2), nullptr) << file;
        for (const EventRow& event : reader->events()) EXPECT_NE(event.kind, EventKind::Gap);
    }
    EXPECT_TRUE(hasEvent(*SessionReader::open(files[0]), EventKind::Decision, "approve"));
    EXPECT_TRUE(hasEvent(*SessionReader::open(files[1]), EventKind::Decision, "stop"));
}

TEST_F(Recorder, everyFileBeginsWithThePresentState)
{
    {
        SessionRecorder recorder(options);
        recorder.record(ModelRow{.id = 0, .name = "default.ttm"});
        recorder.record(someScene(1, 0));
        recorder.record(someEstimate(1, 0));
        const auto log = [&](EventKind kind, const char* subject, const char* text,
                             std::optional<double> number = {}) {
            recorder.record(EventRow{
                .kind = kind, .subject = subject, .text = text, .number = number, .estimate = 1});
        };
        log(EventKind::Phase, "pressing", "");
        log(EventKind::Phase, "ready", "");
        log(EventKind::Link, "up", "");
        log(EventKind::TelemetryGap, "", "");
        log(EventKind::Override, "", "roll 9");
        log(EventKind::Forgotten, "", "the robot has moved");
        log(EventKind::Alarm, "load", "too much", 3.0);
        log(EventKind::Alarm, "link", "gone", 3.0);
        log(EventKind::Alarm, "link", "", 0.0);
        log(EventKind::Word, "note", "said once");
        ASSERT_TRUE(eventually([&] { return recorder.state().recording; }));
        recorder.setOn(false);
        ASSERT_TRUE(eventually([&] { return !recorder.state().recording; }));
        recorder.setOn(true);
        ASSERT_TRUE(eventually([&] { return recorder.state().recording; }));
    }
    const auto files = filesIn(folder);
    ASSERT_EQ(files.size(), 2U);
    const auto next = SessionReader::open(files[1]);
    ASSERT_TRUE(next) << next.error().text;
    std::vector<std::string> told;
    for (const EventRow& event : next->events())
        told.push_back(std::string(name(event.kind)) + ' ' + event.subject + ' ' + event.text);
    std::sort(told.begin(), told.end());
    const std::string after = "session continued after " + files[0];
    EXPECT_EQ(told,
              (std::vector<std::string>{"alarm load too much", "forgotten  the robot has moved",
                                        "link up ", "override  roll 9", "phase ready ", after,
                                        "session ended closed with the console", "unheard  "}));
    EXPECT_NE(next->estimate(1), nullptr);

    const std::string merged = folder + "/both.tts";
    ASSERT_TRUE(mergeSessionFiles(files, merged));
    const auto whole = SessionReader::open(merged);
    ASSERT_TRUE(whole) << whole.error().text;
    const auto& events = whole->events();
    EXPECT_EQ(std::count_if(events.begin(), events.end(),
                            [](const EventRow& e) { return e.kind == EventKind::Override; }),
              1);
    EXPECT_EQ(std::count_if(events.begin(), events.end(),
                            [](const EventRow& e) { return e.kind == EventKind::Phase; }),
              2);
}

TEST_F(Recorder, leavesNoFileIfNothingWasRecorded)
{
    options.batch = 10s;
    {
        const SessionRecorder recorder(options);
    }
    EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST_F(Recorder, writesForItsOwnerAlone)
{
    const mode_t before = ::umask(022);
    const std::string deep = folder + "/of/a/user";
    options.folder = deep;
    {
        SessionRecorder recorder(options);
        recorder.record(EventRow{.kind = EventKind::Marker});
        ASSERT_TRUE(eventually([&] { return recorder.state().recording; }));
    }
    ::umask(before);
    const auto modeOf = [](const std::string& path) {
        struct stat file {};
        EXPECT_EQ(::stat(path.c_str(), &file), 0) << path;
        return file.st_mode & 0777U;
    };
    EXPECT_EQ(modeOf(filesIn(deep).front()), 0600U);
    for (const char* const made : {"", "/of", "/of/a", "/of/a/user"})
        EXPECT_EQ(modeOf(folder + made), 0700U) << made;
}

TEST_F(Recorder, withoutAFolderReportsIt)
{
    const std::string none = "there is no home folder to record in: --sessions names another";
    for (const auto& [where, said] :
         {std::pair(std::string(), none),
          std::pair(std::string("/proc/terratact"),
                    std::string("/proc/terratact: the directory cannot be made: "))}) {
        options.folder = where;
        SessionRecorder recorder(options);
        recorder.record(EventRow{.kind = EventKind::Marker});
        ASSERT_TRUE(eventually([&] { return !recorder.state().trouble.empty(); }));
        EXPECT_TRUE(recorder.state().trouble.english().starts_with(said))
            << recorder.state().trouble.english();
    }
}

TEST_F(Recorder, refusesABusWhoseNameMovesTheCursor)
{
    options.start.bus = "can\x1b[2J0";
    SessionRecorder recorder(options);
    recorder.record(EventRow{.kind = EventKind::Marker});
    ASSERT_TRUE(eventually([&] { return !recorder.state().trouble.empty(); }));
    EXPECT_NE(recorder.state().trouble.english().find("'can?[2J0' has control characters"),
              std::string::npos)
        << recorder.state().trouble.english();
    EXPECT_TRUE(filesIn(folder).empty());
}

// Records 3.6 million frames, an hour at 1 kHz, as fast as they are accepted. TERRATACT_RECORD_FRAMES sets the number.
TEST_F(Recorder, costsLittle)
{
    const char* const given = std::getenv("TERRATACT_RECORD_FRAMES");
    const std::int64_t frames = given ? std::atoll(given) : 60'000;
    const auto cpu = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
    std::int64_t bytes = 0;
    const double begin = cpu(), began = steadyNow();
    {
        options.batch = 50ms;  // batches of at most 9,000 frames
        options.mostBytes = std::int64_t{1} << 40U;
        SessionRecorder recorder(options);
        for (std::int64_t n = 0; n < frames; n += 250) {
            recorder.add(busFrames(n, 250));
            ASSERT_TRUE(eventually([&] { return recorder.state().frames + 9000 > n; }));
        }
        ASSERT_TRUE(eventually([&] { return recorder.state().frames == frames; }));
        EXPECT_EQ(recorder.state().missing, 0);
    }
    bytes = static_cast<std::int64_t>(std::filesystem::file_size(filesIn(folder).front()));
    const double perHour = 3.6e6 / static_cast<double>(frames);
    std::printf("%lld frames: %.2f s of CPU (%.2f %% of a core at 1 kHz), %.1f s, %.1f MB; an hour "
                "at 1 kHz: %.0f MB\n",
                static_cast<long long>(frames), cpu() - begin,
                100.0 * (cpu() - begin) * perHour / 3600.0, steadyNow() - began,
                static_cast<double>(bytes) / 1e6, static_cast<double>(bytes) / 1e6 * perHour);
    EXPECT_LT(static_cast<double>(bytes) / static_cast<double>(frames), 130e6 / 3.6e6);
}

}  // namespace
}  // namespace terratact
