// Tests what counts as damage of a write-ahead journal.
#include "core/store/sqlite_journal.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/store/sqlite.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

constexpr std::size_t kHead = 32, kFrame = 24 + 8192;  // [bytes] pages of SqliteFile::createLog()

void invert(std::string& bytes, std::size_t at)
{
    bytes[at] = static_cast<char>(~bytes[at]);
}

struct Journal : testing::Test {
    /// Commits one row after the other.
    void add(int rows)
    {
        for (int i = 0; i < rows; ++i)
            file.run("INSERT INTO t(text) VALUES('" + std::string(300, 'x') + "')");
    }
    std::string bytes() const { return contentOf(SqliteFile::journalOf(path)); }
    std::optional<JournalDamage> damageOf(const std::string& journal) const
    {
        return journalDamage(directory.write("copy", journal));
    }
    /// Returns the number of frames for which `is` returns true.
    std::size_t count(const std::string& journal, bool (JournalFrames::*is)() const) const
    {
        JournalFrames frame(directory.write("copy", journal));
        std::size_t found = 0;
        while (frame.next())
            if ((frame.*is)()) ++found;
        return found;
    }
    std::size_t intact(const std::string& journal) const
    {
        return count(journal, &JournalFrames::isIntact);
    }

    TemporaryDirectory directory;
    std::string path = directory.file("log");
    SqliteFile file = SqliteFile::createLog(path);
    void SetUp() override { file.run("CREATE TABLE t(id INTEGER PRIMARY KEY, text TEXT)"); }
};

/// A journal that was restarted twice: its end holds frames of both times before.
struct UsedAgain : Journal {
    void SetUp() override
    {
        Journal::SetUp();
        for (const int rows : {40, 20, 10}) {
            file.checkpoint();
            add(rows);
        }
        whole = bytes();
        frames = intact(whole);
    }
    std::string whole;
    std::size_t frames = 0;  // intact ones
};

TEST_F(UsedAgain, olderFramesAreNoDamage)
{
    ASSERT_GE(frames, 10U);
    const std::size_t older = count(whole, &JournalFrames::isOlder);
    EXPECT_EQ(frames + older, (whole.size() - kHead) / kFrame);
    EXPECT_GE(older, 30U);
    EXPECT_EQ(damageOf(whole), std::nullopt);
    std::string hole = whole;
    hole.replace(kHead + (frames + 5) * kFrame, 20'000, 20'000, '\0');
    EXPECT_EQ(damageOf(hole), std::nullopt) << "nothing that is read is there";
}

TEST_F(UsedAgain, zerosAndOtherBytesAreDamageFromThere)
{
    for (const char byte : {'\0', 'x'}) {
        std::string hole = whole;
        hole.replace(kHead + 3 * kFrame, 8192, 8192, byte);
        EXPECT_EQ(damageOf(hole), (JournalDamage{kHead + 3 * kFrame, frames - 3}));
        std::string rest = whole;
        rest.replace(kHead, std::string::npos, whole.size() - kHead, byte);
        EXPECT_EQ(damageOf(rest), (JournalDamage{kHead, (whole.size() - kHead) / kFrame}));
    }
}

TEST_F(UsedAgain, aChangedByteIsDamage)
{
    for (const std::size_t at : {std::size_t{0}, std::size_t{5}, std::size_t{17}, kFrame - 1}) {
        std::string changed = whole;
        invert(changed, kHead + 4 * kFrame + at);
        EXPECT_EQ(damageOf(changed), (JournalDamage{kHead + 4 * kFrame, frames - 4})) << at;
    }
}

TEST_F(UsedAgain, aDamagedHeaderIsDamageFromTheBeginning)
{
    for (std::size_t at = 0; at < kHead; ++at) {
        std::string changed = whole;
        invert(changed, at);
        EXPECT_EQ(damageOf(changed), JournalDamage{}) << at;
    }
    EXPECT_EQ(damageOf(whole.substr(0, kHead - 1)), JournalDamage{});
    EXPECT_EQ(damageOf(""), std::nullopt);
    EXPECT_EQ(journalDamage(directory.file("nothing")), std::nullopt);
    EXPECT_EQ(journalDamage(directory.file("")), std::nullopt);
}

