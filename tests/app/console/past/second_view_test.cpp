// Tests the window for a second screen.
#include "app/console/past/second_view.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QPushButton>
#include <QSignalSpy>

#include "app/display/format.h"
#include "core/limits.h"
#include "tests/support/benches/console_bench.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

struct SecondWindow : Console {
    void openBoth()
    {
        open(fastRobot(robot, 2.0));
        QTest::keyClick(window.get(), Qt::Key_D, Qt::ControlModifier);
        ASSERT_NE(window->secondView(), nullptr);
        window->secondView()->move(2000, 0);  // a covered probe card takes no approval
    }
};

TEST_F(SecondWindow, showsWhatTheConsoleShows)
{
    openBoth();
    EXPECT_TRUE(window->secondView()->isVisible());
    EXPECT_TRUE(window->secondView()->isWindow());
    proposeByKeyboard();
    const TerrainPage& page = *window->secondView()->page();
    ASSERT_TRUE(gui::eventually([&] { return page.showsEstimate(); }));
    ASSERT_TRUE(page.terrain()->estimate().has_value());
    EXPECT_EQ(*page.terrain()->estimate(), *window->terrain()->estimate());
    EXPECT_EQ(page.strip()->headline(), window->strip()->headline());
    EXPECT_EQ(page.verdict()->limit(), window->verdict()->limit());
}

TEST_F(SecondWindow, nothingInItCommands)
{
    openBoth();
    proposeByKeyboard();
    SecondView& second = *window->secondView();
    for (const QPushButton* button : second.findChildren<QPushButton*>())
        EXPECT_FALSE(button->isVisible() && button->isEnabled() && button->width() > 0)
            << button->text().toStdString();
    QSignalSpy decided(&window->exploration(), &Exploration::decided);
    const auto before = window->exploration().state().phase;
    for (QWidget* target :
         {static_cast<QWidget*>(&second), static_cast<QWidget*>(second.page()->terrain())})
        for (const Qt::Key key : {Qt::Key_W, Qt::Key_A, Qt::Key_Space, Qt::Key_N, Qt::Key_B,
                                  Qt::Key_1, Qt::Key_PageUp, Qt::Key_Return})
            QTest::keyClick(target, key);
    QTest::mouseDClick(second.page()->terrain()->canvas(), Qt::LeftButton);
    EXPECT_EQ(decided.size(), 0);
    EXPECT_EQ(window->exploration().state().phase, before);
}

TEST_F(SecondWindow, saysThatDataAreStaleAsTheConsoleDoes)
{
    QWidget console;
    SecondView second(robot, "SIMULATED", console);
    const Measurement measurement;
    TerrainViewState state;
    state.measurement = &measurement;
    state.count = 1;
    state.age = kStaleAfter / 2.0;
    second.show(state, 0.1, 2.0, {});
    const TerrainProfileView& terrain = *second.page()->terrain();
    EXPECT_FALSE(terrain.accessibleDescription().contains("not live"));
    EXPECT_FALSE(second.banner()->isVisibleTo(&second));
    state.age = kStaleAfter + 0.1;
    second.show(state, 0.1, 2.0, "LINK LOST");
    EXPECT_TRUE(terrain.accessibleDescription().contains("not live"));
    EXPECT_TRUE(second.banner()->isVisibleTo(&second));
    EXPECT_EQ(second.banner()->text(), "LINK LOST");
}

TEST_F(SecondWindow, leavesTheKeysToTheConsoleAndCloses)
{
    open(fastRobot(robot, 2.0));
    EXPECT_EQ(window->secondView(), nullptr) << "it is made at its first use";
    openBoth();
    EXPECT_TRUE(window->secondView()->testAttribute(Qt::WA_ShowWithoutActivating));
    QTest::keyClick(window->secondView(), Qt::Key_Escape);
    EXPECT_FALSE(window->secondView()->isVisible());
    QTest::keyClick(window.get(), Qt::Key_D, Qt::ControlModifier);
    EXPECT_TRUE(window->secondView()->isVisible());
    QTest::keyClick(window.get(), Qt::Key_D, Qt::ControlModifier);
    EXPECT_FALSE(window->secondView()->isVisible());
}

TEST_F(SecondWindow, leavesTheHeaderFreeOnTheOnlyScreen)
{
    open(fastRobot(robot, 2.0));
    ASSERT_EQ(QApplication::screens().size(), 1);
    QTest::keyClick(window.get(), Qt::Key_D, Qt::ControlModifier);
    SecondView& second = *window->secondView();
    const QRect header = onScreen(*window->header());
    EXPECT_FALSE(second.frameGeometry().intersects(header));
    QTest::keyClick(&second, Qt::Key_F11);
    EXPECT_FALSE(second.isFullScreen());
    EXPECT_FALSE(second.frameGeometry().intersects(header)) << "with F11";
    EXPECT_EQ(second.size(), window->roomBelowHeader()) << "it takes the room there is";
    second.close();
    second.setWindowState(Qt::WindowFullScreen);  // as left on a screen that is gone
    second.open();
    EXPECT_FALSE(second.isFullScreen());
    EXPECT_FALSE(second.frameGeometry().intersects(header)) << "opened again";
}

TEST_F(SecondWindow, followsThemeAndFont)
{
    openBoth();
    for (const Qt::Key key : {Qt::Key_5, Qt::Key_4}) {
        QTest::keyClick(window.get(), key, Qt::ControlModifier);
        EXPECT_TRUE(gui::eventually([&] {
            return window->secondView()->page()->terrain()->canvasBackground().color()
                == theme().card;
        }));
    }
    window->preferences().change([](Preferences& p) { p.fontScale = 130; });
    EXPECT_TRUE(gui::eventually([&] { return !window->isFittingFont(); }));
    EXPECT_FALSE(window->secondView()->page()->decisions()->isVisible());
    EXPECT_FALSE(window->secondView()->page()->lower()->isVisible());
}

}  // namespace
}  // namespace terratact
