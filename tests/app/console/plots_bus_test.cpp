// Tests the plots of a console on a bus: frames one by one, and the load.
#include <QComboBox>

#include "app/pages/plots_page.h"
#include "tests/support/benches/bus_console_bench.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/signals/plot_values.h"

namespace terratact {
namespace {

using gui::eventually;

struct PlotsOfBus : BusConsole {
    PlotsPanel& panel() const { return *window->plotsPage()->panel(); }
};

TEST_F(PlotsOfBus, showFramesEstimatesAndErrors)
{
    open();
    PlotRows rows{{"bus:Attitude.Pitch"},
                  {"bus:frames_per_second"},
                  {"estimate:sd_max.left", "estimate:error_max.left"}};
    panel().state().setRows(rows);
    emit panel().sets()->textActivated("no such set");  // notifies the source
    window->rail()->choose(window->rail()->pageOf(kPlotsKey));
    const auto count = [&](int row) {
        return panel().values()->text(row, PlotValues::Count).toInt();
    };
    EXPECT_TRUE(
        eventually([&] { return panel().values()->rows() == 4 && count(0) > 10 && count(1) > 1; }));
}

}  // namespace
}  // namespace terratact
