// Tests that a session is shown in the language of its reader: events, what was on the screen, and the mission report.
#include <gtest/gtest.h>

#include <QRegularExpression>
#include <stdexcept>
#include <string>

#include "app/display/translated.h"
#include "app/figures/report/mission_report.h"
#include "app/figures/report/session_report.h"
#include "app/recording/session_folder.h"
#include "app/review/review_timeline.h"
#include "app/start/language.h"
#include "core/log/event_text.h"
#include "core/log/session_reader.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"
#include "tests/support/benches/bus_console_bench.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

/// Installs a language while it exists.
struct InLanguage {
    explicit InLanguage(const char* language)
        : isThere(installLanguage(*qApp, language) == QLatin1String(language))
    {
    }
    ~InLanguage() { installLanguage(*qApp, "en"); }
    InLanguage(const InLanguage&) = delete;
    InLanguage& operator=(const InLanguage&) = delete;
    bool isThere;
};

QStringList wordsOf(const QString& text)
{
    static const QRegularExpression kBetween(QStringLiteral("[^\\p{L}]+"));
    return text.split(kBetween, Qt::SkipEmptyParts);
}

/// Returns the words of four letters and more that are in both texts. Names of files, methods and settings, hashes, and
/// words that are the same in the other language are left out.
std::string leftInEnglish(QString english, const QString& translated)
{
    static const QStringList kNames{"STOP",    "stop",  "Hashes",    "Ctrl",     "Absolem",
                                    "robot",   "local", "truncate",  "isolated", "single",
                                    "forward", "model", "terratact", "console",  "test",
                                    "fake",    "alarm", "text"};
    static const QRegularExpression kHash(QStringLiteral("[0-9a-f]{64}"));
    QStringList left;
    const QStringList kept = wordsOf(translated);
    for (const QString& word : wordsOf(english.remove(kHash)))
        if (word.size() > 3 && kept.contains(word) && !kNames.contains(word, Qt::CaseInsensitive))
            left << word;
    return left.join(QStringLiteral(", ")).toStdString();
}

/// Returns every text of the review's list and of both reports in the active language.
QStringList textsOf(SessionReader& session)
{
    QStringList texts;
    for (const EventRow& event : session.events()) {
        if (event.kind == EventKind::Marker) continue;  // text that a person typed
        texts << sentenceOf(event) << translatedLine(screenOf(event)) << nameOf(event.kind);
    }
    const auto add = [&](const std::string& text) { texts << QString::fromStdString(text); };
    const auto mission = missionReportOf(session, {}, {}, inReadersLanguage);
    if (!mission) throw std::runtime_error(mission.error().text);
    for (const DocumentPart& part : mission->parts) {
        add(part.heading + ". " + part.note);
        for (const auto& [what, text] : part.facts) add(what + ": " + text);
        for (const DocumentPicture& picture : part.pictures) add(picture.text);
        for (const std::string& cell : part.table.heading) add(cell);
        for (const auto& row : part.table.rows)
            for (const std::string& cell : row) add(cell);
    }
    const auto scene = reportOf(session, 0, {}, {}, inReadersLanguage);
    if (!scene) throw std::runtime_error(scene.error().text);
    add(scene->title + ". " + scene->verdict);
    for (const auto& [what, text] : scene->facts) add(what + ": " + text);
    for (const auto& row : scene->table)
        for (const std::string& cell : row) add(cell);
    for (const std::string& event : scene->events) add(event);
    return texts;
}

TEST_F(BusConsole, aWholeSessionIsReadInTheReadersLanguage)
{
    const TemporaryDirectory directory;
    startQuickRobot();
    SessionStart start = someStart();
    start.robot = *readFile(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml", 65536);
    start.robotHash = sha256Hex(start.robot);
    recording = std::make_shared<SessionRecorder>(SessionRecorder::Options{
        .folder = directory.file("sessions"), .start = start, .patience = kBusyDisk});
    openOn();
    ASSERT_TRUE(drives());
    QTest::keyRelease(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Halted));
    ASSERT_TRUE(exploresAndProbes());
    QTest::keyClick(window.get(), Qt::Key_K);
    QTest::keyClick(window.get(), Qt::Key_Delete);
    QTest::keyClick(window.get(), Qt::Key_F12);
    ASSERT_TRUE(gui::eventually([&] { return arming() == ArmingPhase::Disarmed; }));
    window.reset();
    recording.reset();
    const auto files = sessionsIn(directory.file("sessions"));
    ASSERT_EQ(files.size(), 1U);
    auto session = SessionReader::open(files.front());
    ASSERT_TRUE(session) << session.error().text;
    ASSERT_FALSE(session->estimates().empty());
    const QStringList english = textsOf(*session);
    for (const char* language : {"de", "cs"}) {
        const InLanguage installed(language);
        ASSERT_TRUE(installed.isThere);
        const QStringList translated = textsOf(*session);
        ASSERT_EQ(translated.size(), english.size());
        for (qsizetype i = 0; i < english.size(); ++i)
            EXPECT_EQ(leftInEnglish(english[i], translated[i]), "")
                << language << ": " << translated[i].toStdString();
    }
}

TEST(SessionLanguage, argumentsOfAnEarlierVersionAreShownAsTodays)
{
    EventRow event{.kind = EventKind::Word};
    event.message.context = "terratact::ConsoleAlarms";
    event.message.source = "Disarmed: %1";
    Message cause;
    cause.context = "core";
    cause.source = "the tracks moved less than the advance asked for";
    event.message.arguments = {cause};
    EXPECT_EQ(messageOf(event).english(),
              "Disarmed: the tracks moved less than the commanded advance");
    const InLanguage german("de");
    ASSERT_TRUE(german.isThere);
    EXPECT_TRUE(sentenceOf(event).endsWith("die Ketten fuhren weniger weit als befohlen"))
        << sentenceOf(event).toStdString();
}

TEST(SessionLanguage, aSentenceOfAnEarlierVersionIsShownAsTodays)
{
    EventRow event{.kind = EventKind::Word};
    event.message.context = "core";
    event.message.source = "left: %1";
    Message step;
    step.context = "core";
    step.source =
        "a step ahead of more than %1 mm: probability %2 ± %3, likeliest between %4 and %5 m (%6)";
    for (const char* number : {"100", "0.30", "0.05", "+0.5", "+0.6", "0.30"})
        step.arguments.push_back(Message::verbatim(number));
    event.message.arguments = {step};
    EXPECT_EQ(
        messageOf(event).english(),
        "left: a step ahead of more than 100 mm: probability 0.30 ± 0.05, most likely at +0.5 "
        "m … +0.6 m (0.30)");
    const InLanguage german("de");
    ASSERT_TRUE(german.isThere);
    EXPECT_EQ(sentenceOf(event).toStdString(),
              "links: eine Stufe über 100 mm: Wahrscheinlichkeit 0.30 ± 0.05, am ehesten bei "
              "+0.5 m … +0.6 m (0.30)");
}

}  // namespace
}  // namespace terratact
