// Tests that fonts fit the window and the screen.
#include <gtest/gtest.h>

#include "app/console/main_window.h"
#include "app/console/pages/settings_page.h"
#include "app/shell/font_fit.h"
#include "app/shell/view_menu.h"
#include "app/shell/window_picture.h"
#include "tests/support/benches/look_bench.h"
#include "tests/support/gui.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/status_header.h"

namespace terratact {
namespace {

using gui::eventually;

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

TEST_F(Look, fontTooLargeForTheScreenIsReportedAndKept)
{
    window->setRoom({1200, 680});
    window->preferences().change([](Preferences& p) { p.fontScale = 200; });
    ASSERT_TRUE(eventually([&] { return !window->isFittingFont(); }));
    const int fits = lookInForce().fontScale;
    EXPECT_LT(fits, 200);
    EXPECT_TRUE(window->updatesEnabled());
    EXPECT_LE(window->minimumWidth(), 1200);
    EXPECT_LE(window->minimumHeight(), 680);
    const QString note = QStringLiteral("200 % wanted, %1 % fits this screen").arg(fits);
    EXPECT_EQ(fontNote(200), note);
    window->rail()->choose(window->rail()->pageOf(Qt::Key_F7));
    EXPECT_TRUE(eventually([&] { return window->settings()->fontNote()->isVisible(); }));
    EXPECT_EQ(window->settings()->fontNote()->text(), note);
    ViewMenu menu(window->preferences(), "at once");
    menu.popup(window->pos());
    EXPECT_TRUE(menu.actions().last()->isVisible());
    EXPECT_EQ(menu.actions().last()->text(), note);
    menu.hide();

    window->setRoom({1920, 1080});
    EXPECT_EQ(lookInForce().fontScale, 200);
    EXPECT_EQ(window->preferences().current().fontScale, 200);
    EXPECT_TRUE(eventually([&] { return !window->settings()->fontNote()->isVisible(); }));
    EXPECT_EQ(fontNote(200), QString());

    window->setRoom({1200, 680});
    press(Qt::Key_Minus);
    EXPECT_EQ(lookInForce().fontScale, fits - 10) << "smaller than what is seen, not than wanted";
}

struct Paintings final : QObject {
    bool eventFilter(QObject* /*painted*/, QEvent* event) override
    {
        if (event->type() == QEvent::Paint) ++count;
        return false;
    }
    int count = 0;
};

TEST_F(Look, aRepaintThatWasDueWhileFittingIsPainted)
{
    ASSERT_TRUE(eventually([&] { return !window->isFittingFont(); }));
    window->update();
    window->preferences().change([](Preferences& p) { p.fontScale = 90; });
    ASSERT_TRUE(eventually([&] { return !window->isFittingFont(); }));
    QApplication::processEvents();

    QWidget& stop = *window->header()->stopButton();
    Paintings paintings;
    stop.installEventFilter(&paintings);
    stop.update();
    EXPECT_TRUE(eventually([&] { return paintings.count > 0; }));
}

TEST_F(Look, aPictureIsNotBlankWhileTheFontIsBeingFitted)
{
    for (QWidget* const pictured : std::initializer_list<QWidget*>{window.get(), window->rail()}) {
        const int scale = lookInForce().fontScale;
        press(Qt::Key_Minus);
        ASSERT_TRUE(window->isFittingFont());
        EXPECT_GT(gui::colours(pictureOf(*pictured).toImage()), 20);
        EXPECT_FALSE(window->isFittingFont());
        EXPECT_LT(lookInForce().fontScale, scale);
    }
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

}  // namespace
}  // namespace terratact
