// Sessions that older versions recorded read as they did when they were recorded.
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>
#include <sstream>

#include "core/infer/verdict/verdict.h"
#include "core/log/event_text.h"
#include "core/log/recorded_sentences.h"
#include "core/log/review_moment.h"
#include "core/log/rows/recorded_words.h"
#include "core/robot/two_tracks.h"
#include "tests/support/absolem.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const std::string kDemo = TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts";  // of version 1
const std::string kVersion2 = TERRATACT_SOURCE_DIR "/tests/core/log/session_of_version_2.sql";
/// The same session in version 3, from before events and estimates held messages.
const std::string kWithoutMessages =
    TERRATACT_SOURCE_DIR "/tests/core/log/session_of_version_3.sql";

/// Version 4, from before any release: an estimate of one plane, and one of two sides.
const std::string kVersion4 = TERRATACT_SOURCE_DIR "/tests/core/log/session_of_version_4.sql";

/// The file as SQLite has it: what the operator read when it was recorded.
std::vector<std::string> recordedEvents(const std::string& path)
{
    std::vector<std::string> lines;
    sqlite3* file = nullptr;
    const auto add = [](void* all, int, char** row, char**) {
        const auto part = [row](int column) { return std::string(row[column]); };
        static_cast<std::vector<std::string>*>(all)->push_back(part(0) + '|' + part(1) + '|'
                                                               + part(2));
        return 0;
    };
    sqlite3_open_v2(path.c_str(), &file, SQLITE_OPEN_READONLY, nullptr);
    sqlite3_exec(file, "SELECT kind, subject, text FROM event ORDER BY id", add, &lines, nullptr);
    sqlite3_close(file);
    return lines;
}

std::vector<std::string> readEvents(const SessionReader& session)
{
    std::vector<std::string> lines;
    for (const EventRow& event : session.events())
        lines.push_back(std::string(name(event.kind)) + '|' + subjectOf(event).english() + '|'
                        + messageOf(event).english());
    return lines;
}

SessionReader opened(const std::string& path)
{
    auto session = SessionReader::open(path);
    if (!session) throw std::runtime_error(session.error().text);
    return std::move(*session);
}

