#include "widgets/terrain/readings/numbers_table.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QClipboard>

#include "tests/support/estimates.h"
#include "tests/support/gui.h"

namespace terratact {
namespace {

QString cell(const NumbersTable& table, int row, NumbersTable::Column column)
{
    return table.item(row, column)->text();
}

TEST(NumbersTable, hasARowPerBinFromTheRear)
{
    NumbersTable table;
    table.setEstimate(stepEstimate(), 0.1);
    ASSERT_EQ(table.rowCount(), kBins);
    EXPECT_EQ(cell(table, 0, NumbersTable::Bin), QStringLiteral("−0.3"));
    EXPECT_EQ(cell(table, 8, NumbersTable::Height), QStringLiteral("−0.050"));
    EXPECT_EQ(cell(table, 8, NumbersTable::From), QStringLiteral("contact"));
    EXPECT_EQ(cell(table, 3, NumbersTable::From), QStringLiteral("constrained"));
    EXPECT_EQ(cell(table, 10, NumbersTable::From), QStringLiteral("prior only"));
    EXPECT_EQ(cell(table, 10, NumbersTable::Ceiling), QStringLiteral("--"));
    table.clearEstimate();
    EXPECT_EQ(cell(table, 8, NumbersTable::Height), QStringLiteral("--"));
}

TEST(NumbersTable, showsStepsAndTwoHeights)
{
    TerrainEstimate e = stepEstimate();
    for (int d = 0; d < 100; ++d) {
        Heights h = e.height;
        if (d < 40) h[9] = h[10] = 0.2;
        e.draws.push_back(h);
    }
    NumbersTable table;
    table.setEstimate(e, 0.1);
    EXPECT_EQ(cell(table, 8, NumbersTable::Step), QStringLiteral("0.400"));
    EXPECT_EQ(cell(table, 9, NumbersTable::Step), QStringLiteral("0.000"));
    EXPECT_EQ(cell(table, 9, NumbersTable::TwoHeaps),
              QStringLiteral("−0.05 (60 %) or +0.20 (40 %)"));
    EXPECT_EQ(cell(table, 3, NumbersTable::TwoHeaps), QStringLiteral("--"));
}

TEST(NumbersTable, hidesChainColumnsOfClosedForms)
{
    NumbersTable table;
    TerrainEstimate estimate = stepEstimate();
    estimate.ending = Ending::NotSampled;
    table.setEstimate(estimate, 0.1);
    EXPECT_TRUE(table.isColumnHidden(NumbersTable::Rhat));
    EXPECT_TRUE(table.isColumnHidden(NumbersTable::Ess));
    TwoTrackEstimate both = equalSides(estimate);
    both.onePlane = false;
    both.side[1].ending = Ending::Converged;
    table.setEstimate(both, 0.1);
    EXPECT_FALSE(table.isColumnHidden(NumbersTable::Rhat)) << "one side has chains";
    estimate.ending = Ending::Converged;
    table.setEstimate(estimate, 0.1);
    EXPECT_FALSE(table.isColumnHidden(NumbersTable::Ess));
}

TEST(NumbersTable, isReadCellByCell)
{
    NumbersTable table;
    table.setEstimate(stepEstimate(), 0.1);
    gui::showActive(table);
    QAccessibleInterface* whole = QAccessible::queryAccessibleInterface(&table);
    ASSERT_TRUE(whole && whole->tableInterface());
    EXPECT_EQ(whole->text(QAccessible::Name), table.accessibleName());
    EXPECT_FALSE(table.accessibleName().isEmpty());
    QAccessibleTableInterface& cells = *whole->tableInterface();
    ASSERT_EQ(cells.rowCount(), kBins);
    ASSERT_EQ(cells.columnCount(), NumbersTable::kColumns);
    const auto said = [&](int row, int column) {
        return cells.cellAt(row, column)->text(QAccessible::Name);
    };
    for (int row = 0; row < kBins; ++row)
        for (int column = 0; column < NumbersTable::kColumns; ++column)
            EXPECT_EQ(said(row, column), table.item(row, column)->text());
    EXPECT_EQ(said(8, NumbersTable::From), "contact");
    for (int column = 0; column < NumbersTable::kColumns; ++column)
        EXPECT_EQ(cells.columnDescription(column), table.horizontalHeaderItem(column)->text());
}

TEST(NumbersTable, isCopiedWithItsHeadings)
{
    NumbersTable table;
    table.setEstimate(stepEstimate(), 0.1);
    gui::showActive(table);
    QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
    const QStringList lines = QApplication::clipboard()->text().split('\n');
    ASSERT_GE(lines.size(), kBins + 1);
    EXPECT_EQ(lines[0].split('\t').size(), NumbersTable::kColumns - 3) << "no side, no chains";
    for (const QString& line : lines) {
        EXPECT_FALSE(line.contains(QChar(0x2212))) << "other programs read no such minus";
        EXPECT_FALSE(line.contains("--")) << "what is not known is an empty field";
    }
    EXPECT_TRUE(lines[9].startsWith(QStringLiteral("+0.5\t-0.050\t")));
}

TEST(NumbersTable, hasARowPerSideWhereSidesDiffer)
{
    NumbersTable table;
    table.setEstimate(leftStepEstimate(), 0.1);
    ASSERT_EQ(table.rowCount(), 2 * kBins);
    EXPECT_FALSE(table.isColumnHidden(NumbersTable::AtSide));
    EXPECT_EQ(cell(table, 16, NumbersTable::Bin), QStringLiteral("+0.5"));
    EXPECT_EQ(cell(table, 16, NumbersTable::AtSide), "left");
    EXPECT_EQ(cell(table, 16, NumbersTable::Height), QStringLiteral("−0.050"));
    EXPECT_EQ(cell(table, 17, NumbersTable::AtSide), "right");
    EXPECT_EQ(cell(table, 17, NumbersTable::Height), QStringLiteral("−0.250"));
    EXPECT_EQ(cell(table, 20, NumbersTable::Touched), "yes");
    EXPECT_EQ(cell(table, 21, NumbersTable::Touched), "no");
    const QStringList lines = table.text().split('\n');
    EXPECT_TRUE(lines[0].startsWith("bin [m]\tside\theight [m]")) << lines[0].toStdString();
    EXPECT_TRUE(lines[17].startsWith("+0.5\tleft\t-0.050\t")) << lines[17].toStdString();
    table.setEstimate(equalSides(stepEstimate()), 0.1);
    EXPECT_EQ(table.rowCount(), kBins);
    EXPECT_TRUE(table.text().startsWith("bin [m]\theight [m]"));
}

TEST(NumbersTable, showsNoHostileNumber)
{
    for (const double hostile : gui::kHostile) {
        if (std::isfinite(hostile)) continue;
        TerrainEstimate e = stepEstimate();
        e.height.fill(hostile);
        e.sd.fill(hostile);
        NumbersTable table;
        table.setEstimate(e, 0.1);
        EXPECT_EQ(cell(table, 2, NumbersTable::Height), QStringLiteral("--"));
    }
}

}  // namespace
}  // namespace terratact
