#include "widgets/terrain/numbers_table.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>

#include "app/display/format.h"
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
    case Touch::Bounded: return touchWord(touch);
    case Touch::NotFelt: return NumbersTable::tr("no");
    case Touch::Unrecorded: break;
    }
    return format::kNothing;
}

}  // namespace

NumbersTable::NumbersTable(QWidget* parent) : HeadedTable(kBins, kColumns, parent)
{
    setAccessibleName(tr("The scene as numbers"));
    setHorizontalHeaderLabels({tr("bin [m]"), tr("height [m]"), tr("sd [m]"), tr("10 % [m]"),
                               tr("90 % [m]"), tr("ceiling [m]"), tr("from"), tr("felt"),
                               tr("step to next"), tr("R-hat"), tr("ESS"), tr("two heights")});
    setTip(
        *horizontalHeaderItem(Step),
        tr("P of a step to the next bin alone; the verdict's P counts steps within 0.2 m, which is "
           "over two bins, and anywhere ahead"));
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(verticalHeader()->defaultSectionSize());
    verticalHeader()->setSectionResizeMode(
        QHeaderView::ResizeToContents);  // the font sets the row height
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    for (const Column wide : {From, Touched, Step, TwoHeaps})
        horizontalHeader()->setSectionResizeMode(wide, QHeaderView::ResizeToContents);
    horizontalHeader()->setHighlightSections(false);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setTabKeyNavigation(false);
    setAlternatingRowColors(true);
    for (int row = 0; row < kBins; ++row)
        for (int column = 0; column < kColumns; ++column) {
            auto* item = new QTableWidgetItem;
            item->setTextAlignment(column == From || column == Touched || column == TwoHeaps
                                       ? Qt::AlignLeft | Qt::AlignVCenter
                                       : Qt::AlignRight | Qt::AlignVCenter);
            setItem(row, column, item);
        }
    clearEstimate();
}

void NumbersTable::setEstimate(const TerrainEstimate& e, double stepLimit)
{
    const auto modes = twoModes(e);
    const auto steps = e.draws.empty() ? std::array<StepProbability, kBins - 1>{}
                                       : stepProbabilities(e, stepLimit);
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        set(bin, Height, format::signedNumber(e.height[i], 3));
        set(bin, Sd, format::number(e.sd[i], 3));
        set(bin, Low, format::signedNumber(e.q10[i], 3));
        set(bin, High, format::signedNumber(e.q90[i], 3));
        set(bin, Ceiling, format::signedNumber(e.ceiling[i], 3));
        set(bin, From, provenanceWord(provenance(e, bin)));
        set(bin, Touched, feltWord(e.touch[i]));
        set(bin, Step,
            bin + 1 < kBins && !e.draws.empty() ? format::number(steps[i].p, 3) : format::kNothing);
        set(bin, Rhat, format::rhat(e.rhat[i]));
        set(bin, Ess, format::number(e.ess[i], 0));
        set(bin, TwoHeaps,
            modes[i] ? tr("%1 (%2 %) or %3 (%4 %)")
                           .arg(format::signedNumber(modes[i]->lowMean, 2),
                                format::percent(modes[i]->lowShare),
                                format::signedNumber(modes[i]->highMean, 2),
                                format::percent(modes[i]->highShare))
                     : format::kNothing);
    }
}

void NumbersTable::clearEstimate()
{
    for (int bin = 0; bin < kBins; ++bin) {
        set(bin, Bin, format::signedNumber(binCentre(bin), 1));
        for (int column = Height; column < kColumns; ++column)
            set(bin, static_cast<Column>(column), format::kNothing);
    }
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
    QStringList lines, headings;
    for (int column = 0; column < kColumns; ++column)
        headings << horizontalHeaderItem(column)->text();
    lines << headings.join(QLatin1Char('\t'));
    for (int row = 0; row < rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < kColumns; ++column)
            cells << plainNumber(item(row, column)->text());
        lines << cells.join(QLatin1Char('\t'));
    }
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
