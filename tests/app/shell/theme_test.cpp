// Tests fonts, layouts, languages and preferences, so that everyone can read the console.
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QSpinBox>
#include <algorithm>

#include "app/console/main_window.h"
#include "app/console/settings_page.h"
#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/bus_text.h"
#include "app/review/review_timeline.h"
#include "app/shell/about.h"
#include "app/shell/font_fit.h"
#include "app/shell/language.h"
#include "app/shell/view_menu.h"
#include "core/atem/following.h"
#include "core/infer/verdict/estimate_text.h"
#include "core/infer/verdict/verdict.h"
#include "core/learn/data/scene_file.h"
#include "core/robot/force_sensor.h"
#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor_suspicion.h"
#include "core/store/csv_reader.h"
#include "core/store/file_read.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/look_bench.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/estimate_strip.h"
#include "widgets/terrain/terrain_profile_view.h"
#include "widgets/terrain/verdict_strip.h"

namespace terratact {
namespace {

using gui::eventually;

/// Returns the share of pixels that emit more than red.
double notRed(const QImage& image)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            if (std::max(c.green(), c.blue()) > 0.52 * c.red() + 6) ++count;
        }
    return static_cast<double>(count) / (image.width() * image.height());
}

TEST_F(Look, inTheNightThemeEveryPixelIsRed)
{
    explore();
    EXPECT_GT(notRed(gui::painted(*window)), 0.5) << "by day";
    press(Qt::Key_5);
    eachPage([&] { EXPECT_EQ(notRed(gui::painted(*window)), 0.0) << window->rail()->chosen(); });
    QTest::mousePress(window->header()->stopButton(), Qt::LeftButton);
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->releaseButton()->isVisible(); }));
    EXPECT_EQ(notRed(gui::painted(*window)), 0.0) << "stopped";
    press(Qt::Key_4);
    QTest::qWait(80);
    EXPECT_GT(notRed(gui::painted(*window)), 0.5) << "the theme changes back while it runs";
}

TEST_F(Look, largeFontsCutNoText)
{
    explore();
    const std::pair<int, QSize> cases[]{
        {80, {1440, 900}}, {120, {1440, 900}}, {150, {1440, 900}}, {200, {2560, 1440}}};
    for (const auto& [scale, size] : cases) {
        window->setRoom(size);
        window->preferences().change([scale = scale](Preferences& p) { p.fontScale = scale; });
        for (const Qt::Key layout : {Qt::Key_1, Qt::Key_3, Qt::Key_2}) {
            press(layout);
            window->resize(size);
            QTest::qWait(100);
            EXPECT_EQ(window->size(), size) << "the layout needs more than this";
            (void)eventually([&] { return gui::cutText(*window).empty(); },
                             2000);  // waits for the layout
            EXPECT_EQ(gui::cutText(*window), std::vector<std::string>())
                << scale << " % " << layout;
        }
    }
}

TEST_F(Look, noLanguageCutsText)
{
    for (const char* language : {"en", "cs", "de"}) {
        window.reset();
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        open();
        explore();
        for (const QSize size : {QSize(1280, 720), QSize(1440, 900), window->minimumSize()}) {
            window->resize(size);
            QTest::qWait(100);
            eachPage([&] {
                (void)eventually([&] { return gui::cutText(*window).empty(); },
                                 2000);  // waits for the layout
                EXPECT_EQ(gui::cutText(*window), std::vector<std::string>())
                    << language << ", width " << size.width() << ", page "
                    << window->rail()->chosen();
            });
        }
        EXPECT_EQ(window->keys().html().contains("drive back"), language == std::string_view("en"));
    }
    installLanguage(*qApp, "en");
}

/// Returns describe() of every enumerator from 0 to `last`; describe() knows none beyond it.
template <class Enum>
QStringList allTo(Enum last)
{
    QStringList sentences;
    for (int i = 0; i <= static_cast<int>(last); ++i)
        sentences << QString::fromStdString(describe(static_cast<Enum>(i)));
    EXPECT_THROW((void)describe(static_cast<Enum>(static_cast<int>(last) + 1)),
                 std::invalid_argument)
        << sentences.last().toStdString() << " is not the last";
    return sentences;
}

