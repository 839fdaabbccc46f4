// The console as an operator meets it: real mouse and key events in, commands and pictures out.
#include "app/main_window.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QEventLoop>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <algorithm>
#include <atomic>
#include <ctime>
#include <functional>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "app/language.h"
#include "app/resources.h"
#include "app/steady_now.h"
#include "core/learn/model_file.h"
#include "core/sim/terrain_shapes.h"
#include "tests/support/console_bench.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/loop_beat.h"
#include "tests/support/scripted_source.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/toy_model.h"
#include "widgets/atem_panel.h"
#include "widgets/drive_pad.h"
#include "widgets/estimate_strip.h"
#include "widgets/force_bars.h"
#include "widgets/held_button.h"
#include "widgets/look.h"
#include "widgets/navigation_rail.h"
#include "widgets/probe_card.h"
#include "widgets/robot_readout.h"
#include "widgets/status_header.h"
#include "widgets/terrain_profile_view.h"
#include "widgets/verdict_strip.h"
#include "widgets/words.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(Console, noButtonHasTheFocusAtFirst)
{
    open(fastRobot(robot, 2.1));
    EXPECT_EQ(QApplication::focusWidget(), window.get());
}

TEST_F(Console, theSourcesNameAndStopAreThereFromTheFirstPicture)
{
    open(fastRobot(robot, 2.1));
    EXPECT_EQ(window->header()->sourceName(), "SIMULATED ROBOT");
    EXPECT_TRUE(window->header()->stopButton()->isVisible());
    EXPECT_TRUE(window->header()->stopButton()->text().contains("F12"));
}

TEST_F(Console, theWholeLoopByKeyboard)
{
    open(fastRobot(robot, 2.0));
    ASSERT_TRUE(readyToExplore());
    QTest::keyPress(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Driving));
    QTest::keyRelease(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Halted));

    proposeByKeyboard();
    EXPECT_EQ(window->probeCard()->approveButton()->text(),
              "hold to approve probe at 0.6 m (Space)");
    EXPECT_TRUE(window->strip()->headline().startsWith("Uncertain at 0.6 m"));
    QTest::keyPress(window.get(), Qt::Key_Space);
    ASSERT_TRUE(robotIs(RobotActivity::Probing));
    QTest::keyRelease(window.get(), Qt::Key_Space);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_EQ(window->exploration().estimation().estimate()->origin[9], Origin::Arm);
    ASSERT_TRUE(eventually([&] { return window->terrain()->binText(9).endsWith("arm"); }));

    QTest::keyPress(window.get(), Qt::Key_Up);
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    QTest::keyRelease(window.get(), Qt::Key_Up);
    ASSERT_TRUE(eventually(
        [&] { return window->terrain()->accessibleDescription().contains("has moved"); }));
}

TEST_F(Console, theWholeLoopByMouse)
{
    open(fastRobot(robot, 2.1));
    ASSERT_TRUE(readyToExplore());
    QTest::mousePress(window->drivePad()->backButton(), Qt::LeftButton);
    ASSERT_TRUE(robotIs(RobotActivity::Driving));
    QTest::mouseRelease(window->drivePad()->backButton(), Qt::LeftButton);
    ASSERT_TRUE(robotIs(RobotActivity::Halted));
    QTest::mouseClick(window->atemPanel()->requestButton(), Qt::LeftButton);
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    ASSERT_TRUE(eventually([&] { return window->probeCard()->shown().has_value(); }));
    QTest::mousePress(window->probeCard()->approveButton(), Qt::LeftButton);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(window->exploration().state().probed);
}

TEST_F(Console, lettingGoEarlyApprovesNothing)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    window->probeCard()->approveButton()->setHoldTime(100000);
    QTest::keyPress(window.get(), Qt::Key_Space);
    EXPECT_TRUE(window->probeCard()->approveButton()->isHeld());
    QTest::keyRelease(window.get(), Qt::Key_Space);
    EXPECT_TRUE(eventually([&] { return !window->probeCard()->approveButton()->isHeld(); }));
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe);
    QTest::keyClick(window.get(), Qt::Key_N);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_FALSE(window->exploration().state().probed);
}

