// Tests the pages of alarms, signals and diagnostics in a console with a robot on a bus.
#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <string>

#include "app/console/pages/diagnostics_page.h"
#include "app/console/pages/signals_page.h"
#include "app/pages/dbc_files.h"
#include "app/pages/numbers_page.h"
#include "app/runtime/steady_now.h"
#include "app/shell/preferences/preference_store.h"
#include "tests/support/benches/pages_bench.h"
#include "tests/support/gui.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/control/drive_pad.h"
#include "widgets/signals/alarm_table.h"
#include "widgets/signals/raw_trace.h"
#include "widgets/signals/signal_table.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(Pages, signalsLiveAndGoStale)
{
    open();
    QTest::keyClick(window.get(), Qt::Key_F5);
    ASSERT_TRUE(eventually([&] { return valueOf("Pitch") != "no such signal"; }));
    EXPECT_TRUE(eventually([&] { return valueOf("Pitch") != "--"; }));
    EXPECT_TRUE(
        eventually([&] { return window->signalsPage()->headline().contains("of 500 kbit/s"); }));
    picture("signals");
    EXPECT_TRUE(window->signalsPage()->headline().contains("can0: working"));
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    robot.reset();
    EXPECT_TRUE(eventually([&] { return valueOf("Pitch") == "--"; }));
    picture("signals-stale");
}

TEST_F(ForeignFramesOnThePage, areDecodedByTheirDbcFiles)
{
    open({file("gas.dbc")});
    QTest::keyClick(window.get(), Qt::Key_F5);
    ASSERT_TRUE(eventually([&] { return valueOf("Power") == "187.5"; }));
    EXPECT_EQ(valueOf("Oxygen"), "20.71");
    EXPECT_EQ(valueOf("State"), "ready");
    EXPECT_TRUE(eventually([&] { return valueOf("Pitch") != "--"; })) << "beside the robot's own";
    EXPECT_EQ(window->signalsPage()->dbc()->files(), "DBC files: gas.dbc (frames: 2)");
    EXPECT_EQ(window->signalsPage()->dbc()->troubles(), "");
    EXPECT_TRUE(tipOf("Oxygen", SignalTable::Name).contains("no human may enter"));
    EXPECT_TRUE(tipOf("Oxygen", SignalTable::Frame).contains("&lt;b&gt;air"))
        << "no HTML of others";
    EXPECT_TRUE(tipOf("Oxygen", SignalTable::Frame).contains("gas.dbc"));
    EXPECT_TRUE(tipOf("Pitch", SignalTable::Name).contains("Nose up positive"))
        << "from the shipped file";
    RawTrace* trace = window->signalsPage()->trace();
    trace->filter()->setText("gas");
    const QAbstractItemModel* frames = trace->view()->model();
    ASSERT_TRUE(eventually([&] { return frames->rowCount() > 0; }));
    QStringList shown;
    for (int column = 2; column < frames->columnCount(); ++column)
        shown << frames->index(0, column).data().toString();
    EXPECT_EQ(shown.join("|"), "500|GasSensor|[3] 08 17 01|Oxygen 20.71 %, State ready");
    EXPECT_TRUE(eventually([&] {
        for (const TappedFrame& frame : window->link()->tap().frames(steadyNow()))
            if (frame.described && frame.rate > 5.0) return true;
        return false;
    })) << "50 Hz on an idle machine";
    trace->filter()->clear();
    QTest::qWait(300);
    window->signalsPage()->table()->scrollToBottom();
    picture("signals-foreign");
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    sending.stop();
    EXPECT_TRUE(eventually([&] {
        for (const TappedFrame& frame : window->link()->tap().frames(steadyNow()))
            if (frame.described && frame.times[0].age > frame.times[0].fresh) return true;
        return false;
    })) << "goes grey";
}

TEST_F(Pages, typingIntoTheFilterMovesNoRobot)
{
    open();
    QTest::keyClick(window.get(), Qt::Key_F5);
    QLineEdit* filter = window->signalsPage()->trace()->filter();
    filter->setFocus();
    QTest::keyClicks(filter, "warms 2");
    EXPECT_EQ(filter->text(), "warms 2");
    EXPECT_FALSE(window->drivePad()->forwardButton()->isDown());
    EXPECT_EQ(window->link()->view().link.arming.phase, ArmingPhase::Disarmed);
    QTest::keyClick(filter, Qt::Key_F2);
    EXPECT_EQ(window->rail()->chosen(), 0) << "pages are chosen from anywhere";
}

TEST_F(Pages, diagnosticsCanBeCopied)
{
    open();
    EXPECT_TRUE(window->diagnosticsPage()->text().contains("panel: --"));
    QTest::keyClick(window.get(), Qt::Key_F8);
    EXPECT_TRUE(eventually([&] {
        return window->diagnosticsPage()->text().contains("telemetry to screen: median ");
    }));
    picture("diagnostics");
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    QTest::mouseClick(window->diagnosticsPage()->copyButton(), Qt::LeftButton);
    const QString text = QApplication::clipboard()->text();
    for (const char* part : {"Qt: 6.", "Qwt: 6.", "Eigen: 3.", "OpenBLAS: ", "Linux",
                             "CAN socket: ", "bus: can0: working", "estimator uses: ", "fake.ttm",
                             "made up", "can0", "telemetry to screen: median "})
        EXPECT_TRUE(text.contains(part)) << part << " is not in\n" << text.toStdString();
    EXPECT_GT(residentMemory(), 1e6);
}

TEST_F(Pages, sourceThatIsNoBusShowsItsValues)
{
    openWithoutBus();
    QTest::keyClick(window.get(), Qt::Key_F5);
    EXPECT_TRUE(eventually([&] { return valueOf("pitch") != "no such signal"; }));
    EXPECT_TRUE(window->signalsPage()->headline().contains("no CAN bus"));
    QTest::qWait(200);
    picture("signals-no-bus");
}

TEST_F(Pages, fitTheSmallestWindow)
{
    open();
    window->resize(window->minimumSize());
    for (const Qt::Key page : {Qt::Key_F4, Qt::Key_F5, Qt::Key_F8}) {
        QTest::keyClick(window.get(), page);
        QTest::qWait(200);
        EXPECT_EQ(window->size(), window->minimumSize()) << "page " << page - Qt::Key_F1 + 1;
        EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    }
}

}  // namespace
}  // namespace terratact
