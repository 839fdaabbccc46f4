// The pages beside the terrain's: alarms, signals, diagnostics.
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>
#include <QTimer>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include "app/alarms_page.h"
#include "app/can_words.h"
#include "app/console_alarms.h"
#include "app/diagnostics_page.h"
#include "app/event_watch.h"
#include "app/loop_meter.h"
#include "app/main_window.h"
#include "app/preference_store.h"
#include "app/robot_in_process.h"
#include "app/signals_page.h"
#include "app/steady_now.h"
#include "core/sim/terrain_shapes.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "tests/support/temporary_directory.h"
#include "widgets/alarm_table.h"
#include "widgets/drive_pad.h"
#include "widgets/held_button.h"
#include "widgets/look.h"
#include "widgets/navigation_rail.h"
#include "widgets/raw_trace.h"
#include "widgets/signal_table.h"
#include "widgets/status_header.h"

namespace terratact {
namespace {

using gui::eventually;
constexpr float kGap = std::numeric_limits<float>::quiet_NaN();

class CountingSounder final : public Sounder {
public:
    explicit CountingSounder(int& sounds) : sounds_(sounds) {}
    void sound() override { ++sounds_; }

private:
    int& sounds_;
};

// What makes an alarm.

struct Alarming : testing::Test {
    int sounds = 0;
    ConsoleAlarms alarms{std::make_unique<CountingSounder>(sounds)};
    double now = 1000.0;
    AlarmSight sight{.telemetryAge = 0.01, .linkAlive = true, .bus = CanView{}, .busName = "can0"};

