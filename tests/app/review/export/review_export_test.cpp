// Tests the files that a review writes, and its export dialog.
#include "app/review/export/review_export.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>

#include "app/pages/numbers_page.h"
#include "app/pages/terrain_page.h"
#include "app/pages/terrain_picture.h"
#include "app/review/review_window.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/theme.h"
#include "widgets/signals/signal_table.h"
#include "widgets/terrain/readings/numbers_table.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST_F(ReviewOf, whatIsShownIsExported)
{
    record();
    open();
    window->goTo(At::kMarker);
    TerrainProfileView& terrain = *window->terrainPage()->terrain();
    for (const char* suffix : {"png", "svg", "pdf"}) {
        const QString to = QString::fromStdString(directory.file("picture.")) + suffix;
        EXPECT_TRUE(savePicture(terrain, to).isEmpty()) << suffix;
        EXPECT_GT(QFileInfo(to).size(), 2000) << suffix;
    }
    EXPECT_FALSE(savePicture(terrain, "picture.bmp").isEmpty());
    const QString day = QString::fromStdString(directory.file("day.png"));
    terrain.setFixedSize(800, 400);
    for (const Qt::Key theme : {Qt::Key_6, Qt::Key_4})  // fits the font to the remaining room
        QTest::keyClick(window.get(), theme, Qt::ControlModifier);
    gui::settle(terrain);
    EXPECT_TRUE(savePicture(terrain, day).isEmpty());
    for (const ThemeName dark : {ThemeName::NightRed, ThemeName::HighContrast}) {
        QTest::keyClick(window.get(), dark == ThemeName::NightRed ? Qt::Key_5 : Qt::Key_6,
                        Qt::ControlModifier);
        ASSERT_EQ(lookInForce().theme, dark);
        gui::settle(terrain);
        const QImage shown = gui::painted(terrain);
        const QString to = QString::fromStdString(directory.file("dark.png"));
        EXPECT_TRUE(savePicture(terrain, to).isEmpty());
        EXPECT_EQ(QImage(to), QImage(day)) << "paper is white";
        EXPECT_EQ(lookInForce().theme, dark);
        gui::settle(terrain);
        EXPECT_EQ(gui::painted(terrain), shown);
    }
    QTest::keyClick(window.get(), Qt::Key_4, Qt::ControlModifier);
    window->numbers()->refresh(0.0);
    NumbersTable& table = *window->numbers()->table();
    EXPECT_FALSE(saveNumbers(window->moment(), table, "/nowhere/numbers.csv").isEmpty());
    const std::string to = directory.file("numbers.csv");
    EXPECT_TRUE(saveNumbers(window->moment(), table, QString::fromStdString(to)).isEmpty());
    const std::string text = *readFile(to, 1U << 20U);
    EXPECT_EQ(text.rfind("t_s,measured_s,pitch_rad", 0), 0U);
    EXPECT_NE(text.find("\n2,"), std::string::npos);
}

}  // namespace
}  // namespace terratact
