// Takes a picture of every state of the console, in the order of a mission. Pictures are saved only if
// TERRATACT_PICTURES is set:
//   TERRATACT_PICTURES=DIR build/release/tests/app.console.screens.screens_test && tests/app/contact_sheet.sh DIR
//   TERRATACT_LANGUAGE=en: only this language.
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/preconditions.h"
#include "app/mission/text/robot_text.h"
#include "app/pages/terrain_page.h"
#include "app/runtime/resources.h"
#include "core/base/system_message.h"
#include "core/store/file_read.h"
#include "tests/app/console/screens/screens.h"
#include "tests/support/gui.h"
#include "widgets/base/held_button.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/precondition_grid.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"
#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {

using gui::eventually;

namespace {

QString told(const Message& message)
{
    return translated(message);
}

QString notReady()
{
    return AtemPanel::tr("not ready");
}

QString noEstimateYet()
{
    return Exploration::tr("No estimate yet: press M, then hold M to arm; then explore (A)");
}

}  // namespace

TEST_F(Screens, start)
{
    inEveryLanguage([&] {
        open({.model = []() -> Result<LoadedModel> {
            return fileError(
                "models/mine.ttm",
                Message::joined(TR_NOOP("core", "cannot be opened"), systemMessage(ENOENT)),
                ENOENT);
        }});
        ASSERT_TRUE(eventually([&] { return console->exploration().linkAlive(); }));
        picture("no_model",
                {MainWindow::tr("no model"), Exploration::tr("No estimate: there is no model"),
                 QStringLiteral("models/mine.ttm: %1: %2")
                     .arg(told(TR_NOOP("core", "cannot be opened")),
                          told(TR_NOOP("core", "No such file or directory"))),
                 notReady()});

        std::atomic<bool> go = false;
        open({.model = [&] {
            go.wait(false);
            return shipped();
        }});
        picture("model_loading", {MainWindow::tr("model loading …"),
                                  Exploration::tr("No estimate yet: the model is being loaded")});
        go = true;
        go.notify_all();
        ArmingControl& arming = *console->header()->arming();
        ASSERT_TRUE(eventually([&] { return arming.armButton()->isEnabled(); }));
        picture("not_armed",
                {ArmingControl::tr("DISARMED · arm (M)"), noEstimateYet(), notReady()});
        press(Qt::Key_M);
        ASSERT_TRUE(eventually([&] { return arming.confirmButton()->isVisible(); }));
        picture("arming", {ArmingControl::tr("hold to arm (M)")});
        QTest::qWait(60);  // a second action, not key repeat
        holdAtHalf(*arming.confirmButton(), Qt::Key_M, "hold_to_arm_at_half",
                   {ArmingControl::tr("hold to arm (M)")});
        ASSERT_TRUE(eventually([&] { return console->exploration().armed(); }));
        QTest::keyRelease(&window(), Qt::Key_M);
        ASSERT_NO_FATAL_FAILURE(arm());
        ASSERT_TRUE(eventually([&] { return console->atemPanel()->requestButton()->isEnabled(); }));
        picture("ready", {ArmingControl::tr("ARMED · disarm (M)"),
                          Exploration::tr("No estimate yet: explore the terrain (A)"),
                          told(describe(AtemPhase::Idle)), TerrainPage::tr("< %1 s old")});
        EXPECT_FALSE(reads(notReady()));
        QTest::keyPress(&window(), Qt::Key_W);
        picture("driving", {glance(RobotActivity::Driving)});
        QTest::keyRelease(&window(), Qt::Key_W);

        open({.safeMode = true});
        ASSERT_TRUE(eventually([&] { return console->exploration().linkAlive(); }));
        picture("safe_mode", {ConsoleWindow::tr("SAFE MODE: default settings; none are read or "
                                                "saved · start without --safe-mode to leave it")});
    });
}

