// Damaged sessions: without their journal, in a read-only folder, cut, with holes, with shared
// pages.
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>

#include "core/log/session_journal.h"
#include "core/log/session_reader.h"
#include "core/log/session_salvage.h"
#include "core/log/session_summary.h"
#include "core/log/session_writer.h"
#include "tests/core/log/session_fixture.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

constexpr std::size_t kPage = 8192;

struct DamagedSession : testing::Test {
    void crash(std::int64_t frames) const { crashed(path, frames); }
    void seal(std::int64_t frames)
    {
        auto writer = someSession(path, frames);
        ASSERT_TRUE(writer && writer->seal());
    }
    std::string copyAlone()
    {
        const std::string alone = directory.file("alone.tts");
        std::filesystem::copy_file(path, alone);
        return alone;
    }
    /// Returns the number of frames that the pages of the damaged file still give.
    std::int64_t savedFrom(const std::string& damaged)
    {
        const std::string file = directory.write("damaged.tts", damaged);
        const std::string scratch = directory.file("scratch.tts");
        std::filesystem::remove(scratch);
        const auto pages = salvagePages(file, scratch);
        if (!pages) return 0;
        EXPECT_EQ(contentOf(file), damaged) << "the damaged file is only read";
        auto reader = SessionReader::openFragments(scratch);
        EXPECT_TRUE(reader) << reader.error().text;
        if (!reader) return 0;
        std::int64_t count = 0;
        for (std::size_t i = 0; i < reader->batches().size(); ++i)
            for (const FrameRow& frame : reader->frames(i)) {
                EXPECT_EQ(frame, someFrame(frame.time / 1'000'000));
                ++count;
            }
        return count;
    }

    TemporaryDirectory directory;
    std::string path = directory.file("session.tts");
};

TEST_F(DamagedSession, mainFileIsASessionFromTheStart)
{
    const auto writer = someSession(path, 100);
    ASSERT_TRUE(writer) << writer.error().text;
    const std::string alone = copyAlone();
    const auto reader = SessionReader::open(alone);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_EQ(reader->start(), someStart());
    EXPECT_FALSE(reader->sealed());
    EXPECT_TRUE(reader->lacksJournal());
    ASSERT_EQ(reader->damage().size(), 1U);
    EXPECT_NE(reader->damage()[0].why.english().find("its journal alone.tts-wal is not beside it"),
              std::string::npos)
        << reader->damage()[0].why.english();
    EXPECT_FALSE(std::filesystem::exists(alone + "-wal")) << "looking at it must not make one";
    EXPECT_FALSE(std::filesystem::exists(alone + "-shm"));
}

TEST_F(DamagedSession, mainFileAloneHasAllButTheLastBatches)
{
    constexpr std::int64_t kBatches = 60;
    const auto writer = someSession(path, 100 * kBatches);
    ASSERT_TRUE(writer) << writer.error().text;
    const auto reader = SessionReader::open(copyAlone());
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_GE(reader->frameCount(), 100 * (kBatches - SessionWriter::kCheckpointBatches));
}

TEST_F(DamagedSession, journalAloneIsNamedInTheError)
{
    (void)SqliteFile::createLog(path);  // a session before its first checkpoint
    for (const char* const end : {"-wal", "-shm"}) std::filesystem::remove(path + end);
    const auto reader = SessionReader::open(path);
    ASSERT_FALSE(reader);
    EXPECT_NE(reader.error().text.find("without its journal session.tts-wal"), std::string::npos)
        << reader.error().text;
    const auto recovered = recoverSession(path);
    ASSERT_FALSE(recovered);
    EXPECT_NE(recovered.error().text.find("both files belong together"), std::string::npos);
}

TEST_F(DamagedSession, emptyJournalIsAMissingOne)
{
    crash(500);
    std::filesystem::resize_file(path + "-wal", 0);
    const std::string before = contentOf(path);
    const auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_TRUE(reader->lacksJournal());
    const auto recovered = recoverSession(path);
    ASSERT_FALSE(recovered);
    EXPECT_NE(recovered.error().text.find("both files belong together"), std::string::npos);
    EXPECT_EQ(contentOf(path), before);
}

TEST_F(DamagedSession, aLinkIsReadWithTheJournalOfItsFile)
{
    crash(500);
    std::filesystem::create_directory(directory.file("there"));
    const std::string link = directory.file("there/link.tts");
    std::filesystem::create_symlink("../session.tts", link);
    auto reader = SessionReader::open(link);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_FALSE(reader->lacksJournal());
    EXPECT_EQ(reader->verify().frames, 500);
    const auto pages = salvagePages(link, directory.file("scratch.tts"));
    EXPECT_TRUE(pages) << pages.error().text;
}

