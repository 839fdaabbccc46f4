// Tests the window of a file of scenes.
#include "app/review/scenes_window.h"

#include <gtest/gtest.h>

#include "app/mission/estimator_worker.h"
#include "app/pages/terrain_page.h"
#include "app/review/review_window.h"
#include "app/review/scenes_page.h"
#include "app/review/what_if_page.h"
#include "tests/support/benches/review_command_check.h"
#include "tests/support/gui.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/force_bars.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using namespace gui;

ScenesWindow::Options fileOf(std::vector<TwoTrackScene> scenes)
{
    return {.path = "/some/scenes.csv",
            .scenes = std::move(scenes),
            .robot = absolem(),
            .model =
                modelFileLoader(TERRATACT_SOURCE_DIR "/resources/models/default.ttm", absolem())};
}

TEST(ScenesOfAFile, ofTwoTracksAreEstimatedOnBothSides)
{
    TwoTrackScene scene;
    scene.s.roll = 0.15;
    scene.s.flippers = {0.2, -0.1, 0.0, 0.0};
    scene.s.currents.fill(1.0);
    for (auto& forces : scene.s.forces) forces.fill(1.0);
    ScenesWindow window(fileOf({scene}));
    showActive(window);
    ASSERT_TRUE(eventually([&] { return window.estimate().has_value(); }, 60000));
    EXPECT_FALSE(window.estimate()->onePlane);
    EXPECT_NE(window.estimate()->side[0].height, window.estimate()->side[1].height);
}

TEST(ScenesOfAFile, areEstimatedOneByOneWithoutCommands)
{
    std::vector<Scene> scenes(2);
    scenes[0].run = "first";
    scenes[0].s.force.fill(0.0);
    scenes[1] = scenes[0];
    scenes[1].run = "second";
    scenes[1].s.pitch = 0.2;
    scenes[0].s.force[2] = 15.0;
    scenes[1].truth[3] = -0.2;  // the other bins are unknown
    ScenesWindow window(fileOf(onBothSides(scenes)));
    showActive(window);
    ASSERT_TRUE(eventually([&] { return window.estimate().has_value(); }, 60000));
    const TwoTrackEstimate first = *window.estimate();
    EXPECT_TRUE(window.stateLabel()->text().contains("first"));
    QTest::keyClick(&window, Qt::Key_Period);
    EXPECT_EQ(window.scene(), 1U);
    EXPECT_FALSE(window.estimate()) << "of another scene";
    EXPECT_LT(window.terrainPage()->forces()->peak(2).value_or(0.0), 1.0) << "of this scene alone";
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

TEST(ScenesOfAFile, listHasVerdictAndErrorOfEveryScene)
{
    std::vector<Scene> scenes(4);
    for (Scene& scene : scenes) scene.s.force.fill(1.0);
    scenes[0].run = "first";
    scenes[2].s.pitch = 0.1;
    scenes[2].truth.fill(-0.2);
    ScenesWindow window(fileOf(onBothSides(scenes)));
    showActive(window);
    const QAbstractItemModel& rows = *window.list()->table()->model();
    ASSERT_EQ(rows.rowCount(), 4);
    const auto text = [&](int row, int column) {
        return rows.index(row, column).data().toString();
    };
    ASSERT_TRUE(eventually(
        [&] {
            for (int row = 0; row < 4; ++row)
                if (text(row, SceneRows::Answer).size() < 2) return false;
            return true;
        },
        60000))
        << "scenes that are not shown are estimated, too";
    EXPECT_EQ(window.scene(), 0U);
    EXPECT_TRUE(window.estimate().has_value()) << "that of the shown scene stays";
    EXPECT_EQ(text(0, SceneRows::Truth), "unknown");
    EXPECT_EQ(text(0, SceneRows::Median), "");
    EXPECT_TRUE(window.stateLabel()->text().contains("the truth is unknown"));
    EXPECT_EQ(text(2, SceneRows::Truth), "11 bins");
    EXPECT_GT(text(2, SceneRows::Median).section(' ', 0, 0).toInt(), 0);
    EXPECT_TRUE(window.list()->summary()->text().startsWith("4 of 4 scenes"))
        << window.list()->summary()->text().toStdString();

    QTest::keyClick(&window, Qt::Key_F3);
    ASSERT_TRUE(window.list()->isVisible());
    EXPECT_TRUE(window.list()->table()->hasFocus()) << "the keys go to the list";
    QTest::keyClicks(window.list()->table(), "3");
    QTest::keyClick(window.list()->table(), Qt::Key_Return);
    EXPECT_EQ(window.scene(), 2U);
    EXPECT_TRUE(window.terrainPage()->isVisible());
    ASSERT_TRUE(eventually([&] { return window.estimate().has_value(); }, 60000));
    EXPECT_TRUE(window.stateLabel()->text().contains(
        QStringLiteral("error: median %1").arg(text(2, SceneRows::Median))))
        << window.stateLabel()->text().toStdString();
    QTest::keyClick(&window, Qt::Key_Period);
    EXPECT_EQ(window.list()->table()->currentIndex().row(), 3) << "the list follows";
}

}  // namespace
}  // namespace terratact
