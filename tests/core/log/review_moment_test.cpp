// Tests that a review shows the file's state at each time, in any order of times.
#include "core/log/review_moment.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/log/session_survey.h"
#include "tests/support/sessions/robot_session.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using At = RobotSessionTimes;

struct Review : testing::Test {
    void record(double seconds, const std::function<bool(double)>& silent = {})
    {
        auto writer = robotSession(path, seconds, 0.0, silent);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }
    ReviewMoments& moments()
    {
        if (moments_) return *moments_;
        auto opened = SessionReader::open(path);
        if (!opened) throw std::runtime_error(opened.error().text);
        reader.emplace(std::move(*opened));
        moments_.emplace(*reader, absolem());
        return *moments_;
    }
    ReviewMoment at(double seconds) { return moments().at(sessionTimeOf(seconds)); }

    TemporaryDirectory directory;
    std::string path = directory.file("review.tts");
    std::optional<SessionReader> reader;
    std::optional<ReviewMoments> moments_;
};

TEST_F(Review, showsTheNewestTelemetryUpToTheTime)
{
    record(4.0);
    for (const double t : {0.5, 1.0, 3.9}) {
        const ReviewMoment moment = at(t);
        ASSERT_TRUE(moment.measurement) << t;
        EXPECT_LE(moment.measured, moment.time);
        EXPECT_LE(secondsOf(moment.time - moment.measured), 0.06);
        EXPECT_TRUE(moment.forces.carried);
        EXPECT_TRUE(moment.linkAlive);
    }
    EXPECT_NEAR(at(3.0).linesPerSecond, 20.0, 1.0);
    EXPECT_FALSE(at(-1.0).measurement);
}

TEST_F(Review, showsTheStateAtThatTime)
{
    record(4.0);
    EXPECT_FALSE(at(At::kScene - 0.05).scene);
    EXPECT_TRUE(at(At::kScene + 0.05).scene);
    EXPECT_FALSE(at(At::kScene + 0.05).estimate);

    const ReviewMoment asked = at(At::kMarker);
    ASSERT_TRUE(asked.estimate);
    EXPECT_EQ(asked.estimate->id, 1);
    EXPECT_EQ(asked.estimate->estimate.side[1].draws.size(), 4U);
    ASSERT_TRUE(asked.proposal);
    EXPECT_FALSE(asked.decision);
    EXPECT_EQ(asked.state.phase, AtemPhase::ProposingProbe);
    EXPECT_NEAR(asked.state.since, At::kProposing, 0.011);
    EXPECT_EQ(asked.arming, ArmingPhase::Disarmed);

    const ReviewMoment probing = at(At::kProbing + 0.1);
    EXPECT_EQ(probing.state.phase, AtemPhase::Probing);
    ASSERT_TRUE(probing.decision);
    EXPECT_EQ(probing.decision->subject, "approve");

    const ReviewMoment again = at(At::kPresenting + 0.1);
    ASSERT_TRUE(again.estimate);
    EXPECT_EQ(again.estimate->id, 2);
    EXPECT_TRUE(again.state.probed);

    const ReviewMoment gone = at(At::kForgotten + 0.1);
    EXPECT_FALSE(gone.estimate);
    EXPECT_FALSE(gone.scene);
    EXPECT_EQ(gone.forgotten.english(), "The robot has moved");
}

TEST_F(Review, showsTheAlarmsAtThatTime)
{
    record(2.0);
    EXPECT_TRUE(at(At::kAlarm - 0.1).alarms.empty());
    ASSERT_EQ(at(At::kAlarm + 0.1).alarms.size(), 1U);
    EXPECT_EQ(at(At::kAlarm + 0.1).alarms[0].text.english(), "frames are lost");
    EXPECT_EQ(at(At::kAlarm + 0.1).alarms[0].state, AlarmState::Unacknowledged);
    EXPECT_TRUE(at(At::kAlarmGone + 0.1).alarms.empty());
}

TEST_F(Review, isTheSameForAnyOrderOfRequests)
{
    record(4.0);
    std::vector<double> times;
    for (double t = 0.05; t < 4.0; t += 0.13) times.push_back(t);
    std::vector<ReviewMoment> forwards;
    for (const double t : times) forwards.push_back(at(t));
    std::mt19937 rng(7);
    std::vector<std::size_t> order(times.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), rng);
    for (const std::size_t i : order) {
        const ReviewMoment moment = at(times[i]);
        EXPECT_EQ(moment.measurement, forwards[i].measurement);
        EXPECT_EQ(moment.measured, forwards[i].measured);
        EXPECT_EQ(moment.state, forwards[i].state);
        EXPECT_EQ(moment.scene, forwards[i].scene);
        EXPECT_EQ(moment.proposal, forwards[i].proposal);
        EXPECT_EQ(moment.estimate ? moment.estimate->id : 0,
                  forwards[i].estimate ? forwards[i].estimate->id : 0);
    }
}