TEST_F(Screens, exploring)
{
    modelFile = "one_plane.ttm";  // roll and different flippers are doubtful for it
    inEveryLanguage([&] {
        open({});
        const auto isSeenToPress = [&] {
            const auto latest = console->acquisition().latest();
            return latest && console->exploration().estimation().live()
                && latest->sample.measurement.activity == RobotActivity::Pressing;
        };
        ASSERT_NO_FATAL_FAILURE(arm());
        robot->stage({.activity = RobotActivity::Driving});
        ASSERT_TRUE(eventually([&] { return console->atemPanel()->requestButton()->isEnabled(); }));
        press(Qt::Key_A);
        ASSERT_TRUE(reaches(AtemPhase::Halting));
        picture("halting", {told(describe(AtemPhase::Halting))});
        robot->stage({.lasts = RobotActivity::Pressing});
        (void)eventually([&] {
            return isSeenToPress() || console->exploration().state().phase == AtemPhase::Failed;
        });
        ASSERT_TRUE(isSeenToPress()) << describe(console->exploration().state().failure).english;
        picture("live_preview",
                {told(describe(AtemPhase::Pressing)), TerrainPage::tr("LIVE preview")});
        holdsEstimates = true;
        robot->stage({});
        ASSERT_TRUE(reaches(AtemPhase::Estimating))
            << describe(console->exploration().state().failure).english;
        picture("estimating", {told(describe(AtemPhase::Estimating)),
                               TerrainPage::tr("The estimate is being computed")});
        EXPECT_FALSE(reads(TerrainPage::tr("The flippers still move"))) << "they have stopped";
        holdsEstimates = false;
        ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
        press(Qt::Key_Escape);
        ASSERT_TRUE(reaches(AtemPhase::Idle));

        robot->stage({.roll = 0.2, .twist = 0.2});
        picture(
            "doubtful_ground",
            {AtemPanel::tr("Override (O)"),
             QCoreApplication::translate("PlanarGround", "roll %1: left and right ground differ"),
             QCoreApplication::translate("PlanarGround", "left and right flippers differ by %1")});
        press(Qt::Key_O);
        picture("checks_overridden",
                {StatusHeader::tr("! CHECK OVERRIDDEN"), PreconditionGrid::tr("%1 (overridden)")});

        robot->stage({.refuses = Refusal::NoRestPose});
        ASSERT_TRUE(eventually([&] { return console->atemPanel()->requestButton()->isEnabled(); }));
        press(Qt::Key_A);
        ASSERT_TRUE(reaches(AtemPhase::Failed));
        picture("press_refused_by_the_robot",
                {told(describe(AtemFailure::PressRefused)), told(describe(Refusal::NoRestPose))});
        robot->stage({});
        ASSERT_NO_FATAL_FAILURE(explore());
        robot->stage({.pitch = 0.3});
        ASSERT_TRUE(reaches(AtemPhase::Failed));
        picture("moved_meanwhile", {told(describe(AtemFailure::PoseChanged))});
        robot->stage({});
        alterEstimates([](TerrainEstimate&) { throw std::runtime_error("a number is no number"); });
        ASSERT_TRUE(eventually([&] { return console->atemPanel()->requestButton()->isEnabled(); }));
        press(Qt::Key_A);
        ASSERT_TRUE(reaches(AtemPhase::Failed));
        picture("estimate_failed", {told(describe(AtemFailure::EstimateError))});
        alterEstimates({});
        ASSERT_NO_FATAL_FAILURE(explore());
        press(Qt::Key_M);
        ASSERT_TRUE(reaches(AtemPhase::Failed));
        picture("disarmed_meanwhile",
                {told(describe(AtemFailure::Disarmed)), ArmingControl::tr("DISARMED · arm (M)")});
    });
}

namespace {

/// Returns the step limit [m] nearest to the default that gives this verdict; empty: none does.
std::optional<double> limitFor(const Estimation& estimation, StepVerdict stepVerdict)
{
    std::optional<double> found;
    for (int centimetres = 2; centimetres <= 50; ++centimetres) {
        const double limit = 0.01 * centimetres;
        const Measurement& scene = estimation.scene()->measurement;
        const Verdict verdict = verdictOf(estimation.estimate()->side[0], scene, {}, limit);
        if (verdict.stepVerdict == stepVerdict
            && (!found || std::abs(limit - kStepLimit) < std::abs(*found - kStepLimit)))
            found = limit;
    }
    return found;
}

}  // namespace

