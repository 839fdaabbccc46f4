// Tests repair and retention of sessions while a console runs.
#include "app/console/past/session_retention.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/display/translated.h"
#include "app/recording/session_folder.h"
#include "core/log/session_reader.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using gui::eventually;

TEST(SessionRetention, closesAndReportsSessionsOfADeadProgram)
{
    const TemporaryDirectory directory;
    const std::string folder = directory.file("sessions"), path = folder + "/dead.tts";
    std::filesystem::create_directory(folder);
    ASSERT_TRUE(someSession(path, 300));  // the writer is destroyed without sealing
    ASSERT_FALSE(SessionReader::open(path)->sealed());
    SessionRetention house(sessionsIn(folder), folder, {});
    QStringList told;
    QObject::connect(&house, &SessionRetention::news, &house, [&] {
        for (const Message& sentence : house.consumeNews()) told << translated(sentence);
    });
    QTest::qWait(100);  // waits for an event that must not come
    EXPECT_FALSE(SessionReader::open(path)->sealed()) << "nothing before the window is there";
    house.start();
    ASSERT_TRUE(eventually([&] { return !told.isEmpty(); }));
    EXPECT_TRUE(told[0].contains("session recovered")) << told[0].toStdString();
    EXPECT_TRUE(SessionReader::open(path)->sealed());
}

TEST(SessionRetention, appliesANewLimitAfterTheGracePeriod)
{
    const TemporaryDirectory directory;
    const std::string folder = directory.file("sessions"), path = folder + "/old.tts";
    std::filesystem::create_directory(folder);
    ASSERT_TRUE(someSession(path, 300));
    ASSERT_FALSE(recoverDeadSessions({path}).empty());  // closes the session
    const RetentionLimits any{}, small{.gigabytes = 1e-9, .confirmed = true};
    SessionRetention house(sessionsIn(folder), folder, any);
    house.setGrace(300);
    house.start();
    QStringList told;
    QObject::connect(&house, &SessionRetention::news, &house, [&] {
        for (const Message& sentence : house.consumeNews()) told << translated(sentence);
    });
    house.setLimits(small);
    house.setLimits(any);  // a mistake that is undone in time
    QTest::qWait(900);     // three times the grace; the deletion must not come
    EXPECT_TRUE(std::filesystem::exists(path));
    house.setLimits(small);
    ASSERT_TRUE(eventually([&] { return !told.isEmpty(); }));
    EXPECT_TRUE(told[0].contains("session deleted")) << told[0].toStdString();
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(SessionRetention, countsAndDeletesTheSessionsOfThisRunToo)
{
    const TemporaryDirectory directory;
    const std::string folder = directory.file("sessions");
    std::filesystem::create_directory(folder);
    SessionRetention house({}, folder, {});
    house.setGrace(1);
    house.start();
    auto closed = someSession(folder + "/of-this-run.tts", 300);
    ASSERT_TRUE(closed && closed->seal());
    const auto open = someSession(folder + "/under-way.tts", 300);
    ASSERT_TRUE(open);
    house.setLimits({.gigabytes = 1e-9, .confirmed = true});
    EXPECT_TRUE(eventually([&] { return !std::filesystem::exists(folder + "/of-this-run.tts"); }));
    EXPECT_TRUE(std::filesystem::exists(folder + "/under-way.tts"));
    // Inspecting the session must not release the lock that this process holds on it.
    (void)std::system(
        (TERRATACT_CLI " session recover " + folder + "/under-way.tts >/dev/null 2>&1").c_str());
    EXPECT_TRUE(std::filesystem::exists(folder + "/under-way.tts-wal"))
        << "another process took it over";
}

TEST(SessionRetention, aLimitThatIsTakenBackDeletesNothingFromThenOn)
{
    const TemporaryDirectory directory;
    const std::string folder = directory.file("sessions"), path = folder + "/old.tts";
    std::filesystem::create_directory(folder);
    auto session = someSession(path, 300);
    ASSERT_TRUE(session && session->seal());
    SessionRetention house(sessionsIn(folder), folder, {.gigabytes = 1e-9, .confirmed = true});
    house.setLimits({.days = 1.0, .confirmed = true});  // the stricter limit of the two
    house.start();
    QTest::qWait(500);  // waits for an event that must not come
    EXPECT_TRUE(std::filesystem::exists(path)) << "although the grace has hardly begun";
}

}  // namespace
}  // namespace terratact
