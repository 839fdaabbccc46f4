// Tests that a theme changes every pixel at once and back.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QScrollBar>
#include <algorithm>

#include "app/console/main_window.h"
#include "tests/support/benches/look_bench.h"
#include "tests/support/gui.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/status_header.h"

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
    EXPECT_TRUE(eventually([&] { return notRed(gui::painted(*window)) > 0.5; }))
        << "the theme changes back while it runs";
}

TEST_F(Look, aNumberBoxHasAVisibleFrameInEveryTheme)
{
    for (const ThemeName name : {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast}) {
        applyLook(*qApp, name);
        QDoubleSpinBox box;
        box.resize(200, 40);
        const QImage image = gui::painted(box);
        for (const QPoint& edge : {QPoint(30, 0), QPoint(30, 39), QPoint(0, 20), QPoint(199, 20)})
            EXPECT_EQ(image.pixelColor(edge), theme().muted) << edge.x() << ' ' << edge.y();
        QCheckBox check;
        EXPECT_GT(gui::pixelsOf(gui::painted(check), theme().muted), 20) << "not checked";
    }
    applyLook(*qApp);
}

TEST_F(Look, aScrollBarHasAVisibleSliderInEveryTheme)
{
    for (const ThemeName name : {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast}) {
        applyLook(*qApp, name);
        for (const Qt::Orientation along : {Qt::Horizontal, Qt::Vertical}) {
            QScrollBar bar(along);
            bar.setRange(0, 100);
            bar.setPageStep(100);
            bar.resize(along == Qt::Horizontal ? QSize(300, 16) : QSize(16, 300));
            const QImage image = gui::painted(bar);
            const auto at = [&](int across) {
                return along == Qt::Horizontal ? QPoint(100, across) : QPoint(across, 100);
            };
            EXPECT_EQ(image.pixelColor(at(8)), theme().button.area);
            for (const int edge : {0, 15})
                EXPECT_EQ(image.pixelColor(at(edge)), theme().muted) << along << ' ' << edge;
        }
    }
    applyLook(*qApp);
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

}  // namespace
}  // namespace terratact