TEST_F(Console, aHoldThatIsNotCompleteInTimeApprovesNothing)
{
    answerTime = 2.0;
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    window->probeCard()->approveButton()->setHoldTime(100000);
    QTest::keyPress(window.get(), Qt::Key_Space);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(window->exploration().state().approvalExpired);
    EXPECT_FALSE(window->exploration().state().probed);
    EXPECT_TRUE(eventually([&] { return says("no answer in time"); }));
    EXPECT_FALSE(window->probeCard()->approveButton()->isHeld());
    QTest::keyRelease(window.get(), Qt::Key_Space);
    EXPECT_FALSE(window->exploration().state().probed);
}

TEST_F(Console, coloursAndLettersChangeWhileAQuestionIsOpen)
{
    open(fastRobot(robot, 2.1));
    window->setRoom(QSize(1920, 1080));
    window->resize(1920, 1080);
    proposeByKeyboard();
    const auto asked = window->exploration().proposal()->id;
    QTest::keyClick(window.get(), Qt::Key_5, Qt::ControlModifier);
    EXPECT_EQ(lookInForce().theme, ThemeName::NightRed);
    for (int i = 0; i < 5; ++i) QTest::keyClick(window.get(), Qt::Key_Plus, Qt::ControlModifier);
    EXPECT_GE(lookInForce().fontScale, 140);
    EXPECT_EQ(window->exploration().proposal()->id, asked);
    ASSERT_TRUE(eventually([&] { return window->probeCard()->asks(); }));
    ASSERT_TRUE(eventually([&] {  // once it is drawn in these letters
        QTest::keyPress(window.get(), Qt::Key_Space);
        if (window->probeCard()->approveButton()->isHeld()) return true;
        QTest::keyRelease(window.get(), Qt::Key_Space);
        return false;
    }));
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(window->exploration().state().probed);
    QTest::keyRelease(window.get(), Qt::Key_Space);
}

/// stepEstimate with draws: at +0.6 and +0.7 m the ground is high or low, each by itself.
TerrainEstimate withDraws(TerrainEstimate e)
{
    for (int d = 0; d < 400; ++d) {
        Heights h = e.height;
        h[9] += d % 2 == 0 ? 0.09 : -0.09;
        h[10] += d % 4 < 2 ? 0.08 : -0.08;
        e.draws.push_back(h);
    }
    return e;
}