TEST(Languages, coreSentencesAreTranslatedWithTheirNumbers)
{
    constexpr const char* kTrouble =
        "/home/no 2/mine.ttm: cannot be opened: No such file or directory";
    TerrainEstimate estimate = stepEstimate();
    for (int i = 0; i < 400; ++i) {
        estimate.draws.push_back(estimate.height);
        if (i % 2 == 0) estimate.draws.back()[9] -= 0.3;
    }
    QStringList said = allTo(AtemPhase::Failed) + allTo(AtemFailure::Disarmed)
                     + allTo(DisarmCause::EpochChanged) + allTo(GateRefusal::OtherBin)
                     + allTo(WithholdReason::Contradiction) + allTo(RobotActivity::Stopped)
                     + allTo(Refusal::OutOfLimits)
                     + allTo(ElementState::Short).mid(1)  // Sound has no text
                     + QStringList{"yes", "no", "none", "not measured"};
    for (int i = 0; i <= static_cast<int>(AtemPhase::Failed); ++i)
        said << QString::fromStdString(describeFollowed(static_cast<AtemPhase>(i)));
    for (std::size_t i = 0; i < kSensors; ++i)
        said << QString::fromStdString(std::string(describe(sensorAt(i))));
    for (int i = 0; i < kSensorTroubles; ++i)
        for (const double way : {0.0, 0.6})
            said << QString::fromStdString(describeTrouble(
                {.trouble = static_cast<SensorTrouble>(i), .amount = 12.0, .way = way}));
    for (const double limit : {0.1, 0.9})  // an undecided and an almost certain value
        for (const std::string& sentence : hiddenByBands(estimate, limit))
            said << QString::fromStdString(sentence);
    said << QString::fromUtf8(
        "the estimate contradicts the readings: pitch +3° measured, -1° on its ground; "
        "front flippers -2° measured, +4° on its ground");
    for (const StepVerdict stepVerdict :
         {StepVerdict::Clear, StepVerdict::Blocked, StepVerdict::CannotTell})
        said << format::text(name(stepVerdict));
    for (const char* language : {"cs", "de"}) {
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        for (const BusState state : kBusStates) {
            const QString english = QString::fromStdString(describe(state, "can0"));
            const QString translated = busWords(state, "can0");
            EXPECT_NE(translated, english) << language;
            EXPECT_TRUE(translated.startsWith("can0 ")) << translated.toStdString();
            const auto command = [](const QString& text) { return text.section(" (", -1); };
            EXPECT_TRUE(!english.endsWith(')') || command(translated) == command(english))
                << translated.toStdString();
        }
        for (const QString& english : said)
            EXPECT_NE(format::sentence(english.toStdString()), english) << language;
        const QString roll =
            format::sentence("roll -5.2°: the ground is not the same left and right");
        EXPECT_TRUE(roll.contains("-5.2°") && !roll.contains("ground")) << roll.toStdString();
        EXPECT_EQ(format::sentence("nobody knows 3 of these"), "nobody knows 3 of these");
        const QStringList trouble = format::sentence(kTrouble).split(": ");
        ASSERT_EQ(trouble.size(), 3) << language;
        EXPECT_EQ(trouble[0], "/home/no 2/mine.ttm");
        EXPECT_NE(trouble[1], "cannot be opened");
        EXPECT_NE(trouble[2], "No such file or directory");
    }
    EXPECT_EQ(installLanguage(*qApp, "tlh"), "en");
    EXPECT_EQ(format::sentence("ready"), "ready");
    EXPECT_EQ(format::sentence(kTrouble), kTrouble);
}

