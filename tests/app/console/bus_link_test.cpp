// Tests the console's view of the bus: lost link, silence, receive-only mode, replay of a log.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <functional>
#include <future>
#include <limits>
#include <string>
#include <vector>

#include "app/console/main_window.h"
#include "app/recording/session_folder.h"
#include "app/runtime/resources.h"
#include "core/log/review_moment.h"
#include "core/log/review_strip.h"
#include "core/log/session_reader.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/wire/frame_layout.h"
#include "drivers/log_replay.h"
#include "tests/support/benches/bus_console_bench.h"
#include "tests/support/benches/staged_robot.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/held_button.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;
using gui::eventually;

TEST_F(BusConsole, reviewShowsOverridesAndTelemetryGaps)
{
    StagedRobot tilted = stagedRobot();
    tilted.stage({.roll = 0.2});
    const TemporaryDirectory folder;
    openRecordedOn(folder);
    Exploration& exploration = window->exploration();
    ASSERT_TRUE(eventually([&] { return exploration.linkAlive(); }));
    exploration.overrideWarnings();
    ASSERT_TRUE(armsOnce() && exploresAndProbes());
    tilted.stage({.roll = 0.2, .isMute = true});
    QTest::qWait(static_cast<int>(1000.0 * kMaxSilence) + 300);  // longer than a gap that withholds
    tilted.stage({.roll = 0.2});
    const auto isWithheld = [&] {
        const auto verdict = exploration.estimation().verdict();
        return verdict
            && std::ranges::count(verdict->side[0].withheldFor, WithholdReason::TelemetryGap) == 1;
    };
    ASSERT_TRUE(eventually(isWithheld));
    window.reset();
    recording.reset();

    auto session = SessionReader::open(sessionsIn(folder.file("sessions")).front());
    ASSERT_TRUE(session) << session.error().text;
    const auto kinds = [&](EventKind kind) {
        return std::ranges::count(session->events(), kind, &EventRow::kind);
    };
    EXPECT_EQ(kinds(EventKind::TelemetryGap), 1);
    ReviewMoments moments(*session, model);
    const ReviewMoment last = moments.at(session->end());
    ASSERT_TRUE(last.scene);
    EXPECT_FALSE(last.unbroken);
    EXPECT_NE(last.overridden.english().find("roll"), std::string::npos);
    EXPECT_TRUE(moments.at(last.scene->time).unbroken);
}

/// Returns the largest difference [m] of places, heights and sd; infinite if one strip lacks a bin of the other.
double farthestApart(const SeenStrip& a, const SeenStrip& b)
{
    double most = 0.0;
    for (std::size_t side = 0; side < 2; ++side) {
        if (a.side[side].size() != b.side[side].size())
            return std::numeric_limits<double>::infinity();
        for (std::size_t bin = 0; bin < a.side[side].size(); ++bin) {
            const SeenBin &one = a.side[side][bin], &other = b.side[side][bin];
            most = std::max({most, std::abs(one.x - other.x),
                             std::abs(one.band.height - other.band.height),
                             std::abs(one.band.sd - other.band.sd)});
        }
    }
    return most;
}

