// Tests looking back at estimates of this run: the picture changes, and nothing else.
#include "app/console/past/history_control.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QListWidget>
#include <QPushButton>

#include "app/console/past/history_window.h"
#include "app/mission/estimate_history.h"
#include "tests/support/benches/console_bench.h"
#include "tests/support/gui.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using gui::eventually;

struct HistoryOf : Console {
    /// Makes two estimates of one scene: before and after a probe.
    void probed()
    {
        answerTime = 300.0;  // long, because the machine may be busy
        open(fastRobot(robot, 2.1));
        proposeByKeyboard();
        QTest::keyPress(window.get(), Qt::Key_Space);
        ASSERT_TRUE(reaches(AtemPhase::Probing));
        QTest::keyRelease(window.get(), Qt::Key_Space);
        ASSERT_TRUE(reaches(AtemPhase::Presenting));
        ASSERT_TRUE(eventually([&] { return history().entries().size() == 2; }));
        ASSERT_TRUE(eventually([&] { return window->showsEstimate(); }));
    }
    const EstimateHistory& history() const { return window->history().history(); }
    HistoryWindow& list()
    {
        QTest::keyClick(window.get(), Qt::Key_H, Qt::ControlModifier);
        EXPECT_NE(window->history().window(), nullptr);
        EXPECT_TRUE(eventually([&] { return window->history().window()->isVisible(); }));
        return *window->history().window();
    }
    /// Returns true once the picture has this estimate's bands.
    bool pictured(const TwoTrackEstimate& estimate)
    {
        return eventually([&] {
            const auto& drawn = window->terrain()->estimate();
            return drawn && drawn->side[0].sd == estimate.side[0].sd;
        });
    }
    void keepPicture(const char* name)
    {
        const QString folder = qEnvironmentVariable("TERRATACT_PICTURES");
        if (folder.isEmpty()) return;
        window->grab().save(folder + "/history-" + name + "-console.png");
        if (window->history().window())
            window->history().window()->grab().save(folder + "/history-" + name + ".png");
    }
};

TEST_F(HistoryOf, aPastEstimateChangesThePictureAndNothingElse)
{
    probed();
    EXPECT_EQ(window->history().window(), nullptr) << "it is made at first use";
    HistoryWindow& panel = list();
    ASSERT_EQ(panel.list()->count(), 2);
    EXPECT_TRUE(panel.list()->item(0)->text().contains("present"));
    EXPECT_TRUE(panel.list()->item(0)->text().contains("probe"));
    EXPECT_TRUE(panel.list()->item(1)->text().contains("measured later by the arm"));
    EXPECT_FALSE(window->history().showsPast()) << "nothing is chosen yet";
    const QString badge = window->verdict()->badge(), question = window->verdict()->question();
    const auto verdict = window->exploration().estimation().verdict();
    const TwoTrackEstimate present = *window->exploration().estimation().estimate();
    panel.list()->setCurrentRow(1);
    const PastEstimate& past = history().entries()[1];
    ASSERT_NE(past.estimate->side[0].sd, present.side[0].sd);
    EXPECT_TRUE(pictured(*past.estimate));
    EXPECT_TRUE(eventually([&] { return says("not the present one. Backspace"); }));
    EXPECT_TRUE(panel.stateLabel()->text().contains("not the present one"));
    EXPECT_EQ(window->verdict()->badge(), badge);
    EXPECT_EQ(window->verdict()->question(), question);
    EXPECT_EQ(window->exploration().estimation().verdict(), verdict);
    EXPECT_EQ(*window->exploration().estimation().estimate(), present);
    keepPicture("past");
    // No probe goes to a bin of a picture of the past.
    const AtemPhase phase = window->exploration().state().phase;
    emit window->terrain()->binChosen({5, ProbeSide::Middle});
    EXPECT_TRUE(eventually([&] { return says("shows an earlier estimate"); }));
    EXPECT_EQ(window->exploration().state().phase, phase);
    QTest::keyClick(panel.list(), Qt::Key_Backspace);
    EXPECT_TRUE(pictured(present));
    EXPECT_TRUE(eventually([&] { return !says("not the present one. Backspace"); }));
}

TEST_F(HistoryOf, thePresentComesBackWhenTheRobotDrives)
{
    probed();
    list().list()->setCurrentRow(1);
    ASSERT_TRUE(eventually([&] { return window->history().showsPast(); }));
    window->exploration().drive(+1);
    EXPECT_TRUE(eventually([&] {
        if (window->history().showsPast()) window->exploration().drive(+1);
        return !window->history().showsPast();
    }));
    window->exploration().halt();
    EXPECT_TRUE(eventually([&] { return !says("not the present one. Backspace"); }));
}

