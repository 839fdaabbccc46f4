// Tests that the console connects to another source from inside its window, and what is said where it cannot.
#include "app/console/connection/connect_window.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <chrono>
#include <future>
#include <utility>

#include "app/console/main_window.h"
#include "tests/support/benches/arming.h"
#include "tests/support/benches/robot_on_bench.h"
#include "tests/support/gui.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

using gui::eventually;

BusOffer goodBus()
{
    return {"can0", {{CanFinding::Level::Fine, Message::verbatim("can0 is up"), {}}}};
}

BusOffer downBus()
{
    return {"can1",
            {{CanFinding::Level::Problem, Message::verbatim("can1 is down"),
              Message::verbatim("sudo ip link set can1 up type can bitrate 500000")}}};
}

struct ConnectBench : testing::Test {
    ConnectBench()
        : window({.inUse = "SIMULATED ROBOT",
                  .search = [this](const std::stop_token&) { return offers; },
                  .whyNot = [this] { return whyNot; },
                  .sessions = "/sessions"})
    {
        applyLook(*qApp);
        QObject::connect(&window, &ConnectWindow::connectionWanted, &window,
                         [this](const ConnectionWish& wish) { wishes.push_back(wish); });
        QObject::connect(&window, &ConnectWindow::fileWanted, &window,
                         [this](const QString& path) { files << path; });
        gui::showActive(window);
        EXPECT_TRUE(isListed());
    }
    bool isListed() const
    {
        return eventually([&] { return window.searchButton()->isEnabled(); });
    }
    void choose(int row) { window.list()->setCurrentRow(row); }
    /// Chooses the bus of a row and allows this console to send commands on it.
    void allow(int row)
    {
        choose(row);
        window.transmitBox()->setChecked(true);
    }

    std::vector<BusOffer> offers{goodBus(), downBus()};
    std::optional<Message> whyNot;
    std::vector<ConnectionWish> wishes;
    QStringList files;
    TemporaryDirectory directory;
    ConnectWindow window;
};

TEST_F(ConnectBench, listsEverySourceAndItsRepair)
{
    ASSERT_EQ(window.list()->count(), 5);
    EXPECT_EQ(window.list()->item(1)->text(), "CAN bus can0 — can be used");
    EXPECT_EQ(window.list()->item(2)->text(), "CAN bus can1 — cannot be used, see below");
    choose(2);
    EXPECT_EQ(window.facts(),
              "✘ can1 is down\n    repair: sudo ip link set can1 up type can bitrate 500000");
    EXPECT_FALSE(window.connectButton()->isEnabled());
    EXPECT_EQ(window.result(), "This interface cannot be used: repair it first, then look again");
    offers[1].findings = goodBus().findings;
    QTest::keyClick(window.searchButton(), Qt::Key_Space);
    EXPECT_TRUE(eventually([&] { return window.connectButton()->isEnabled(); }))
        << "the line stays chosen";
}

TEST_F(ConnectBench, namesTheFolderOfRecordingsIfThereIsOne)
{
    choose(window.list()->count() - 1);
    EXPECT_EQ(window.facts(), "Recordings of this console (.tts), in /sessions");
    ConnectWindow homeless({.inUse = "SIMULATED ROBOT",
                            .search = [this](const std::stop_token&) { return offers; },
                            .whyNot = [this] { return whyNot; }});
    gui::showActive(homeless);
    ASSERT_TRUE(eventually([&] { return homeless.searchButton()->isEnabled(); }));
    homeless.list()->setCurrentRow(homeless.list()->count() - 1);
    EXPECT_EQ(homeless.facts(), "Recordings of this console (.tts)");
}

TEST_F(ConnectBench, thePermissionToSendIsForOneBus)
{
    offers[1].findings = goodBus().findings;
    window.searchAgain();
    ASSERT_TRUE(isListed());
    allow(1);
    choose(2);
    EXPECT_FALSE(window.transmitBox()->isChecked()) << "another bus";
    window.transmitBox()->setChecked(true);
    window.searchButton()->click();
    EXPECT_FALSE(window.transmitBox()->isChecked()) << "another look";
    ASSERT_TRUE(isListed());
    allow(2);
    window.close();
    window.show();
    EXPECT_FALSE(window.transmitBox()->isChecked()) << "opened again";
    ASSERT_TRUE(isListed());
    window.connectButton()->click();
    ASSERT_EQ(wishes.size(), 1U);
    EXPECT_EQ(wishes[0].can, "can1");
    EXPECT_FALSE(wishes[0].transmit);
}

TEST_F(ConnectBench, keepsTheBusByItsNameAfterANewSearch)
{
    choose(1);
    offers.insert(offers.begin(), {"a0", goodBus().findings});
    window.searchAgain();
    EXPECT_FALSE(window.connectButton()->isEnabled()) << "not before it is found again";
    ASSERT_TRUE(isListed());
    EXPECT_EQ(window.list()->currentRow(), 2);
    window.connectButton()->click();
    ASSERT_EQ(wishes.size(), 1U);
    EXPECT_EQ(wishes[0].can, "can0");
    offers.erase(offers.begin() + 1);
    window.searchAgain();
    ASSERT_TRUE(isListed());
    EXPECT_EQ(window.list()->currentRow(), -1) << "no other bus in its place";
    EXPECT_FALSE(window.connectButton()->isEnabled());
    EXPECT_EQ(window.facts(), "CAN bus can0 is no longer there");
}