TEST_F(BusConsole, aReviewRemembersTheGroundThatTheConsoleRemembered)
{
    const TemporaryDirectory folder;
    startQuickRobot();
    openRecordedOn(folder);
    const Estimation& estimation = window->exploration().estimation();
    const auto hasMoved = [&] {
        const SeenStrip seen = estimation.remembered();
        return !estimation.estimate() && !seen.isEmpty() && seen.side[0].front().way > 0.05;
    };
    ASSERT_TRUE(exploresAndProbes() && drives());
    ASSERT_TRUE(eventually([&] { return hasMoved() || !robotDoes(RobotActivity::Driving); }));
    ASSERT_TRUE(hasMoved());
    QTest::keyRelease(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Halted));
    QTest::qWait(300);
    QTest::keyClick(window.get(), Qt::Key_K);  // sets a marker at this moment
    const SeenStrip shown = estimation.remembered();
    ASSERT_FALSE(shown.isEmpty());
    QTest::keyClick(window.get(), Qt::Key_Delete);
    ASSERT_TRUE(eventually([&] { return estimation.remembered().isEmpty(); })) << "it was cleared";
    QTest::qWait(100);
    window.reset();
    recording.reset();

    auto session = SessionReader::open(sessionsIn(folder.file("sessions")).front());
    ASSERT_TRUE(session) << session.error().text;
    const auto marker = std::ranges::find(session->events(), EventKind::Marker, &EventRow::kind);
    ASSERT_NE(marker, session->events().end());
    const SessionTime marked = marker->time;
    ReviewMoments moments(*session, model);
    ReviewStrip strips(*session, model);
    const SeenStrip reviewed = strips.at(moments.at(marked)).seen;
    ASSERT_FALSE(reviewed.isEmpty());
    // The file gives the newest telemetry at the marker only to within a few lines, which differ by pitch noise.
    double nearest = std::numeric_limits<double>::infinity();
    for (auto t = moments.frameAfter(marked - sessionTimeOf(0.3));
         t && *t < marked + sessionTimeOf(0.1); t = moments.frameAfter(*t))
        nearest = std::min(nearest, farthestApart(strips.at(moments.at(*t)).seen, shown));
    EXPECT_LT(nearest, 5e-3);
    EXPECT_TRUE(strips.at(moments.at(session->end())).seen.isEmpty()) << "it was cleared";
    EXPECT_EQ(strips.at(moments.at(marked)).seen, reviewed) << "however one came there";
}

TEST_F(BusConsole, aPendingDriveEndsWhenItsKeyIsReleased)
{
    StagedRobot slow = stagedRobot();
    openOn();
    Exploration& exploration = window->exploration();
    ASSERT_TRUE(eventually([&] { return exploration.linkAlive(); }));
    const auto way = [&] { return window->acquisition().latest()->sample.measurement.travelled; };
    const auto explores = [&] {
        const auto said = window->link()->view().link.robot;
        return said && said->exploring;
    };
    /// Ends an exploration while the robot is still slow to react; its late result must not appear.
    const auto waitsInVain = [&](const std::function<void()>& end) {
        arm();
        slow.stage({.explores = true});
        ASSERT_TRUE(eventually(explores));
        const auto before = way();
        exploration.drive(+1);
        end();
        slow.stage({});
        ASSERT_TRUE(eventually([&] { return !explores(); }));
        QTest::qWait(300);  // waits for an event that must not come
        EXPECT_EQ(way(), before);
        EXPECT_EQ(window->events()->findItems("command not sent", Qt::MatchContains).size(), 0);
    };
    waitsInVain([&] { exploration.halt(); });
    waitsInVain([&] { window->link()->disarm(); });
    waitsInVain([&] { exploration.stop(); });
    window.reset();
}

TEST_F(BusConsole, theNextExplorationWaitsForTheEndOfTheOneBefore)
{
    StagedRobot slow = stagedRobot();
    openOn();
    Exploration& exploration = window->exploration();
    ASSERT_TRUE(exploresUntilAsked());
    slow.stage({.explores = true});
    QTest::keyClick(window.get(), Qt::Key_Escape);
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    exploration.request();
    ASSERT_TRUE(reaches(AtemPhase::Halting));
    slow.stage({});
    EXPECT_TRUE(gets(AtemPhase::ProposingProbe));
    EXPECT_EQ(window->events()->findItems("command not sent", Qt::MatchContains).size(), 0);
    window.reset();
}