TEST_F(Console, theVerdictFollowsTheLimitAndTheProbeThatIsChosen)
{
    open(fastRobot(robot, 2.1), [] {
        return Result<LoadedModel>(
            LoadedModel{.estimate =
                            [](const EstimateRequest& request, const Watch&) {
                                TerrainEstimate e = withDraws(stepEstimate());
                                e.settings = request.settings;
                                return e;
                            },
                        .name = "fake.ttm",
                        .details = {}});
    });
    EXPECT_EQ(window->verdict()->badge(), QStringLiteral("NO VERDICT"));
    proposeByKeyboard();
    ASSERT_TRUE(
        eventually([&] { return window->verdict()->badge() == QStringLiteral("✘ BLOCKED"); }));
    QTest::keyClick(window.get(), Qt::Key_F3);
    EXPECT_TRUE(eventually([&] { return says(QStringLiteral("✘ BLOCKED · P(step")); }));
    QTest::keyClick(window.get(), Qt::Key_F2);
    for (int i = 0; i < 40; ++i) QTest::keyClick(window.get(), Qt::Key_PageUp);
    EXPECT_TRUE(
        eventually([&] { return window->verdict()->badge() == QStringLiteral("✔ CLEAR"); }));
    EXPECT_NEAR(window->exploration().options().stepLimit, 0.5, 1e-9);

    ASSERT_TRUE(eventually([&] {
        return window->verdict()->reason().contains("probe at")
            && window->exploration().proposal()->stepLimit == window->verdict()->limit();
    })) << "the question of the probe is that of the verdict";
    const auto first = window->exploration().proposal();
    ASSERT_TRUE(first && first->worth && !first->others.empty());
    ASSERT_TRUE(eventually([&] { return window->probeCard()->shown() == first->id; }));
    QTest::keyClick(window.get(), Qt::Key_1);
    const auto chosen = window->exploration().proposal();
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->bin, first->others[0].bin);
    EXPECT_NE(chosen->id, first->id) << "an answer to the first must not count for the second";
    EXPECT_EQ(chosen->worth, first->others[0]);
    ASSERT_TRUE(eventually([&] {
        return window->probeCard()->approveButton()->text().contains(words::binName(chosen->bin));
    }));

    ASSERT_TRUE(eventually([&] { return window->probeCard()->shown() == chosen->id; }));
    QTest::keyClick(window.get(), Qt::Key_N);
    ASSERT_TRUE(eventually([&] { return window->probeCard()->tells(); }))
        << "what it would have bought";
    EXPECT_FALSE(window->probeCard()->asks());
    EXPECT_TRUE(window->verdict()->reason().contains("probe at"));
    QTest::keyClick(window.get(), Qt::Key_PageDown);
    EXPECT_TRUE(eventually([&] {
        const auto best = window->exploration().bestProbe();
        return best && best->stepLimit == window->verdict()->limit();
    })) << "by the limit of now";
}

TEST_F(Console, aSecondMethodIsEstimatedBesideTheFirst)
{
    open(fastRobot(robot, 2.1));
    window->exploration().setSecondMethod(Method::Pafc);
    proposeByKeyboard();
    ASSERT_TRUE(
        eventually([&] { return window->exploration().estimation().second().has_value(); }));
    EXPECT_EQ(window->exploration().estimation().second()->settings.method, Method::Pafc);
    EXPECT_EQ(window->exploration().estimation().estimate()->settings.method, Method::Local);
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe);
    window->exploration().setSecondMethod(std::nullopt);
    EXPECT_FALSE(window->exploration().estimation().second());
}

TEST_F(Console, aProposedProbeIsToldOnEveryPageWithTheTimeThatIsLeft)
{
    answerTime = 300.0;  // this machine may be busy
    open(fastRobot(robot, 2.1));
    const QPushButton& terrain = *window->rail()->button(0);
    ASSERT_TRUE(readyToExplore());
    const QString plain = terrain.text();
    const int wide = window->rail()->width();
    proposeByKeyboard();
    EXPECT_FALSE(says("PROBE at")) << "the card asks";
    const QRegularExpression left("PROBE at 0\\.6 m\\? [0-9]:[0-9]{2} left, then no");
    const auto tells = [&] {
        for (const QLabel* label : window->findChildren<QLabel*>())
            if (label->isVisible() && left.match(label->text()).hasMatch()) return true;
        return false;
    };
    for (int page = 1; page < window->rail()->pages(); ++page) {
        if (window->rail()->button(page)->isHidden()) continue;
        QTest::keyClick(window.get(), window->rail()->keyOf(page));
        const std::string where = std::to_string(page);
        EXPECT_TRUE(eventually(tells)) << where;
        EXPECT_TRUE(terrain.text().contains(QRegularExpression("arm\\? [0-9]:[0-9]{2}"))) << where;
        EXPECT_TRUE(eventually([&] { return gui::cramped(*window).empty(); }, 2000)) << where;
        EXPECT_EQ(window->rail()->width(), wide) << where;
    }
    QTest::keyClick(window.get(), Qt::Key_F3);
    ASSERT_TRUE(eventually(tells));
    if (const QString folder = qEnvironmentVariable("TERRATACT_PICTURES"); !folder.isEmpty())
        window->grab().save(folder + "/probe-asked-on-another-page.png");
    QTest::mouseClick(window->rail()->button(0), Qt::LeftButton);
    EXPECT_TRUE(eventually([&] { return window->probeCard()->shown().has_value(); }));
    EXPECT_TRUE(eventually([&] { return !tells(); }));
    QTest::keyClick(window.get(), Qt::Key_N);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(eventually([&] { return terrain.text() == plain; }))
        << terrain.text().toStdString();
    QTest::keyClick(window.get(), Qt::Key_F3);
    QTest::qWait(100);
    EXPECT_FALSE(says("not answered in time")) << "it was answered";
}

