// Session files: written rows are read back, changed rows are hidden, and committed rows survive a
// crash.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <thread>

#include "core/infer/verdict/verdict.h"
#include "core/log/session_hash.h"
#include "core/log/session_reader.h"
#include "core/log/session_writer.h"
#include "tests/support/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

void seal(const std::string& path, std::int64_t frames)
{
    auto writer = someSession(path, frames);
    ASSERT_TRUE(writer) << writer.error().text;
    const Status sealed = writer->seal();
    ASSERT_TRUE(sealed) << sealed.error().text;
}

std::vector<FrameRow> allFrames(SessionReader& reader)
{
    std::vector<FrameRow> all;
    for (std::size_t i = 0; i < reader.batches().size(); ++i)
        for (const FrameRow& frame : reader.frames(i)) all.push_back(frame);
    return all;
}

void change(const std::string& path, const std::string& sql)
{
    sqlite3* file = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &file), SQLITE_OK);
    char* message = nullptr;
    EXPECT_EQ(sqlite3_exec(file, sql.c_str(), nullptr, nullptr, &message), SQLITE_OK) << message;
    sqlite3_close(file);
}

int countFrom(const char* variable, int otherwise)
{
    const char* given = std::getenv(variable);
    return given ? std::atoi(given) : otherwise;
}

struct Session : testing::Test {
    TemporaryDirectory directory;
    std::string path = directory.file("a session.tts");
};

TEST_F(Session, givesBackEveryRow)
{
    seal(path, 1000);
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_TRUE(reader->sealed());
    EXPECT_EQ(reader->start(), someStart());
    EXPECT_EQ(reader->frameCount(), 1000);
    EXPECT_EQ(reader->begin(), 0);
    EXPECT_EQ(reader->end(), 999'000'000);
    const auto frames = allFrames(*reader);
    ASSERT_EQ(frames.size(), 1000U);
    for (std::int64_t n = 0; n < 1000; ++n)
        EXPECT_EQ(frames[static_cast<std::size_t>(n)], someFrame(n));
    ASSERT_EQ(reader->scenes().size(), 2U);
    EXPECT_EQ(reader->scenes()[0], someScene(1, 250'000'000));
    EXPECT_EQ(reader->scenes()[1], someScene(2, 500'000'001));
    ASSERT_EQ(reader->estimates().size(), 2U);
    for (const std::int64_t id : {1, 2}) {
        EstimateRow expected = someEstimate(id, id == 1 ? 250'000'001 : 500'000'002);
        const auto draws = reader->draws(id);
        ASSERT_TRUE(draws) << draws.error().text;
        EXPECT_EQ(*draws, expected.estimate.draws);
        expected.estimate.draws.clear();
        EXPECT_EQ(*reader->estimate(id), expected);
    }
    ASSERT_EQ(reader->proposals().size(), 1U);
    EXPECT_EQ(reader->proposals()[0], someProposal(250'000'002));
    ASSERT_EQ(reader->events().size(), 2U);
    EXPECT_EQ(reader->events()[1], someDecision(500'000'000));
    EXPECT_EQ(reader->model(1)->name, "default.ttm");
    EXPECT_TRUE(reader->damage().empty());
    EXPECT_FALSE(std::filesystem::exists(path + "-wal"));
    const auto verified = reader->verify();
    EXPECT_FALSE(verified.broken);
    EXPECT_EQ(verified.frames, 1000);
}

TEST_F(Session, keepsWhatASceneLacks)
{
    auto writer = someSession(path, 100);
    ASSERT_TRUE(writer) << writer.error().text;
    SceneRow scene = someScene(3, 600'000'000);
    scene.measurement.force[3] = 0.0;
    scene.measurement.missing[kFirstForceFeature + 3] = true;
    scene.measurement.missing[kRearCurrentFeature] = true;
    EstimateRow estimate = someEstimate(3, 600'000'001);
    estimate.estimate.missing = scene.measurement.missing;
    ASSERT_TRUE(writer->add(scene));
    ASSERT_TRUE(writer->add(estimate));
    ASSERT_TRUE(writer->seal());
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    ASSERT_EQ(reader->scenes().size(), 3U);
    EXPECT_EQ(reader->scenes()[2], scene);
    EXPECT_EQ(reader->estimate(3)->estimate.missing, scene.measurement.missing);
    EXPECT_TRUE(reader->estimate(2)->estimate.missing.none());
    EXPECT_FALSE(reader->verify().broken);
}

