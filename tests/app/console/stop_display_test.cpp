// Tests what the console claims about a STOP.
#include "app/console/stop_display.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <vector>

#include "app/console/main_window.h"
#include "tests/support/benches/console_bench.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(Console, stopClaimsNoMoreThanIsKnown)
{
    ScriptedSource* source = openScripted();
    const QPushButton& stop = *window->header()->stopButton();
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    source->setDeaf(true);
    QTest::keyClick(window.get(), Qt::Key_F12);
    EXPECT_TRUE(eventually([&] { return says("STOP NOT SENT for"); }));
    EXPECT_TRUE(says("the bus is off"));
    EXPECT_EQ(stop.text(), "STOP NOT SENT");
    source->setDeaf(false);
    EXPECT_TRUE(eventually([&] { return says("STOP SENT, NOT CONFIRMED for"); }));
    EXPECT_TRUE(stop.text().startsWith("STOP SENT")) << stop.text().toStdString();
    EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
    if (const QString folder = qEnvironmentVariable("TERRATACT_PICTURES"); !folder.isEmpty())
        window->grab().save(folder + "/stop-not-confirmed.png");
    Measurement stopped;
    stopped.activity = RobotActivity::Stopped;
    source->setMeasurement(stopped);
    EXPECT_TRUE(eventually([&] { return stop.text() == "STOPPED (F12)"; }));
    EXPECT_FALSE(says("STOP SENT") || says("STOP NOT SENT"));
}

}  // namespace
}  // namespace terratact