TEST_F(Console, howFarAnExplorationIsStandsInTheRailOfEveryOtherPage)
{
    answerTime = 300.0;
    std::atomic<bool> mayEstimate = false;
    open(fastRobot(robot, 2.1), [&mayEstimate] {
        LoadedModel model = madeUp();
        model.estimate = [&mayEstimate, estimate = model.estimate](const EstimateRequest& request,
                                                                   const Watch& watch) {
            while (!mayEstimate && !watch.cancelled())
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            return estimate(request, watch);
        };
        return Result<LoadedModel>(std::move(model));
    });
    ASSERT_TRUE(readyToExplore());
    const QPushButton& terrain = *window->rail()->button(0);
    const QString plain = terrain.text();
    const int wide = window->rail()->width();
    const auto tells = [&](const char* what) {
        const QRegularExpression words(QLatin1String(what) + QLatin1Char('$'));
        EXPECT_TRUE(eventually([&] { return terrain.text().contains(words); }))
            << what << ": " << terrain.text().toStdString();
        EXPECT_EQ(window->rail()->width(), wide) << what;
        EXPECT_EQ(gui::cutWhenSettled(*window->rail()), std::vector<std::string>()) << what;
    };
    QTest::keyClick(window.get(), Qt::Key_A);
    EXPECT_TRUE(reaches(AtemPhase::Estimating));
    EXPECT_TRUE(eventually([&] { return says("Estimating"); }));
    EXPECT_EQ(terrain.text(), plain) << "the card says it";
    QTest::keyClick(window.get(), Qt::Key_F3);
    tells("estimating");
    mayEstimate = true;
    tells("arm\\? [0-9]:[0-9]{2}");
    QTest::keyClick(window.get(), Qt::Key_F2);
    ASSERT_TRUE(eventually([&] { return window->probeCard()->shown().has_value(); }));
    QTest::keyPress(window.get(), Qt::Key_Space);
    ASSERT_TRUE(reaches(AtemPhase::Probing));
    QTest::keyRelease(window.get(), Qt::Key_Space);
    QTest::keyClick(window.get(), Qt::Key_F5);
    tells("probe 0:[0-9]{2}");
    tells("result");
    QTest::keyClick(window.get(), Qt::Key_F2);
    EXPECT_TRUE(eventually([&] { return terrain.text() == plain; }));
}

TEST_F(Console, whatTheRailTellsOfAnExplorationMakesItNoWiderInAnyLanguage)
{
    for (const char* language : {"en", "cs", "de"}) {
        window.reset();
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        openScripted();
        const int wide = window->rail()->width();
        for (const char* word :
             {"halting", "pressing", "estimating", "probe", "result", "failed"}) {
            const bool timed = std::string_view(word) == "probe";
            const QString time = timed ? QStringLiteral(" 0:44") : QString();
            window->rail()->tell(0, ProbeNotice::tr(word) + time, false);
            QTest::qWait(20);
            EXPECT_EQ(window->rail()->width(), wide) << language << ": " << word;
        }
    }
    window.reset();
    installLanguage(*qApp, "en");
}

