// Tests the pages of alarms, signals and diagnostics in a console with a robot on a bus.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <QTimer>
#include <array>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "app/console/alarms_page.h"
#include "app/console/diagnostics_page.h"
#include "app/console/signals_page.h"
#include "app/mission/console_alarms.h"
#include "app/pages/dbc_files.h"
#include "app/pages/numbers_page.h"
#include "app/runtime/steady_now.h"
#include "app/shell/preference_store.h"
#include "tests/support/counting_alarm_sound.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/robot_on_bench.h"
#include "tests/support/scripted_source.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/alarm_table.h"
#include "widgets/signals/raw_trace.h"
#include "widgets/signals/signal_table.h"

namespace terratact {
namespace {

using gui::eventually;

struct Pages : testing::Test, RobotOnBench {
    static void SetUpTestSuite()
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
    }
    void open(const QStringList& dbc = {})
    {
        startRobot();
        MainWindow::Options options =
            linked({.mode = CanSource::Mode::Transmit, .bitrate = 500'000.0});
        Preferences preferences;
        preferences.dbc = dbc;
        options.preferences = std::make_unique<PreferenceStore>(LoadedPreferences{}, preferences);
        show(std::move(options));
    }
    void openWithoutBus()
    {
        auto source = std::make_unique<ScriptedSource>();
        MainWindow::Options options;
        options.robot = model;
        options.source = std::move(source);
        show(std::move(options));
    }
    void show(MainWindow::Options options)
    {
        options.model = [] {
            return Result<LoadedModel>(LoadedModel{
                .estimate = [](const EstimateRequest&, const Watch&) { return stepEstimate(); },
                .name = "fake.ttm",
                .details = "made up"});
        };
        options.alarmSound = std::make_unique<CountingAlarmSound>(sounds);
        window = std::make_unique<MainWindow>(std::move(options));
        window->resize(1280, 720);
        gui::showActive(*window);
    }
    void picture(const QString& name)
    {
        const QString folder = qEnvironmentVariable("TERRATACT_PICTURES");
        if (!folder.isEmpty()) window->grab().save(folder + "/" + name + ".png");
    }
    QString valueOf(const QString& signal)
    {
        const SignalTable* table = window->signalsPage()->table();
        for (int row = 0; row < table->rows(); ++row)
            if (table->text(row, SignalTable::Name) == signal)
                return table->text(row, SignalTable::Value);
        return "no such signal";
    }
    QString tipOf(const QString& signal, SignalTable::Column column) const
    {
        const QAbstractItemModel* rows = window->signalsPage()->table()->model();
        for (int row = 0; row < rows->rowCount(); ++row)
            if (rows->index(row, SignalTable::Name).data().toString() == signal)
                return rows->index(row, column).data(Qt::ToolTipRole).toString();
        return {};
    }

    int sounds = 0;
    std::unique_ptr<MainWindow> window;
};

TEST_F(Pages, signalsLiveAndGoStale)
{
    open();
    QTest::keyClick(window.get(), Qt::Key_F5);
    ASSERT_TRUE(eventually([&] { return valueOf("Pitch") != "no such signal"; }));
    QTest::qWait(2500);
    picture("signals");
    EXPECT_TRUE(eventually([&] { return valueOf("Pitch") != "--"; }));
    EXPECT_TRUE(window->signalsPage()->headline().contains("of 500 kbit/s"));
    EXPECT_TRUE(window->signalsPage()->headline().contains("can0 works"));
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    robot.reset();
    EXPECT_TRUE(eventually([&] { return valueOf("Pitch") == "--"; }));
    picture("signals-stale");
}

struct ForeignFramesOnThePage : Pages {
    ForeignFramesOnThePage()
    {
        directory.write("gas.dbc", "BO_ 1280 GasSensor: 8 Payload\n"
                                   " SG_ Oxygen : 7|16@0+ (0.01,0) [0|25] \"%\" C\n"
                                   " SG_ State : 16|2@1+ (1,0) [0|2] \"\" C\n"
                                   "BO_ 2566836481 Battery: 4 Payload\n"
                                   " SG_ Power : 0|32@1- (1,0) [0|0] \"W\" C\n"
                                   "CM_ BO_ 1280 \"Of the <b>air</b>.\";\n"
                                   "CM_ SG_ 1280 Oxygen \"Below 19.5 % no human may enter.\";\n"
                                   "VAL_ 1280 State 1 \"ready\" ;\n"
                                   "SIG_VALTYPE_ 2566836481 Power : 1;\n");
        directory.write("clash.dbc", "BO_ 34 Tilt: 8 P\nBO_ 1280 Other: 8 P\n");
        directory.write("bad.dbc", "nothing\n");
        payload = bus.join("payload");
        QObject::connect(&sending, &QTimer::timeout, [this] {
            std::array<BusFrame, 64> heard;
            (void)payload->receive(heard, std::chrono::milliseconds(0));  // keeps the bus end alive
            (void)payload->send({.id = 1280, .length = 3, .data = {0x08, 0x17, 1}});
            (void)payload->send(
                {.id = 0x18FED101, .extended = true, .length = 4, .data = {0, 0x80, 0x3B, 0x43}});
        });
        sending.start(20);
    }
    ~ForeignFramesOnThePage() override { sending.stop(); }
    QString file(const std::string& name) const
    {
        return QString::fromStdString(directory.file(name));
    }
    TemporaryDirectory directory;
    std::unique_ptr<CanBus> payload;
    QTimer sending;
};

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

TEST_F(ForeignFramesOnThePage, aBadDbcFileIsReportedAndStopsNothing)
{
    open({file("gas.dbc"), file("clash.dbc"), file("bad.dbc"), file("none.dbc")});
    QTest::keyClick(window.get(), Qt::Key_F5);
    ASSERT_TRUE(eventually([&] { return valueOf("Oxygen") == "20.71"; }));
    const SignalsPage* page = window->signalsPage();
    EXPECT_EQ(page->dbc()->files(),
              "DBC files: gas.dbc (frames: 2), clash.dbc (frames: 0), bad.dbc (not "
              "used), none.dbc (not used)");
    const QStringList troubles = page->dbc()->troubles().split('\n');
    ASSERT_EQ(troubles.size(), 4);
    EXPECT_TRUE(troubles[0].contains("bad.dbc: describes no message"));
    EXPECT_TRUE(troubles[0].contains("line 1: expected the keyword"));
    EXPECT_TRUE(troubles[1].contains("none.dbc: cannot be opened"));
    EXPECT_TRUE(troubles[2].contains("frame 022: the robot's protocol has that identifier"));
    EXPECT_EQ(troubles[3], QString::fromUtf8("… and 1 more, all listed in this tooltip"));
    EXPECT_TRUE(eventually([&] { return valueOf("Pitch") != "--"; })) << "the protocol wins";
    window->resize(window->minimumSize());
    QTest::qWait(300);
    picture("signals-foreign-troubles");
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
}

TEST_F(ForeignFramesOnThePage, dbcFilesCanBeAddedAndRemovedWhileRunning)
{
    open();
    QTest::keyClick(window.get(), Qt::Key_F5);
    const SignalsPage* page = window->signalsPage();
    EXPECT_TRUE(page->dbc()->addButton()->isVisible());
    EXPECT_FALSE(page->dbc()->removeButton()->isVisible());
    ASSERT_TRUE(eventually([&] { return window->link()->tap().frames(steadyNow()).size() > 10; }));
    QTest::mouseClick(page->dbc()->addButton(), Qt::LeftButton);
    auto* dialog = page->findChild<QFileDialog*>();
    ASSERT_TRUE(dialog);
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(file("gas.dbc"));
    QMetaObject::invokeMethod(dialog, "accept");
    ASSERT_TRUE(eventually([&] { return valueOf("Oxygen") == "20.71"; }));
    EXPECT_EQ(window->preferences().current().dbc, QStringList{file("gas.dbc")}) << "remembered";
    ASSERT_TRUE(page->dbc()->removeButton()->isVisible());
    ASSERT_EQ(page->dbc()->removeButton()->menu()->actions().size(), 1);
    page->dbc()->removeButton()->menu()->actions().first()->trigger();
    EXPECT_TRUE(eventually([&] { return valueOf("Oxygen") == "no such signal"; }));
    EXPECT_EQ(window->preferences().current().dbc, QStringList());
    EXPECT_FALSE(page->dbc()->removeButton()->isVisible());

    window->preferences().change([&](Preferences& p) { p.dbc << file("gas.dbc"); });
    EXPECT_FALSE(page->dbc()->removeButton()->isVisible()) << "no file is read in this thread";
    EXPECT_TRUE(eventually([&] { return page->dbc()->removeButton()->isVisible(); }));
}

/// A file whose reader blocks until it is released, like on an unresponsive network share.
class SlowFile {
public:
    explicit SlowFile(const std::string& path) : fd_(::open(path.c_str(), O_RDWR | O_CLOEXEC))
    {
        std::signal(SIGIO, SIG_IGN);  // the kernel requests the lease with it
        waits_ = fd_ >= 0 && ::fcntl(fd_, F_SETLEASE, F_WRLCK) == 0;
    }
    ~SlowFile()
    {
        letGo();
        if (fd_ >= 0) ::close(fd_);
    }
    SlowFile(const SlowFile&) = delete;
    SlowFile& operator=(const SlowFile&) = delete;
    bool waits() const { return waits_; }
    void letGo() const { (void)::fcntl(fd_, F_SETLEASE, F_UNLCK); }

private:
    int fd_;
    bool waits_ = false;
};

TEST_F(ForeignFramesOnThePage, closingWaitsForAtMostOneDbcFile)
{
    using namespace std::chrono_literals;
    constexpr double kHang = 20.0;  // [s]; the kernel blocks readers of such a file for 45 s
    const SlowFile first(directory.file("gas.dbc")), second(directory.file("clash.dbc"));
    if (!first.waits() || !second.waits()) GTEST_SKIP() << "no leases of files here";
    open({file("gas.dbc"), file("clash.dbc")});
    for (int i = 0; i < 5; ++i)
        window->preferences().change([this](Preferences& p) { p.dbc = {file("clash.dbc")}; });
    QTest::qWait(300);
    const std::jthread lets([&] {
        std::this_thread::sleep_for(500ms);
        first.letGo();
    });
    const double began = steadyNow();
    window.reset();
    EXPECT_LT(steadyNow() - began, kHang);
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

TEST_F(Pages, lostLinkSoundsOnceOpensTheAlarmsAndIsAcknowledged)
{
    open();
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    EXPECT_EQ(window->header()->alarmsButton()->text(), "no alarms");
    bus.setState(BusState::Down, "can0");
    ASSERT_TRUE(eventually([&] { return window->alarms().list().alarms().size() >= 2; }));
    EXPECT_TRUE(eventually([&] {
        return window->header()->alarmsButton()->text() == QString::fromUtf8("▲ alarms: 2");
    }));
    QTest::qWait(300);
    EXPECT_EQ(sounds, 1) << "bus and link at once";
    QTest::mouseClick(window->header()->alarmsButton(), Qt::LeftButton);
    EXPECT_EQ(window->rail()->chosen(), window->rail()->pageOf(Qt::Key_F4));
    ASSERT_TRUE(
        eventually([&] { return window->alarmsPage()->table()->table()->rowCount() == 2; }));
    QTest::qWait(100);
    picture("alarms");
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    bus.setState(BusState::Up, "can0");
    ASSERT_TRUE(
        eventually([&] { return window->alarms().list().count(AlarmState::Returned) == 2; }));
    QTest::qWait(100);
    picture("alarms-returned");
    QTest::mouseClick(window->alarmsPage()->table()->acknowledgeAllButton(), Qt::LeftButton);
    EXPECT_TRUE(
        eventually([&] { return window->header()->alarmsButton()->text() == "no alarms"; }));
    EXPECT_EQ(sounds, 1) << "none on return";
    QTest::qWait(100);
    picture("alarms-none");
}

TEST_F(Pages, diagnosticsCanBeCopied)
{
    open();
    EXPECT_TRUE(window->diagnosticsPage()->text().contains("panel: --"));
    QTest::keyClick(window.get(), Qt::Key_F8);
    QTest::qWait(1500);
    picture("diagnostics");
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    QTest::mouseClick(window->diagnosticsPage()->copyButton(), Qt::LeftButton);
    const QString text = QApplication::clipboard()->text();
    for (const char* part : {"Qt: 6.", "Qwt: 6.", "Eigen: 3.", "OpenBLAS: ", "Linux",
                             "CAN socket: ", "bus: can0 works", "estimator uses: ", "fake.ttm",
                             "made up", "can0", "telemetry to screen: half ≤"})
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

TEST_F(Pages, theNumbersSayWhatTheVerdictIsAndHowOldTheyAre)
{
    const TerrainEstimate estimate = stepEstimate();
    NumbersViewState viewState;
    NumbersPage page([&] { return viewState; });
    page.resize(1200, 600);
    gui::showActive(page);
    const QLabel* line = nullptr;
    for (const QLabel* label : page.findChildren<QLabel*>())
        if (label->accessibleName() == "Verdict") line = label;
    ASSERT_TRUE(line);
    page.refresh(0.0);
    EXPECT_FALSE(line->isVisible()) << "there is no estimate";
    viewState.estimate = &estimate;
    viewState.verdict = Verdict{.stepVerdict = StepVerdict::Blocked,
                                .step = {0.99, 0.004},
                                .likeliest = 8,
                                .likeliestP = 0.97,
                                .withheldFor = {},
                                .toHorizon = {}};
    viewState.age = 0.04;
    const auto explained = [&page] {
        const auto labels = page.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) {
            return label->isVisible() && label->text().contains("steps over two bins (0.2 m)");
        });
    };
    EXPECT_FALSE(explained());
    page.refresh(0.0);
    EXPECT_EQ(line->text(),
              QString::fromUtf8("✘ BLOCKED · P(step > 0.10 m ahead) = 0.99 ± < 0.01 · likeliest at "
                                "+0.5 … +0.6 m (0.97)"));
    EXPECT_TRUE(explained()) << "P over two bins, beside a column of P to the next";
    viewState.verdict->stepVerdict = StepVerdict::CannotTell;
    viewState.verdict->withheldFor = {WithholdReason::Stale};
    viewState.age = 12.34;
    page.refresh(0.0);
    EXPECT_EQ(
        line->text(),
        QString::fromUtf8("? CANNOT TELL · P(step > 0.10 m ahead) = 0.99 ± < 0.01 · withheld: "
                          "no live telemetry, the robot may have moved · last telemetry 12.3 s "
                          "ago"));
    EXPECT_EQ(gui::cutWhenSettled(page), std::vector<std::string>());
    viewState.verdict->withheldFor = {WithholdReason::TelemetryGap};
    viewState.age = 0.04;
    page.refresh(0.0);
    EXPECT_TRUE(line->text().endsWith("withheld: the link was lost, the robot may have moved"));
    viewState.estimate = nullptr;
    viewState.verdict.reset();
    page.refresh(0.0);
    EXPECT_FALSE(line->isVisible());
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