TEST_F(BusConsole, anExplorationThatTheRobotDoesNotBeginFails)
{
    StagedRobot slow = stagedRobot();
    slow.stage({.explores = false});
    const auto recorder = bus.join("recorder", 0);
    openOn();
    arm();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    const auto begins = [&] {
        std::size_t count = 0;
        for (const BusFrame& heard : framesOf(*recorder))
            count += heard.frame.id == layoutOf(FrameKind::BeginAtem).id ? 1U : 0U;
        return count;
    };
    window->exploration().request();
    ASSERT_TRUE(reaches(AtemPhase::Failed));
    EXPECT_EQ(window->exploration().state().failure, AtemFailure::BeginTimeout);
    EXPECT_GT(begins(), 1U) << "it was asked again";
    window.reset();
}

TEST_F(BusConsole, isReceiveOnlyWithoutTransmit)
{
    open(CanSource::Mode::Listen);
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    EXPECT_FALSE(window->header()->arming()->armButton()->isEnabled());
    EXPECT_TRUE(window->header()->arming()->armButton()->toolTip().contains("--transmit"));
    EXPECT_FALSE(window->drivePad()->forwardButton()->isEnabled());
    QTest::keyClick(window.get(), Qt::Key_F12);
    EXPECT_TRUE(eventually([&] { return says("STOP HAS NO EFFECT HERE"); }));
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::Idle) << "nothing is stopped";
    QPushButton& stop = *window->header()->stopButton();
    EXPECT_EQ(stop.text(), "STOP: no commands");
    const QImage image = gui::painted(stop);
    EXPECT_EQ(image.pixelColor(12, image.height() / 2), theme().chip.area) << "it looks like none";
    EXPECT_EQ(window->link()->view().frames.sent, 0U);
    picture("listening");
}

/// Geometry of the page's parts and the texts of the terrain.
struct TerrainLook {
    QList<QRect> places;
    QStringList says;
    bool operator==(const TerrainLook&) const = default;
};

TerrainLook styleOf(const MainWindow& console)
{
    TerrainLook look;
    const auto place = [&](const QWidget* part) {
        return QRect(part->mapTo(&console, QPoint()), part->size());
    };
    const QWidget* const parts[]{console.verdict(), console.terrain(),  console.forces(),
                                 console.readout(), console.drivePad(), console.events()};
    for (const QWidget* part : parts) look.places << place(part);
    // The preconditions may take one line more; the neighbour in the column gives that line.
    look.places << place(console.atemPanel()).united(place(console.probeCard()));
    // STOP is wider in windows where it has no effect, because its text is longer.
    const QRect stop = console.header()->stopButton()->geometry();
    look.places << QRect(stop.topRight(), stop.bottomRight());
    look.says << console.verdict()->badge() << console.verdict()->question()
              << console.terrain()->accessibleDescription();
    return look;
}

