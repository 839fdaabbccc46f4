// Tests a reviewed session: it is recognizable as a review, offers no command, and shows damage.
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>
#include <utility>

#include "app/display/format.h"
#include "app/mission/estimator_worker.h"
#include "app/pages/terrain_page.h"
#include "app/review/review_export_dialog.h"
#include "app/review/review_window.h"
#include "app/review/scenes_window.h"
#include "app/review/what_if_page.h"
#include "app/shell/language.h"
#include "app/shell/open_file.h"
#include "app/shell/remote_stop.h"
#include "core/store/file_write.h"
#include "tests/support/gui.h"
#include "tests/support/review_bench.h"
#include "tests/support/robot_session.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/signals/force_bars.h"
#include "widgets/terrain/estimate_strip.h"
#include "widgets/terrain/terrain_profile_view.h"
#include "widgets/terrain/verdict_strip.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

bool saysThatStopIsDead(const QWidget& window)
{
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (label->isVisible() && label->text().startsWith("STOP HAS NO EFFECT HERE")) return true;
    return false;
}

QList<QPushButton*> commandButtons(const TerrainPage& page)
{
    return {page.atemPanel()->requestButton(), page.atemPanel()->abortButton(),
            page.atemPanel()->releaseButton(), page.atemPanel()->overrideButton(),
            page.probeCard()->approveButton(), page.probeCard()->refuseButton(),
            page.drivePad()->forwardButton(),  page.drivePad()->backButton()};
}

TEST_F(ReviewOf, aSessionSaysThatItIsOneAndOffersNoCommand)
{
    record();
    open();
    EXPECT_TRUE(window->windowTitle().contains("REVIEW"));
    EXPECT_TRUE(window->windowTitle().contains("review.tts"));
    EXPECT_TRUE(window->header()->sourceName().contains("REVIEW"));
    EXPECT_TRUE(window->stateLabel()->text().contains("sealed"));
    EXPECT_FALSE(window->header()->stopButton()->isVisible());
    press(Qt::Key_F12);
    EXPECT_TRUE(saysThatStopIsDead(*window)) << "nobody may believe that it stops a robot";
    for (double t = 0.0; t <= 4.0; t += 0.25) {
        window->goTo(t);
        for (const QPushButton* button : commandButtons(*window->terrainPage()))
            EXPECT_FALSE(button->isVisible() && button->isEnabled())
                << t << " " << button->text().toStdString();
    }
}

bool saysUponTheHeader(const QWidget& window, const char* words)
{
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (label->isVisible() && label->text().contains(words)) return true;
    return false;
}

TEST_F(ReviewOf, aSessionOpenedByAConsoleStopsItsRobot)
{
    record();
    const std::string name = "terratact-review-test-" + std::to_string(::getpid());
    qputenv(kStopLineVariable, QByteArray::fromStdString(name));
    open();
    qunsetenv(kStopLineVariable);
    auto listens = StopLine::listen(name);
    ASSERT_TRUE(listens) << listens.error().text;
    auto line = std::make_unique<StopLine>(std::move(*listens));
    press(Qt::Key_Pause);
    EXPECT_TRUE(line->consume());
    press(Qt::Key_F12);
    EXPECT_TRUE(line->consume());
    EXPECT_TRUE(saysUponTheHeader(*window, "STOP SENT to the console"));
    EXPECT_TRUE(eventually([&] { return saysUponTheHeader(*window, "has received it"); }));
    press(Qt::Key_F12);  // nobody reads the line
    EXPECT_TRUE(eventually([&] { return saysUponTheHeader(*window, "STOP NOT RECEIVED"); }));
    line.reset();
    press(Qt::Key_F12);
    EXPECT_TRUE(saysUponTheHeader(*window, "STOP HAS NO EFFECT HERE: the console that opened"));
}