TEST_F(Screens, verdict)
{
    modelFile = "one_plane.ttm";  // roll and different flippers withhold its verdict
    const auto withLimit = [&](StepVerdict stepVerdict) {
        const Estimation& estimation = console->exploration().estimation();
        const std::optional<double> limit = limitFor(estimation, stepVerdict);
        ASSERT_TRUE(limit) << name(stepVerdict);
        console->preferences().change([&](Preferences& p) { p.obstacleLimit = *limit; });
        const auto isAsked = [&] {
            const auto& proposal = console->exploration().proposal();
            return !proposal || proposal->stepLimit == *limit;
        };
        EXPECT_TRUE(eventually(isAsked)) << "the question of the probe is that of the verdict";
    };
    const auto withheld = [](WithholdReason reason) {
        return QStringList{VerdictStrip::tr("? CANNOT TELL"), VerdictStrip::tr("withheld: %1"),
                           told(describe(reason))};
    };
    const auto unsettled = [](TerrainEstimate& e) {
        e.converged = false;
        e.rhat[9] = 1.061;
        e.ess[9] = 92.0;
        e.warnings.emplace_back(
            TR_NOOP("core", "chains not converged: R-hat %1 (limit %2), effective draws %3 (limit "
                            "%4)"),
            "1.061", "1.01", "92", "400");
    };
    const auto unlike = [](TerrainEstimate& e) {
        e.novelty = 1.8;
        e.warnings.emplace_back(
            TR_NOOP("core",
                    "unlike the training scenes: %1 times the distance that 1 % of them exceed"),
            "1.8");
    };
    // Halves the step, so that some selectable limit certainly exceeds it, whatever the noise.
    const auto halved = [](TerrainEstimate& e) {
        const double ground = e.mean[3];
        const auto halve = [ground](Heights& heights) {
            for (double& h : heights) h = ground + 0.5 * (h - ground);
        };
        for (Heights* heights : {&e.mean, &e.q10, &e.q90, &e.height}) halve(*heights);
        for (Heights& heights : e.draws) halve(heights);
        for (double& sd : e.sd) sd *= 0.5;
        e.touch.fill(Touch::Felt);  // otherwise the robot would span some of the ground
    };
    const auto seldom = [&] {
        console->preferences().change(
            [](Preferences& p) { p.hazardRate = kHazardRateRange.least; });
    };
    inEveryLanguage([&] {
        open({.before = 1.3});  // flat ground
        seldom();
        alterEstimates([&](TerrainEstimate& e) {
            halved(e);
            e.touch.back() = Touch::NotFelt;
        });
        ASSERT_NO_FATAL_FAILURE(explore());
        picture("clear_to_a_horizon",
                {VerdictStrip::tr("✔ CLEAR"),
                 VerdictStrip::tr("felt to %1 ahead of the IMU, risk below %2 %") + "; "
                     + VerdictStrip::tr("not felt: %1")});

        open({.before = 0.5, .linkLostAfter = 0.8});
        seldom();
        alterEstimates(halved);
        ASSERT_NO_FATAL_FAILURE(explore());
        ASSERT_NO_FATAL_FAILURE(withLimit(StepVerdict::Clear));
        picture("clear", {VerdictStrip::tr("✔ CLEAR")});
        withLimit(StepVerdict::CannotTell);
        picture("undecided",
                {VerdictStrip::tr("? CANNOT TELL"), VerdictStrip::tr("not decided; %1")});
        withLimit(StepVerdict::Blocked);
        picture("blocked", {VerdictStrip::tr("✘ BLOCKED")});
        robot->stage({.isMute = true});
        picture("withheld_stale", withheld(WithholdReason::Stale));
        QTest::qWait(static_cast<int>(1000.0 * kMaxSilence) + 200);
        robot->stage({});
        picture("withheld_unheard", withheld(WithholdReason::TelemetryGap));

        alterEstimates(unsettled);
        ASSERT_NO_FATAL_FAILURE(explore());
        picture("withheld_not_converged", withheld(WithholdReason::NotConverged));
        alterEstimates(unlike);
        ASSERT_NO_FATAL_FAILURE(explore());
        picture("withheld_unlike_training", withheld(WithholdReason::UnlikeTraining));
        alterEstimates({});
        const auto exploreOn = [&](const Staging& ground) {
            robot->stage(ground);
            ASSERT_TRUE(
                eventually([&] { return console->atemPanel()->overrideButton()->isVisible(); }));
            press(Qt::Key_O);
            ASSERT_NO_FATAL_FAILURE(explore());
        };
        press(Qt::Key_Escape);
        ASSERT_NO_FATAL_FAILURE(exploreOn({.roll = 0.2}));
        picture("withheld_roll", withheld(WithholdReason::Roll));
        press(Qt::Key_Escape);
        ASSERT_NO_FATAL_FAILURE(exploreOn({.twist = 0.2}));
        picture("withheld_flippers", withheld(WithholdReason::Asymmetry));
        press(Qt::Key_Escape);
        alterEstimates([&](TerrainEstimate& e) { unsettled(e), unlike(e); });
        ASSERT_NO_FATAL_FAILURE(exploreOn({.roll = 0.2, .twist = 0.2}));
        robot->stage({.roll = 0.2, .twist = 0.2, .isMute = true});
        picture("withheld_for_all",
                {VerdictStrip::tr("withheld: %1"), VerdictStrip::tr("no live telemetry"),
                 VerdictStrip::tr("not converged"), VerdictStrip::tr("unlike all training"),
                 VerdictStrip::tr("the robot rolls"), VerdictStrip::tr("the flippers differ")});
    });
}

