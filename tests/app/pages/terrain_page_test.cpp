// Tests ages, live previews, both sides and rear forces on the terrain page.
#include "app/pages/terrain_page.h"

#include <gtest/gtest.h>
#include <qwt_plot_shapeitem.h>
#include <qwt_text.h>

#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>

#include "app/console/main_window.h"
#include "app/display/format.h"
#include "app/pages/side_keys.h"
#include "app/shell/key_table.h"
#include "core/infer/verdict/verdict.h"
#include "core/limits.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/base/tips.h"
#include "widgets/control/drive_strip.h"
#include "widgets/control/robot_readout.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/readings/rear_view.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

TEST(TerrainPageAlone, neverUnderstatesTheAgeOfTelemetry)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const Measurement m;
    const auto says = [&](double age, bool due, double numbersFor) {
        TerrainViewState viewState;
        viewState.measurement = &m;
        viewState.age = age;
        viewState.numbersDue = due;
        viewState.numbersFor = numbersFor;
        page.setViewState(viewState);
        for (const QLabel* label : page.findChildren<QLabel*>())
            if (label->accessibleName() == "Age of the telemetry") return label->text();
        return QString();
    };
    EXPECT_EQ(says(0.046, true, 0.0), "46 ms old") << "it stands";
    EXPECT_EQ(says(0.046, true, 0.24), "< 0.3 s old") << "when it is shown anew";
    EXPECT_EQ(says(0.149, false, 0.24), "< 0.3 s old") << "these are still those numbers";
    EXPECT_EQ(says(0.149, true, 0.24), "< 0.4 s old");
    EXPECT_EQ(says(0.16, false, 0.24), "0.2 s old") << "at once";
    EXPECT_EQ(page.readout()->text(RobotReadout::Pitch), "--   160 ms old");
    EXPECT_EQ(says(1.27, false, 0.24), "1.3 s old") << "and it grows";
}

TEST(TerrainPageAlone, drawsNeitherRobotNorTruthWithoutTelemetry)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const auto shows = [&page](const TerrainViewState& viewState) {
        page.setViewState(viewState);
        return gui::painted(*page.terrain()->canvas());
    };
    const QImage nothing = shows({});
    Measurement m;
    m.pitch = 0.2;
    std::optional<Heights> truth = Heights{};
    TerrainViewState heard;
    heard.measurement = &m;
    heard.truth = &truth;
    heard.count = 1;
    const QImage robot = shows(heard);
    EXPECT_NE(robot, nothing);
    EXPECT_EQ(shows({}), nothing) << "a review went back to before the first telemetry";
    EXPECT_EQ(shows(heard), robot) << "the same telemetry again";
}

TEST(TerrainPageAlone, showsTheAgeOfForcesThatItHides)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const Measurement m;
    std::vector<ForceArray> forces(1);
    for (ForceElement& element : forces[0].elements) element.newtons = 3.0;
    std::uint64_t shows = 0;
    const auto says = [&](double age, std::optional<double> forcesAge) {
        TerrainViewState viewState;
        viewState.measurement = &m;
        viewState.age = age;
        viewState.forces = &forces;
        viewState.forcesAge = forcesAge;
        viewState.count = ++shows;
        page.setViewState(viewState);
        for (const QLabel* label : page.forces()->parentWidget()->findChildren<QLabel*>())
            if (label->isVisible() && label->text().endsWith(" old")) return label->text();
        return QString();
    };
    EXPECT_EQ(says(0.05, {}), "");
    EXPECT_EQ(page.forces()->numberText(0), "3.0");
    EXPECT_EQ(says(0.05, 0.44), "0.4 s old") << "their frames alone are missing";
    EXPECT_EQ(page.forces()->numberText(0), "--");
    EXPECT_EQ(says(0.05, 0.06), "") << "they are back";
    EXPECT_EQ(page.forces()->numberText(0), "3.0");
    EXPECT_EQ(says(1.27, {}), "1.3 s old") << "with all telemetry";
    EXPECT_EQ(page.forces()->numberText(0), "--");
}

TEST(TerrainPageAlone, showsMovingFlippersOnlyWhileTheyMove)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const Measurement m;
    const TwoTrackEstimate preview = equalSides(stepEstimate());
    const auto says = [&](AtemPhase phase) {
        TerrainViewState viewState;
        viewState.measurement = &m;
        viewState.live = {&preview, 0};
        viewState.state.phase = phase;
        page.setViewState(viewState);
        return page.verdict()->reason() + "\n" + page.terrain()->accessibleDescription() + "\n"
             + page.strip()->headline();
    };
    const QString moving = says(AtemPhase::Pressing), computing = says(AtemPhase::Estimating);
    EXPECT_EQ(moving.count("flippers still move"), 2) << moving.toStdString();
    EXPECT_TRUE(moving.contains("LIVE preview"));
    EXPECT_EQ(computing.count("flippers still move"), 0) << computing.toStdString();
    EXPECT_EQ(computing.count("estimate is being computed"), 2) << computing.toStdString();
    EXPECT_FALSE(computing.contains("LIVE"));
}