    void pass(double seconds)
    {
        for (const double until = now + seconds; now < until; now += 0.04) alarms.look(now, sight);
    }
    const Alarm* find(const std::string& id) const
    {
        for (const Alarm& alarm : alarms.list().alarms())
            if (alarm.id == id) return &alarm;
        return nullptr;
    }
    testing::AssertionResult says(const std::string& id, const std::string& part) const
    {
        const Alarm* alarm = find(id);
        if (!alarm) return testing::AssertionFailure() << "no alarm " << id;
        if (alarm->text.find(part) == std::string::npos)
            return testing::AssertionFailure() << alarm->text;
        return testing::AssertionSuccess();
    }
    bool stands(const std::string& id) const
    {
        const Alarm* alarm = find(id);
        return alarm && alarm->state == AlarmState::Unacknowledged;
    }
};

TEST_F(Alarming, aSoundRobotMakesNone)
{
    pass(20.0);
    EXPECT_TRUE(alarms.list().alarms().empty());
    EXPECT_EQ(sounds, 0);
}

TEST_F(Alarming, lostLinkSoundsOnceThenSeldomAndIsSilentOnReturn)
{
    sight.linkAlive = false;
    sight.sourceTrouble = "can0 is down";
    pass(1.0);
    EXPECT_TRUE(says("link", "can0 is down"));
    EXPECT_EQ(sounds, 1);
    pass(8.0);
    EXPECT_EQ(sounds, 1);
    pass(2.0);
    EXPECT_EQ(sounds, 2);
    sight.linkAlive = true;
    pass(30.0);
    EXPECT_EQ(sounds, 2);
    ASSERT_TRUE(find("link")) << "nobody has seen it";
    EXPECT_EQ(find("link")->state, AlarmState::Returned);
}

TEST_F(Alarming, linkThatFluttersIsOneAlarm)
{
    for (int i = 0; i < 20; ++i) {
        sight.linkAlive = i % 2 == 1;
        pass(0.4);
    }
    EXPECT_EQ(find("link")->raised, 1U);
    EXPECT_EQ(sounds, 1);
}

TEST_F(Alarming, telemetryThatNeverCameIsOneAfterAWhile)
{
    sight.telemetryAge.reset();
    sight.linkAlive = false;
    pass(ConsoleAlarms::kFirstTelemetry - 0.5);
    EXPECT_TRUE(alarms.list().alarms().empty());
    pass(1.0);
    EXPECT_TRUE(stands("silence"));
}

TEST_F(Alarming, replayThatWaitsOrHasEndedMakesNone)
{
    sight.telemetryAge.reset();
    sight.linkAlive = false;
    sight.bus->waits = true;
    pass(2.0 * ConsoleAlarms::kFirstTelemetry);  // while its model is being loaded
    sight.bus->waits = false;
    pass(ConsoleAlarms::kFirstTelemetry - 0.5);
    sight.telemetryAge = 5.0;
    sight.bus->ended = true;
    sight.bus->bus = BusState::Ended;
    pass(20.0);
    for (const Alarm& alarm : alarms.list().alarms()) ADD_FAILURE() << alarm.text;
    EXPECT_EQ(sounds, 0);
}

TEST_F(Alarming, busThatIsNotUpSaysWhatMendsIt)
{
    sight.bus->bus = BusState::BusOff;
    pass(0.1);
    EXPECT_TRUE(says("bus", "sudo ip link set can0 type can restart"));
    EXPECT_EQ(find("bus")->severity, Severity::Critical);
}

TEST_F(Alarming, stalledBusIsOneOnlyWhenItStays)
{
    sight.bus->bus = BusState::Stalled;
    pass(0.5);
    EXPECT_FALSE(find("bus"));
    sight.bus->bus = BusState::Up;
    pass(2.0);
    sight.bus->bus = BusState::Stalled;
    pass(1.5);
    EXPECT_TRUE(stands("bus"));
    EXPECT_EQ(sounds, 0) << "a caution";
}

TEST_F(Alarming, lostAndDamagedFramesAreCounted)
{
    sight.bus->frames.dropped = 7;
    sight.wrongChecksums = 3;
    pass(0.1);
    EXPECT_TRUE(says("dropped", "7 frames"));
    EXPECT_TRUE(says("checksum", "3 with a wrong checksum"));
    alarms.acknowledgeAll();
    pass(ConsoleAlarms::kCountedFor + ConsoleAlarms::kGoneFor + 0.5);
    EXPECT_FALSE(find("dropped")) << "none was lost since";
    sight.bus->frames.dropped = 8;
    pass(0.1);
    EXPECT_TRUE(stands("dropped"));
}

TEST_F(Alarming, whoeverListensOrReplaysHearsTheConsoleItFollows)
{
    sight.bus->link.foreignSender = true;
    sight.bus->transmits = false;
    pass(1.0);
    EXPECT_FALSE(find("foreign"));
}

TEST_F(Alarming, otherCauses)
{
    sight.bus->link.foreignSender = true;
    sight.bus->transmits = true;
    sight.noModel = "no such file";
    sight.panelTrouble = "the panel does not answer";
    sight.failedExploration = "the estimate failed";
    sight.isStopped = true;
    sight.bus->forces.left[2] = ElementForce{0.0, ElementState::Open};
    pass(0.1);
    for (const char* id : {"foreign", "model", "panel", "exploration", "stop"})
        EXPECT_TRUE(stands(id)) << id;
    EXPECT_FALSE(find("sensors"));
    pass(1.5);
    EXPECT_TRUE(says("sensors", "left 3 " + describe(ElementState::Open)));
    EXPECT_EQ(sounds, 1) << "all at once sound once";
}

TEST_F(Alarming, soundCanBeSwitchedOff)
{
    alarms.setSoundOn(false);
    sight.linkAlive = false;
    pass(30.0);
    EXPECT_EQ(sounds, 0);
    EXPECT_TRUE(stands("link"));
}

// Widgets.

TEST(AlarmTableWidget, showsEachStateInWordsAndEmitsWhatTheOperatorDoes)
{
    AlarmList list;
    list.raise("seen", "the first", Severity::Caution, 0.0);
    list.acknowledge("seen");
    list.raise("over", "the second", Severity::Critical, 10.0);
    list.clear("over", 20.0);
    list.raise("new", "the third", Severity::Critical, 30.0);
    AlarmTable table;
    table.resize(900, 300);
    table.setAlarms(list.alarms(), 95.0, 42.0);
    gui::showActive(table);
    const auto cell = [&](int row, int column) { return table.table()->item(row, column)->text(); };
    ASSERT_EQ(table.table()->rowCount(), 3);
    EXPECT_TRUE(cell(0, 0).contains("CRITICAL"));
    EXPECT_EQ(cell(0, 1), "the third");
    EXPECT_EQ(cell(0, 2), "for 1:05");
    EXPECT_TRUE(cell(1, 0).contains("over"));
    EXPECT_EQ(cell(1, 2), "over for 1:15");
    EXPECT_TRUE(cell(2, 0).contains("seen"));
    EXPECT_EQ(gui::cutText(table), std::vector<std::string>());

    QStringList seen;
    int all = 0;
    double silenced = 0.0;
    QObject::connect(&table, &AlarmTable::acknowledged, [&](const QString& id) { seen << id; });
    QObject::connect(&table, &AlarmTable::allAcknowledged, [&] { ++all; });
    QObject::connect(&table, &AlarmTable::silenced, [&](double s) { silenced = s; });
    table.table()->selectRow(1);
    list.raise("newer", "on top", Severity::Critical, 96.0);
    table.setAlarms(list.alarms(), 97.0, 0.0);
    QTest::mouseClick(table.acknowledgeButton(), Qt::LeftButton);
    EXPECT_EQ(seen, QStringList{"over"}) << "the chosen alarm, wherever it has moved";
    QTest::mouseClick(table.acknowledgeAllButton(), Qt::LeftButton);
    EXPECT_EQ(all, 1);
    QTest::mouseClick(table.silenceButton(2), Qt::LeftButton);
    EXPECT_EQ(silenced, 120.0);
    table.setAlarms({}, 98.0, 0.0);
    EXPECT_FALSE(table.acknowledgeButton()->isEnabled());
}

TEST(AlarmTableWidget, choosesNoOtherAlarmWhenTheChosenOneGoes)
{
    AlarmList list;
    for (const char* id : {"a", "b", "c"}) list.raise(id, id, Severity::Caution, 0.0);
    AlarmTable table;
    QStringList seen;
    QObject::connect(&table, &AlarmTable::acknowledged, [&](const QString& id) { seen << id; });
    table.setAlarms(list.alarms(), 1.0, 0.0);
    gui::showActive(table);
    EXPECT_EQ(table.table()->currentRow(), 0) << "the first is chosen when there was none";
    table.table()->selectRow(1);
    const std::string chosen = list.alarms()[1].id;
    list.clear(chosen, 2.0);
    list.acknowledge(chosen);  // now it is gone
    table.setAlarms(list.alarms(), 3.0, 0.0);
    ASSERT_EQ(table.table()->rowCount(), 2);
    EXPECT_FALSE(table.acknowledgeButton()->isEnabled());
    QTest::mouseClick(table.acknowledgeButton(), Qt::LeftButton);
    QTest::keyClick(table.table(), Qt::Key_Return);
    EXPECT_TRUE(seen.isEmpty());
    table.table()->selectRow(1);
    QTest::mouseClick(table.acknowledgeButton(), Qt::LeftButton);
    EXPECT_EQ(seen, QStringList(QString::fromStdString(list.alarms()[1].id)));
}

TEST(Sparkline, breaksAtGapsAndStaysInItsBox)
{
    const QRectF box(10.0, 20.0, 100.0, 30.0);
    const std::vector<float> history{kGap, 1.0F, 2.0F, kGap, 3.0F, -5.0F, 1e30F, kGap};
    const auto lines = sparkline(history, box);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].size(), 2);
    EXPECT_EQ(lines[1].size(), 3);
    for (const QPolygonF& line : lines)
        for (const QPointF& point : line)
            EXPECT_TRUE(box.adjusted(-1e-6, -1e-6, 1e-6, 1e-6).contains(point))
                << point.x() << " " << point.y();
    EXPECT_NEAR(sparkline(std::vector{1.0F, 1.0F}, box)[0][0].y(), 35.0, 1e-9)
        << "flat: the middle";
    EXPECT_TRUE(sparkline(std::vector{kGap, kGap}, box).empty());
    EXPECT_TRUE(sparkline({}, box).empty());
    const float infinite = std::numeric_limits<float>::infinity();
    EXPECT_EQ(sparkline(std::vector{infinite, 1.0F, -infinite}, box).size(), 1U);
    const float most = std::numeric_limits<float>::max();
    const auto extreme = sparkline(std::vector{most, -most}, box);
    ASSERT_EQ(extreme.size(), 1U);
    for (const QPointF& point : extreme[0])
        EXPECT_TRUE(std::isfinite(point.x()) && std::isfinite(point.y()));
}