TEST_F(Session, withholdsAVerdictForTheRecordedReason)
{
    EstimateRow estimate = someEstimate(3, 600'000'001);
    estimate.estimate.contradicts = true;
    auto writer = someSession(path, 100);
    ASSERT_TRUE(writer) << writer.error().text;
    ASSERT_TRUE(writer->add(someScene(3, 600'000'000)));
    ASSERT_TRUE(writer->add(estimate));
    ASSERT_TRUE(writer->seal());
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    const EstimateRow& read = reader->estimates().back();
    EXPECT_TRUE(read.estimate.contradicts);
    const Proprioception s = proprioception(reader->scenes().back().measurement);
    const Verdict verdict = verdictOf(read.estimate, s, 0.1);
    EXPECT_EQ(verdict.stepVerdict, StepVerdict::CannotTell);
    EXPECT_EQ(std::ranges::count(verdict.withheldFor, WithholdReason::Contradiction), 1);
    EXPECT_FALSE(reader->estimates().front().estimate.contradicts);
}

TEST_F(Session, isReadFromAReadOnlyFolderOnceSealed)
{
    seal(path, 100);
    std::filesystem::permissions(directory.file(""), std::filesystem::perms::owner_read
                                                         | std::filesystem::perms::owner_exec);
    const auto reader = SessionReader::open(path);
    EXPECT_TRUE(reader) << reader.error().text;
    std::filesystem::permissions(directory.file(""), std::filesystem::perms::owner_all);
}

TEST_F(Session, isReadWhileItIsWritten)
{
    auto writer = someSession(path, 200);
    ASSERT_TRUE(writer) << writer.error().text;
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_FALSE(reader->sealed());
    EXPECT_EQ(reader->frameCount(), 200);
    EXPECT_FALSE(*reader->refresh());
    ASSERT_TRUE(writer->add(someFrame(200)));
    EXPECT_FALSE(*reader->refresh()) << "what is not committed is not there";
    ASSERT_TRUE(writer->commit());
    EXPECT_TRUE(*reader->refresh());
    EXPECT_EQ(reader->frameCount(), 201);
    EXPECT_EQ(allFrames(*reader).back(), someFrame(200));
    EXPECT_TRUE(reader->damage().empty());
    EXPECT_EQ(*recoverSession(path), SessionRecovery::InUse);
}

TEST_F(Session, refusesReferencesToMissingRows)
{
    auto writer = SessionWriter::create(path, someStart());
    ASSERT_TRUE(writer);
    EXPECT_THROW((void)writer->add(someEstimate(1, 0)), std::invalid_argument);
    ASSERT_TRUE(writer->add(someScene(2, 0)));
    EXPECT_THROW((void)writer->add(someScene(2, 0)), std::invalid_argument);
}

TEST_F(Session, existingFileIsLeftAlone)
{
    seal(path, 100);
    const auto again = SessionWriter::create(path, someStart());
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().text.find(path), std::string::npos);
    EXPECT_TRUE(SessionReader::open(path));
}

struct Tampering {
    const char* name;
    const char* sql;
    SessionTime from;  ///< nothing before it is in doubt
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
                  "INSERT INTO event VALUES(3, 6, 5, 'word', '', '', NULL, 0, 0, '', '')",
                  500'000'000},
        Tampering{"rowOfNoBatch",
                  "INSERT INTO event VALUES(9, 77, 5, 'word', '', '', NULL, 0, 0, '', '')",
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
        text += "estimate " + std::to_string(row.id) + std::to_string(row.estimate.mean[3]) + "/"
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
          "proposal, shown, message FROM event WHERE id = 1",
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
           "proposal, shown, message FROM event WHERE id = 1");
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
          "PRAGMA user_version = 4", "PRAGMA application_id = 7",
          "DROP VIEW messages; CREATE VIEW messages AS SELECT load_extension('x')"}) {
        std::filesystem::remove(path);
        seal(path, 100);
        change(path, sql);
        const auto reader = SessionReader::open(path);
        ASSERT_FALSE(reader) << sql;
        EXPECT_EQ(reader.error().text.find(path), 0U) << reader.error().text;
    }
}

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
