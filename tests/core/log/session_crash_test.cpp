// Sessions that are truncated, have flipped bytes, or whose writer was killed or found a full disk.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <thread>

#include "core/log/session_reader.h"
#include "core/log/session_writer.h"
#include "tests/core/log/session_fixture.h"
#include "tests/support/sessions/sessions.h"

namespace terratact {
namespace {

TEST_F(Session, truncatedAnywhereItOpensOrIsRefusedWithAReason)
{
    seal(path, 2000);
    const std::string whole = contentOf(path);
    int opened = 0;
    for (std::size_t size = 0; size < whole.size(); size += 4096) {
        std::ofstream(path, std::ios::binary) << whole.substr(0, size);
        auto reader = SessionReader::open(path);
        if (!reader) {
            EXPECT_EQ(reader.error().text.find(path), 0U) << reader.error().text;
            continue;
        }
        ++opened;
        for (const FrameRow& frame : allFrames(*reader))
            ASSERT_EQ(frame, someFrame(frame.time / 1'000'000));
    }
    std::printf("%zu truncations, %d opened\n", whole.size() / 4096, opened);
}

TEST_F(Session, flippedBytesHideRowsOrGiveAReason)
{
    seal(path, 500);
    const std::string whole = contentOf(path);
    std::mt19937 random(7);
    int opened = 0, hurt = 0;
    const int flips = countFrom("TERRATACT_FLIPS", 1000);
    for (int i = 0; i < flips; ++i) {
        std::string damaged = whole;
        const std::size_t at = random() % damaged.size();
        damaged[at] = static_cast<char>(damaged[at] ^ static_cast<char>(1U << random() % 8));
        std::ofstream(path, std::ios::binary) << damaged;
        auto reader = SessionReader::open(path);
        if (!reader) {
            ASSERT_EQ(reader.error().text.find(path), 0U) << reader.error().text;
            continue;
        }
        ++opened;
        const auto frames = allFrames(*reader);
        for (const FrameRow& frame : frames)
            ASSERT_EQ(frame, someFrame(frame.time / 1'000'000)) << "byte " << at;
        for (const EventRow& event : reader->events()) {
            if (event.id != 2) continue;
            ASSERT_EQ(event, someDecision(250'000'000));
        }
        if (frames.size() == 500) continue;
        ++hurt;
        ASSERT_FALSE(reader->damage().empty()) << "byte " << at << ": frames are missing unseen";
    }
    std::printf("%d flips: %d opened, %d of them with lost intervals\n", flips, opened, hurt);
}

/// Writes frames into a session without end, and the number of committed frames into `out`.
[[noreturn]] void recordUntilKilled(const std::string& path, int out)
{
    auto writer = someSession(path, 100);
    if (!writer) ::_exit(1);
    for (std::int64_t n = 100;; ++n) {
        if (!writer->add(someFrame(n))) ::_exit(1);
        if (n % 50 != 49) continue;
        if (!writer->commit()) ::_exit(1);
        const std::int64_t committed = writer->frames();
        if (::write(out, &committed, sizeof committed) != sizeof committed) ::_exit(1);
    }
}

// TERRATACT_KILLS=1000 runs the full test.
TEST_F(Session, whatWasCommittedOutlivesAKill)
{
    const int kills = countFrom("TERRATACT_KILLS", 60);
    std::mt19937 random(11);
    std::int64_t kept = 0, more = 0;
    for (int i = 0; i < kills; ++i) {
        const std::string file = directory.file("killed.tts");
        for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(file + end);
        int ends[2];
        ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
        const pid_t child = ::fork();
        if (child == 0) recordUntilKilled(file, ends[1]);
        ::close(ends[1]);
        std::int64_t committed = 0, next = 0;
        ASSERT_EQ(::read(ends[0], &next, sizeof next), static_cast<ssize_t>(sizeof next));
        committed = next;
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 60'000));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        while (::read(ends[0], &next, sizeof next) == static_cast<ssize_t>(sizeof next))
            committed = next;
        ::close(ends[0]);

        auto reader = SessionReader::open(file);  // without any repair
        ASSERT_TRUE(reader) << reader.error().text;
        const auto frames = allFrames(*reader);
        ASSERT_GE(static_cast<std::int64_t>(frames.size()), committed) << "kill " << i;
        for (std::size_t n = 0; n < frames.size(); ++n)
            ASSERT_EQ(frames[n], someFrame(static_cast<std::int64_t>(n))) << "kill " << i;
        ASSERT_FALSE(reader->verify().broken);
        kept += committed;
        more += static_cast<std::int64_t>(frames.size()) - committed;
    }
    std::printf("%d kills: %lld acknowledged frames, none lost, %lld more kept; no chain broken\n",
                kills, static_cast<long long>(kept), static_cast<long long>(more));
}

TEST_F(Session, isRecoveredWithAnEventAfterItsWriterDied)
{
    int ends[2];
    ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    const pid_t child = ::fork();
    if (child == 0) recordUntilKilled(path, ends[1]);
    std::int64_t committed = 0;
    for (int i = 0; i < 5; ++i)
        ASSERT_EQ(::read(ends[0], &committed, sizeof committed),
                  static_cast<ssize_t>(sizeof committed));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ends[0]);
    ::close(ends[1]);

    const auto recovered = recoverSession(path);
    ASSERT_TRUE(recovered) << recovered.error().text;
    EXPECT_EQ(*recovered, SessionRecovery::Recovered);
    EXPECT_EQ(*recoverSession(path), SessionRecovery::NotNeeded);
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_TRUE(reader->sealed());
    EXPECT_GE(reader->frameCount(), committed);
    EXPECT_EQ(reader->events().back().subject, "recovered");
    EXPECT_FALSE(reader->verify().broken);
}

TEST_F(Session, fullDiskKeepsWhatWasCommitted)
{
    const pid_t child = ::fork();
    if (child == 0) {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{1'000'000, 1'000'000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        auto writer = someSession(path, 100);
        Status last = Done{};
        for (std::int64_t n = 100; last && n < 1'000'000; ++n) {
            last = writer->add(someFrame(n));
            if (last && n % 50 == 49) last = writer->commit();
        }
        ::_exit(last ? 1 : 0);  // it has to fail with an Error
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    const auto frames = allFrames(*reader);
    EXPECT_GT(frames.size(), 1000U);
    for (std::size_t n = 0; n < frames.size(); ++n)
        ASSERT_EQ(frames[n], someFrame(static_cast<std::int64_t>(n)));
    EXPECT_FALSE(reader->verify().broken);
}

}  // namespace
}  // namespace terratact