TEST_F(BusConsole, listenerAndReplayShowTheSameEstimates)
{
    const auto shipped = [this] {
        return modelFileLoader(resourcePath("models/default.ttm"), model);
    };
    const auto recorder = bus.join("recorder", 0);
    startQuickRobot();
    const auto listener = console(bus.join("can1"), CanSource::Mode::Listen, shipped());
    const Estimates heard(listener->exploration());
    window = console(bus.join("can0"), CanSource::Mode::Transmit, shipped());
    const Estimates made(window->exploration());
    gui::showActive(*listener);
    gui::showActive(*window);
    for (MainWindow* one : {listener.get(), window.get()})
        EXPECT_TRUE(eventually([&] { return modelInUse(*one) == "default.ttm"; }));
    ASSERT_TRUE(armsOnce() && exploresAndProbes());
    ASSERT_TRUE(eventually([&] { return heard.all().size() == 2; }));
    const auto ledger = window->exploration().estimation().ledger().entries();
    const auto isDrawn = [](const MainWindow& console) {  // a touched bin
        return console.terrain()->accessibleDescription().contains(", arm");
    };
    ASSERT_TRUE(eventually([&] { return isDrawn(*window) && isDrawn(*listener); }));
    (void)eventually([&] { return styleOf(*listener) == styleOf(*window); });
    EXPECT_EQ(styleOf(*listener).says.join('\n').toStdString(),
              styleOf(*window).says.join('\n').toStdString());
    EXPECT_EQ(styleOf(*listener).places, styleOf(*window).places);
    const TerrainLook look = styleOf(*window);
    EXPECT_NE(look.says.first(), VerdictStrip::tr("NO VERDICT"));
    const TemporaryDirectory directory;
    const std::string log = directory.write("atem.log", candumpOf(*recorder));
    window.reset();

    auto replay = LogReplay::open(log, {.speed = 2.0});
    ASSERT_TRUE(replay) << replay.error().text;
    window = console(std::move(*replay), CanSource::Mode::Replay, shipped());
    const Estimates replayed(window->exploration());
    gui::showActive(*window);
    ASSERT_TRUE(eventually([&] { return replayed.all().size() == 1; }));
    picture("following");
    ASSERT_TRUE(eventually([&] { return window->exploration().ended(); }));
    ASSERT_TRUE(eventually([&] { return replayed.all().size() == 2; }));
    ASSERT_EQ(made.all().size(), 2U);
    const auto armBins = [&](std::size_t which) {
        const auto& estimate = made.all()[which];
        const auto armBinsOf = [](const TerrainEstimate& side) {
            return std::ranges::count(side.origin, Origin::Arm);
        };
        const auto left = armBinsOf(estimate.side[0]), right = armBinsOf(estimate.side[1]);
        return estimate.onePlane ? left : left + right;  // one plane: both sides are the same
    };
    EXPECT_EQ(armBins(0), 0);
    EXPECT_EQ(armBins(1), 1) << "of either side: noise decides which is less certain";
    EXPECT_EQ(heard.all(), made.all());
    EXPECT_EQ(replayed.all(), made.all());
    ASSERT_EQ(ledger.size(), 1U);
    EXPECT_EQ(listener->exploration().estimation().ledger().entries(), ledger);
    EXPECT_TRUE(eventually([&] { return window->probeCard()->showsWorth(); }))
        << "what a probe would buy is known here, too";
    EXPECT_FALSE(window->probeCard()->asks());
    ASSERT_TRUE(eventually([&] { return isDrawn(*window); }));
    EXPECT_EQ(styleOf(*window).says.join('\n').toStdString(), look.says.join('\n').toStdString());
    EXPECT_EQ(styleOf(*window).places, look.places);
    EXPECT_EQ(window->exploration().estimation().ledger().entries(), ledger);
    EXPECT_EQ(listener->link()->view().frames.sent, 0U);
}

TEST_F(BusConsole, aLogHasAnEndAndNoLostLink)
{
    auto replay = LogReplay::open(TERRATACT_SOURCE_DIR "/docs/can_demo.log", {});
    ASSERT_TRUE(replay) << replay.error().text;
    std::promise<void> loaded;
    window = console(std::move(*replay), CanSource::Mode::Replay,
                     [loaded = loaded.get_future().share()] {
                         (void)loaded.wait_for(20s);
                         return Result<LoadedModel>(madeUp());
                     });
    gui::showActive(*window);
    QTest::qWait(500);  // longer than the log
    EXPECT_FALSE(says("END OF THE LOG")) << "its press waits for the model";
    loaded.set_value();
    ASSERT_TRUE(eventually([&] { return says("END OF THE LOG"); }));
    QTest::qWait(500);  // longer than the link watchdog
    EXPECT_TRUE(says("END OF THE LOG"));
    EXPECT_FALSE(says("LINK LOST"));
    EXPECT_TRUE(says("the log has ended"));
    for (const Alarm& alarm : window->alarms().list().alarms()) {
        // This log's forces contradict its activity, so SensorWatch raises alarms.
        if (alarm.id.starts_with("sensor")) continue;
        EXPECT_EQ(alarm.severity, Severity::Caution) << alarm.text.english();
        for (const char* id : {"link", "silence", "bus"})
            EXPECT_NE(alarm.id, id) << alarm.text.english();
    }
    QTest::keyClick(window.get(), Qt::Key_F5);
    EXPECT_TRUE(eventually([&] { return says("REPLAY can_demo.log has ended"); }));
    for (const QLabel* label : window->findChildren<QLabel*>())
        EXPECT_FALSE((label->text() + label->toolTip()).contains("does not exist"));
    QTest::keyClick(window.get(), Qt::Key_F2);
    EXPECT_TRUE(says("Following"));
    const Estimation& estimation = window->exploration().estimation();
    EXPECT_TRUE(eventually([&] { return estimation.estimate().has_value(); }));
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    picture("end-of-the-log");
}