struct OlderSession : testing::Test {
    std::string version2() { return sessionFrom(kVersion2, "version_2.tts"); }
    std::string withoutMessages() { return sessionFrom(kWithoutMessages, "version_3.tts"); }
    std::string version4() { return sessionFrom(kVersion4, "version_4.tts"); }
    std::string sessionFrom(const std::string& statements, const std::string& name)
    {
        std::string path = directory.file(name);
        std::ostringstream sql;
        sql << std::ifstream(statements).rdbuf();
        sqlite3* file = nullptr;
        sqlite3_open(path.c_str(), &file);
        EXPECT_EQ(sqlite3_exec(file, sql.str().c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
        sqlite3_close(file);
        return path;
    }
    TemporaryDirectory directory;
};

TEST_F(OlderSession, everyEventReadsAsItWasRecorded)
{
    for (const std::string& path : {kDemo, version2()}) {
        const SessionReader session = opened(path);
        EXPECT_TRUE(session.damage().empty());
        const std::vector<std::string> recorded = recordedEvents(path);
        EXPECT_GT(recorded.size(), 30U);
        EXPECT_EQ(readEvents(session), recorded) << path;
    }
}

TEST_F(OlderSession, sentencesCanBeShownInAnotherLanguage)
{
    const SessionReader session = opened(kDemo);
    int words = 0;
    for (const EventRow& event : session.events()) {
        if (event.kind != EventKind::Word) continue;
        ++words;
        EXPECT_FALSE(messageOf(event).context.empty()) << event.text;
        EXPECT_EQ(messageOf(event).english(), event.text);
    }
    EXPECT_GT(words, 10);
}

TEST(RecordedSentence, argumentsAreSentencesToo)
{
    const Message arm = recordedSentence("arm at 0.7 m: +0.01 m, inside the band shown before");
    ASSERT_EQ(arm.arguments.size(), 3U);
    EXPECT_EQ(arm.arguments[0], Message(TR_NOOP("terratact::Place", "at %1"), "0.7 m"));
    EXPECT_EQ(arm.arguments[1], Message::verbatim("+0.01"));
    EXPECT_EQ(arm.arguments[2], Message(TR_NOOP("terratact::Estimation", "inside")));
}

TEST(RecordedSentence, otherTextsStayAsTheyAre)
{
    for (const char* text :
         {"", "at ", "STOP!", "estimate in", "probe approved", "probe at  m", "%1"})
        EXPECT_EQ(recordedSentence(text), Message::verbatim(text)) << text;
}

TEST(RecordedSentence, sentencesInSentencesAreFollowedTwice)
{
    std::string text;
    for (int i = 0; i < 100000; ++i) text += "exploration failed: ";
    EXPECT_EQ(recordedSentence(text).english(), text);
}

TEST_F(OlderSession, aNoteOfTheOperatorIsNoSentence)
{
    EventRow note;
    note.kind = EventKind::Marker;
    note.text = "probe refused";
    EXPECT_EQ(messageOf(note), Message::verbatim("probe refused"));
}

TEST_F(OlderSession, withoutMessagesReadsTheSame)
{
    const SessionReader older = opened(version2()), session = opened(withoutMessages());
    EXPECT_TRUE(session.damage().empty());
    std::vector<std::string> events = readEvents(session);
    std::erase_if(events, [](const auto& line) { return line.starts_with("session|merged|"); });
    EXPECT_EQ(events, readEvents(older));
    for (const EventRow& event : session.events()) EXPECT_TRUE(event.message.empty());
    ASSERT_EQ(session.estimates().size(), 1U);
    const TerrainEstimate& estimate = session.estimates()[0].estimate.side[0];
    EXPECT_TRUE(estimate.contradicts);
    EXPECT_EQ(estimate.warnings, older.estimates().at(0).estimate.side[0].warnings);
    ASSERT_EQ(estimate.warnings.size(), 2U);
    EXPECT_EQ(estimate.warnings[0], Message::verbatim("the chains have not converged"));
}

TEST_F(OlderSession, aSceneHasOnlyTheMeansOfItsSides)
{
    for (const std::string& path : {kDemo, version2(), withoutMessages()}) {
        const SessionReader session = opened(path);
        ASSERT_EQ(session.scenes().size(), 1U) << path;
        const Measurement& m = session.scenes()[0].measurement;
        EXPECT_EQ(m.sides, SideForces{});
        EXPECT_EQ(m.rearSides, SideForces{});
        EXPECT_FALSE(m.differential);
        EXPECT_TRUE(proprioception(m).force[5]) << path;
        EXPECT_FALSE(twoTrackReadings(m).forces[0][5]) << path;
    }
}

TEST_F(OlderSession, everyPhaseAndFailureIsRecognised)
{
    SessionReader session = opened(version2());
    int phase = 0, failure = 0, cause = 0;
    ReviewMoments moments(session, absolem());
    for (const EventRow& event : session.events()) {
        EXPECT_TRUE(phaseOf(event) || event.kind != EventKind::Phase || event.id == 50) << event.id;
        if (armingOf(event) == ArmingPhase::Disarmed) {
            EXPECT_EQ(causeOf(event), static_cast<DisarmCause>(cause++));
        }
        if (event.kind != EventKind::Phase || event.id > 39) continue;
        const AtemState state = moments.at(event.time).state;
        EXPECT_EQ(phaseOf(event), state.phase);
        if (phase < static_cast<int>(AtemPhase::Failed)) {
            EXPECT_EQ(state.phase, static_cast<AtemPhase>(phase++));
            continue;
        }
        EXPECT_EQ(state.phase, AtemPhase::Failed);
        EXPECT_EQ(state.failure, static_cast<AtemFailure>(failure++));
    }
    EXPECT_EQ(phase, 9);
    EXPECT_EQ(failure, 12);
    EXPECT_EQ(cause, 11);
}

TEST_F(OlderSession, aContradictionIsReadFromItsWarning)
{
    const SessionReader session = opened(version2());
    ASSERT_EQ(session.estimates().size(), 1U);
    EXPECT_TRUE(session.estimates()[0].estimate.side[0].contradicts);
}

TEST_F(OlderSession, theDemoShowsTheSamePhasesAndVerdicts)
{
    SessionReader session = opened(kDemo);
    ReviewMoments moments(session, absolem());
    std::string phases;
    for (const EventRow& event : session.events())
        if (event.kind == EventKind::Phase)
            phases += std::string(describe(moments.at(event.time).state.phase).english) + "; ";
    EXPECT_EQ(
        phases,
        "ready; halting the robot; pressing the front flippers down; arm probe proposed; arm is "
        "probing; estimate stands; ready; ");
    ASSERT_EQ(session.estimates().size(), 2U);
    for (const EstimateRow& row : session.estimates()) {
        const SceneRow* scene = session.scene(row.scene);
        ASSERT_TRUE(scene);
        TwoTrackEstimate estimate = row.estimate;
        setDraws(estimate, *session.draws(row.id));
        EXPECT_TRUE(estimate.onePlane);
        EXPECT_EQ(estimate.side[0], estimate.side[1]);
        EXPECT_GT(estimate.side[0].draws.size(), 100U);
        const Verdict verdict = verdictOf(estimate.side[0], scene->measurement, {}, row.stepLimit);
        EXPECT_EQ(stepVerdictMessage(verdict).english(), "BLOCKED");
        EXPECT_TRUE(verdict.withheldFor.empty());
    }
}

TEST_F(OlderSession, estimatesOfOnePlaneHaveEqualSides)
{
    for (const std::string& path : {kDemo, version2(), withoutMessages()}) {
        SessionReader session = opened(path);
        ASSERT_FALSE(session.estimates().empty());
        for (const EstimateRow& row : session.estimates()) {
            EXPECT_TRUE(row.estimate.onePlane) << path;
            EXPECT_EQ(row.estimate.side[0], row.estimate.side[1]) << path;
            const SideDraws draws = *session.draws(row.id);
            EXPECT_FALSE(draws[0].empty());
            EXPECT_EQ(draws[0], draws[1]);
        }
        for (const ProposalRow& row : session.proposals()) {
            EXPECT_EQ(row.side, ProbeSide::Middle);
            for (const OfferedBin& offer : row.offers) EXPECT_EQ(offer.side, ProbeSide::Middle);
        }
        for (const SceneRow& row : session.scenes()) EXPECT_FALSE(row.sideTruth);
    }
}

TEST_F(OlderSession, version4HoldsEstimatesOfTwoSides)
{
    SessionReader session = opened(version4());
    EXPECT_EQ(session.verify().damage, std::vector<SessionDamage>{});
    ASSERT_EQ(session.estimates().size(), 2U);
    EXPECT_TRUE(session.estimates()[0].estimate.onePlane);
    EXPECT_EQ(session.estimates()[0].estimate.side[0], session.estimates()[0].estimate.side[1]);
    EstimateRow two = session.estimates()[1];
    setDraws(two.estimate, *session.draws(2));
    EXPECT_EQ(two, someSides(2, two.time));
    ASSERT_EQ(session.proposals().size(), 1U);
    EXPECT_EQ(session.proposals()[0].offers, someProposal(0).offers);
    EXPECT_EQ(session.scenes().at(1), someScene(2, session.scenes()[1].time));
    for (const SceneRow& scene : session.scenes()) EXPECT_FALSE(scene.memory);
    for (const ModelRow& model : session.models()) EXPECT_EQ(model.trailName, "");
}

TEST_F(OlderSession, aNewSessionHoldsNamesAndMessages)
{
    const std::string path = directory.file("new.tts");
    auto writer = SessionWriter::create(path, someStart());
    ASSERT_TRUE(writer) << writer.error().text;
    std::vector<EventRow> rows;
    const auto add = [&](EventRow row) {
        row.id = static_cast<std::int64_t>(rows.size()) + 1;
        row.time = row.id;
        ASSERT_TRUE(writer->add(row));
        rows.push_back(std::move(row));
    };
    add({.kind = EventKind::Phase,
         .subject = std::string(name(AtemPhase::Failed)),
         .text = std::string(name(AtemFailure::HaltTimeout))});
    add({.kind = EventKind::Arming,
         .subject = std::string(name(ArmingPhase::Disarmed)),
         .text = std::string(name(DisarmCause::Stop))});
    const Message message(TR_NOOP("core", "roll %1°: the ground is not the same left and right"),
                          fixed(-5.24, 1));
    add(withText({.kind = EventKind::Word}, message));
    add(withText({.kind = EventKind::Alarm, .subject = "halted", .number = 3.0},
                 describe(Refusal::Busy)));
    ASSERT_TRUE(writer->seal());
    const SessionReader session = opened(path);
    EXPECT_EQ(session.events(), rows);
    EXPECT_EQ(readEvents(session)[0], "phase|exploration failed|the robot did not halt in time");
    EXPECT_EQ(readEvents(session)[1], "arming|disarmed|STOP is latched");
    EXPECT_EQ(rows[2].text, "roll -5.2°: the ground is not the same left and right");
    EXPECT_EQ(messageOf(session.events()[2]), message);
    EXPECT_EQ(messageOf(session.events()[3]), Message(describe(Refusal::Busy)));
    EXPECT_EQ(messageOf(session.events()[0]), Message(describe(AtemFailure::HaltTimeout)));
}

}  // namespace
}  // namespace terratact