TEST(SignalTableWidget, hostileNumbersPaintQuickly)
{
    std::vector<SignalRow> rows;
    for (const double value : gui::kHostile) {
        SignalRow row;
        row.name = "hostile";
        row.rate = row.age = value;
        row.standing = SignalRow::Standing::Fresh;
        row.history.assign(120, static_cast<float>(std::isfinite(value) ? 1.0 : value));
        row.history[60] = std::numeric_limits<float>::max();
        rows.push_back(row);
    }
    SignalTable table;
    table.resize(900, 300);
    table.setRows(rows);
    table.show();
    EXPECT_FALSE(gui::painted(table).isNull());
    EXPECT_EQ(table.text(0, SignalTable::Age), "--");
}

TappedFrame attitude(double age)
{
    TappedFrame frame;
    frame.kind = FrameKind::Attitude;
    frame.newest = pack({.kind = FrameKind::Attitude, .values = {0.21, -0.05, 1.0}});
    frame.rate = 20.0;
    frame.age = age;
    frame.payload.resize(3);
    for (std::size_t i = 0; i < 3; ++i)
        frame.payload[i] = {.last = 0.21, .least = -0.5, .most = 0.5, .history = {}};
    return frame;
}

TEST(SignalRows, haveValueUnitRateAgeAndExtremes)
{
    SignalTable table;
    table.setRows(signalRows({attitude(0.04)}));
    ASSERT_EQ(table.rows(), 3);
    EXPECT_EQ(table.text(0, SignalTable::Frame), "022 Attitude");
    EXPECT_EQ(table.text(0, SignalTable::Name), "Pitch");
    EXPECT_EQ(table.text(0, SignalTable::Value), "0.2100");
    EXPECT_EQ(table.text(0, SignalTable::Unit), "rad");
    EXPECT_EQ(table.text(0, SignalTable::Rate), "20.0 Hz");
    EXPECT_EQ(table.text(0, SignalTable::Age), "40 ms");
    EXPECT_EQ(table.text(0, SignalTable::Least), QString::fromUtf8("\u22120.5000"));
    EXPECT_EQ(table.text(1, SignalTable::Frame), "") << "once for a frame";
}