TEST_F(ReviewOf, aSessionShowsWhatTheOperatorSaw)
{
    record();
    open();
    window->goTo(At::kMarker);
    EXPECT_TRUE(window->terrainPage()->showsEstimate());
    EXPECT_TRUE(window->terrainPage()->probeCard()->asks());
    EXPECT_TRUE(window->terrainPage()->strip()->headline().contains("0.6"));
    window->goTo(At::kForgotten + 0.1);
    EXPECT_FALSE(window->terrainPage()->showsEstimate());
    window->goTo(At::kAlarm + 0.1);
    EXPECT_TRUE(window->header()->alarmsButton()->text().contains("1"));
}

TEST_F(ReviewOf, theEventsBesideTheRobotAreThoseOfTheTimeBefore)
{
    record();
    open();
    const EventList& list = *window->terrainPage()->events();
    const auto newestIsTheAlarm = [&] {
        return list.count() > 0 && list.item(0)->text().contains("frames are lost");
    };
    window->goTo(At::kAlarm + 0.1);
    const int before = list.count();
    EXPECT_TRUE(newestIsTheAlarm());
    window->goTo(At::kForgotten + 0.1);
    EXPECT_GT(list.count(), before);
    EXPECT_FALSE(newestIsTheAlarm());
    window->goTo(At::kAlarm + 0.1);
    EXPECT_EQ(list.count(), before);
    EXPECT_TRUE(newestIsTheAlarm());
}

TEST_F(ReviewOf, anotherLimitIsThatOfEveryTimeFromThenOn)
{
    record();
    open();
    window->goTo(At::kMarker);
    const VerdictStrip& verdict = *window->terrainPage()->verdict();
    const double other = verdict.limit() + VerdictStrip::kLimitStep;
    QTest::mouseClick(verdict.raiseButton(), Qt::LeftButton);
    EXPECT_NEAR(verdict.limit(), other, 1e-9);
    window->goTo(At::kAgain + 0.1);
    EXPECT_NEAR(verdict.limit(), other, 1e-9);
    EXPECT_TRUE(verdict.question().contains(format::number(other, 2)))
        << verdict.question().toStdString();
}

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

TEST_F(ReviewOf, aNoteIsKeptBesideTheSessionAndNotInIt)
{
    record();
    open();
    const auto content = [&] { return *readFile(path.toStdString(), 1U << 26U); };
    const std::string before = content();
    window->goTo(1.25);
    press(Qt::Key_M);
    QTest::keyClicks(window->noteEdit(), "a, \"step\"");
    QTest::keyClick(window->noteEdit(), Qt::Key_Return);
    ASSERT_EQ(window->notes().size(), 1U);
    const auto notes = readNotes(path.toStdString());
    ASSERT_TRUE(notes) << notes.error().text;
    ASSERT_EQ(notes->size(), 1U);
    EXPECT_EQ((*notes)[0], (ReviewNote{1.25, "a, \"step\""}));
    EXPECT_EQ(content(), before);
    window->goTo(0.0);
    press(Qt::Key_8);
    EXPECT_NEAR(now(), 1.25, 1e-6);
    ASSERT_TRUE(writeFileAtomically(notesPath(path.toStdString()), "t_s,note\nsoon,x\n"));
    EXPECT_FALSE(readNotes(path.toStdString()));
}