TEST_F(HistoryOf, anEstimateIsLaidOverThePresentWithALegend)
{
    probed();
    HistoryWindow& panel = list();
    EXPECT_FALSE(panel.layButton()->isEnabled()) << "nothing is chosen";
    panel.list()->setCurrentRow(1);
    ASSERT_TRUE(eventually([&] { return panel.layButton()->isEnabled(); }));
    QTest::keyClick(panel.list(), Qt::Key_L);
    EXPECT_TRUE(pictured(*window->exploration().estimation().estimate()));
    EXPECT_FALSE(window->history().showsPast());
    EXPECT_TRUE(eventually([&] { return panel.stateLabel()->text().contains("lies over"); }));
    EXPECT_TRUE(eventually([&] { return says("Dashed in the picture: the past estimate"); }));
    EXPECT_FALSE(says("driven since")) << "the robot stood still";
    EXPECT_FALSE(window->exploration().estimation().second()) << "it is no second method";
    keepPicture("laid");
    QTest::keyClick(panel.list(), Qt::Key_Backspace);
    EXPECT_TRUE(eventually([&] { return !panel.presentButton()->isEnabled(); }));
    EXPECT_TRUE(eventually([&] { return !says("Dashed in the picture"); }));
}

TEST_F(HistoryOf, aHiddenEstimateIsRestoredFromTheList)
{
    probed();
    HistoryWindow& panel = list();
    EXPECT_FALSE(panel.restoreButton()->isEnabled());
    QTest::keyClick(window.get(), Qt::Key_Delete);
    ASSERT_TRUE(eventually([&] { return panel.restoreButton()->isEnabled(); }));
    EXPECT_TRUE(panel.list()->item(0)->text().contains("hidden by the operator"));
    QTest::mouseClick(panel.restoreButton(), Qt::LeftButton);
    ASSERT_TRUE(
        eventually([&] { return window->exploration().estimation().estimate().has_value(); }));
    EXPECT_TRUE(eventually([&] { return panel.list()->item(0)->text().contains("restored"); }));
    EXPECT_TRUE(eventually([&] { return !panel.restoreButton()->isEnabled(); }));
}

TEST_F(HistoryOf, openingTheListShowsNothingOfThePast)
{
    probed();
    QTest::keyClick(window.get(), Qt::Key_Delete);
    ASSERT_TRUE(
        eventually([&] { return !window->exploration().estimation().estimate().has_value(); }));
    HistoryWindow& panel = list();
    ASSERT_TRUE(eventually([&] { return panel.list()->hasFocus(); }));
    EXPECT_FALSE(window->history().showsPast()) << "the focus is no choice";
    EXPECT_FALSE(panel.layButton()->isEnabled());
    QTest::keyClick(panel.list(), Qt::Key_L);
    EXPECT_EQ(window->history().banner(), QString());
    QTest::keyClick(panel.list(), Qt::Key_Down);
    EXPECT_TRUE(pictured(*history().entries()[0].estimate)) << "the first row, not the second";
    EXPECT_TRUE(window->history().showsPast());
    QTest::keyClick(panel.list(), Qt::Key_Down);
    EXPECT_TRUE(pictured(*history().entries()[1].estimate));
}

TEST_F(HistoryOf, theListIsReachedByKeyboardInEveryTheme)
{
    probed();
    HistoryWindow& panel = list();
    for (QWidget* control :
         {static_cast<QWidget*>(panel.list()), static_cast<QWidget*>(panel.presentButton()),
          static_cast<QWidget*>(panel.layButton())}) {
        EXPECT_TRUE(control->focusPolicy() & Qt::TabFocus);
        const auto* button = qobject_cast<QPushButton*>(control);
        EXPECT_FALSE(button ? button->text().isEmpty() : control->accessibleName().isEmpty());
    }
    panel.list()->setCurrentRow(1);
    ASSERT_TRUE(eventually([&] { return says("not the present one. Backspace"); }));
    constexpr ThemeName themes[]{ThemeName::Day, ThemeName::HighContrast, ThemeName::NightRed};
    const char* const names[]{"day", "contrast", "night"};
    for (std::size_t i = 0; i < 3; ++i) {
        window->preferences().change([&](Preferences& p) { p.theme = themes[i]; });
        EXPECT_TRUE(eventually([&] { return lookInForce().theme == themes[i]; }));
        EXPECT_EQ(gui::cramped(panel), std::vector<std::string>()) << names[i];
        keepPicture(names[i]);
    }
}

}  // namespace
}  // namespace terratact