TEST_F(UsedAgain, anEndWithinAFrameIsNoDamage)
{
    for (std::size_t size = kHead; size < whole.size(); size += 3001)
        EXPECT_EQ(damageOf(whole.substr(0, size)), std::nullopt) << size;
}

TEST_F(UsedAgain, aLastFrameWithoutItsPageIsNoDamage)
{
    std::string died = whole;
    died.replace(kHead + (frames - 1) * kFrame + 24, 8192, whole, kHead + frames * kFrame, 8192);
    EXPECT_EQ(intact(died), frames - 1) << "its writer was killed before it wrote the page";
    EXPECT_EQ(damageOf(died), std::nullopt);
}

TEST_F(UsedAgain, aTornLastTransactionIsNoDamage)
{
    file.run("BEGIN");
    add(100);
    file.run("COMMIT");
    const auto torn = [this] {  // a power loss may leave any of its pages as they were
        return bytes().replace(kHead + frames * kFrame + 24, 8192, 8192, '\0');
    };
    ASSERT_GE(intact(bytes()), frames + 3);
    EXPECT_EQ(intact(torn()), frames);
    EXPECT_EQ(damageOf(torn()), std::nullopt);
    add(1);
    const std::size_t all = intact(bytes());
    EXPECT_EQ(damageOf(torn()), (JournalDamage{kHead + frames * kFrame, all - frames}))
        << "it was committed before the next one began";
}

/// A journal that grew by a last transaction of several frames.
struct Grown : Journal {
    void SetUp() override
    {
        Journal::SetUp();
        add(5);
        committed = bytes().size();
        file.run("BEGIN");
        add(100);
        file.run("COMMIT");
        whole = bytes();
        ASSERT_GE(whole.size(), committed + 3 * kFrame);
        ASSERT_EQ(intact(whole), (whole.size() - kHead) / kFrame);
    }
    /// Returns the journal with zeros instead of the bytes from there on.
    std::string zerosFrom(std::size_t at) const
    {
        return whole.substr(0, at) + std::string(whole.size() - at, '\0');
    }
    std::string whole;
    std::size_t committed = 0;  // bytes before the last transaction
};

TEST_F(Grown, zerosUpToItsEndAreNoDamage)
{
    constexpr std::size_t kBlock = 4096;  // of a file system
    EXPECT_EQ(damageOf(zerosFrom(committed)), std::nullopt);
    for (std::size_t at = (committed / kBlock + 1) * kBlock; at < whole.size(); at += kBlock)
        EXPECT_EQ(damageOf(zerosFrom(at)), std::nullopt) << at;
}

TEST_F(Grown, aByteBehindZerosShowsDamage)
{
    const JournalDamage all{committed, (whole.size() - committed) / kFrame};
    std::string last = zerosFrom(committed);
    last.back() = 'x';
    EXPECT_EQ(damageOf(last), all);
    EXPECT_EQ(damageOf(zerosFrom(committed) + 'x'), all) << "less than a frame";
}

TEST_F(Grown, zerosBehindADamagedCommitShowDamage)
{
    std::string changed = zerosFrom(committed);
    invert(changed, committed - 1);
    EXPECT_NE(damageOf(changed), std::nullopt) << "it was committed before the next one began";
}

TEST_F(Journal, aTransactionWithoutItsEndIsNoDamage)
{
    add(5);
    file.run("PRAGMA cache_size = 10");  // pages that are written before the commit
    file.run("BEGIN");
    for (int i = 1; i <= 100; ++i) {
        file.run("INSERT INTO t(text) VALUES('" + std::string(3000, 'y') + "')");
        file.run("UPDATE t SET text = 'z' WHERE id = " + std::to_string(1 + i / 2));
    }
    const std::string open = bytes();
    EXPECT_GT(count(open, &JournalFrames::isUnfinished), 0U) << "SQLite has not entered salts yet";
    EXPECT_EQ(damageOf(open), std::nullopt);
    file.run("COMMIT");
    EXPECT_EQ(damageOf(bytes()), std::nullopt);
    EXPECT_EQ(intact(bytes()), (bytes().size() - kHead) / kFrame);
}

}  // namespace
}  // namespace terratact