TEST_F(Screens, probe)
{
    inEveryLanguage([&] {
        open({});
        ASSERT_NO_FATAL_FAILURE(explore());
        Exploration& exploration = console->exploration();
        const QString question = ProbeCard::tr("hold to approve probe %1 (Space)");
        picture("proposed", {question, VerdictStrip::tr("? CANNOT TELL")});
        press(Qt::Key_D);
        exploration.setSecondMethod(Method::Pafc);
        ASSERT_TRUE(
            eventually([&] { return exploration.estimation().second().has_value(); }, 60000));
        console->terrain()->inspect(8);
        ASSERT_TRUE(eventually([&] { return console->findChild<BinInspector*>()->isVisible(); }));
        picture("draws_second_method_and_a_bin_up_close",
                console->findChild<BinInspector*>()->lines() << question);
        console->terrain()->inspect(std::nullopt);
        press(Qt::Key_D);
        exploration.setSecondMethod(std::nullopt);

        HoldToConfirmButton& approveButton = *console->probeCard()->approveButton();
        ASSERT_EQ(exploration.state().phase, AtemPhase::ProposingProbe);
        holdAtHalf(approveButton, Qt::Key_Space, "hold_to_approve_at_half", {question});
        QTest::keyRelease(&window(), Qt::Key_Space);
        ASSERT_TRUE(eventually([&] { return !approveButton.isHeld(); }));
        ASSERT_EQ(exploration.state().phase, AtemPhase::ProposingProbe) << "nobody has approved it";
        press(Qt::Key_N);
        picture("do_not_probe",
                {QCoreApplication::translate("terratact::Exploration", "The probe was refused")});

        ASSERT_NO_FATAL_FAILURE(explore());
        robot->stage({.lasts = RobotActivity::Probing});
        approveButton.setHoldTime(1);
        QTest::keyPress(&window(), Qt::Key_Space);
        picture("probing",
                {ProbeCard::tr("The arm is probing %1"), glance(RobotActivity::Probing)});
        QTest::keyRelease(&window(), Qt::Key_Space);
        robot->stage({});
        picture("probed",
                {TerrainPage::tr("The arm has measured; its height is part of the "
                                 "estimate."),
                 told(describe(AtemPhase::Presenting)) + AtemPanel::tr(", arm included")});

        ASSERT_NO_FATAL_FAILURE(explore());
        robot->stage({.refuses = Refusal::OutOfReach});
        approve();
        ASSERT_TRUE(reaches(AtemPhase::Failed));
        picture("probe_refused_by_the_robot",
                {told(describe(AtemFailure::ProbeRefused)), told(describe(Refusal::OutOfReach))});

        robot->stage({});
        const TemporaryDirectory files;
        const auto chooseModel = [&](const std::string& name) {
            std::filesystem::copy_file(resourcePath("models/default.ttm"), files.file(name));
            console->preferences().change(
                [&](Preferences& p) { p.model = QString::fromStdString(files.file(name)); });
            ASSERT_TRUE(eventually(
                [&] { return exploration.estimation().model().name.toStdString() == name; },
                60000));
        };
        ASSERT_NO_FATAL_FAILURE(explore());
        ASSERT_NO_FATAL_FAILURE(chooseModel("other.ttm"));
        ASSERT_EQ(exploration.state().phase, AtemPhase::ProposingProbe);
        picture("question_of_another_model",
                {QCoreApplication::translate(
                     "Preconditions", "scene, settings or model have changed since the question"),
                 ProbeCard::tr("void"), ProbeCard::tr("approval void: probe %1")});
        approve();
        ASSERT_TRUE(reaches(AtemPhase::Failed));
        picture("approval_void", {told(describe(AtemFailure::ApprovalVoid))});
    });
}