TEST_F(Console, aProbeThatNobodyAnsweredIsToldUntilTheTerrainIsSeen)
{
    answerTime = 2.0;
    open(fastRobot(robot, 2.1));
    ASSERT_TRUE(readyToExplore());
    QTest::keyClick(window.get(), Qt::Key_A);
    QTest::keyClick(window.get(), Qt::Key_F3);
    ASSERT_TRUE(reaches(AtemPhase::Presenting)) << "nobody has answered";
    EXPECT_TRUE(eventually([&] { return says("not answered in time, which means no"); }));
    QTest::keyClick(window.get(), Qt::Key_F4);
    QTest::qWait(100);
    EXPECT_TRUE(says("not answered in time")) << "on every page";
    QTest::keyClick(window.get(), Qt::Key_F2);
    EXPECT_TRUE(eventually([&] { return !says("The probe was not answered in time"); }));
    QTest::keyClick(window.get(), Qt::Key_F3);
    QTest::qWait(100);
    EXPECT_FALSE(says("not answered in time")) << "it has been seen";
}

TEST_F(Console, theQualityMenuSaysWhatAPresetCostsAndSetsIt)
{
    openScripted();
    const QString fast =
        QStringLiteral("fast: 0.5 ms, exact quantiles by a formula, mean error 25 mm");
    const auto offered = [&] { return window->header()->qualityButton()->menu()->actions(); };
    ASSERT_TRUE(eventually([&] { return offered()[0]->text() == fast; }))
        << offered()[0]->text().toStdString();
    const auto actions = offered();
    ASSERT_EQ(actions.size(), 3);
    EXPECT_EQ(actions[1]->text(), QStringLiteral("balanced: not measured (terratact tradeoff)"));
    actions[0]->trigger();
    EXPECT_EQ(window->header()->qualityButton()->text(), QStringLiteral("fast"));
    const Settings& settings = window->exploration().options().settings;
    EXPECT_EQ(settings, withQuality(settings, Quality::Fast));
    EXPECT_NE(settings, withQuality(settings, Quality::Balanced));
    window->preferences().change([](Preferences& p) { p.method = Method::Pafac; });
    EXPECT_EQ(offered()[0]->text(),
              QStringLiteral(
                  "fast: 4.0 ms, quantiles ± 11.3 mm from a long run, mean error 34 mm; chains "
                  "converge in 13 % of scenes, without which there is no verdict"));
}

TEST_F(Console, escapeAbortsAnExploration)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(reaches(AtemPhase::Idle));
    EXPECT_TRUE(eventually([&] { return !window->probeCard()->asks(); }));
}

TEST_F(Console, whatGoesWrongIsSaidWhereTheLastMinutesAreNotSeen)
{
    ScriptedSource* source = openScripted();
    ASSERT_TRUE(readyToExplore());
    source->setDeaf(true);
    window->exploration().drive(+1);
    QTest::qWait(100);
    EXPECT_FALSE(says("command not sent")) << "it stands in the list";
    QTest::keyClick(window.get(), Qt::Key_F3);
    window->exploration().drive(+1);
    EXPECT_TRUE(eventually([&] { return says("command not sent: the bus is off"); }));
    QTest::keyClick(window.get(), Qt::Key_F12);
    EXPECT_TRUE(eventually([&] { return says("STOP NOT SENT for"); }));
    EXPECT_FALSE(says("command not sent")) << "it gives way";
    source->setDeaf(false);
    ASSERT_TRUE(eventually([&] { return !says("STOP NOT SENT"); }));
    window->events()->add("a doubt of anybody's", Weight::Doubt, {});
    window->events()->add("what anybody says is bad", Weight::Bad, {});
    EXPECT_TRUE(eventually([&] { return says("what anybody says is bad"); }));
    EXPECT_FALSE(says("a doubt of anybody's"));
}