TEST_F(BusConsole, aPausedLogIsNoLostLink)
{
    auto replay = LogReplay::open(TERRATACT_SOURCE_DIR "/docs/can_demo.log", {.speed = 0.5});
    ASSERT_TRUE(replay) << replay.error().text;
    hasReplayBar = true;
    window = console(std::move(*replay), CanSource::Mode::Replay,
                     [] { return Result<LoadedModel>(madeUp()); });
    gui::showActive(*window);
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    QTest::keyClick(window.get(), Qt::Key_Space, Qt::ControlModifier);
    QTest::qWait(1500);  // longer than the link watchdog
    EXPECT_TRUE(says("paused at"));
    EXPECT_TRUE(window->exploration().linkAlive());
    EXPECT_FALSE(says("LINK LOST"));
    QTest::keyClick(window.get(), Qt::Key_Space, Qt::ControlModifier);
    EXPECT_TRUE(eventually([&] { return says("END OF THE LOG"); }));
}

TEST_F(BusConsole, aKerbOnTheLeftIsProbedOnASideOverTheBus)
{
    const TerrainProfile kerb({{0.0, 0.0}, {2.499, 0.0}, {2.5, 0.16}, {6.0, 0.16}});
    SimulatedRobot::Options simulation;
    simulation.startX = 1.96;
    // The number of received frames decides the draws of the noise. A tenth of the usual noise cannot change a verdict.
    simulation.noise = {.pitch = 8.7e-4,
                        .flipperAngle = 1.7e-4,
                        .current = 5e-3,
                        .forceShare = 0.01,
                        .forceFloor = 0.03};
    const StagedRobot uneven(
        bus, model,
        SimulatedRobot(model, GroundLines({{0.2, kerb}, {-0.2, flatTerrain(6.0)}}), simulation),
        RobotOnBus::Options{.firstEpoch = 9, .speed = 10.0}, time());
    window = console(bus.join("can0"), CanSource::Mode::Transmit,
                     modelFileLoader(resourcePath("models/default.ttm"), model));
    gui::showActive(*window);
    const Estimation& estimation = window->exploration().estimation();
    std::optional<ProbeProposal> asked;
    std::string before;
    QObject::connect(&window->exploration(), &Exploration::proposed, window.get(), [&] {
        asked = window->exploration().proposal();
        before = describe(*estimation.verdict());
    });
    ASSERT_TRUE(armsOnce() && exploresAndProbes());
    EXPECT_EQ(before, "left BLOCKED at +0.6 m · right CLEAR to +0.55 m");
    ASSERT_TRUE(asked);
    EXPECT_NE(asked->side, ProbeSide::Middle);
    ASSERT_EQ(estimation.readings().size(), 1U);
    EXPECT_EQ(estimation.readings()[0].side, asked->side) << "the arm touched what was approved";
    EXPECT_EQ(estimation.readings()[0].bin, asked->bin);
    EXPECT_EQ(
        sideOf(*estimation.estimate(), asked->side).origin[static_cast<std::size_t>(asked->bin)],
        Origin::Arm);
}

}  // namespace
}  // namespace terratact
