// Tests the console in every window and font size: no text is cut, nothing moves.
#include "app/console/main_window.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <vector>

#include "app/console/pages/settings_page.h"
#include "tests/support/benches/console_bench.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/force_bars.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(Console, everyControlCanBeHitAndNamed)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    int seen = 0;
    for (const QAbstractButton* button : window->findChildren<QAbstractButton*>()) {
        if (!button->isVisible()) continue;
        ++seen;
        EXPECT_GE(std::min(button->width(), button->height()), 32) << button->text().toStdString();
        EXPECT_FALSE(button->text().isEmpty() && button->accessibleName().isEmpty());
        EXPECT_FALSE(button->toolTip().isEmpty()) << button->text().toStdString();
        const int needed =
            button->fontMetrics().size(0, button->text()).width();  // width of the widest line
        EXPECT_GE(button->width(), needed) << "text cut: " << button->text().toStdString();
    }
    EXPECT_GE(seen, 7);
}

TEST_F(Console, noTextIsCutAtTheSmallestSizes)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    for (const QSize size : {QSize(1280, 720), QSize(1440, 900), window->minimumSize()}) {
        window->resize(size);
        QTest::qWait(100);
        EXPECT_EQ(window->size(), size) << "the layout needs more than this";
        EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>()) << size.width();
    }
}

TEST_F(Console, everyFontScaleFitsEveryScreen)
{
    ScriptedSource* source = openScripted();
    ASSERT_TRUE(readyToExplore());
    fitsEveryScreen("ready", {100, 120, 150, 200});
    source->setSilent(true);
    ASSERT_TRUE(eventually([&] { return window->header()->linkText().startsWith("LINK LOST"); }));
    fitsEveryScreen("lost", {150, 200});
}

TEST_F(Console, theProbeCardFitsInEveryFontScale)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    fitsEveryScreen("asked", {100, 150, 200});
}

TEST_F(Console, appearingItemsDoNotMoveTheWindow)
{
    ScriptedSource* source = openScripted();
    window->setRoom({1200, 680});
    window->preferences().change([](Preferences& p) { p.fontScale = 200; });
    ASSERT_TRUE(eventually([&] { return !window->isFittingFont(); }));
    window->resize(window->minimumSize());
    ASSERT_TRUE(readyToExplore());
    const QSize least = window->minimumSize();
    const int letters = lookInForce().fontScale;
    window->header()->setLink("link 20 Hz · ≤ 1234 ms · 123456 dropped", Tone::Warning);
    window->header()->setOverridden("the robot rolls");
    window->header()->setStop({.state = StopViewState::State::NotSent, .why = "the bus is off"});
    window->header()->setAlarms(3, 12);
    QTest::qWait(100);
    EXPECT_EQ(gui::overlapsWhenSettled(*window), std::vector<std::string>());
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    source->setSilent(true);
    ASSERT_TRUE(eventually([&] { return window->header()->linkText().startsWith("LINK LOST"); }));
    QTest::qWait(100);
    EXPECT_EQ(gui::overlapsWhenSettled(*window), std::vector<std::string>());
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    EXPECT_EQ(window->size(), least);
    EXPECT_EQ(window->minimumSize(), least);
    EXPECT_EQ(lookInForce().fontScale, letters);
}

TEST_F(Console, cardsThatDoNotFitBesideTheTerrainGetAPage)
{
    open(fastRobot(robot, 2.1));
    const int page = window->rail()->pageOf(Qt::Key_F9);
    window->setRoom({1440, 900});
    window->resize(1440, 900);
    EXPECT_TRUE(eventually([&] { return window->forces()->isVisible(); }));
    EXPECT_FALSE(window->rail()->button(page)->isVisible());
    QTest::keyClick(window.get(), Qt::Key_F9);
    EXPECT_EQ(window->rail()->chosen(), 0) << "there is no such page now";
    window->preferences().change([](Preferences& p) { p.fontScale = 200; });
    EXPECT_TRUE(eventually([&] { return window->rail()->button(page)->isVisible(); }));
    EXPECT_FALSE(window->forces()->isVisible());
    EXPECT_TRUE(window->drivePad()->isVisible()) << "driving stays at hand";
    QTest::keyClick(window.get(), Qt::Key_F9);
    EXPECT_TRUE(eventually([&] { return window->forces()->isVisible(); }));
    EXPECT_EQ(gui::cramped(*window), std::vector<std::string>());
    window->preferences().change([](Preferences& p) { p.fontScale = 100; });
    window->rail()->choose(0);
    EXPECT_TRUE(eventually(
        [&] { return window->forces()->isVisible() && window->terrain()->isVisible(); }));
}

TEST_F(Console, aBannerMovesNoCard)
{
    ScriptedSource* source = openScripted();
    ASSERT_TRUE(readyToExplore());
    const int page = window->rail()->pageOf(Qt::Key_F9);
    const auto eachLayout = [&](const std::function<void(const std::string&)>& poll) {
        for (const QSize size : {QSize(1200, 680), QSize(1280, 720), QSize(1440, 900)})
            for (const Layout layout : {Layout::Drive, Layout::Probe, Layout::Review}) {
                window->preferences().change([layout](Preferences& p) { p.layout = layout; });
                window->resize(size);
                QTest::qWait(60);
                EXPECT_EQ(window->size(), size);
                poll(std::to_string(size.width()) + " px, layout "
                     + std::to_string(static_cast<int>(layout)));
            }
    };
    std::map<std::string, bool> apart;
    eachLayout([&](const std::string& where) {
        apart[where] = window->rail()->button(page)->isVisible();
    });
    EXPECT_FALSE(apart.at("1280 px, layout 0")) << "who drives has the forces in sight";
    source->setSilent(true);
    ASSERT_TRUE(eventually([&] { return says("LINK LOST for"); }));
    eachLayout([&](const std::string& where) {
        EXPECT_TRUE(says("LINK LOST for"));
        EXPECT_EQ(window->rail()->button(page)->isVisible(), apart.at(where)) << where;
        EXPECT_EQ(window->forces()->isVisible(), !apart.at(where)) << where;
        EXPECT_EQ(gui::overlaps(*window), std::vector<std::string>()) << where;
        EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>()) << where;
    });
}

}  // namespace
}  // namespace terratact