TEST(ReviewNotes, comeBackAsTheyWereWritten)
{
    TemporaryDirectory directory;
    const std::string session = directory.file("a.tts");
    const std::vector<ReviewNote> notes{{0.0, "plain"},      {1.25, "a, \"step\", or so"},
                                        {2.5, "\"quoted\""}, {3.0, "two\nlines\r\nand a third"},
                                        {4.0, ","},          {5.0, "\""},
                                        {6.0, ""},           {7.0, "schod, který „uhýbá“"},
                                        {8.0, "=1+1"},       {9.0, "-0.5"},
                                        {10.0, "'@home"}};
    ASSERT_TRUE(writeNotes(session, notes));
    const auto read = readNotes(session);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(*read, notes);
    EXPECT_NE(contentOf(notesPath(session)).find("8,'=1+1\n9,-0.5\n"), std::string::npos);

    const auto errorOf = [&](const std::string& text) {
        EXPECT_TRUE(writeFileAtomically(notesPath(session), text));
        const auto bad = readNotes(session);
        return bad ? std::string() : bad.error().text;
    };
    EXPECT_NE(errorOf("t_s,note\n1,\"two\nlines\"\n2,\"open\n").find("line 4: a quote"),
              std::string::npos);
    EXPECT_NE(errorOf("t_s,note\n1,\"a\"b\n").find("line 2"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\nsoon,x\n").find("line 2: t_s"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\nnan,x\n").find("line 2: t_s"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\n1,a,b\n").find("line 2"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\n1").find("line 2: is torn"), std::string::npos);
    EXPECT_NE(errorOf("t,what\n").find("line 1: is no file of notes"), std::string::npos);
    EXPECT_NE(errorOf("").find("is empty"), std::string::npos);
    EXPECT_EQ(errorOf("t_s,note\r\n1,of another program\r\n"), "");
}