TEST(ConnectWindow, staysUsableWhileItSearches)
{
    constexpr std::chrono::seconds kLong(5);
    std::promise<void> go;
    bool wasLetGo = false;
    ConnectWindow::Options options;
    options.search = [&, gone = go.get_future().share()](const std::stop_token&) {
        wasLetGo = gone.wait_for(kLong) == std::future_status::ready;
        return std::vector<BusOffer>{goodBus()};
    };
    ConnectWindow window(std::move(options));
    gui::showActive(window);
    ASSERT_EQ(window.list()->count(), 4);
    EXPECT_EQ(window.list()->item(1)->text(), "Looking for CAN buses …");
    EXPECT_FALSE(window.searchButton()->isEnabled());
    EXPECT_TRUE(window.connectButton()->isEnabled()) << "to the simulated robot";
    window.list()->setCurrentRow(1);
    EXPECT_FALSE(window.connectButton()->isEnabled());
    window.list()->setCurrentRow(3);
    go.set_value();
    EXPECT_TRUE(eventually([&] { return window.searchButton()->isEnabled(); }));
    EXPECT_TRUE(wasLetGo) << "the window did not wait for it";
    EXPECT_EQ(window.list()->item(1)->text(), "CAN bus can0 — can be used");
    EXPECT_EQ(window.list()->currentRow(), 3) << "the session stays chosen";
}

TEST_F(ConnectBench, connectsToABusByTheKeyboard)
{
    window.list()->setFocus();
    QTest::keyClick(window.list(), Qt::Key_Down);
    window.transmitBox()->setFocus();
    QTest::keyClick(window.transmitBox(), Qt::Key_Space);
    QTest::keyClick(&window, Qt::Key_Return);
    ASSERT_EQ(wishes.size(), 1U);
    EXPECT_EQ(wishes[0].can, "can0");
    EXPECT_TRUE(wishes[0].transmit);
    choose(0);
    EXPECT_FALSE(window.transmitBox()->isVisible());
    window.connectButton()->click();
    ASSERT_EQ(wishes.size(), 2U);
    EXPECT_TRUE(wishes[1].can.empty());
    EXPECT_FALSE(wishes[1].transmit);
}

TEST_F(ConnectBench, staysConnectedWhileTheRobotIsArmed)
{
    whyNot = Message::verbatim("The robot is armed");
    choose(1);
    window.connectButton()->click();
    EXPECT_TRUE(wishes.empty());
    EXPECT_EQ(window.result(), "The robot is armed");
    choose(3);
    EXPECT_TRUE(window.connectButton()->isEnabled()) << "a log opens in its own window";
    choose(1);
    whyNot.reset();
    EXPECT_TRUE(eventually([&] { return window.connectButton()->isEnabled(); }));
    EXPECT_EQ(window.result(), "");
}

TEST_F(ConnectBench, saysWhatIsWrongWithAFile)
{
    const QString log = QString::fromStdString(directory.write("a.log", "(1.0) can0 044#00\n"));
    window.openFile(log, true);
    EXPECT_EQ(window.result(),
              "a.log is no session; choose a recording of this console, or replay it as a log");
    EXPECT_TRUE(files.isEmpty());
    window.openFile(log, false);
    EXPECT_EQ(files, QStringList{log});
    EXPECT_FALSE(window.isVisible());
}

struct ConnectConsole : testing::Test, RobotOnBench {};

TEST_F(ConnectConsole, opensByKeyAndAsksForAnotherRobot)
{
    applyLook(*qApp);
    startRobot();
    auto console = std::make_unique<MainWindow>(linked({.mode = CanSource::Mode::Transmit}));
    gui::showActive(*console);
    EXPECT_EQ(console->connectWindow(), nullptr) << "made at its first use";
    QSignalSpy wanted(console.get(), &MainWindow::connectionWanted);
    QTest::keyClick(console.get(), Qt::Key_L, Qt::ControlModifier);
    ASSERT_NE(console->connectWindow(), nullptr);
    ASSERT_TRUE(arms(*console));
    EXPECT_TRUE(
        eventually([&] { return !console->connectWindow()->connectButton()->isEnabled(); }));
    EXPECT_TRUE(console->connectWindow()->result().contains("The robot is armed"))
        << console->connectWindow()->result().toStdString();
    console->link()->disarm();
    ASSERT_TRUE(eventually([&] { return console->connectWindow()->connectButton()->isEnabled(); }));
    console->connectWindow()->connectButton()->click();
    EXPECT_EQ(wanted.count(), 1);
}

}  // namespace
}  // namespace terratact
