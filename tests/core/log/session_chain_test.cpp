// Changed rows of a session are found by the chain of hashes and hidden.
#include <gtest/gtest.h>

#include <string>

#include "core/log/rows/session_hash.h"
#include "core/log/session_reader.h"
#include "core/log/session_writer.h"
#include "tests/core/log/session_fixture.h"
#include "tests/support/sessions/sessions.h"

namespace terratact {
namespace {

struct Tampering {
    const char* name;
    const char* sql;
    SessionTime from;  ///< everything before it is verified
};
std::ostream& operator<<(std::ostream& out, const Tampering& tampering)
{
    return out << tampering.name;
}
struct Tampered : Session, testing::WithParamInterface<Tampering> {};

TEST_P(Tampered, showsWhereTheChainBreaks)
{
    seal(path, 1000);
    change(path, GetParam().sql);
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    const auto found = reader->verify();
    ASSERT_TRUE(found.broken);
    EXPECT_GE(found.broken->first, GetParam().from);
    EXPECT_LE(found.broken->first, GetParam().from + 100'000'000);
    for (const FrameRow& frame : allFrames(*reader))
        EXPECT_EQ(frame, someFrame(frame.time / 1'000'000)) << "what is shown was recorded";
    for (const EventRow& event : reader->events()) {
        if (event.id != 2) continue;
        EXPECT_EQ(event, someDecision(500'000'000));
    }
}
INSTANTIATE_TEST_SUITE_P(
    Rows, Tampered,
    testing::Values(
        Tampering{"frame", "UPDATE can_frame SET data = x'0000000000000000' WHERE seq = 351",
                  300'000'000},
        Tampering{"frameGone", "DELETE FROM can_frame WHERE seq = 351", 300'000'000},
        Tampering{"decision", "UPDATE event SET subject = 'refuse' WHERE id = 2", 500'000'000},
        Tampering{"decisionGone", "DELETE FROM event WHERE id = 2", 500'000'000},
        Tampering{"eventMore",
                  "INSERT INTO event VALUES(3, 6, 5, 'word', '', '', NULL, 0, 0, '', '', '')",
                  500'000'000},
        Tampering{"rowOfNoBatch",
                  "INSERT INTO event VALUES(9, 77, 5, 'word', '', '', NULL, 0, 0, '', '', '')",
                  900'000'000},
        Tampering{"frameOfNoBatch", "INSERT INTO can_frame VALUES(5000, 5, 0, 1, 0, x'')",
                  900'000'000},
        Tampering{
            "batchAndItsEventGone",
            "DELETE FROM batch WHERE id = 6; UPDATE event SET subject = 'refuse' WHERE id = 2",
            500'000'000},
        Tampering{"bin", "UPDATE estimate_bin SET height_m = 0.5 WHERE id = 3", 200'000'000},
        Tampering{"draws", "UPDATE estimate_draws SET draws = x'' WHERE id = 1", 200'000'000},
        Tampering{"settings", "UPDATE settings SET method = 'pa'", 200'000'000},
        Tampering{"batchGone", "DELETE FROM batch WHERE id = 3", 300'000'000},
        Tampering{"end", "UPDATE batch SET t_last = t_last + 1 WHERE id = 9", 800'000'000},
        Tampering{"start", "UPDATE meta SET value = 'can1' WHERE key = 'bus'", 0}),
    [](const auto& test) { return std::string(test.param.name); });

/// Returns a blob literal of SQL.
std::string literal(std::string_view bytes)
{
    return "x'" + hexOf(bytes) + "'";
}

// Whoever forges frames can also forge their hash, but not the chain's link without all following
// links.
TEST_F(Session, framesWithAForgedHashAreNotShown)
{
    seal(path, 1000);
    Sha256 hash;
    for (std::int64_t n = 300; n < 400; ++n) {
        const FrameRow row = someFrame(n);
        const std::string data(reinterpret_cast<const char*>(row.frame.data.data()), 8);
        RowBytes bytes;
        for (const std::int64_t value : {n + 1, row.time, std::int64_t{0}}) bytes.add(value);
        bytes.add(std::int64_t{row.frame.id});
        bytes.add((row.sent ? kSentFlag : 0) | std::int64_t{8} << kLengthShift);
        bytes.addBlob(n == 300 ? std::string(8, '\0') : data);
        hash.add(bytes.bytes());
    }
    change(path, "UPDATE can_frame SET data = x'0000000000000000' WHERE seq = 301; "
                 "UPDATE batch SET frames_hash = "
                     + literal(hash.finish()) + " WHERE id = 4");
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_EQ(reader->frames(3).size(), 0U) << "the hash beside them holds, the chain does not";
    EXPECT_EQ(reader->frames(2).size(), 100U);
    EXPECT_EQ(reader->verify().broken->first, 300'000'000);
}

/// Returns everything that a reader says about a file, except the damage of frames, as a text.
std::string told(const std::string& path, std::size_t atATime)
{
    auto reader = SessionReader::open(path, atATime);
    if (!reader) return reader.error().text;
    std::string text;
    for (const ModelRow& row : reader->models()) text += "model " + std::to_string(row.id);
    for (const SceneRow& row : reader->scenes())
        text += "scene " + std::to_string(row.id) + std::to_string(row.measurement.pitch)
              + (row.truth ? "t" : "");
    for (const EstimateRow& row : reader->estimates())
        text += "estimate " + std::to_string(row.id) + std::to_string(row.estimate.side[0].mean[3])
              + std::to_string(row.estimate.side[1].mean[3]) + "/"
              + std::to_string(row.readings.size());
    for (const ProposalRow& row : reader->proposals())
        text += "proposal " + std::to_string(row.id) + "/" + std::to_string(row.offers.size());
    for (const EventRow& row : reader->events())
        text += "event " + std::to_string(row.id) + row.text;
    for (const SessionDamage& damage : reader->damage())
        text += "damage " + std::to_string(damage.first) + damage.why.english();
    const SessionVerification found = reader->verify();
    return text + std::to_string(found.batches) + "/" + std::to_string(found.frames) + found.chain
         + (found.broken ? found.broken->why.english() : std::string());
}

TEST_F(Session, isTheSameInPartsOfAnySize)
{
    for (const char* const sql :
         {"", "UPDATE scene SET pitch_rad = 0.5 WHERE id = 1",
          "DELETE FROM event WHERE id = (SELECT max(id) FROM event)",
          "INSERT INTO event SELECT id + 1000, 99999, t, kind, subject, text, number, estimate, "
          "proposal, shown, message, shown_message FROM event WHERE id = 1",
          "UPDATE batch SET chain = rows_hash WHERE id = 2", "DELETE FROM batch WHERE id = 2"}) {
        const std::string changed = directory.file("changed.tts");
        std::filesystem::remove(changed);
        seal(changed, 1000);
        change(changed, sql);
        const std::string whole = told(changed, 65'536);
        EXPECT_EQ(whole.find("damage") == std::string::npos, std::string_view(sql).empty()) << sql;
        for (const std::size_t atATime : {0U, 1U, 2U, 3U, 7U})
            EXPECT_EQ(told(changed, atATime), whole) << sql << ", " << atATime << " at a time";
    }
}

TEST_F(Session, rowThatWasPutIntoAnEarlierBatchIsNotShown)
{
    seal(path, 1000);
    change(path,
           "INSERT INTO event SELECT 100000, 1, t, kind, subject, 'forged', number, estimate, "
           "proposal, shown, message, shown_message FROM event WHERE id = 1");
    for (const std::size_t atATime : {1U, 2U, 65'536U}) {
        const std::string text = told(path, atATime);
        EXPECT_NE(text.find("damage"), std::string::npos) << atATime;
        EXPECT_EQ(text.find("forged"), std::string::npos) << atATime;
    }
}

TEST_F(Session, withMoreDamageThanCanBeListedIsStillRead)
{
    seal(path, 1000);
    change(path,
           "WITH RECURSIVE n(i) AS (SELECT 1000 UNION ALL SELECT i + 2 FROM n WHERE i < 40000) "
           "INSERT INTO batch SELECT i, i, i, 1, 0, frames_hash, rows_hash, chain "
           "FROM n, batch WHERE batch.id = 1");
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    ASSERT_EQ(reader->damage().size(), 10'000U);
    EXPECT_NE(reader->damage().back().why.english().find("more than 10000 places"),
              std::string::npos);
    EXPECT_EQ(allFrames(*reader).size(), 1000U);
}

TEST_F(Session, foreignTablesViewsAndTriggersAreRefused)
{
    for (const char* const sql :
         {"CREATE TABLE more(a)", "CREATE VIEW look AS SELECT 1", "CREATE INDEX i ON event(t)",
          "CREATE TRIGGER t AFTER INSERT ON event BEGIN SELECT 1; END", "DROP VIEW messages",
          "PRAGMA user_version = 8", "PRAGMA application_id = 7",
          "DROP VIEW messages; CREATE VIEW messages AS SELECT load_extension('x')"}) {
        std::filesystem::remove(path);
        seal(path, 100);
        change(path, sql);
        const auto reader = SessionReader::open(path);
        ASSERT_FALSE(reader) << sql;
        EXPECT_EQ(reader.error().text.find(path), 0U) << reader.error().text;
    }
}

}  // namespace
}  // namespace terratact