TEST(TerrainPageAlone, theSpeedOfAStoppedRobotIsZero)
{
    TerrainPage page(absolem());
    Measurement m;
    std::uint64_t lines = 0;
    const auto says = [&](double way, bool due, double age = 0.0) {
        m.time += 0.05;
        m.travelled = way;
        TerrainViewState viewState;
        viewState.measurement = &m;
        viewState.count = ++lines;
        viewState.numbersDue = due;
        viewState.age = age;
        page.setViewState(viewState);
        return page.driveStrip()->text(DriveStrip::Speed);
    };
    for (int i = 0; i < 10; ++i) says(0.04 * i, true);
    EXPECT_EQ(says(0.4, true), "+0.80 m/s");
    EXPECT_NE(says(0.4, false), "+0.00 m/s") << "it may still creep";
    EXPECT_EQ(says(0.4, false), "+0.00 m/s") << "at once, though numbers are not due";
    EXPECT_EQ(says(0.4, false, kStaleAfter + 0.01), "--") << "stale is not zero";
}

/// Returns a line of telemetry with the left side up.
Measurement rolled()
{
    Measurement m;
    m.roll = 0.15;
    m.frontLeft = 0.4;
    return m;
}

TEST(TerrainPageAlone, drawsBothSidesOfARobotThatRolls)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const auto far = [&page] {  // the far side is drawn below all other parts
        int parts = 0;
        for (const QwtPlotItem* item : page.terrain()->itemList())
            parts += item->z() >= 4.0 && item->z() < 5.0
                          && !static_cast<const QwtPlotShapeItem*>(item)->shape().isEmpty()
                       ? 1
                       : 0;
        return parts;
    };
    const Measurement level, tilted = rolled();
    Measurement lacking;
    setCurrents(lacking, {std::nullopt, 1.0, 1.0, 1.0});
    TerrainViewState viewState;
    viewState.measurement = &level;
    viewState.count = 1;
    page.setViewState(viewState);
    EXPECT_EQ(far(), 0);
    viewState.measurement = &lacking;
    viewState.count = 2;
    page.setViewState(viewState);
    EXPECT_EQ(far(), 0) << "the left current is not measured, so it does not differ";
    viewState.measurement = &tilted;
    viewState.count = 3;
    page.setViewState(viewState);
    EXPECT_GT(far(), 0);
    page.terrain()->setShownSides(ShownSides::Left);
    EXPECT_EQ(far(), 0) << "at once";
    page.terrain()->setShownSides(ShownSides::Both);
    const TwoTrackEstimate plane = equalSides(stepEstimate());
    viewState.estimate = {&plane, 1};
    viewState.scene = &tilted;
    viewState.count = 4;
    page.setViewState(viewState);
    EXPECT_EQ(far(), 0) << "an estimate of one plane has one robot";
}

TEST(TerrainPageAlone, showsTheCrossSlopeOfBothSidesFromBehind)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const Measurement m = rolled();
    TwoTrackEstimate estimate = leftStepEstimate();
    TerrainViewState viewState;
    viewState.measurement = viewState.scene = &m;
    viewState.estimate = {&estimate, 1};
    viewState.verdict = equalSides(Verdict{});
    viewState.verdict->crossSlope.steepest = 0.2;
    viewState.verdict->side[1].stepVerdict = StepVerdict::Clear;
    page.setViewState(viewState);
    EXPECT_TRUE(page.rearView()->text().contains(QStringLiteral("cross slope 11.5° L up")))
        << page.rearView()->text().toStdString();
    EXPECT_EQ(page.terrain()->sideInFull(), Side::Left) << "the right side is clear";
    estimate.onePlane = true;
    page.setViewState(viewState);
    EXPECT_FALSE(page.rearView()->text().contains("cross slope"));
}

TEST(TerrainPageAlone, offersAProbeWhereverASideCannotTell)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const Measurement m = rolled();
    const TwoTrackEstimate estimate = leftStepEstimate();
    TerrainViewState viewState;
    viewState.measurement = viewState.scene = &m;
    viewState.estimate = {&estimate, 1};
    viewState.verdict = equalSides(Verdict{});
    viewState.verdict->onePlane = false;
    viewState.verdict->both = viewState.verdict->side[0].stepVerdict = StepVerdict::Blocked;
    viewState.whyNoBestProbe = "no bin in reach is left";
    const QPushButton& button = *page.atemPanel()->probeButton();
    const auto offers = [&](const QString& why) {
        page.setViewState(viewState);
        return !button.isHidden() && !button.isEnabled() && tipOf(button).contains(why);
    };
    EXPECT_TRUE(offers("no bin in reach is left")) << tipOf(button).toStdString();
    EXPECT_TRUE(page.verdict()->reason().contains("no bin in reach is left"))
        << page.verdict()->reason().toStdString();
    viewState.whyNoBestProbe.clear();
    viewState.bestProbe.emplace().bin = 9;
    viewState.preconditions << Precondition{Precondition::Level::Doubtful,
                                            Message::verbatim("roll 7°")};
    EXPECT_TRUE(offers("roll 7°")) << tipOf(button).toStdString();
    viewState.verdict->side[1].stepVerdict = StepVerdict::Clear;
    page.setViewState(viewState);
    EXPECT_TRUE(button.isHidden()) << "each side is decided";
}

