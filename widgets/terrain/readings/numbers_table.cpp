#include "widgets/terrain/readings/numbers_table.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>

#include "app/display/format.h"
#include "app/display/place_text.h"
#include "core/infer/verdict/bimodality.h"
#include "core/infer/verdict/obstacle.h"
#include "widgets/base/tips.h"
#include "widgets/terrain/provenance_text.h"
#include "widgets/terrain/touch_text.h"

namespace terratact {

namespace {

/// Returns a word for the column "felt" that is no longer than its heading.
QString feltWord(Touch touch)
{
    switch (touch) {
    case Touch::Felt: return NumbersTable::tr("yes");
    case Touch::FeltInPart: return NumbersTable::tr("in part");
    case Touch::Remembered:
    case Touch::Bounded: return touchWord(touch);
    case Touch::NotFelt: return NumbersTable::tr("no");
    case Touch::Unrecorded: break;
    }
    return format::kNothing;
}

}  // namespace

NumbersTable::NumbersTable(QWidget* parent) : HeadedTable(0, kColumns, parent)
{
    setAccessibleName(tr("The scene as numbers"));
    const auto withUnit = [](const QString& words) { return words.arg(format::lengthUnit()); };
    setHorizontalHeaderLabels(
        {withUnit(tr("bin [%1]")), tr("side"), withUnit(tr("height [%1]")), withUnit(tr("sd [%1]")),
         withUnit(tr("10 % [%1]")), withUnit(tr("90 % [%1]")), withUnit(tr("ceiling [%1]")),
         tr("from"), tr("felt"), tr("step to next"), tr("R-hat"), tr("ESS"), tr("two heights")});
    setTip(*horizontalHeaderItem(Step),
           tr("P of a step to the next bin alone. The verdict's P counts steps over two bins (%1), "
              "anywhere ahead")
               .arg(format::length(kStepBins * kBinWidth, 1)));
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(verticalHeader()->defaultSectionSize());
    verticalHeader()->setSectionResizeMode(
        QHeaderView::ResizeToContents);  // the font sets the row height
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    for (const Column wide : {AtSide, From, Touched, Step, TwoHeaps})
        horizontalHeader()->setSectionResizeMode(wide, QHeaderView::ResizeToContents);
    horizontalHeader()->setHighlightSections(false);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setTabKeyNavigation(false);
    setAlternatingRowColors(true);
    clearEstimate();
}

void NumbersTable::setRows(bool twoSides)
{
    const int before = rowCount(), rows = twoSides ? 2 * kBins : kBins;
    setColumnHidden(AtSide, !twoSides);
    setRowCount(rows);
    for (int row = before; row < rows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const bool isWord =
                column == AtSide || column == From || column == Touched || column == TwoHeaps;
            auto* item = new QTableWidgetItem;
            item->setTextAlignment((isWord ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            setItem(row, column, item);
        }
    for (int row = 0; row < rows; ++row) {
        set(row, Bin, format::signedLengthNumber(binCentre(twoSides ? row / 2 : row), 1));
        set(row, AtSide, !twoSides ? QString() : sideWord(row % 2 == 0 ? Side::Left : Side::Right));
    }
}

/// Hides what only Markov chains have.
void NumbersTable::hideChains(bool hidden)
{
    setColumnHidden(Rhat, hidden);
    setColumnHidden(Ess, hidden);
}

void NumbersTable::setEstimate(const TerrainEstimate& plane, double stepLimit)
{
    setRows(false);
    hideChains(plane.ending == Ending::NotSampled);
    setSide(plane, stepLimit, 0, 1);
}

void NumbersTable::setEstimate(const TwoTrackEstimate& estimate, double stepLimit)
{
    if (estimate.onePlane) return setEstimate(estimate.side[0], stepLimit);
    setRows(true);
    hideChains(estimate.side[0].ending == Ending::NotSampled
               && estimate.side[1].ending == Ending::NotSampled);
    for (const Side side : {Side::Left, Side::Right})
        setSide(estimate.side[indexOf(side)], stepLimit, static_cast<int>(indexOf(side)), 2);
}

void NumbersTable::setSide(const TerrainEstimate& e, double stepLimit, int firstRow, int rowsPerBin)
{
    const auto modes = twoModes(e);
    const auto steps = e.draws.empty() ? std::array<StepProbability, kBins - 1>{}
                                       : stepProbabilities(e, stepLimit);
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        const int row = firstRow + bin * rowsPerBin;
        set(row, Height, format::signedLengthNumber(e.height[i], 3));
        set(row, Sd, format::lengthNumber(e.sd[i], 3));
        set(row, Low, format::signedLengthNumber(e.q10[i], 3));
        set(row, High, format::signedLengthNumber(e.q90[i], 3));
        set(row, Ceiling, format::signedLengthNumber(e.ceiling[i], 3));
        set(row, From, provenanceWord(provenance(e, bin)));
        set(row, Touched, feltWord(e.touch[i]));
        set(row, Step,
            bin + 1 < kBins && !e.draws.empty() ? format::number(steps[i].p, 3) : format::kNothing);
        set(row, Rhat, format::rhat(e.rhat[i]));
        set(row, Ess, format::number(e.ess[i], 0));
        set(row, TwoHeaps,
            modes[i] ? tr("%1 (%2 %) or %3 (%4 %)")
                           .arg(format::signedLengthNumber(modes[i]->lowMean, 2),
                                format::percent(modes[i]->lowShare),
                                format::signedLengthNumber(modes[i]->highMean, 2),
                                format::percent(modes[i]->highShare))
                     : format::kNothing);
    }
}

void NumbersTable::clearEstimate()
{
    setRows(false);
    hideChains(true);
    for (int bin = 0; bin < kBins; ++bin)
        for (int column = Height; column < kColumns; ++column)
            set(bin, static_cast<Column>(column), format::kNothing);
}

void NumbersTable::set(int row, Column column, const QString& text)
{
    QTableWidgetItem* cell = item(row, column);
    if (cell->text() != text) cell->setText(text);
}

namespace {

/// Converts a cell for other programs: ASCII minus, and an empty cell for a missing value.
QString plainNumber(QString cell)
{
    return cell == format::kNothing ? QString() : cell.replace(QChar(0x2212), QLatin1Char('-'));
}

}  // namespace

QString NumbersTable::text() const
{
    const auto line = [this](auto&& cellOf) {
        QStringList cells;
        for (int column = 0; column < kColumns; ++column)
            if (!isColumnHidden(column)) cells << cellOf(column);
        return cells.join(QLatin1Char('\t'));
    };
    QStringList lines{line([this](int column) { return horizontalHeaderItem(column)->text(); })};
    for (int row = 0; row < rowCount(); ++row)
        lines << line([&](int column) { return plainNumber(item(row, column)->text()); });
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void NumbersTable::copy() const
{
    QApplication::clipboard()->setText(text());
}

void NumbersTable::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Copy)) return copy();
    QTableWidget::keyPressEvent(event);
}

}  // namespace terratact
