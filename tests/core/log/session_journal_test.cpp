// Sessions whose program died and whose journal is damaged, foreign or read by others.
#include "core/log/session_journal.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

#include "core/log/session_reader.h"
#include "core/log/session_salvage.h"
#include "core/log/session_summary.h"
#include "core/log/session_writer.h"
#include "tests/core/log/session_fixture.h"

namespace terratact {
namespace {

struct CrashedSession : Session {
    CrashedSession() { path = directory.file("session.tts"); }

    /// Zeroes a frame of the journal, counted from 0. Returns the journal as it is then.
    std::string zeroFrame(std::size_t number)
    {
        constexpr std::size_t kBytes = 8192;  // of a page
        holeAt = 32 + number * (24 + kBytes);
        std::string journal = contentOf(path + "-wal");
        journal.replace(holeAt, kBytes, kBytes, '\0');
        return contentOf(directory.write("session.tts-wal", journal));
    }
    bool saysWhere(const Message& said) const
    {
        const std::string where = "is damaged from byte " + std::to_string(holeAt) + ": ";
        return said.english().find(where) != std::string::npos;
    }
    /// Returns the number of the last frame that is saved.
    std::int64_t lastSaved() const
    {
        const std::string scratch = directory.file("scratch.tts");
        if (!salvagePages(path, scratch)) return 0;
        const auto reader = SessionReader::openFragments(scratch);
        return reader ? reader->frameCount() : 0;
    }
    std::size_t holeAt = 0;
};

TEST_F(CrashedSession, aHoleInItsJournalIsNamedAndTheRestIsSaved)
{
    constexpr std::int64_t kFrames = 100 * (SessionWriter::kCheckpointBatches + 10);
    crashed(path, kFrames);
    EXPECT_TRUE(SessionReader::open(path)->damage().empty()) << "older frames are no damage";
    const std::string journal = zeroFrame(3), before = contentOf(path);
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_LT(reader->frameCount(), kFrames);
    ASSERT_EQ(reader->damage().size(), 1U);
    EXPECT_TRUE(saysWhere(reader->damage()[0].why)) << reader->damage()[0].why.english();
    EXPECT_FALSE(reader->verify().damage.empty());
    const auto summary = summarizeSession(path);
    ASSERT_TRUE(summary) << summary.error().text;
    EXPECT_EQ(summary->closing, SessionClosing::Torn);
    EXPECT_TRUE(summary->damage && saysWhere(*summary->damage));
    for (const bool evenAlone : {false, true}) {
        const auto recovered = recoverSession(path, evenAlone);
        ASSERT_FALSE(recovered);
        EXPECT_TRUE(saysWhere(recovered.error().message)) << recovered.error().text;
    }
    EXPECT_EQ(lastSaved(), kFrames) << "also what is behind the hole";
    EXPECT_EQ(contentOf(path + "-wal"), journal);
    EXPECT_EQ(contentOf(path), before);
}

/// All of the journal is in the file already. Its frames before the hole are older than the file.
TEST_F(CrashedSession, itsDamagedJournalIsNotCalledForeign)
{
    constexpr std::int64_t kFrames = 100 * SessionWriter::kCheckpointBatches;
    crashed(path, kFrames);
    const std::string journal = zeroFrame(12);
    const auto saysSo = [this](const auto& result) {
        return !result && saysWhere(result.error().message);
    };
    EXPECT_TRUE(saysSo(SessionReader::open(path)));
    EXPECT_TRUE(saysSo(summarizeSession(path)));
    EXPECT_TRUE(saysSo(recoverSession(path)));
    EXPECT_EQ(lastSaved(), kFrames);
    EXPECT_EQ(contentOf(path + "-wal"), journal);
}

TEST_F(CrashedSession, readingItLeavesNoFileBesideIt)
{
    crashed(path, 500);
    const std::set<std::string> files{"session.tts", "session.tts-wal"};
    EXPECT_EQ(SessionReader::open(path)->verify().frames, 500);
    EXPECT_EQ(directory.entries(), files);
    directory.write("session.tts-wal", std::string(50'000, 'x'));
    EXPECT_EQ(SessionReader::open(path)->damage().size(), 1U);
    EXPECT_EQ(directory.entries(), files);
}

TEST_F(CrashedSession, itIsNotClosedWhileSomebodyReadsIt)
{
    crashed(path, 500);
    {
        const auto reader = SessionReader::open(path);
        ASSERT_TRUE(reader) << reader.error().text;
        EXPECT_EQ(*recoverSession(path), SessionRecovery::InUse);
    }
    EXPECT_EQ(*recoverSession(path), SessionRecovery::Recovered);
}

TEST_F(CrashedSession, aBrokenJournalBesideAnIndexIsNamed)
{
    crashed(path, 500);
    directory.write("session.tts-wal", std::string(50'000, 'x'));
    directory.write("session.tts-shm", std::string(32'768, '\0'));  // of the dead program
    const auto summary = summarizeSession(path);
    ASSERT_TRUE(summary) << summary.error().text;
    EXPECT_EQ(summary->closing, SessionClosing::Torn);
    ASSERT_TRUE(summary->damage);
    EXPECT_NE(summary->damage->english().find("session.tts-wal is damaged from its beginning"),
              std::string::npos)
        << summary->damage->english();
}

}  // namespace
}  // namespace terratact
