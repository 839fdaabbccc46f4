// Tests what every window of the console has.
#include "app/shell/console_window.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/display/format.h"
#include "tests/support/benches/look_bench.h"
#include "tests/support/gui.h"

namespace terratact {
namespace {

using gui::eventually;

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

TEST_F(Look, f11ShowsFullScreenAndComesBack)
{
    gui::showActive(*window);
    for (const bool maximized : {false, true}) {
        window->setWindowState(maximized ? Qt::WindowMaximized : Qt::WindowNoState);
        QTest::keyClick(window.get(), Qt::Key_F11);
        EXPECT_TRUE(eventually([&] { return window->isFullScreen(); }));
        QTest::keyClick(window.get(), Qt::Key_F11);
        EXPECT_TRUE(eventually([&] { return !window->isFullScreen(); }));
        EXPECT_EQ(window->isMaximized(), maximized);
    }
}

}  // namespace
}  // namespace terratact
