// Tests the console on a screen below its minimum size: essential controls stay on the screen. The caller chooses the
// screen (tests/CMakeLists.txt).
#include <gtest/gtest.h>

#include <QScreen>
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/start/language.h"
#include "tests/support/benches/bus_console_bench.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

using gui::eventually;

constexpr QSize kEnough{940,
                        500};  // [px] smallest window without cut texts: 960x540 with a title bar
constexpr int kRailHeight = 536;  // [px] least height without scrolling: 960x540 with a frame

QRect onScreen(const QWidget& widget)
{
    return {widget.mapToGlobal(QPoint(0, 0)), widget.size()};
}

struct SmallScreen : BusConsole {
    ~SmallScreen() override
    {
        window.reset();
        robot.reset();
        installLanguage(*qApp, "en");
        applyLook(*qApp);
    }
    QRect screenArea() const { return window->screen()->availableGeometry(); }
    bool hasEnough() const { return window->size().expandedTo(kEnough) == window->size(); }
    bool hasRailRoom() const { return window->height() >= kRailHeight; }
    /// Opens the console like at the first start.
    void openIn(const char* language, bool isFullScreen = false)
    {
        window.reset();
        robot.reset();
        installLanguage(*qApp, language);
        applyLook(*qApp);
        startQuickRobot();
        window = console(bus.join("can0"), CanSource::Mode::Transmit,
                         [] { return Result<LoadedModel>(madeUp()); });
        window->resize(1440, 900);
        if (isFullScreen) return window->showFullScreen();
        gui::showActive(*window);
        EXPECT_TRUE(eventually([&] { return screenArea().contains(window->frameGeometry()); }));
    }
    std::array<const QWidget*, 2> neededInHeader() const
    {
        return {window->header()->stopButton(), window->header()->arming()};
    }
    /// Checks that STOP and arming are visible once the header has made room for its present words.
    void lookAtHeader(const std::string& where)
    {
        (void)eventually(
            [&] {
                return std::ranges::all_of(neededInHeader(), [&](const QWidget* needed) {
                    return window->header()->rect().contains(needed->geometry());
                });
            },
            3000);
        picture(QString::fromStdString(where).remove(' ').replace(',', '_'));
        for (const QWidget* needed : neededInHeader()) {
            EXPECT_TRUE(needed->isVisible()) << where;
            EXPECT_TRUE(screenArea().contains(onScreen(*needed))) << where;
            EXPECT_TRUE(window->header()->rect().contains(needed->geometry())) << where;
        }
        EXPECT_TRUE(screenArea().contains(window->frameGeometry())) << where;
    }
    void lookAtTerrain(const std::string& what)
    {
        window->rail()->choose(0);
        QTest::qWait(60);
        // New header content may need a second line; the rest of the window gives the room.
        (void)eventually(
            [&] {
                return gui::overlaps(*window).empty()
                    && (!hasEnough() || gui::cramped(*window).empty());
            },
            3000);
        lookAtHeader(what + ", terrain");
        const QRect seen = onScreen(*window->verdict()).intersected(screenArea());
        EXPECT_EQ(seen.height(), window->verdict()->height()) << what;
        EXPECT_EQ(gui::overlaps(*window), std::vector<std::string>()) << what;
        if (!hasEnough()) return;
        EXPECT_EQ(seen, onScreen(*window->verdict())) << what;
        EXPECT_EQ(gui::cramped(*window), std::vector<std::string>()) << what;
    }
    /// Checks that no page cuts a text if the screen is large enough.
    void lookAtEachPage(const std::string& what)
    {
        lookAtTerrain(what);
        for (int page = 1; page < window->rail()->pages(); ++page) {
            if (window->rail()->button(page)->isHidden()) continue;
            const std::string where = what + ", page " + std::to_string(page);
            window->rail()->choose(page);
            QTest::qWait(60);
            lookAtHeader(where);
            if (hasEnough()) {
                EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>()) << where;
            }
        }
        window->rail()->choose(0);
    }
    void clickStop()
    {
        const QPushButton& stop = *window->header()->stopButton();
        QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {},
                          stop.mapTo(window.get(), stop.rect().center()));
    }
};

TEST_F(SmallScreen, hasStopArmingAndVerdictInEveryLanguage)
{
    for (const char* language : {"en", "cs", "de"}) {
        openIn(language);
        const std::string in = language;
        lookAtEachPage(in + " started");
        ASSERT_TRUE(exploresUntilAsked());
        lookAtEachPage(in + " asked");
        clickStop();
        EXPECT_TRUE(reaches(AtemPhase::Stopped)) << in;
        lookAtEachPage(in + " stopped");
        robot.reset();
        ASSERT_TRUE(eventually([&] { return !window->exploration().linkAlive(); }));
        lookAtEachPage(in + " lost");
    }
}

TEST_F(SmallScreen, scrollsOnlyWhatDoesNotFit)
{
    for (const char* language : {"en", "cs", "de"}) {
        openIn(language);
        ASSERT_TRUE(eventually([&] { return !window->isFittingFont(); }));
        QTest::qWait(60);
        const QWidget& rail = *window->rail();
        const bool cut = rail.visibleRegion().boundingRect() != rail.rect();
        EXPECT_EQ(cut, !hasRailRoom()) << language << ": " << rail.height() << " px";
        if (cut) {
            EXPECT_EQ(rail.height(), rail.minimumSizeHint().height()) << language;
        }
    }
}

TEST_F(SmallScreen, fitsAgainAfterItsFrameHasChanged)
{
    openIn("en", true);
    EXPECT_TRUE(eventually([&] { return window->geometry() == window->screen()->geometry(); }));
    window->showNormal();
    EXPECT_TRUE(eventually([&] { return window->frameGeometry() != window->geometry(); }));
    EXPECT_TRUE(eventually([&] {
        return !window->isFittingFont() && screenArea().contains(window->frameGeometry());
    })) << window->frameGeometry().height();
}

TEST_F(SmallScreen, fontScaleIsLimitedToWhatFits)
{
    openIn("en");
    for (const int percent : {200, 80, 130}) {
        window->preferences().change([percent](Preferences& p) { p.fontScale = percent; });
        lookAtTerrain("letters of " + std::to_string(percent));
    }
}

}  // namespace
}  // namespace terratact