TEST_F(Screens, tooLate)
{
    inEveryLanguage([&] {
        const auto impatient = [](double AtemLimits::*of) {
            AtemLimits limits = kPatient;
            limits.*of = 0.6;
            return limits;
        };
        open({.limits = impatient(&AtemLimits::approval)});
        ASSERT_NO_FATAL_FAILURE(arm());
        ASSERT_TRUE(eventually([&] { return console->atemPanel()->requestButton()->isEnabled(); }));
        press(Qt::Key_A);
        ASSERT_TRUE(reaches(AtemPhase::Presenting));
        picture("no_answer_in_time",
                {TerrainPage::tr("The proposal was not answered in time and counts as refused."),
                 AtemPanel::tr("; no answer in time counts as refused")});
        open({.limits = impatient(&AtemLimits::probe)});
        ASSERT_NO_FATAL_FAILURE(explore());
        robot->stage({.lasts = RobotActivity::Probing});
        approve();
        ASSERT_TRUE(reaches(AtemPhase::Failed));
        picture("probe_took_too_long", {told(describe(AtemFailure::ProbeTimeout))});

        const auto failsWith = [&](const AtemLimits& limits, const Staging& staging,
                                   bool holds = false) {
            open({.limits = limits});
            holdsEstimates = holds;
            ASSERT_NO_FATAL_FAILURE(arm());
            robot->stage(staging);
            ASSERT_TRUE(
                eventually([&] { return console->atemPanel()->requestButton()->isEnabled(); }));
            press(Qt::Key_A);
            ASSERT_TRUE(reaches(AtemPhase::Failed));
        };
        ASSERT_NO_FATAL_FAILURE(
            failsWith(impatient(&AtemLimits::halt), {.activity = RobotActivity::Driving}));
        picture("halt_took_too_long", {told(describe(AtemFailure::HaltTimeout))});
        ASSERT_NO_FATAL_FAILURE(
            failsWith(impatient(&AtemLimits::press), {.lasts = RobotActivity::Pressing}));
        picture("press_took_too_long", {told(describe(AtemFailure::PressTimeout))});
        ASSERT_NO_FATAL_FAILURE(failsWith(impatient(&AtemLimits::estimate), {}, true));
        picture("estimate_took_too_long", {told(describe(AtemFailure::EstimateTimeout))});
    });
}

}  // namespace terratact