TEST_F(Console, escapeClearsWhatStandsAfterAStop)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    QTest::keyClick(window.get(), Qt::Key_F12);
    ASSERT_TRUE(robotIs(RobotActivity::Stopped));
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->releaseButton()->isVisible(); }));
    QTest::keyPress(window.get(), Qt::Key_R);
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    QTest::keyRelease(window.get(), Qt::Key_R);
    ASSERT_TRUE(window->exploration().estimation().estimate());
    const QPushButton& clear = *window->atemPanel()->abortButton();
    ASSERT_TRUE(eventually([&] { return clear.isVisible() && clear.isEnabled(); }));
    EXPECT_EQ(clear.text(), "Forget (Esc)");
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(eventually([&] { return !window->exploration().estimation().estimate(); }));
    EXPECT_TRUE(eventually([&] { return !clear.isEnabled(); }));
}

TEST_F(Console, staleValuesDisappearAndTheLostLinkIsSaid)
{
    ScriptedSource* source = openScripted();
    ASSERT_TRUE(
        eventually([&] { return window->readout()->text(RobotReadout::Pitch).endsWith("°"); }));
    source->setSilent(true);
    ASSERT_TRUE(eventually(
        [&] { return window->readout()->text(RobotReadout::Pitch).startsWith("--   "); }));
    EXPECT_EQ(window->forces()->numberText(0), "--");
    EXPECT_TRUE(window->terrain()->accessibleDescription().contains("not live"));
    ASSERT_TRUE(eventually([&] { return window->header()->linkText().startsWith("LINK LOST"); }));
    EXPECT_FALSE(window->atemPanel()->requestButton()->isEnabled());
    source->setSilent(false);
    EXPECT_TRUE(
        eventually([&] { return window->readout()->text(RobotReadout::Pitch).endsWith("°"); }));
    EXPECT_TRUE(eventually([&] { return window->header()->linkText().startsWith("link"); }));
    EXPECT_FALSE(window->terrain()->accessibleDescription().contains("not live"));
}

TEST_F(Console, aMissingModelIsSaidAndTheRestWorks)
{
    open(fastRobot(robot, 2.1), modelFileLoader("/nowhere/none.ttm", robot));
    ASSERT_TRUE(eventually([&] { return !window->modelTrouble().isEmpty(); }));
    ASSERT_TRUE(eventually(
        [&] { return window->atemPanel()->requestButton()->toolTip().contains("none.ttm"); }));
    EXPECT_FALSE(window->atemPanel()->requestButton()->isEnabled());
    EXPECT_TRUE(window->drivePad()->forwardButton()->isEnabled());
}

TEST_F(Console, hostileTelemetryLeavesItDrawnAndAlive)
{
    ScriptedSource* source = openScripted();
    for (const double bad : gui::kHostile) {
        Measurement m;
        m.pitch = m.roll = m.frontLeft = m.frontLeftCurrent = bad;
        m.force.fill(bad);
        source->setMeasurement(m);
        const auto before = window->acquisition().latest();
        ASSERT_TRUE(eventually([&] {
            const auto latest = window->acquisition().latest();
            return latest && (!before || latest->count > before->count + 30);
        }));
        QTest::qWait(100);
        ASSERT_FALSE(gui::painted(*window).isNull()) << bad;
    }
    source->setMeasurement({});
    EXPECT_TRUE(
        eventually([&] { return window->readout()->text(RobotReadout::Pitch).endsWith("°"); }));
}

