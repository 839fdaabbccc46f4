// Tests a reviewed session: it is recognizable as a review, offers no command, and shows damage.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QFile>
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/display/format.h"
#include "app/pages/terrain_page.h"
#include "app/review/export/review_export_dialog.h"
#include "app/review/review_window.h"
#include "app/review/scenes_window.h"
#include "app/shell/remote_stop.h"
#include "app/shell/text_sheet.h"
#include "app/start/language.h"
#include "core/atem/atem_machine.h"
#include "core/log/event_text.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/benches/review_command_check.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/drive_strip.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/signals/force_bars.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST_F(ReviewOf, aSessionIsMarkedAndOffersNoCommand)
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

TEST_F(ReviewOf, theKeySheetNamesEveryKeyThatMovesARobotElsewhere)
{
    record();
    open();
    press(Qt::Key_F1);
    const auto* sheet = window->findChild<TextSheet*>();
    ASSERT_TRUE(sheet);
    const QString note = sheet->plainText().section("In the console", 1);
    for (const char* does : {"A explores", "B asks for a probe", "F feels forward and drives",
                             "M arms", "Space approves", "Up and Down drive"})
        EXPECT_TRUE(note.contains(does)) << does;
}

TEST_F(ReviewOf, theDriveStripShowsTheRecordedMoment)
{
    record();
    open();
    const DriveStrip& strip = *window->terrainPage()->driveStrip();
    window->goTo(At::kPresenting + 0.1);
    EXPECT_TRUE(strip.isVisible());
    EXPECT_EQ(strip.text(DriveStrip::Contact), "none") << "the flippers hang in the air";
    const auto& pitch = strip.viewState().pitch;
    ASSERT_TRUE(pitch);
    EXPECT_GT(pitch->tips, 0.3) << "the recorded attitude is judged, [rad]";
    EXPECT_NE(strip.text(DriveStrip::Pitch), "--");
    press(Qt::Key_Plus, Qt::ControlModifier);
    window->resize(1200, 680);
    EXPECT_FALSE(strip.isVisible()) << "large letters leave the room to the terrain";
}

TEST_F(ReviewOf, feelForwardShowsItsPhasesAndWhyItEnded)
{
    path = TERRATACT_SOURCE_DIR "/resources/sessions/feel_forward.tts";
    if (!QFile::exists(path)) GTEST_SKIP() << "make_feel_forward.sh records it";
    open();
    const std::vector<EventRow>& events = window->session().events();
    for (const AtemPhase phase : {AtemPhase::Halting, AtemPhase::Pressing, AtemPhase::Advancing}) {
        const auto entered = std::ranges::find(events, std::optional(phase), phaseOf);
        ASSERT_NE(entered, events.end()) << name(phase);
        window->goTo(secondsOf(entered->time) + 1e-6);
        EXPECT_TRUE(eventually([&] {
            return !readableTexts(*window)
                        .filter(QString(describe(phase).english), Qt::CaseInsensitive)
                        .isEmpty();
        })) << name(phase);
    }
    window->goTo(secondsOf(window->session().end()));
    const auto ends = window->terrainPage()->events()->findItems("feel forward has ended after",
                                                                 Qt::MatchContains);
    ASSERT_FALSE(ends.isEmpty());
    EXPECT_FALSE(ends.front()->text().contains("let go")) << "it ended by itself";
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
    EXPECT_TRUE(saysUponTheHeader(*window, "STOP NOT SENT: the console's stop line"));
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
        ASSERT_TRUE(eventually([&] { return !window->isFittingFont(); })) << c.scale;
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
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
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

}  // namespace
}  // namespace terratact