TEST(Languages, numbersAreWrittenAndReadTheSameInEach)
{
    for (const char* language : {"en", "cs", "de"}) {
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));  // like LANG=de_DE
        (void)installLanguage(*qApp, language);
        QDoubleSpinBox box;
        box.setRange(0.0, 100'000.0);
        box.setValue(12'345.5);
        EXPECT_EQ(box.text(), "12345.50") << language;
        box.findChild<QLineEdit*>()->setText("0.25");
        box.interpretText();
        EXPECT_EQ(box.value(), 0.25) << language;
        QSpinBox whole;
        whole.setRange(0, 100'000);
        whole.setValue(10'000);
        EXPECT_EQ(whole.text(), "10000") << language;
    }
    installLanguage(*qApp, "en");
}

TEST(Languages, fileErrorsAreTranslatedAroundTheirNames)
{
    const auto scenes = [](std::string header) {
        return readScenes(*CsvReader::over("scenes.csv", header + "\n1\n")).error().message;
    };
    const Message messages[]{
        robotModelFrom("/home/no 2/robot.toml", "name = 3\n").error().message,
        robotModelFrom("robot.toml", "wheels = 3\n").error().message,
        scenes("colour"),
        scenes("h_9_m"),
        fileError("mine.ttm", TR_NOOP("core", "is empty")).message,
    };
    for (const char* language : {"cs", "de"}) {
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        for (const Message& message : messages) {
            const std::string sentence = message.english();
            const QString translated = terratact::translated(message);
            EXPECT_NE(translated.toStdString(), sentence) << language;
            for (const char* word : {" is ", " not ", "expected", "since", "line "})
                EXPECT_FALSE(translated.contains(QLatin1String(word))) << translated.toStdString();
            for (const char* name : {"/home/no 2/robot.toml", "'h_9_m'", "colour", "mine.ttm"})
                EXPECT_EQ(translated.contains(QLatin1String(name)),
                          sentence.find(name) != std::string::npos)
                    << translated.toStdString();
        }
    }
    installLanguage(*qApp, "en");
}

TEST(Languages, namesOfFilesColumnsAndSourcesAreNotTranslated)
{
    for (const char* language : {"cs", "de"}) {
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        for (const char* name : {"up", "lost", "approve", "drive", "back", "stop", "halt",
                                 "settings", "ready", "stopped", "driving", "fast", "no", "none"}) {
            const QString whose = QString::fromUtf8(name);
            const std::string file =
                format::sentence(std::string(name) + ": cannot be opened").toStdString();
            EXPECT_TRUE(file.starts_with(std::string(name) + ": ")) << file;
            EXPECT_EQ(file.find("opened"), std::string::npos) << file;
            const std::string behind = "session deleted, since it is older than you have set: ";
            EXPECT_TRUE(format::sentence(behind + name).endsWith(": " + whose)) << name;
            const QString column =
                translated(Message(TR_NOOP("core", "the column %1 appears twice"), name));
            EXPECT_TRUE(column.split(' ').contains(whose)) << column.toStdString();
            EXPECT_FALSE(column.contains("twice")) << column.toStdString();
            EXPECT_EQ(format::sourceName(name), whose);
            const QString replay = format::sourceName(std::string("REPLAY ") + name);
            EXPECT_TRUE(replay.endsWith(' ' + whose) && !replay.startsWith("REPLAY"))
                << replay.toStdString();
        }
        for (const char* word :
             {"up", "lost", "approve", "drive", "back", "stop", "halt", "settings"}) {
            EXPECT_EQ(format::sentence(word), word) << "a word of events is no sentence";
            EXPECT_NE(format::eventWord(word), word) << language;
        }
        EXPECT_NE(format::sourceName("SIMULATED ROBOT"), "SIMULATED ROBOT") << language;
    }
    installLanguage(*qApp, "en");
    EXPECT_EQ(format::sourceName("REPLAY drive"), "REPLAY drive");
    EXPECT_EQ(format::eventWord("drive"), "drive");
}

TEST(Languages, sessionTextIsTranslatedExceptWhatPeopleWrote)
{
    const std::vector<EventRow> told{
        {.kind = EventKind::Decision, .subject = "drive", .text = "back"},
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
        {.kind = EventKind::Link,
         .subject = std::string(kLinkUp),
         .text = "gaps before: 3, the longest 0.41 s"},
        {.kind = EventKind::Link,
         .subject = std::string(kLinkLost),
         .text = describe(BusState::Ended, "bus")},
        {.kind = EventKind::Link, .subject = std::string(kTelemetryLost)},
        {.kind = EventKind::Alarm, .subject = "silence", .number = 0.0},
        {.kind = EventKind::Panel, .subject = "refuse", .number = 1.0},
        {.kind = EventKind::Gap,
         .subject = "missing",
         .text =
             "12 frames and 3 other rows are not here: there was no room while the disk was slow "
             "or full, or they could not be written"},
        {.kind = EventKind::Gap,
         .subject = "log",
         .text = "frames that were lost when the log was recorded"},
        {.kind = EventKind::Session, .subject = "begun", .text = "from a log of CAN frames"},
        {.kind = EventKind::Session, .subject = "continued", .text = "after /tmp/seen.tts"},
        {.kind = EventKind::Session,
         .subject = "merged",
         .text = "from seen.tts, 12 frames, last link 0123, 3 batches of which are not what was "
                 "recorded and left out"},
        {.kind = EventKind::Session,
         .subject = "recovered",
         .text = "the program that recorded ended without closing the session"},
        {.kind = EventKind::Session, .subject = "ended", .text = "closed with the console"}};
    std::vector<QString> english;
    for (const EventRow& event : told) english.push_back(sentenceOf(event));
    for (const char* language : {"cs", "de"}) {
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        static const QRegularExpression kBetween(QStringLiteral("[^\\p{L}]+"));
        for (std::size_t i = 0; i < told.size(); ++i) {
            const QString translated = sentenceOf(told[i]);
            const QStringList left = translated.split(kBetween, Qt::SkipEmptyParts);
            for (const QString& word : english[i].split(kBetween, Qt::SkipEmptyParts))
                EXPECT_TRUE(!left.contains(word)
                            || QStringList({"STOP", "CAN", "disk", "program", "robot", "s", "tmp",
                                            "seen", "tts", "bus"})
                                   .contains(word))
                    << language << ": " << word.toStdString() << " in " << translated.toStdString();
        }
        const EventRow note{.kind = EventKind::Marker, .subject = "operator", .text = "stop"};
        EXPECT_TRUE(sentenceOf(note).endsWith(": stop")) << sentenceOf(note).toStdString();
    }
    installLanguage(*qApp, "en");
}

TEST(About, namesNoFileThatIsNotThere)
{
    static const QRegularExpression kFile(QStringLiteral("(?<![:/])/[a-z][^ <]*"));
    for (auto file = kFile.globalMatch(aboutHtml().remove(QRegularExpression("</[a-z0-9]+>")));
         file.hasNext();) {
        const QString path = file.next().captured();
        EXPECT_TRUE(QFileInfo::exists(path)) << path.toStdString();
    }
}

/// Returns the final font scale of a window and the number of trials.
std::pair<int, int> lettersThatFit(int wanted, QSize room, const std::function<QSize(int)>& needs)
{
    int percent = wanted, tries = 1;
    for (; percent > kSmallestFont && needs(percent).expandedTo(room) != room; ++tries)
        percent = smallerLetters(percent, needs(percent), room);
    return {percent, tries};
}

TEST(Letters, areTheLargestThatFit)
{
    const auto fits = [](int wanted, QSize room) {
        return lettersThatFit(wanted, room,
                              [](int percent) { return QSize(10 * percent, 5 * percent); });
    };
    EXPECT_EQ(fits(100, {2000, 2000}), std::pair(100, 1)) << "never larger than wanted";
    EXPECT_EQ(fits(200, {2000, 1000}), std::pair(200, 1)) << "just so";
    EXPECT_EQ(fits(200, {1999, 2000}), std::pair(190, 2)) << "too wide";
    EXPECT_EQ(fits(200, {2000, 700}), std::pair(140, 2)) << "too high";
    EXPECT_EQ(fits(155, {1460, 2000}), std::pair(145, 2)) << "steps are from the wanted ones";
    EXPECT_EQ(fits(200, {100, 100}), std::pair(kSmallestFont, 2)) << "smaller there are none";
}

TEST(Letters, areTheLargestThatFitWithFixedSizeParts)
{
    for (int room = 900; room < 1700; room += 7) {
        const auto needs = [](int percent) { return QSize(5 * percent, 700 + 4 * percent); };
        const auto [percent, tries] = lettersThatFit(200, {2000, room}, needs);
        EXPECT_EQ(percent, std::clamp((room - 700) / 40 * 10, kSmallestFont, 200)) << room;
        EXPECT_LE(tries, 8) << room;
    }
}

TEST_F(Look, changedWhileItRunsIsAsFromTheStart)
{
    Preferences night;
    night.theme = ThemeName::NightRed;
    night.fontScale = 120;
    const auto settingsPage = [this] {
        window->setRoom({1600, 1000});
        window->resize(1600, 1000);
        window->rail()->choose(window->rail()->pageOf(Qt::Key_F7));
        gui::settle(*window->settings());
        return gui::painted(*window->settings());
    };
    window.reset();
    open(night);
    const QImage fromTheStart = settingsPage();
    window.reset();
    open();
    const QImage byDay = settingsPage();
    for (const Qt::Key key : {Qt::Key_6, Qt::Key_Minus, Qt::Key_5, Qt::Key_0}) press(key);
    for (int i = 0; i < 2; ++i) press(Qt::Key_Plus);
    EXPECT_EQ(settingsPage(), fromTheStart);
    for (const Qt::Key key : {Qt::Key_0, Qt::Key_6, Qt::Key_4}) press(key);
    EXPECT_EQ(settingsPage(), byDay);
}

TEST_F(Look, fontTooLargeForTheScreenIsReportedAndKept)
{
    window->setRoom({1200, 680});
    window->preferences().change([](Preferences& p) { p.fontScale = 200; });
    ASSERT_TRUE(eventually([&] { return !window->isMeasured(); }));
    const int fits = lookInForce().fontScale;
    EXPECT_LT(fits, 200);
    EXPECT_TRUE(window->updatesEnabled());
    EXPECT_LE(window->minimumWidth(), 1200);
    EXPECT_LE(window->minimumHeight(), 680);
    const QString note = QStringLiteral("200 % wanted, %1 % fits this screen").arg(fits);
    EXPECT_EQ(lettersNote(200), note);
    window->rail()->choose(window->rail()->pageOf(Qt::Key_F7));
    EXPECT_TRUE(eventually([&] { return window->settings()->lettersNote()->isVisible(); }));
    EXPECT_EQ(window->settings()->lettersNote()->text(), note);
    ViewMenu menu(window->preferences(), "at once");
    menu.popup(window->pos());
    EXPECT_TRUE(menu.actions().last()->isVisible());
    EXPECT_EQ(menu.actions().last()->text(), note);
    menu.hide();

    window->setRoom({1920, 1080});
    EXPECT_EQ(lookInForce().fontScale, 200);
    EXPECT_EQ(window->preferences().current().fontScale, 200);
    EXPECT_TRUE(eventually([&] { return !window->settings()->lettersNote()->isVisible(); }));
    EXPECT_EQ(lettersNote(200), QString());

    window->setRoom({1200, 680});
    press(Qt::Key_Minus);
    EXPECT_EQ(lookInForce().fontScale, fits - 10) << "smaller than what is seen, not than wanted";
}

TEST_F(Look, fontScaleStaysWithinItsLimits)
{
    const int before = window->header()->stopButton()->height();
    for (int i = 0; i < 5; ++i) press(Qt::Key_Plus);
    EXPECT_EQ(window->preferences().current().fontScale, 150);
    EXPECT_GT(window->header()->stopButton()->height(), before);
    for (int i = 0; i < 20; ++i) press(Qt::Key_Minus);
    EXPECT_EQ(window->preferences().current().fontScale, kSmallestFont);
    press(Qt::Key_0);
    EXPECT_EQ(window->preferences().current().fontScale, 100);
}

TEST_F(Look, everyLayoutShowsStopStateAndWhatAsks)
{
    for (const Qt::Key layout : {Qt::Key_1, Qt::Key_2, Qt::Key_3}) {
        press(layout);
        QTest::qWait(60);
        EXPECT_TRUE(window->header()->stopButton()->isVisible());
        EXPECT_TRUE(window->atemPanel()->isVisible());
        EXPECT_TRUE(window->terrain()->isVisible());
        EXPECT_EQ(window->drivePad()->isVisible(), layout != Qt::Key_3);
        EXPECT_EQ(window->events()->isVisible(), layout != Qt::Key_1);
        EXPECT_EQ(window->probeCard()->isVisible(), layout == Qt::Key_2);
    }
    explore();
    EXPECT_TRUE(window->probeCard()->isVisible()) << "it asks in the review layout";
    press(Qt::Key_Home);
    EXPECT_EQ(window->preferences().current().layout, Layout::Probe);
}

TEST_F(Look, choicesAreSavedButNotCommandLineOptions)
{
    Preferences fromCommandLine;
    fromCommandLine.theme = ThemeName::HighContrast;
    window.reset();
    open(fromCommandLine);
    press(Qt::Key_3);
    EXPECT_EQ(window->preferences().current().theme, ThemeName::HighContrast);
    EXPECT_EQ(saved().theme, ThemeName::Day);
    EXPECT_EQ(saved().layout, Layout::Review);
    window->close();
    EXPECT_FALSE(saved().window.isEmpty());
}

TEST_F(Look, aTroubleWithThePreferencesIsAnEvent)
{
    window.reset();
    directory.write("console.ini", "[General]\nschema=1\ntheme=purple\n");
    open();
    EXPECT_TRUE(eventually([&] {
        return window->events()->count() > 0
            && !window->events()->findItems("purple", Qt::MatchContains).isEmpty();
    }));
}

TEST_F(Look, preferenceErrorsUseTheCurrentLanguage)
{
    directory.write("console.ini", "[General]\nschema=1\nlanguage=cs\ntheme=purple\n");
    LoadedPreferences loaded =
        loadPreferences(QString::fromStdString(directory.file("console.ini")));
    loaded.troubles.push_back(robotNotUsed(Error{"mine.toml: is empty"}));
    const PreferenceStore store(loaded, loaded.preferences);
    const QStringList english = store.troubles();
    if (installLanguage(*qApp, store.current().language) != "cs")
        GTEST_SKIP() << "built without translations";
    const QStringList czech = store.troubles();
    installLanguage(*qApp, "en");
    ASSERT_EQ(czech.size(), 2);
    EXPECT_TRUE(czech[0].contains("purple") && czech[0] != english[0]);
    EXPECT_TRUE(czech[1].contains("mine.toml: ") && !czech[1].contains("is empty"));
}

TEST_F(Look, safeModeIsShownOnEveryPageAndCutsNothing)
{
    window->hide();
    window->showSafeMode();
    gui::showActive(*window);
    for (const QSize size : {QSize(1200, 680), QSize(1440, 900)}) {
        window->setRoom(size);
        window->resize(size);
        eachPage([&] {
            const QStringList texts = gui::readableTexts(*window);
            EXPECT_TRUE(std::ranges::any_of(texts, [](const QString& text) {
                return text.contains("SAFE MODE") && text.contains("without --safe-mode");
            }));
            EXPECT_EQ(window->size(), size);
            (void)eventually([&] { return gui::cutText(*window).empty(); },
                             2000);  // waits for the layout
            EXPECT_EQ(gui::overlaps(*window), std::vector<std::string>());
            EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
        });
    }
}

TEST(TerrainPageAlone, saysNoTelemetryYoungerThanItMayBe)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const Measurement m;
    const auto says = [&](double age, bool due, double numbersFor) {
        TerrainViewState viewState;
        viewState.measurement = &m;
        viewState.age = age;
        viewState.numbersDue = due;
        viewState.numbersFor = numbersFor;
        page.setViewState(viewState);
        for (const QLabel* label : page.findChildren<QLabel*>())
            if (label->accessibleName() == "Age of the telemetry") return label->text();
        return QString();
    };
    EXPECT_EQ(says(0.046, true, 0.0), "46 ms old") << "it stands";
    EXPECT_EQ(says(0.046, true, 0.24), "< 0.3 s old") << "when it is shown anew";
    EXPECT_EQ(says(0.149, false, 0.24), "< 0.3 s old") << "these are still those numbers";
    EXPECT_EQ(says(0.149, true, 0.24), "< 0.4 s old");
    EXPECT_EQ(says(0.16, false, 0.24), "0.2 s old") << "at once";
    EXPECT_EQ(page.readout()->text(RobotReadout::Pitch), "--   160 ms old");
    EXPECT_EQ(says(1.27, false, 0.24), "1.3 s old") << "and it grows";
}

TEST(TerrainPageAlone, saysHowOldTheForcesAreThatItShowsNoMore)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const Measurement m;
    std::vector<ForceArray> forces(1);
    for (ForceElement& element : forces[0].elements) element.newtons = 3.0;
    std::uint64_t shows = 0;
    const auto says = [&](double age, std::optional<double> forcesAge) {
        TerrainViewState viewState;
        viewState.measurement = &m;
        viewState.age = age;
        viewState.forces = &forces;
        viewState.forcesAge = forcesAge;
        viewState.count = ++shows;
        page.setViewState(viewState);
        for (const QLabel* label : page.forces()->parentWidget()->findChildren<QLabel*>())
            if (label->isVisible() && label->text().endsWith(" old")) return label->text();
        return QString();
    };
    EXPECT_EQ(says(0.05, {}), "");
    EXPECT_EQ(page.forces()->numberText(0), "3.0");
    EXPECT_EQ(says(0.05, 0.44), "0.4 s old") << "their frames alone are missing";
    EXPECT_EQ(page.forces()->numberText(0), "--");
    EXPECT_EQ(says(0.05, 0.06), "") << "they are back";
    EXPECT_EQ(page.forces()->numberText(0), "3.0");
    EXPECT_EQ(says(1.27, {}), "1.3 s old") << "with all telemetry";
    EXPECT_EQ(page.forces()->numberText(0), "--");
}

TEST(TerrainPageAlone, saysThatFlippersMoveOnlyWhileTheyDo)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const Measurement m;
    const TerrainEstimate preview = stepEstimate();
    const auto says = [&](AtemPhase phase) {
        TerrainViewState viewState;
        viewState.measurement = &m;
        viewState.live = {&preview, 0};
        viewState.state.phase = phase;
        page.setViewState(viewState);
        return page.verdict()->reason() + "\n" + page.terrain()->accessibleDescription() + "\n"
             + page.strip()->headline();
    };
    const QString moving = says(AtemPhase::Pressing), computing = says(AtemPhase::Estimating);
    EXPECT_EQ(moving.count("flippers still move"), 2) << moving.toStdString();
    EXPECT_TRUE(moving.contains("LIVE preview"));
    EXPECT_EQ(computing.count("flippers still move"), 0) << computing.toStdString();
    EXPECT_EQ(computing.count("estimate is being computed"), 2) << computing.toStdString();
    EXPECT_FALSE(computing.contains("LIVE"));
}

}  // namespace
}  // namespace terratact
