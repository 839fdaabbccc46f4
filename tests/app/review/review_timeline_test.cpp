// Tests the timeline of a review.
#include "app/review/review_timeline.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <QRegularExpression>

#include "app/display/translated.h"
#include "app/review/review_window.h"
#include "app/review/scenes_window.h"
#include "app/start/language.h"
#include "core/infer/verdict/verdict.h"
#include "core/log/event_text.h"
#include "core/log/rows/session_rows.h"
#include "core/robot/force_sensor.h"
#include "core/robot/watch/sensor_suspicion.h"
#include "drivers/can_bus.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"

namespace terratact {
namespace {

TEST(Languages, sessionTextIsTranslatedExceptWhatPeopleWrote)
{
    const std::vector<EventRow> told{
        {.kind = EventKind::Decision, .subject = "drive", .text = "back"},
        withText({.kind = EventKind::Decision, .subject = "drive"}, TR_NOOP("event", "forward")),
        {.kind = EventKind::Decision, .subject = "second method", .text = "none"},
        {.kind = EventKind::Decision, .subject = "release stop"},
        {.kind = EventKind::Phase,
         .subject = std::string(name(AtemPhase::Failed)),
         .text = std::string(name(AtemFailure::Disarmed))},
        {.kind = EventKind::Arming,
         .subject = std::string(name(ArmingPhase::Disarmed)),
         .text = std::string(name(DisarmCause::Stop))},
        {.kind = EventKind::Arming, .subject = std::string(name(ArmingPhase::Confirming))},
        {.kind = EventKind::Arming, .subject = std::string(name(ArmingPhase::Requested))},
        {.kind = EventKind::Arming, .subject = std::string(name(ArmingPhase::Armed))},
        withText({.kind = EventKind::Link, .subject = std::string(kLinkUp)},
                 {TR_NOOP("core", "gaps before: %1, the longest %2 s"), 3, fixed(0.41, 2)}),
        withText({.kind = EventKind::Link, .subject = std::string(kLinkLost)},
                 describe(BusState::Ended, "bus")),
        {.kind = EventKind::Link, .subject = std::string(kTelemetryLost)},
        {.kind = EventKind::Alarm, .subject = "silence", .number = 0.0},
        {.kind = EventKind::Panel, .subject = "refuse", .number = 1.0},
        withText({.kind = EventKind::Gap, .subject = "log"},
                 TR_NOOP("core", "frames that were lost when the log was recorded")),
        withText({.kind = EventKind::Session, .subject = "begun"},
                 TR_NOOP("core", "from a log of CAN frames")),
        withText({.kind = EventKind::Session, .subject = "continued"},
                 {TR_NOOP("core", "after %1"), "/tmp/seen.tts"}),
        withText({.kind = EventKind::Session, .subject = "merged"},
                 {TR_NOOP("core", "from %1, %2 frames, last link %3, %4 batches of which are not "
                                  "what was recorded and left out"),
                  "seen.tts", 12, "0123", 3}),
        withText({.kind = EventKind::Session, .subject = "ended"},
                 TR_NOOP("core", "closed with the console"))};
    std::vector<QString> english;
    for (const EventRow& event : told) english.push_back(sentenceOf(event));
    for (const char* language : {"cs", "de"}) {
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
        static const QRegularExpression kBetween(QStringLiteral("[^\\p{L}]+"));
        for (std::size_t i = 0; i < told.size(); ++i) {
            const QString translated = sentenceOf(told[i]);
            const QStringList left = translated.split(kBetween, Qt::SkipEmptyParts);
            for (const QString& word : english[i].split(kBetween, Qt::SkipEmptyParts))
                EXPECT_TRUE(!left.contains(word)
                            || QStringList({"STOP", "CAN", "alarm", "disk", "program", "robot", "s",
                                            "tmp", "seen", "tts", "bus"})
                                   .contains(word))
                    << language << ": " << word.toStdString() << " in " << translated.toStdString();
        }
        const EventRow note{.kind = EventKind::Marker, .subject = "operator", .text = "stop"};
        EXPECT_TRUE(sentenceOf(note).endsWith(": stop")) << sentenceOf(note).toStdString();
    }
    installLanguage(*qApp, "en");
}

TEST(Languages, whatWasOnTheScreenIsTranslated)
{
    const EventRow event = withScreen(
        {.kind = EventKind::Decision, .subject = "approve"},
        Message::listed({{TR_NOOP("terratact::SessionEventLogger", "exploration: %1"),
                          describe(AtemPhase::ProposingProbe)},
                         describe(StepVerdict::CannotTell),
                         {TR_NOOP("terratact::SessionEventLogger", "not felt: %1"), "+0.3 m"}},
                        "; "));
    EXPECT_EQ(event.shown, "exploration: arm probe proposed; CANNOT TELL; not felt: +0.3 m");
    EventRow older = event;
    older.screen = {};
    for (const char* language : {"cs", "de"}) {
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
        const QString text = translated(screenOf(event));
        EXPECT_FALSE(text.contains("exploration")) << text.toStdString();
        EXPECT_FALSE(text.contains("proposed")) << text.toStdString();
        EXPECT_FALSE(text.contains("not felt")) << text.toStdString();
        EXPECT_TRUE(text.endsWith("+0.3 m")) << text.toStdString();
        EXPECT_EQ(translated(screenOf(older)), QString::fromStdString(event.shown))
            << "versions 1 to 5 hold it in English only";
    }
    installLanguage(*qApp, "en");
}

using namespace gui;
using At = RobotSessionTimes;

TEST_F(ReviewOf, aDamagedSessionShowsItsGaps)
{
    record();
    sqlite3* file = nullptr;
    ASSERT_EQ(sqlite3_open(path.toUtf8().constData(), &file), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(file,
                           "UPDATE can_frame SET data = x'00' WHERE t > 1000000000 AND t < "
                           "3000000000",
                           nullptr, nullptr, nullptr),
              SQLITE_OK);
    sqlite3_close(file);
    open();
    ASSERT_TRUE(eventually([&] { return window->surveyed(); }));
    EXPECT_TRUE(window->stateLabel()->text().contains("DAMAGED"));
    window->goTo(2.9);
    EXPECT_TRUE(window->damageLabel()->isVisible());
    EXPECT_FALSE(window->moment().measurement);
    window->goTo(3.9);
    EXPECT_FALSE(window->damageLabel()->isVisible());
    EXPECT_TRUE(window->moment().measurement);
}

}  // namespace
}  // namespace terratact