TEST_F(DamagedSession, aJournalThatIsALinkOrAPipeIsNamed)
{
    crash(500);
    const std::string before = contentOf(path), journal = path + "-wal";
    std::filesystem::rename(journal, directory.file("real"));
    std::filesystem::create_symlink("real", journal);
    const auto linked = SessionReader::open(path);
    ASSERT_FALSE(linked);
    EXPECT_NE(linked.error().text.find("its journal is a symbolic link"), std::string::npos)
        << linked.error().text;
    std::filesystem::remove(journal);
    ASSERT_EQ(::mkfifo(journal.c_str(), 0600), 0);
    const auto recovered = recoverSession(path);
    ASSERT_FALSE(recovered);
    EXPECT_NE(recovered.error().text.find("session.tts-wal is not a file"), std::string::npos);
    EXPECT_EQ(contentOf(path), before);
    EXPECT_TRUE(std::filesystem::is_fifo(journal));
}

TEST_F(DamagedSession, aPipeHasNoJournalOfAnotherSession)
{
    const std::string pipe = directory.file("pipe.tts");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_FALSE(hasForeignJournal(pipe)) << "and does not wait for a writer";
}

/// The journal of a session under the same name was left where a closed or open session was put.
TEST_F(DamagedSession, aJournalOfAnotherSessionIsRefused)
{
    constexpr std::int64_t kFrames = 100 * (SessionWriter::kCheckpointBatches + 5);
    const std::string other = directory.file("other.tts");
    const pid_t child = ::fork();
    if (child == 0) {
        SessionStart start = someStart();
        start.wallTime += 1;
        ::_exit(someSession(other, kFrames, start) ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_EQ(status, 0);
    crash(500);
    std::filesystem::rename(path + "-wal", other + "-wal");
    std::filesystem::remove(other + "-shm");
    const std::string before = contentOf(other);
    const auto refused = [](const auto& result) {
        return !result
            && result.error().text.find("its journal other.tts-wal was written for another session")
                   != std::string::npos;
    };
    EXPECT_TRUE(refused(SessionReader::open(other)));
    EXPECT_TRUE(refused(summarizeSession(other)));
    EXPECT_TRUE(refused(recoverSession(other)));
    EXPECT_TRUE(refused(recoverSession(other, true)));
    EXPECT_EQ(contentOf(other), before);
    const std::string scratch = directory.file("scratch.tts");
    ASSERT_TRUE(salvagePages(other, scratch));
    const auto saved = SessionReader::openFragments(scratch);
    ASSERT_TRUE(saved) << saved.error().text;
    EXPECT_EQ(saved->start().wallTime, someStart().wallTime + 1);
    EXPECT_GE(saved->frameCount(), 100 * SessionWriter::kCheckpointBatches);
}

/// Another user's session is read without locks, so its writer may move more batches into the file meanwhile.
TEST_F(DamagedSession, aSessionThatGrewSinceItWasOpenedKeepsItsJournal)
{
    crash(100 * (SessionWriter::kCheckpointBatches + 5));
    const std::string opened = path;
    path = directory.file("before.tts");
    crash(500);
    SqliteFile before = SqliteFile::openLogWithoutTrace(path, 1 << 20);
    EXPECT_NO_THROW(requireOwnJournal(opened, before));
}

/// Runs in a process of a user without write permission. Returns its exit status.
int asNobody(const std::function<int()>& work)
{
    const pid_t child = ::fork();
    if (child == 0) {
        if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(99);
        ::_exit(work());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(DamagedSession, isReadWithItsJournalFromAReadOnlyFolder)
{
    crash(500);
    const std::string folder = directory.file("");
    for (const char* const end : {"", "-wal"}) ASSERT_EQ(::chmod((path + end).c_str(), 0444), 0);
    ASSERT_EQ(::chmod(folder.c_str(), 0555), 0);
    const int frames = asNobody([&] {
        auto reader = SessionReader::open(path);
        if (!reader) return 1;
        const SessionVerification found = reader->verify();
        return found.broken || !found.damage.empty() ? 2 : static_cast<int>(found.frames / 10);
    });
    ASSERT_EQ(::chmod(folder.c_str(), 0755), 0);
    EXPECT_EQ(frames, 50);
    EXPECT_EQ(directory.entries(), (std::set<std::string>{"session.tts", "session.tts-wal"}));
}

TEST_F(DamagedSession, anotherUserLeavesNoIndexThatItsOwnerCannotWrite)
{
    crash(500);
    const std::string folder = directory.file("");
    for (const char* const end : {"", "-wal"}) ASSERT_EQ(::chmod((path + end).c_str(), 0644), 0);
    ASSERT_EQ(::chmod(folder.c_str(), 0777), 0);
    if (::geteuid() != 0) GTEST_SKIP() << "only root can be another user";
    EXPECT_EQ(asNobody([&] { return SessionReader::open(path) ? 0 : 1; }), 0);
    EXPECT_EQ(directory.entries(), (std::set<std::string>{"session.tts", "session.tts-wal"}));
    ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
    ASSERT_TRUE(SessionReader::open(path));
    EXPECT_EQ(directory.entries(), (std::set<std::string>{"session.tts", "session.tts-wal"}))
        << "its owner may make it writable later, and the index would stay write-protected";
}

TEST_F(DamagedSession, cutAnywhereKeepsTheRowsBeforeTheCut)
{
    seal(20'000);
    const std::string whole = contentOf(path);
    const std::size_t pages = whole.size() / kPage;
    std::int64_t before = 0;
    for (std::size_t kept = 20; kept <= pages; kept += 11) {
        const std::int64_t saved = savedFrom(whole.substr(0, kept * kPage + 100));
        EXPECT_GE(saved, before) << "more of the file yields no less";
        before = saved;
    }
    const std::int64_t half = savedFrom(whole.substr(0, whole.size() / 2));
    EXPECT_GT(half, 5000);
    EXPECT_EQ(savedFrom(whole), 20'000);
    EXPECT_EQ(savedFrom(whole + std::string(50'000, 'x')), 20'000) << "something behind its end";
    EXPECT_EQ(savedFrom(whole.substr(0, 2 * kPage)), 0);
}

TEST_F(DamagedSession, holesLoseOnlyTheirOwnRows)
{
    seal(5000);
    const std::string whole = contentOf(path);
    const std::size_t pages = whole.size() / kPage;
    std::int64_t worst = 5000;
    for (std::size_t page = 0; page < pages; ++page) {
        std::string damaged = whole;
        damaged.replace(page * kPage, kPage, kPage, '\0');
        worst = std::min(worst, savedFrom(damaged));
        damaged.replace(page * kPage, kPage, kPage, '\xff');
        worst = std::min(worst, savedFrom(damaged));
        if (page < 17) page += 3;  // every fourth of the first pages
    }
    EXPECT_GT(worst, 0) << "no page is needed for all the others";
}

/// Changes the session's pages without SQLite.
void makeOverflowShared(const std::string& path)
{
    std::string bytes = contentOf(path);
    // Every text of the events is longer than a page: its cell ends with the number of the next
    // page.
    std::string first;
    for (std::size_t page = 1; page < bytes.size() / kPage; ++page) {
        const std::size_t at = page * kPage;
        const auto number = [&](std::size_t i, int count) {
            std::size_t value = 0;
            for (int k = 0; k < count; ++k)
                value = value << 8U
                      | static_cast<unsigned char>(bytes[at + i + static_cast<std::size_t>(k)]);
            return value;
        };
        if (bytes[at] != 13) continue;
        for (std::size_t cell = 0; cell < number(3, 2); ++cell) {
            const std::size_t begin = number(8 + 2 * cell, 2);
            const std::size_t size = (number(begin, 1) & 0x7FU) << 14U
                                   | (number(begin + 1, 1) & 0x7FU) << 7U | number(begin + 2, 1);
            if (number(begin, 1) < 0x80 || number(begin + 1, 1) < 0x80 || size > 100'000) continue;
            const std::size_t least = (kPage - 12) * 32 / 255 - 23;
            std::size_t local = least + (size - least) % (kPage - 4);
            if (local > kPage - 35) local = least;
            const std::size_t overflow =
                at + begin + 3 + (number(begin + 3, 1) < 0x80 ? 1 : 2) + local;
            if (first.empty())
                first = bytes.substr(overflow, 4);
            else
                bytes.replace(overflow, 4, first);
        }
    }
    ASSERT_FALSE(first.empty());
    std::ofstream(path, std::ios::binary) << bytes;
}

TEST_F(DamagedSession, pagesThatRowsShareAreFound)
{
    {
        auto writer = SessionWriter::create(path, someStart());
        ASSERT_TRUE(writer);
        for (int i = 0; i < 40; ++i)
            ASSERT_TRUE(writer->add(EventRow{.text = std::string(60'000, 'x')}));
        ASSERT_TRUE(writer->seal());
    }
    makeOverflowShared(path);
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    ASSERT_FALSE(reader->damage().empty());
    EXPECT_NE(reader->damage().back().why.english().find("2nd reference to page"),
              std::string::npos)
        << reader->damage().back().why.english();
    EXPECT_FALSE(reader->verify().damage.empty());
}

TEST_F(DamagedSession, textsThatNoWriterWritesAreRefused)
{
    {
        auto writer = SessionWriter::create(path, someStart());
        ASSERT_TRUE(writer);
        ASSERT_TRUE(writer->add(EventRow{.text = std::string(70'000, 'x') + "\xc3\xa4"}));
        ASSERT_TRUE(writer->seal());
    }
    const auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    ASSERT_EQ(reader->events().size(), 1U);
    EXPECT_EQ(reader->events()[0].text.size(), 65'536U) << "cut where it is written";
}

}  // namespace
}  // namespace terratact
