// Tests the page of numbers.
#include "app/pages/numbers_page.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <string>

#include "app/pages/table_csv.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/readings/numbers_table.h"

namespace terratact {
namespace {

TEST(TableCsv, noCellBecomesAFormula)
{
    EXPECT_EQ(csvOfTable("bin\t=1+1\n+0.5\t@SUM(A1)\n").toStdString(),
              "bin,'=1+1\n+0.5,'@SUM(A1)\n");
}

TEST(NumbersPage, showsTheVerdictAndTheAgeOfTelemetry)
{
    applyLook(*qApp);
    const TwoTrackEstimate estimate = equalSides(stepEstimate());
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
    Verdict verdict{.stepVerdict = StepVerdict::Blocked,
                    .step = {0.99, 0.004},
                    .likeliest = 8,
                    .likeliestP = 0.97,
                    .withheldFor = {},
                    .toHorizon = {}};
    viewState.verdict = equalSides(verdict);
    viewState.age = 0.04;
    const auto explained = [&page] {
        const auto labels = page.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) {
            return label->isVisible() && label->text().contains("steps over two bins (0.2 m)");
        });
    };
    EXPECT_FALSE(explained());
    page.refresh(0.0);
    EXPECT_EQ(
        line->text(),
        QString::fromUtf8("✘ BLOCKED · P(step > 0.10 m ahead) = 0.99 ± < 0.01 · most likely at "
                          "+0.5 … +0.6 m (P 0.97)"));
    EXPECT_TRUE(explained()) << "P over two bins, beside a column of P to the next";
    verdict.stepVerdict = StepVerdict::CannotTell;
    verdict.withheldFor = {WithholdReason::Stale};
    viewState.verdict = equalSides(verdict);
    viewState.age = 12.34;
    page.refresh(0.0);
    EXPECT_EQ(
        line->text(),
        QString::fromUtf8("? CANNOT TELL · P(step > 0.10 m ahead) = 0.99 ± < 0.01 · withheld: "
                          "no live telemetry, the robot may have moved · last telemetry 12.3 s "
                          "ago"));
    EXPECT_EQ(gui::cutWhenSettled(page), std::vector<std::string>());
    verdict.withheldFor = {WithholdReason::TelemetryGap};
    viewState.verdict = equalSides(verdict);
    viewState.age = 0.04;
    page.refresh(0.0);
    EXPECT_TRUE(line->text().endsWith("withheld: the link was lost, the robot may have moved"));
    viewState.estimate = nullptr;
    viewState.verdict.reset();
    page.refresh(0.0);
    EXPECT_FALSE(line->isVisible());
}

TEST(NumbersPage, leavesAGapBetweenNumbersAndWords)
{
    applyLook(*qApp);
    const TwoTrackEstimate estimate = equalSides(stepEstimate());
    NumbersTable table;
    table.setEstimate(estimate, kStepLimit);
    table.show();  // the style sheet applies
    const QString word = table.item(0, NumbersTable::From)->text();
    ASSERT_EQ(word, "constrained");
    EXPECT_GE(table.columnWidth(NumbersTable::From),
              table.fontMetrics().horizontalAdvance(word) + 8);
}

}  // namespace
}  // namespace terratact