TEST_F(Console, theRealChainRunsAndTheWindowStaysAlive)
{
    const TemporaryDirectory directory;
    const std::string model = directory.file("small.ttm");
    ASSERT_TRUE(writeModel(model, toyModel()));
    MainWindow::Options options;
    options.robot = robot;
    options.source = fastRobot(robot, 2.0);
    options.model = modelFileLoader(model, robot);
    options.exploration.linkLostAfter = 3.0;
    options.exploration.settings.draws = 4000;

    QElapsedTimer opening;
    opening.start();
    window = std::make_unique<MainWindow>(std::move(options));
    window->resize(1440, 900);
    gui::showActive(*window);
    const qint64 up = opening.elapsed();

    LoopBeat beat;
    ASSERT_TRUE(readyToExplore());
    QTest::keyPress(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Driving));
    QTest::keyRelease(window.get(), Qt::Key_W);
    QTest::keyClick(window.get(), Qt::Key_A);
    ASSERT_TRUE(eventually([&] { return window->showsEstimate(); }, 60000));
    beat.stop();
    for (int bin = 0; bin < kBins; ++bin)
        EXPECT_FALSE(window->terrain()->binText(bin).contains("--"));
    RecordProperty("window_up_ms", static_cast<int>(up));
    RecordProperty("longest_block_ms", static_cast<int>(beat.late()));
    std::printf("window up after %lld ms; event loop late by %lld ms at most, busy for %.1f ms\n",
                static_cast<long long>(up), static_cast<long long>(beat.late()), beat.own(1.0));
    EXPECT_LT(beat.own(1.0), 50.0);
    EXPECT_LT(beat.late(), 1000) << "far beyond what a busy machine explains";
    window.reset();
}

/// When a widget was first painted while the condition held [s].
class FirstPaint final : public QObject {
public:
    FirstPaint(QWidget* widget, std::function<bool()> condition) : condition_(std::move(condition))
    {
        widget->installEventFilter(this);
    }
    /// Runs the event loop without a pause until then; empty after 5 s.
    std::optional<double> wait()
    {
        at_.reset();
        QTimer::singleShot(5000, &loop_, &QEventLoop::quit);
        loop_.exec();
        return at_;
    }

private:
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() != QEvent::Paint || at_ || !condition_()) return false;
        at_ = steadyNow();
        loop_.quit();
        return false;
    }
    std::function<bool()> condition_;
    std::optional<double> at_;
    QEventLoop loop_;
};

/// Prints the whole way from the telemetry that completes a scene to the picture of its estimate.
TEST_F(Console, theEstimateIsPaintedSoonAfterTheSceneIsComplete)
{
    SimulatedRobot::Options options;
    options.startX = 2.1;
    SimulatedRobot simulated(robot, demoTerrain(), options);
    Measurement halted = simulated.measure();
    simulated.command(PressCommand{18.0});
    for (int i = 0; i < 400 && simulated.activity() != RobotActivity::Pressed; ++i)
        simulated.step(0.05);
    const Measurement pressed = simulated.measure();
    ASSERT_EQ(pressed.activity, RobotActivity::Pressed);

    auto source = std::make_unique<ScriptedSource>();
    ScriptedSource* script = source.get();
    script->pressWhenTold();
    open(std::move(source), modelFileLoader(resourcePath("models/default.ttm"), robot));
    FirstPaint paint(window->terrain()->canvas(), [&] { return window->showsEstimate(); });
    std::vector<double> seconds;
    for (int i = 0; i < 9; ++i) {
        script->setMeasurement(halted);
        QTest::keyClick(window.get(), Qt::Key_Escape);
        ASSERT_TRUE(reaches(AtemPhase::Idle));
        ASSERT_TRUE(readyToExplore());
        QTest::keyClick(window.get(), Qt::Key_A);
        ASSERT_TRUE(reaches(AtemPhase::Pressing));
        QTest::qWait(100 + 7 * i);  // not in step with the window's own beat
        const double complete = steadyNow();
        script->setMeasurement(pressed);
        const auto painted = paint.wait();
        ASSERT_TRUE(painted);
        seconds.push_back(*painted - complete);
        QTest::keyClick(window.get(), Qt::Key_N);
        QTest::qWait(50);
    }
    std::sort(seconds.begin(), seconds.end());
    std::printf("scene complete to estimate painted: median %.0f ms, worst %.0f ms of %zu\n",
                1e3 * seconds[seconds.size() / 2], 1e3 * seconds.back(), seconds.size());
    EXPECT_LT(seconds.back(), 2.0) << "a hang";
}

}  // namespace
}  // namespace terratact
