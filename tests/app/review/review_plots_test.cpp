// Tests the plots of a reviewed session: the whole of it, its cursor, the dock.
#include "app/pages/plots_page.h"
#include "app/review/review_signals_page.h"
#include "tests/support/benches/review_bench.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/signals/plot_values.h"
#include "widgets/signals/time_plots.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(ReviewOf, plotsShowTheWholeSessionAndItsTime)
{
    applyLook(*qApp);
    record();
    open();
    press(kPlotsKey);
    PlotsPanel& panel = *window->plotsPage()->panel();
    ASSERT_TRUE(panel.isVisible());
    ASSERT_TRUE(eventually([&] {
        return window->plotted().isIdle() && panel.values()->rows() > 0
            && panel.values()->text(0, PlotValues::Count).toInt() > 50;
    }));
    EXPECT_NEAR(panel.state().from(), 0.0, 0.01);
    EXPECT_NEAR(panel.state().to(), 4.0, 0.05);
    EXPECT_FALSE(panel.liveButton()->isVisible());
    window->goTo(1.5);
    EXPECT_EQ(panel.state().cursor(), 1.5);
    ASSERT_GE(panel.plots()->rows(), 1);
    EXPECT_EQ(panel.plots()->viewState().cursor, 1.5);
    const QWidget* canvas = panel.plots()->row(0)->canvas();
    QTest::mouseClick(const_cast<QWidget*>(canvas), Qt::LeftButton, {},
                      {canvas->width() / 2, canvas->height() / 2});
    EXPECT_NEAR(now(), 2.0, 0.05) << "a click goes to that time";
}

TEST_F(ReviewOf, theDockOfPlotsFollowsTheTime)
{
    applyLook(*qApp);
    record();
    open();
    window->setRoom({1920, 1200});
    window->resize(1920, 1200);
    press(Qt::Key_P, Qt::ControlModifier);
    PlotsPanel& panel = *window->plotsPage()->panel();
    EXPECT_TRUE(eventually([&] { return window->isDockShown() && panel.isVisible(); }));
    window->goTo(2.5);
    EXPECT_EQ(panel.plots()->viewState().cursor, 2.5);
}

}  // namespace
}  // namespace terratact