TEST(TerrainPageAlone, theTruthIsThatOfTheSideInFull)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const Measurement m = rolled();
    const TwoTrackEstimate estimate = leftStepEstimate();
    std::array<Heights, 2> truths{};
    truths[0].fill(-0.33);
    truths[1].fill(-0.17);
    const std::optional<std::array<Heights, 2>> sideTruth = truths;
    TerrainViewState viewState;
    viewState.measurement = viewState.scene = &m;
    viewState.sceneSideTruth = &sideTruth;
    viewState.estimate = {&estimate, 1};
    viewState.verdict = equalSides(Verdict{});
    viewState.verdict->onePlane = false;
    viewState.verdict->side[1].stepVerdict = StepVerdict::Clear;
    viewState.count = 1;
    page.setViewState(viewState);
    const auto height = [&page] {
        for (const QwtPlotItem* item : page.terrain()->itemList())
            if (item->title().text() == "truth")
                return static_cast<const QwtPlotShapeItem*>(item)->shape().boundingRect().top();
        return 0.0;
    };
    EXPECT_NEAR(height(), -0.33, 1e-9) << "the left side decides";
    page.terrain()->setShownSides(ShownSides::Right);
    EXPECT_NEAR(height(), -0.17, 1e-9) << "at once";
}

TEST(TerrainPageAlone, showsRearForcesOnlyOnARobotThatHasThem)
{
    RobotModel robot = absolem();
    {
        TerrainPage without(robot);
        gui::showActive(without);
        EXPECT_FALSE(without.rearForcesButton()->isVisible());
    }
    robot.rearElementShare.emplace();
    TerrainPage page(robot);
    gui::showActive(page);
    Measurement m;
    m.rearSides.left[2] = 7.0;
    m.rearSides.right[2] = 4.0;
    TerrainViewState viewState;
    viewState.measurement = &m;
    viewState.count = 1;
    page.setViewState(viewState);
    EXPECT_TRUE(page.forces()->isVisible());
    EXPECT_FALSE(page.rearForces()->isVisible());
    page.rearForcesButton()->click();
    EXPECT_TRUE(page.rearForces()->isVisible());
    EXPECT_FALSE(page.forces()->isVisible());
    EXPECT_EQ(page.rearForces()->numberText(2, 0), "7.0");
    EXPECT_EQ(page.rearForces()->numberText(2, 1), "4.0");
    EXPECT_EQ(page.rearForces()->numberText(0, 0), "--");
    EXPECT_TRUE(page.rearForces()->legend().contains("L"));
    viewState.age = 1.0;
    viewState.count = 2;
    page.setViewState(viewState);
    EXPECT_EQ(page.rearForces()->numberText(2, 0), "--") << "old";
}

TEST(SideKeys, chooseTheSidesOfThePicture)
{
    KeyTable keys;
    TerrainProfileView view;
    addSideKeys(keys, view, false);
    gui::showActive(view);
    const auto press = [&](Qt::Key key) {
        const QKeyEvent event(QEvent::KeyPress, key, Qt::AltModifier);
        const KeyTable::Entry* entry = keys.entryOf(event);
        ASSERT_TRUE(entry && entry->applies());
        entry->pressed();
    };
    press(Qt::Key_L);
    EXPECT_EQ(view.shownSides(), ShownSides::Left);
    press(Qt::Key_R);
    EXPECT_EQ(view.shownSides(), ShownSides::Right);
    press(Qt::Key_B);
    EXPECT_EQ(view.shownSides(), ShownSides::Both);
    EXPECT_FALSE(keys.entryOf(QKeyEvent(QEvent::KeyPress, Qt::Key_R, Qt::NoModifier)))
        << "R alone releases STOP";
}

TEST(SideKeys, sayThatOneProbesThereOnlyWhereOneCan)
{
    TerrainProfileView view;
    const QKeyEvent left(QEvent::KeyPress, Qt::Key_L, Qt::AltModifier);
    KeyTable review, console;
    addSideKeys(review, view, false);
    addSideKeys(console, view, true);
    EXPECT_EQ(review.entryOf(left)->meaning, QStringLiteral("show the left side"));
    EXPECT_EQ(console.entryOf(left)->meaning,
              QStringLiteral("show the left side, and probe there"));
}

}  // namespace
}  // namespace terratact
