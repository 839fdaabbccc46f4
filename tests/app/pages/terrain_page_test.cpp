// Tests ages and live previews on the terrain page.
#include "app/pages/terrain_page.h"

#include <gtest/gtest.h>

#include <QLabel>

#include "app/console/main_window.h"
#include "app/display/format.h"
#include "core/infer/verdict/verdict.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/control/robot_readout.h"
#include "widgets/terrain/estimate_strip.h"
#include "widgets/terrain/terrain_profile_view.h"
#include "widgets/terrain/verdict_strip.h"

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

}  // namespace
}  // namespace terratact