TEST_F(Review, stepsFromFrameToFrameAndBack)
{
    record(1.0);
    std::vector<SessionTime> there, back;
    for (auto t = moments().frameAfter(-1); t; t = moments().frameAfter(*t)) there.push_back(*t);
    for (auto t = moments().frameBefore(sessionTimeOf(9.0)); t; t = moments().frameBefore(*t))
        back.push_back(*t);
    ASSERT_GT(there.size(), 15U);
    EXPECT_TRUE(std::is_sorted(there.begin(), there.end()));
    std::reverse(back.begin(), back.end());
    EXPECT_EQ(there, back);
}

TEST_F(Review, showsWhetherTelemetryWasUnbroken)
{
    auto writer = robotSession(path, 3.3);
    ASSERT_TRUE(writer) << writer.error().text;
    std::int64_t id = 100;
    for (const double when : {At::kScene - 0.1, 3.15})  // the first belongs to the scene before
        ASSERT_TRUE(writer->add(
            EventRow{.id = ++id, .time = sessionTimeOf(when), .kind = EventKind::TelemetryGap}));
    ASSERT_TRUE(writer->seal());
    ASSERT_TRUE(at(3.1).scene);
    EXPECT_TRUE(at(3.1).unbroken);
    EXPECT_FALSE(at(3.2).unbroken);
}

TEST_F(Review, showsWhetherASensorWasSuspected)
{
    auto writer = robotSession(path, 3.3);
    ASSERT_TRUE(writer) << writer.error().text;
    std::int64_t id = 100;
    const auto alarm = [&](double when, double state) {
        return writer->add(EventRow{.id = ++id,
                                    .time = sessionTimeOf(when),
                                    .kind = EventKind::Alarm,
                                    .subject = std::string(kSensorAlarm),
                                    .number = state});
    };
    ASSERT_TRUE(alarm(At::kScene - 0.2, 3.0));
    ASSERT_TRUE(alarm(At::kScene - 0.1, 0.0)) << "of a scene before";
    ASSERT_TRUE(alarm(3.1, 3.0));
    ASSERT_TRUE(alarm(3.2, 0.0));
    ASSERT_TRUE(writer->seal());
    ASSERT_TRUE(at(3.05).scene);
    EXPECT_TRUE(at(3.05).sensorsSound);
    EXPECT_FALSE(at(3.15).sensorsSound);
    EXPECT_FALSE(at(3.25).sensorsSound) << "the scene stays what it was";
}

TEST_F(Review, showsWhatWasOverridden)
{
    auto writer = robotSession(path, 3.0);
    ASSERT_TRUE(writer) << writer.error().text;
    std::int64_t id = 100;
    for (const auto& [when, text] : {std::pair(1.0, "roll 9°"), std::pair(2.0, "")})
        ASSERT_TRUE(writer->add(EventRow{
            .id = ++id, .time = sessionTimeOf(when), .kind = EventKind::Override, .text = text}));
    ASSERT_TRUE(writer->seal());
    EXPECT_EQ(at(0.9).overridden.english(), "");
    EXPECT_EQ(at(1.9).overridden.english(), "roll 9°");
    EXPECT_EQ(at(2.1).overridden.english(), "");
}

TEST_F(Review, olderSessionsShowInterruptionsByTheirLink)
{
    auto writer = robotSession(path, 3.3);
    ASSERT_TRUE(writer) << writer.error().text;
    std::int64_t id = 100;
    const auto link = [&](const char* what, double at) {
        ASSERT_TRUE(writer->add(EventRow{
            .id = ++id, .time = sessionTimeOf(at), .kind = EventKind::Link, .subject = what}));
    };
    link("lost", 1.7);  // after 0.25 s of silence
    link("up", 2.15);
    link("lost", 2.3);
    link("up", 3.15);
    ASSERT_TRUE(writer->seal());
    EXPECT_TRUE(at(2.2).unbroken) << "0.7 s are short";
    EXPECT_TRUE(at(3.1).unbroken) << "it has not ended";
    EXPECT_FALSE(at(3.2).unbroken) << "1.1 s";
}

TEST_F(Review, sceneOfTheFirstLineAfterASilenceIsUnbroken)
{
    auto writer = robotSession(path, 3.3);
    ASSERT_TRUE(writer) << writer.error().text;
    // The link-up event follows the captured scene.
    for (const auto& [id, what, when] :
         {std::tuple(100, "lost", At::kScene - 1.1), std::tuple(101, "up", At::kScene + 0.01)})
        ASSERT_TRUE(writer->add(EventRow{
            .id = id, .time = sessionTimeOf(when), .kind = EventKind::Link, .subject = what}));
    ASSERT_TRUE(writer->seal());
    ASSERT_TRUE(at(3.2).scene);
    EXPECT_TRUE(at(3.2).unbroken);
}