TEST(SignalRows, staleOnesReadNothing)
{
    SignalTable table;
    table.setRows(signalRows({attitude(0.151)}));
    EXPECT_EQ(table.text(0, SignalTable::Value), "--");
    EXPECT_EQ(table.text(0, SignalTable::Age), "151 ms");
    TappedFrame unmeasured = attitude(0.04);
    unmeasured.isMeasured = false;
    unmeasured.payload[2].last = 0.0;
    table.setRows(signalRows({unmeasured}));
    EXPECT_EQ(table.text(0, SignalTable::Value), "--");
    EXPECT_EQ(table.text(2, SignalTable::Value), "no") << "that it was not measured is fresh";
}

TEST(SignalRows, whatWasSaidOnceCanStillBeRead)
{
    TappedFrame frame;
    frame.kind = FrameKind::PressFlippers;
    frame.newest = pack({.kind = FrameKind::PressFlippers, .values = {3.0, 18.0}});
    frame.age = 7.0;
    frame.payload.resize(2);
    frame.payload[1].last = 18.0;
    const auto rows = signalRows({frame});
    EXPECT_EQ(rows[1].standing, SignalRow::Standing::Said);
    EXPECT_EQ(rows[1].value, "18.00");
}

TEST(Load, saysWhatItAssumesOrThatItIsNotKnown)
{
    BusLoad load;
    load.fewestBits = 100'000.0;
    load.mostBits = 120'000.0;
    EXPECT_EQ(loadWords(load, {.bitsPerSecond = 500'000.0}),
              "load 20.0 to 24.0 % of 500 kbit/s (without stuff bits, with all there can be)");
    EXPECT_EQ(loadWords(load, {.bitsPerSecond = 500'000.0, .nominal = true}),
              "load 20.0 to 24.0 % of nominal 500 kbit/s (without stuff bits, with all there can "
              "be)");
    EXPECT_EQ(loadWords(load, {}), "load --- (bit rate not known): 100.0 to 120.0 kbit/s");
}

TEST(Filter, takesAnIdentifierOrAPartOfTheName)
{
    const CanFrame frame{.id = 0x22, .length = 8};
    struct Case {
        const char* text;
        bool passes;
    };
    for (const Case& c : {Case{"", true}, Case{"22", true}, Case{"0x022", true}, Case{" 22 ", true},
                          Case{"atti", true}, Case{"23", false}, Case{"222", false},
                          Case{"heart", false}, Case{"ffffffffff", false}})
        EXPECT_EQ(TraceFilter(c.text).passes(frame, "Attitude"), c.passes) << c.text;
}

TEST(RawTraceWidget, showsTheNewestFirstFiltersAndHolds)
{
    RawTrace trace([](const CanFrame&) { return TraceWords(); },
                   [](const CanFrame& f) { return f.id == 0x22 ? "Attitude" : "other"; });
    const auto frames = [](std::uint32_t id, std::uint64_t count) {
        std::vector<TracedFrame> made;
        for (std::uint64_t i = 1; i <= count; ++i)
            made.push_back({.number = i, .frame = {.id = id}});
        return made;
    };
    const auto cell = [&](int row, int column) {
        return trace.view()->model()->index(row, column).data().toString();
    };
    auto mixed = frames(0x22, 5);
    mixed[1].frame.id = 0x33;
    trace.setFrames(mixed);
    EXPECT_EQ(cell(0, 0), "5");
    trace.filter()->setText("33");
    EXPECT_EQ(trace.view()->model()->rowCount(), 1);
    EXPECT_EQ(cell(0, 0), "2");
    trace.filter()->clear();
    trace.pauseButton()->click();
    trace.setFrames(frames(0x22, 9));
    EXPECT_EQ(cell(0, 0), "5") << "held";
    trace.pauseButton()->click();
    trace.setFrames(frames(0x22, 9));
    EXPECT_EQ(cell(0, 0), "9");
}

// Measuring.

TEST(NewestValues, quantilesAreOfTheNewest)
{
    NewestValues values(100);
    EXPECT_EQ(values.quantile(0.99), 0.0);
    for (int i = 1; i <= 250; ++i) values.add(i);
    EXPECT_EQ(values.count(), 100U);
    EXPECT_EQ(values.quantile(0.0), 151.0);
    EXPECT_EQ(values.quantile(0.5), 200.0);
    EXPECT_EQ(values.quantile(0.99), 249.0);
    EXPECT_EQ(values.most(), 250.0);
    EXPECT_THROW((void)values.quantile(1.1), std::invalid_argument);
}

TEST(LoopMeter, countsWhatABeatIsLate)
{
    LoopMeter meter(0.01);
    for (const double beat : {5.0, 5.01, 5.05, 5.055}) meter.beat(beat);
    EXPECT_EQ(meter.lateness().count(), 3U);
    EXPECT_NEAR(meter.lateness().most(), 0.03, 1e-9);
    EXPECT_NEAR(meter.lateness().quantile(0.0), 0.0, 1e-9) << "early is not late";
    meter.frame(0.004, 0.02);
    meter.frame(0.005, -1.0);
    EXPECT_EQ(meter.frames().count(), 2U);
    EXPECT_EQ(meter.latencies().count(), 1U);
    EXPECT_THROW(LoopMeter(0.0), std::invalid_argument);
}

TEST(EventWatch, keepsTheLongestEventsOfTheInnermostLoop)
{
    EventWatch watch;
    const auto handle = [&watch](int level, double seconds, const char* what) {
        ASSERT_TRUE(watch.begins(level));
        EXPECT_FALSE(watch.begins(level)) << "what it sends meanwhile is part of it";
        if (watch.ends(level, seconds)) watch.keep({seconds, what, {}});
    };
    const auto kept = [&watch] {
        QStringList all;
        for (const LongEvent& event : watch.longest()) all << event.what;
        return all.join(' ');
    };
    EXPECT_FALSE(watch.begins(0)) << "there is no loop yet";
    handle(1, 0.2, "b");
    handle(1, 0.3, "a");
    handle(1, 0.1, "d");
    handle(1, 0.15, "c");
    EXPECT_EQ(kept(), "a b c");
    ASSERT_TRUE(watch.begins(1));
    handle(2, 0.25, "button");
    EXPECT_FALSE(watch.ends(1, 9.0)) << "while a dialog is open its events are handled";
    EXPECT_EQ(kept(), "a button b");
    handle(1, 0.5, "afterwards");
    EXPECT_EQ(kept(), "afterwards a button");
}

TEST(ConsoleDiagnostics, sayWhichEventsTookLongest)
{
    const auto text = [](const ConsoleFacts& facts) {
        return plainText(consoleDiagnostics(facts, LoopMeter(0.01)));
    };
    EXPECT_TRUE(text({}).contains("longest events: --\n"));
    ConsoleFacts facts;
    facts.longest = {{0.2, "Timer for QTimer", QTime(1, 2, 3)}, {0.1, "Paint for QWidget", {}}};
    EXPECT_TRUE(text(facts).contains("200.0 ms at 01:02:03: Timer for QTimer\n100.0 ms at"));
}

// The console with a robot on a bus.

struct Pages : testing::Test {
    static void SetUpTestSuite()
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
    }
    void open(const QStringList& dbc = {})
    {
        SimulatedRobot::Options simulation;
        simulation.startX = 2.0;
        robot = std::make_unique<RobotInProcess>(
            bus, model, SimulatedRobot(model, demoTerrain(), simulation), RobotOnBus::Options{});
        auto source = std::make_unique<CanSource>(
            bus.join("can0"), model,
            CanSource::Options{.mode = CanSource::Mode::Transmit, .bitrate = 500'000.0});
        MainWindow::Options options;
        options.robot = model;
        options.link = source.get();
        options.source = std::move(source);
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
        options.sounder = std::make_unique<CountingSounder>(sounds);
        window = std::make_unique<MainWindow>(std::move(options));
        window->resize(1280, 720);
        gui::showActive(*window);
    }
    ~Pages() override
    {
        window.reset();  // its source lives on the bus
        robot.reset();
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
    RobotModel model = absolem();
    MemoryBus bus{steadyNow};
    std::unique_ptr<RobotInProcess> robot;
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
    EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
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
        directory.write("bad.dbc", "BO_ 9 Bad: 8 P\n SG_ S : 60|8@1+ (1,0) [0|0] \"\" C\n");
        payload = bus.join("payload");
        QObject::connect(&sending, &QTimer::timeout, [this] {
            std::array<BusFrame, 64> heard;
            (void)payload->receive(heard, std::chrono::milliseconds(0));  // as an end that lives
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
    EXPECT_EQ(window->signalsPage()->dbcFiles(), "DBC files: gas.dbc (frames: 2)");
    EXPECT_EQ(window->signalsPage()->dbcTroubles(), "");
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
    EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
    sending.stop();
    EXPECT_TRUE(eventually([&] {
        for (const TappedFrame& frame : window->link()->tap().frames(steadyNow()))
            if (frame.described && frame.times[0].age > frame.times[0].fresh) return true;
        return false;
    })) << "goes grey";
}

TEST_F(ForeignFramesOnThePage, whatIsWrongWithAFileIsSaidAndStopsNothing)
{
    open({file("gas.dbc"), file("clash.dbc"), file("bad.dbc"), file("none.dbc")});
    QTest::keyClick(window.get(), Qt::Key_F5);
    ASSERT_TRUE(eventually([&] { return valueOf("Oxygen") == "20.71"; }));
    const SignalsPage* page = window->signalsPage();
    EXPECT_EQ(page->dbcFiles(),
              "DBC files: gas.dbc (frames: 2), clash.dbc (frames: 0), bad.dbc (not "
              "used), none.dbc (not used)");
    const QStringList troubles = page->dbcTroubles().split('\n');
    ASSERT_EQ(troubles.size(), 4);
    EXPECT_TRUE(troubles[0].contains("bad.dbc: line 2: the signal S does not fit"));
    EXPECT_TRUE(troubles[0].contains("correct its first bit"));
    EXPECT_TRUE(troubles[1].contains("none.dbc: cannot be opened"));
    EXPECT_TRUE(troubles[2].contains("frame 022: the robot's protocol has that identifier"));
    EXPECT_EQ(troubles[3], QString::fromUtf8("… and 1 more, all of them in the tip here"));
    EXPECT_TRUE(eventually([&] { return valueOf("Pitch") != "--"; })) << "the protocol wins";
    window->resize(window->minimumSize());
    QTest::qWait(300);
    picture("signals-foreign-troubles");
    EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
}

TEST_F(ForeignFramesOnThePage, filesComeAndGoWhileItRuns)
{
    open();
    QTest::keyClick(window.get(), Qt::Key_F5);
    const SignalsPage* page = window->signalsPage();
    EXPECT_TRUE(page->addDbcButton()->isVisible());
    EXPECT_FALSE(page->removeDbcButton()->isVisible());
    ASSERT_TRUE(eventually([&] { return window->link()->tap().frames(steadyNow()).size() > 10; }));
    QTest::mouseClick(page->addDbcButton(), Qt::LeftButton);
    auto* dialog = page->findChild<QFileDialog*>();
    ASSERT_TRUE(dialog);
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(file("gas.dbc"));
    QMetaObject::invokeMethod(dialog, "accept");
    ASSERT_TRUE(eventually([&] { return valueOf("Oxygen") == "20.71"; }));
    EXPECT_EQ(window->preferences().current().dbc, QStringList{file("gas.dbc")}) << "remembered";
    ASSERT_TRUE(page->removeDbcButton()->isVisible());
    ASSERT_EQ(page->removeDbcButton()->menu()->actions().size(), 1);
    page->removeDbcButton()->menu()->actions().first()->trigger();
    EXPECT_TRUE(eventually([&] { return valueOf("Oxygen") == "no such signal"; }));
    EXPECT_EQ(window->preferences().current().dbc, QStringList());
    EXPECT_FALSE(page->removeDbcButton()->isVisible());
}

TEST_F(Pages, whatIsTypedIntoTheFilterMovesNoRobot)
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
    QTest::qWait(300);
    EXPECT_EQ(sounds, 1) << "bus and link at once";
    EXPECT_EQ(window->header()->alarmsButton()->text(), QString::fromUtf8("▲ alarms: 2"));
    QTest::mouseClick(window->header()->alarmsButton(), Qt::LeftButton);
    EXPECT_EQ(window->rail()->chosen(), window->rail()->pageOf(Qt::Key_F4));
    ASSERT_TRUE(
        eventually([&] { return window->alarmsPage()->table()->table()->rowCount() == 2; }));
    QTest::qWait(100);
    picture("alarms");
    EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
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
    EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
    QTest::mouseClick(window->diagnosticsPage()->copyButton(), Qt::LeftButton);
    const QString text = QApplication::clipboard()->text();
    for (const char* part : {"Qt: 6.", "Qwt: 6.", "Eigen: 3.", "OpenBLAS: ", "Linux",
                             "CAN socket: ", "estimator uses: ", "fake.ttm", "made up", "can0",
                             "telemetry to screen: half ≤"})
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
        EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
    }
}

}  // namespace
}  // namespace terratact
