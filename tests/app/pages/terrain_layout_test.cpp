// Tests the layouts of the terrain page.
#include "app/pages/terrain_layout.h"

#include <gtest/gtest.h>

#include "app/console/main_window.h"
#include "tests/support/benches/look_bench.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

TEST_F(Look, everyLayoutShowsStopStateAndWhatAsks)
{
    for (const Qt::Key layout : {Qt::Key_1, Qt::Key_2, Qt::Key_3}) {
        press(layout);
        QTest::qWait(60);
        EXPECT_TRUE(window->header()->stopButton()->isVisible());
        EXPECT_TRUE(window->atemPanel()->isVisible());
        EXPECT_TRUE(window->terrain()->isVisible());
        EXPECT_EQ(window->drivePad()->isVisible(), layout != Qt::Key_3);
        EXPECT_EQ(window->events()->isVisible(), layout != Qt::Key_1);
        EXPECT_EQ(window->probeCard()->isVisible(), layout == Qt::Key_2);
    }
    explore();
    EXPECT_TRUE(window->probeCard()->isVisible()) << "it asks in the review layout";
    press(Qt::Key_Home);
    EXPECT_EQ(window->preferences().current().layout, Layout::Probe);
}

}  // namespace
}  // namespace terratact