TEST_F(Review, readsTheSilenceFromADelayedLinkUpEvent)
{
    auto writer = robotSession(path, 4.0);
    ASSERT_TRUE(writer) << writer.error().text;
    std::int64_t id = 100;
    const auto link = [&](std::string_view what, double at, std::optional<double> silence = {}) {
        ASSERT_TRUE(writer->add(EventRow{.id = ++id,
                                         .time = sessionTimeOf(at),
                                         .kind = EventKind::Link,
                                         .subject = std::string(what),
                                         .number = silence}));
    };
    link(kTelemetryLost, 1.7);
    link(kLinkLost, 1.75);
    link(kLinkUp, 2.9, 0.3);
    link(kLinkLost, 3.0);
    link(kLinkUp, 3.15, 1.2);
    ASSERT_TRUE(writer->seal());
    EXPECT_TRUE(at(1.72).telemetryAlone);
    EXPECT_FALSE(at(1.8).telemetryAlone);
    EXPECT_TRUE(at(2.5).linkAlive) << "its frames are there";
    EXPECT_TRUE(at(2.95).unbroken) << "0.3 s are short";
    EXPECT_FALSE(at(3.2).unbroken) << "1.2 s";
    EXPECT_FALSE(at(3.1).unbroken) << "and known as soon as frames came again";
}

TEST_F(Review, showsNoFrameOfADamagedSpanButANotice)
{
    record(4.0);
    sqlite3* file = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &file), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(
                  file, "UPDATE can_frame SET data = x'00' WHERE t > 1000000000 AND t < 3000000000",
                  nullptr, nullptr, nullptr),
              SQLITE_OK);
    sqlite3_close(file);
    const ReviewMoment moment = at(2.75);
    EXPECT_FALSE(moment.measurement);
    EXPECT_TRUE(moment.damage);
    EXPECT_TRUE(at(3.9).measurement);
    EXPECT_FALSE(at(3.9).damage);
}

TEST_F(Review, surveyFindsSilencesAndContacts)
{
    record(4.0, [](double t) { return t > 1.0 && t < 2.0; });
    (void)moments();
    SessionSurvey survey(absolem(), 1.0);
    while (survey.addNext(*reader)) {
    }
    EXPECT_EQ(survey.batchesRead(), reader->batches().size());
    ASSERT_EQ(survey.silences().size(), 1U);
    EXPECT_NEAR(secondsOf(survey.silences()[0].first), 1.0, 0.06);
    EXPECT_NEAR(secondsOf(survey.silences()[0].last), 2.0, 0.06);
    EXPECT_FALSE(at(1.9).linkAlive && at(1.9).measurement
                 && at(1.9).time - at(1.9).measured < sessionTimeOf(0.25));
    SessionSurvey sensitive(absolem(), -1.0);
    while (sensitive.addNext(*reader)) {
    }
    EXPECT_EQ(sensitive.contacts().size(), 2U);  // silences separate contacts
}

/// Returns the peak memory of this process [MB]; 0: unknown.
double mostMemory()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::atof(line.c_str() + 6) / 1024.0;
    return 0.0;
}

/// An hour at 1 kHz by a command: TERRATACT_REVIEW_SECONDS=3600 core.log.review_moment_test; 10 GB of a full bus:
/// TERRATACT_REVIEW_SECONDS=36000 TERRATACT_REVIEW_RATE=8850.
TEST(ReviewOfALongSession, opensAndSeeksAtOnce)
{
    using Clock = std::chrono::steady_clock;
    const auto since = [](Clock::time_point began) {
        return std::chrono::duration<double>(Clock::now() - began).count();
    };
    const char* given = std::getenv("TERRATACT_REVIEW_SECONDS");
    const double seconds = given ? std::atof(given) : 20.0;
    const char* rate = std::getenv("TERRATACT_REVIEW_RATE");
    TemporaryDirectory directory;
    const std::string path = directory.file("long.tts");
    {
        auto writer = robotSession(path, seconds, rate ? std::atof(rate) : 850.0);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }
    auto began = Clock::now();
    auto reader = SessionReader::open(path);
    const double opening = since(began);
    ASSERT_TRUE(reader) << reader.error().text;
    ReviewMoments moments(*reader, absolem());
    std::mt19937 rng(1);
    std::uniform_real_distribution<double> anywhere(2.0, seconds);
    double worst = 0.0;
    constexpr int kSeeks = 40;
    began = Clock::now();
    for (int n = 0; n < kSeeks; ++n) {
        const auto seek = Clock::now();
        ASSERT_TRUE(moments.at(sessionTimeOf(anywhere(rng))).measurement);
        worst = std::max(worst, since(seek));
    }
    std::printf(
        "%lld frames, %.1f MB: opens in %.3f s, seeks in %.1f ms, at worst %.1f ms; %.0f MB "
        "of memory\n",
        static_cast<long long>(reader->frameCount()),
        1e-6 * static_cast<double>(std::filesystem::file_size(path)), opening,
        1e3 * since(began) / kSeeks, 1e3 * worst, mostMemory());
    EXPECT_LT(opening, 30.0);  // a hang guard, like the next
    EXPECT_LT(worst, 5.0);
}

}  // namespace
}  // namespace terratact
