// Tests the conditions of alarms, and the alarm table.
#include <gtest/gtest.h>

#include "app/display/translated.h"
#include "app/mission/console_alarms.h"
#include "tests/support/bytes/messages.h"
#include "tests/support/devices/counting_alarm_sound.h"
#include "tests/support/gui.h"
#include "widgets/signals/alarm_table.h"

namespace terratact {
namespace {

struct Alarming : testing::Test {
    int sounds = 0;
    ConsoleAlarms alarms{std::make_unique<CountingAlarmSound>(sounds)};
    double now = 1000.0;
    static constexpr LinkAccount kUp{.standing = LinkStanding::Up, .alive = true},
        kLost{.standing = LinkStanding::Lost, .gaps = 1};
    AlarmViewState viewState{.link = kUp, .bus = CanView{.busName = "can0"}};

    void pass(double seconds)
    {
        for (const double until = now + seconds; now < until; now += 0.04)
            alarms.poll(now, viewState);
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
        if (!mentions(alarm->text, part))
            return testing::AssertionFailure() << alarm->text.english();
        return testing::AssertionSuccess();
    }
    bool stands(const std::string& id) const
    {
        const Alarm* alarm = find(id);
        return alarm && alarm->state == AlarmState::Unacknowledged;
    }
};

TEST_F(Alarming, aRobotWithoutFaultsRaisesNoAlarm)
{
    pass(20.0);
    EXPECT_TRUE(alarms.list().alarms().empty());
    EXPECT_EQ(sounds, 0);
}

TEST_F(Alarming, namesASensorThatMayLieAndItsKind)
{
    viewState.suspicions = {{.sensor = Sensor::Pitch, .amount = 12.0, .way = 0.6}};
    pass(0.1);
    EXPECT_TRUE(says("sensor-fault",
                     "pitch angle: not changed for 12 s while the robot drove 0.6 m, stuck?"));
    EXPECT_EQ(sounds, 1);
    viewState.suspicions.clear();
    viewState.isSceneSuspected = true;
    pass(5.0);
    EXPECT_TRUE(stands("sensor-fault")) << "a verdict is withheld for it";
    viewState.isSceneSuspected = false;
    pass(2.0);
    EXPECT_FALSE(stands("sensor-fault"));
}

TEST_F(Alarming, joinsSensorsWithTheSameTrouble)
{
    for (const Sensor sensor : {Sensor::Force1, Sensor::Force2})
        viewState.suspicions.push_back({.sensor = sensor, .trouble = SensorTrouble::NoLoad});
    pass(0.1);
    EXPECT_TRUE(says("sensor-fault", "force 1, force 2: no load while the flippers press"));
}

TEST_F(Alarming, alarmsForSteepPitchBeforeTheRobotTips)
{
    viewState.measurement = Measurement{};
    viewState.measurement->pitch = 0.6;
    viewState.attitude = {.pitch = AttitudeLevel::Amber, .pitchTips = 0.9};
    pass(1.0);
    EXPECT_TRUE(says("attitude", "Steep: pitch +34"));
    EXPECT_EQ(sounds, 0);
    viewState.attitude.pitch = AttitudeLevel::Red;
    pass(1.0);
    EXPECT_TRUE(says("attitude", "Danger of tipping over: pitch +34"));
    EXPECT_EQ(sounds, 1);
    viewState.attitude = {};
    pass(2.0);
    EXPECT_FALSE(stands("attitude"));
}

TEST_F(Alarming, givesTheReasonOfTheRobotsOwnHalt)
{
    viewState.measurement = Measurement{};
    viewState.measurement->activity = RobotActivity::Driving;
    pass(1.0);
    viewState.measurement->activity = RobotActivity::Halted;
    viewState.measurement->refusal = Refusal::NoRestPose;
    pass(1.0);
    EXPECT_TRUE(says("halted", "halted by itself: the robot finds no pose to rest in there"));
    viewState.measurement->activity = RobotActivity::Driving;
    viewState.measurement->refusal = Refusal::None;
    pass(2.0);
    EXPECT_FALSE(stands("halted"));
}

TEST_F(Alarming, aRequestedHaltRaisesNoAlarm)
{
    viewState.measurement = Measurement{};
    viewState.measurement->activity = RobotActivity::Driving;
    pass(1.0);
    viewState.measurement->activity = RobotActivity::Halted;
    pass(1.0);
    EXPECT_FALSE(find("halted"));
}

TEST_F(Alarming, lostLinkSoundsOnceThenSeldomAndIsSilentOnReturn)
{
    viewState.link = kLost;
    viewState.sourceTrouble = Message::verbatim("can0 is down");
    pass(1.0);
    EXPECT_TRUE(says("link", "can0 is down"));
    EXPECT_EQ(sounds, 1);
    pass(8.0);
    EXPECT_EQ(sounds, 1);
    pass(2.0);
    EXPECT_EQ(sounds, 2);
    viewState.link = kUp;
    pass(30.0);
    EXPECT_EQ(sounds, 2);
    ASSERT_TRUE(find("link")) << "nobody has seen it";
    EXPECT_EQ(find("link")->state, AlarmState::Returned);
}

TEST_F(Alarming, missingTelemetryWithOtherFramesIsNoLostLink)
{
    viewState.link = kLost;
    viewState.link.alone = true;
    pass(1.0);
    EXPECT_TRUE(says("link", "Telemetry lost"));
}

TEST_F(Alarming, aBusWithManyErrorsAlarmsBeforeItFails)
{
    viewState.bus->bus = BusState::ErrorWarning;
    pass(0.5);
    EXPECT_FALSE(find("bus")) << "a second of it is nothing";
    pass(1.0);
    EXPECT_TRUE(says("bus", "can0 has errors"));
    EXPECT_EQ(find("bus")->severity, Severity::Caution);
    viewState.bus->bus = BusState::ErrorPassive;
    pass(3.0);
    EXPECT_TRUE(says("bus", "many errors"));
    QStringList told;
    QObject::connect(&alarms, &ConsoleAlarms::raised,
                     [&](const Message& text, Severity) { told << translated(text); });
    viewState.bus->bus = BusState::BusOff;
    pass(1.0);
    EXPECT_EQ(find("bus")->severity, Severity::Critical);
    EXPECT_EQ(told.size(), 1) << "it has become worse";
}

TEST_F(Alarming, alarmsWithoutABannerAreRaisedOncePerOnset)
{
    QStringList told;
    QObject::connect(&alarms, &ConsoleAlarms::raised,
                     [&](const Message& text, Severity) { told << translated(text); });
    viewState.bus->link.foreignSender = viewState.bus->transmits = true;
    viewState.link = kLost;
    pass(3.0);
    ASSERT_EQ(told.size(), 1) << "the link has a banner";
    EXPECT_TRUE(told.first().startsWith("Another console"));
    viewState.bus->link.foreignSender = false;
    pass(30.0);
    viewState.bus->link.foreignSender = true;
    pass(1.0);
    EXPECT_EQ(told.size(), 2) << "it is back";
}

TEST_F(Alarming, aFlappingLinkIsOneAlarm)
{
    for (int i = 0; i < 20; ++i) {
        viewState.link.standing = i == 0 ? LinkStanding::Lost : LinkStanding::Unsteady;
        viewState.link.gaps = i / 2 + 1;
        viewState.link.longest = 0.4;
        viewState.link.alive = i % 2 == 1;
        pass(0.4);
    }
    EXPECT_EQ(find("link")->raised, 1U);
    EXPECT_TRUE(says("link", "Link unsteady; gaps: 10, the longest 400 ms"));
    EXPECT_EQ(sounds, 1);
}

TEST_F(Alarming, telemetryThatNeverCameAlarmsAfterAWhile)
{
    viewState.link = {};
    pass(ConsoleAlarms::kFirstTelemetry - 0.5);
    EXPECT_TRUE(alarms.list().alarms().empty());
    pass(1.0);
    EXPECT_TRUE(stands("silence"));
}

TEST_F(Alarming, aPausedOrEndedReplayRaisesNoAlarm)
{
    viewState.link = {};
    viewState.bus->waits = true;
    pass(2.0 * ConsoleAlarms::kFirstTelemetry);  // while its model is loading
    viewState.bus->waits = false;
    pass(ConsoleAlarms::kFirstTelemetry - 0.5);
    viewState.link = {.standing = LinkStanding::Ended};
    viewState.bus->ended = true;
    viewState.bus->bus = BusState::Ended;
    pass(20.0);
    for (const Alarm& alarm : alarms.list().alarms()) ADD_FAILURE() << alarm.text.english();
    EXPECT_EQ(sounds, 0);
}

TEST_F(Alarming, busThatIsNotUpNamesTheFix)
{
    viewState.bus->bus = BusState::BusOff;
    pass(0.1);
    EXPECT_TRUE(says("bus", "sudo ip link set can0 type can restart"));
    EXPECT_EQ(find("bus")->severity, Severity::Critical);
}

TEST_F(Alarming, aStalledBusAlarmsOnlyIfItPersists)
{
    viewState.bus->bus = BusState::Stalled;
    pass(0.5);
    EXPECT_FALSE(find("bus"));
    viewState.bus->bus = BusState::Up;
    pass(2.0);
    viewState.bus->bus = BusState::Stalled;
    pass(1.5);
    EXPECT_TRUE(stands("bus"));
    EXPECT_EQ(sounds, 0) << "a caution";
}

TEST_F(Alarming, lostAndDamagedFramesAreCounted)
{
    viewState.bus->frames.dropped = 7;
    viewState.wrongChecksums = 3;
    pass(0.1);
    EXPECT_TRUE(says("dropped", "7 frames"));
    EXPECT_TRUE(says("checksum", "3 with a wrong checksum"));
    alarms.acknowledgeAll();
    pass(GrowingCount::kLately + ConsoleAlarms::kGoneFor + 0.5);
    EXPECT_FALSE(find("dropped")) << "none was lost since";
    viewState.bus->frames.dropped = 8;
    pass(0.1);
    EXPECT_TRUE(stands("dropped"));
}

TEST_F(Alarming, listenersRaiseNoAlarmForAnotherConsole)
{
    viewState.bus->link.foreignSender = true;
    viewState.bus->transmits = false;
    pass(1.0);
    EXPECT_FALSE(find("foreign"));
}

TEST_F(Alarming, unwantedDisarmingAlarmsUntilTheRobotIsRearmed)
{
    const auto goes = [&](ArmingPhase phase, DisarmCause cause = DisarmCause::None) {
        viewState.bus->link.arming = {.phase = phase, .cause = cause};
        pass(0.1);
    };
    goes(ArmingPhase::Disarmed, DisarmCause::ConfirmTimeout);
    EXPECT_FALSE(find("disarmed")) << "it was not armed";
    for (const DisarmCause wanted : {DisarmCause::Operator, DisarmCause::Stop}) {
        goes(ArmingPhase::Armed);
        goes(ArmingPhase::Disarmed, wanted);
        EXPECT_FALSE(find("disarmed")) << describe(wanted).english;
    }
    EXPECT_EQ(sounds, 0);
    for (int i = 0; i <= static_cast<int>(DisarmCause::EpochChanged); ++i) {
        const auto cause = static_cast<DisarmCause>(i);
        if (cause == DisarmCause::Operator || cause == DisarmCause::Stop) continue;
        goes(ArmingPhase::Armed);
        goes(ArmingPhase::Disarmed, cause);
        EXPECT_TRUE(says("disarmed", std::string("Disarmed: ") + describe(cause).english));
        goes(ArmingPhase::Disarmed, DisarmCause::LinkNotGood);  // reported after an attempt to arm
        EXPECT_TRUE(says("disarmed", std::string("Disarmed: ") + describe(cause).english));
        goes(ArmingPhase::Confirming);
        pass(2.0);
        EXPECT_EQ(find("disarmed")->state, AlarmState::Returned);
        alarms.acknowledgeAll();
    }
    EXPECT_GT(sounds, 0);
}

TEST_F(Alarming, otherCauses)
{
    viewState.bus->link.foreignSender = true;
    viewState.bus->transmits = true;
    viewState.noModel = Message::verbatim("no such file");
    viewState.panelTrouble = Message::verbatim("the panel does not answer");
    viewState.failedExploration = Message::verbatim("the estimate failed");
    viewState.isStopped = true;
    viewState.bus->forces.left[2] = ElementForce{0.0, ElementState::Open};
    pass(0.1);
    for (const char* id : {"foreign", "model", "panel", "exploration", "stop"})
        EXPECT_TRUE(stands(id)) << id;
    EXPECT_FALSE(find("sensors"));
    pass(1.5);
    EXPECT_TRUE(says("sensors", std::string("left 3 ") + describe(ElementState::Open).english));
    EXPECT_EQ(sounds, 1) << "all at once sound once";
}

TEST_F(Alarming, soundCanBeSwitchedOff)
{
    alarms.setSoundOn(false);
    viewState.link = kLost;
    pass(30.0);
    EXPECT_EQ(sounds, 0);
    EXPECT_TRUE(stands("link"));
}

TEST(AlarmTableWidget, showsStatesAsTextAndEmitsTheOperatorsActions)
{
    AlarmList list;
    list.raise("seen", Message::verbatim("the first"), Severity::Caution, 0.0);
    list.acknowledge("seen");
    list.raise("over", Message::verbatim("the second"), Severity::Critical, 10.0);
    list.clear("over", 20.0);
    list.raise("new", Message::verbatim("the third"), Severity::Critical, 30.0);
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
    list.raise("newer", Message::verbatim("on top"), Severity::Critical, 96.0);
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

TEST(AlarmTableWidget, selectsNoOtherAlarmWhenTheSelectedOneEnds)
{
    AlarmList list;
    for (const char* id : {"a", "b", "c"})
        list.raise(id, Message::verbatim(id), Severity::Caution, 0.0);
    AlarmTable table;
    QStringList seen;
    QObject::connect(&table, &AlarmTable::acknowledged, [&](const QString& id) { seen << id; });
    table.setAlarms(list.alarms(), 1.0, 0.0);
    gui::showActive(table);
    EXPECT_EQ(table.table()->currentRow(), 0) << "the first is chosen when there was none";
    table.table()->selectRow(1);
    const std::string chosen = list.alarms()[1].id;
    list.clear(chosen, 2.0);
    list.acknowledge(chosen);  // the alarm is gone
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

}  // namespace
}  // namespace terratact