TEST_F(ReviewOf, recordedSettingsGiveTheRecordedEstimateBitForBit)
{
    const std::string model = TERRATACT_SOURCE_DIR "/resources/models/default.ttm";
    const auto loaded = modelFileLoader(model, absolem())();
    ASSERT_TRUE(loaded) << loaded.error().text;
    SessionStart start = someStart();
    start.robot = *readFile(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml", 1U << 16U);
    auto writer = SessionWriter::create(path.toStdString(), start);
    ASSERT_TRUE(writer) << writer.error().text;
    ASSERT_TRUE(
        writer->add(ModelRow{.id = 1, .name = "default.ttm", .hash = *sha256OfFile(model)}));
    SceneRow scene{.id = 1, .time = sessionTimeOf(1.0)};
    scene.measurement.pitch = 0.05;
    scene.measurement.roll = 0.2;  // causes a warning
    scene.measurement.force = {0.0, 0.0, 0.0, 0.0, 0.0, 7.0};
    ASSERT_TRUE(writer->add(scene));
    EstimateRow row{.id = 1, .time = sessionTimeOf(1.5), .scene = 1, .model = 1};
    Settings settings;
    settings.seed = 18'446'744'073'709'551'557U;
    row.estimate = loaded->estimate({scene.measurement, {}, settings}, Watch{});
    ASSERT_TRUE(writer->add(row));
    EstimateRow rounded = row;  // rounded like on another processor
    rounded.id = 2;
    rounded.time = sessionTimeOf(1.7);
    rounded.estimate.height[4] += 1e-12;
    ASSERT_TRUE(writer->add(rounded));
    ASSERT_TRUE(writer->seal());

    open({QString::fromStdString(model)});
    window->goTo(1.5);
    press(Qt::Key_E);
    WhatIfPage& page = *window->whatIf();
    EXPECT_EQ(page.seed()->text(), "18446744073709551557");
    ASSERT_TRUE(eventually([&] { return page.answer().hasValue(); }, 60000));
    EXPECT_TRUE(page.result()->text().contains("bit for bit"))
        << page.result()->text().toStdString();
    EXPECT_EQ(*page.answer(), row.estimate);

    page.threshold()->setValue(20.0);
    page.estimate();
    ASSERT_TRUE(eventually([&] { return page.answer() && *page.answer() != row.estimate; }, 60000));
    EXPECT_FALSE(page.result()->text().contains("bit for bit"));
    EXPECT_EQ(page.answer()->settings.forceThreshold, 20.0);
    window->goTo(1.0);
    EXPECT_FALSE(page.answer()) << "of another estimate";

    window->goTo(1.7);
    page.estimate();
    ASSERT_TRUE(eventually([&] { return page.answer().hasValue(); }, 60000));
    EXPECT_TRUE(page.result()->text().contains("except for rounding in the last bits"))
        << page.result()->text().toStdString();
}

/// Other processors and later versions may round the last bits differently.
TEST_F(ReviewOf, theShippedSessionIsReproduced)
{
    path = TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts";
    open({TERRATACT_SOURCE_DIR "/resources/models/default.ttm"});
    press(Qt::Key_4);
    for (int estimate = 0; estimate < 2; ++estimate) {
        if (estimate > 0) {
            window->goTo(secondsOf(window->session().estimates().back().time));
            ASSERT_TRUE(window->moment().state.probed);
        }
        ASSERT_TRUE(window->moment().estimate);
        window->whatIf()->estimate();
        ASSERT_TRUE(eventually([&] { return window->whatIf()->answer().hasValue(); }, 60000));
        EXPECT_TRUE(window->whatIf()->result()->text().contains("reproduce the recorded estimate"))
            << window->whatIf()->result()->text().toStdString();
    }
}

TEST_F(ReviewOf, everyTextHasItsRoomAndEveryControlAName)
{
    applyLook(*qApp);
    record();
    open();
    window->resize(1200, 680);
    for (int page = 0; page < window->rail()->pages(); ++page) {
        window->rail()->choose(page);
        window->goTo(At::kMarker);
        QCoreApplication::processEvents();
        // The numbers table has its own test; four diverging draws are too wide for it.
        if (window->rail()->keyOf(page) != Qt::Key_F3) {
            EXPECT_EQ(cutWhenSettled(), std::vector<std::string>{}) << page;
        }
        for (const QWidget* widget : window->findChildren<QWidget*>()) {
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            if (!widget->isVisible() || widget->objectName().startsWith("qt_")) continue;
            if (!button && !(widget->focusPolicy() & Qt::TabFocus)) continue;
            EXPECT_FALSE(widget->accessibleName().isEmpty()
                         && (!button || button->text().isEmpty()))
                << page << widget->metaObject()->className();
            EXPECT_GE(std::min(widget->width(), widget->height()), 32)
                << page << widget->accessibleName().toStdString();
        }
    }
    EXPECT_TRUE(window->keys().html().contains("Space"));
}

TEST_F(ReviewOf, largeFontsCutNothingAndTerrainTakesFreeSpace)
{
    applyLook(*qApp);
    record();
    open();
    struct Case {
        int scale;  // [%]
        QSize size;
        double terrain;  // [px] minimum length of a metre
    };
    const Case cases[]{{100, {1200, 680}, 300.0}, {100, {1440, 900}, 320.0},
                       {120, {1200, 680}, 200.0}, {150, {1200, 680}, 170.0},
                       {150, {1440, 900}, 340.0}, {200, {1920, 1080}, 340.0}};
    int scale = 100;
    for (const Case& c : cases) {
        window->setRoom(c.size);
        for (; scale < c.scale; scale += 10) press(Qt::Key_Plus, Qt::ControlModifier);
        window->resize(c.size);
        EXPECT_EQ(lookInForce().fontScale, c.scale) << c.size.width();
        for (int page = 0; page < window->rail()->pages(); ++page) {
            window->rail()->choose(page);
            window->goTo(At::kMarker);
            if (window->rail()->keyOf(page) == Qt::Key_F3) continue;
            EXPECT_EQ(cutWhenSettled(), std::vector<std::string>{}) << c.scale << " " << page;
            EXPECT_EQ(gui::overlaps(*window), std::vector<std::string>{}) << c.scale << " " << page;
        }
        window->rail()->choose(0);
        settle(*window->terrainPage()->terrain());
        EXPECT_EQ(window->size(), c.size);
        const TerrainProfileView& terrain = *window->terrainPage()->terrain();
        EXPECT_GE(terrain.transform(QwtPlot::xBottom, 1.0)
                      - terrain.transform(QwtPlot::xBottom, 0.0),
                  c.terrain)
            << c.scale << " % " << c.size.width();
    }
    press(Qt::Key_0, Qt::ControlModifier);
}

TEST_F(ReviewOf, noLanguageCutsText)
{
    applyLook(*qApp);
    record();
    for (const char* language : {"en", "cs", "de"}) {
        window.reset();
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        open();
        for (const QSize size : {QSize(1200, 680), QSize(1440, 900)}) {
            window->resize(size);
            for (int page = 0; page < window->rail()->pages(); ++page) {
                window->rail()->choose(page);
                window->goTo(At::kMarker);
                if (window->rail()->keyOf(page) == Qt::Key_F3) continue;
                EXPECT_EQ(cutWhenSettled(), std::vector<std::string>{}) << language << " " << page;
            }
        }
        press(Qt::Key_E, Qt::ControlModifier);
        const ReviewExportDialog* dialog = window->exportDialog();
        ASSERT_TRUE(dialog);
        EXPECT_EQ(gui::cutWhenSettled(*dialog), std::vector<std::string>{}) << language;
    }
    installLanguage(*qApp, "en");
}

TEST(ScenesOfAFile, areEstimatedOneByOneWithoutCommands)
{
    std::vector<Scene> scenes(2);
    scenes[0].run = "first";
    scenes[0].s.force.fill(0.0);
    scenes[1] = scenes[0];
    scenes[1].run = "second";
    scenes[1].s.pitch = 0.2;
    scenes[1].truth[3] = -0.2;  // the other bins are unknown
    ScenesWindow window({.path = "/some/scenes.csv",
                         .scenes = scenes,
                         .robot = absolem(),
                         .model = modelFileLoader(
                             TERRATACT_SOURCE_DIR "/resources/models/default.ttm", absolem())});
    showActive(window);
    ASSERT_TRUE(eventually([&] { return window.estimate().has_value(); }, 60000));
    const TerrainEstimate first = *window.estimate();
    EXPECT_TRUE(window.stateLabel()->text().contains("first"));
    QTest::keyClick(&window, Qt::Key_Period);
    EXPECT_EQ(window.scene(), 1U);
    EXPECT_FALSE(window.estimate()) << "of another scene";
    ASSERT_TRUE(eventually([&] { return window.estimate().has_value(); }, 60000));
    EXPECT_NE(*window.estimate(), first);
    EXPECT_FALSE(painted(window).isNull());
    QTest::keyClick(&window, Qt::Key_Period);
    EXPECT_EQ(window.scene(), 1U) << "is the last";
    QTest::keyClick(&window, Qt::Key_Comma);
    EXPECT_EQ(window.scene(), 0U);
    for (const QPushButton* button : commandButtons(*window.terrainPage()))
        EXPECT_FALSE(button->isVisible() && button->isEnabled());
    EXPECT_FALSE(window.header()->stopButton()->isVisible());
    EXPECT_FALSE(saysThatStopIsDead(window));
    QTest::keyClick(&window, Qt::Key_Pause);
    EXPECT_TRUE(saysThatStopIsDead(window));
}

TEST(KindOfFile, isRecognizedByItsContent)
{
    TemporaryDirectory directory;
    const std::string session = directory.file("a.log");
    {
        auto writer = someSession(session, 200);
        ASSERT_TRUE(writer);
        ASSERT_TRUE(writer->seal());
    }
    EXPECT_EQ(kindOfFile(QString::fromStdString(session)), FileKind::Session);
    const std::string scenes = directory.file("a.tts");
    ASSERT_TRUE(writeFileAtomically(scenes, "run,t_s,pitch_rad,front_rad\n"));
    EXPECT_EQ(kindOfFile(QString::fromStdString(scenes)), FileKind::Scenes);
    const std::string log = directory.file("b.tts");
    ASSERT_TRUE(writeFileAtomically(log, "(1.0) can0 100#00\n"));
    EXPECT_EQ(kindOfFile(QString::fromStdString(log)), FileKind::Log);
    EXPECT_EQ(kindOfFile("/nowhere/x"), FileKind::Log);
}

}  // namespace
}  // namespace terratact
