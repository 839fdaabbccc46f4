#include "widgets/base/plain_table.h"

#include <QEvent>
#include <QHeaderView>
#include <algorithm>
#include <utility>

namespace terratact {

bool changesFont(const QEvent& event)
{
    return event.type() == QEvent::StyleChange || event.type() == QEvent::FontChange;
}

int columnWidthFor(const QTableView& table, const QFontMetrics& letters, int column,
                   const QStringList& texts)
{
    constexpr int kSpace = 24;  // [px]
    int width =
        letters.horizontalAdvance(table.model()->headerData(column, Qt::Horizontal).toString());
    for (const QString& text : texts) width = std::max(width, letters.horizontalAdvance(text));
    return width + kSpace;
}

void fitRows(QTableView& table, const QFontMetrics& letters)
{
    constexpr int kSpace = 6;  // [px]
    table.verticalHeader()->setDefaultSectionSize(letters.height() + kSpace);
}

void chooseRows(QTableView& table)
{
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setSelectionMode(QAbstractItemView::SingleSelection);
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setTabKeyNavigation(false);
    table.setShowGrid(false);
    table.setAlternatingRowColors(true);
    table.setWordWrap(false);
    table.setFrameShape(QFrame::NoFrame);
    table.verticalHeader()->hide();
    table.horizontalHeader()->setHighlightSections(false);
    table.horizontalHeader()->setStretchLastSection(true);
}

QSize HeadedTable::minimumSizeHint() const
{
    const QHeaderView& header = *horizontalHeader();
    int width = 2 * frameWidth(), widest = 0,
        alike = 0;  // [px], common width of the stretching columns
    for (int column = 0; column < header.count(); ++column) {
        const int needed = header.sectionSizeHint(column);
        if (header.sectionResizeMode(column) == QHeaderView::Stretch)
            widest = std::max(widest, needed), ++alike;
        else
            width += std::max(needed, header.sectionSize(column));
    }
    return {width + alike * widest, QTableWidget::minimumSizeHint().height()};
}

PlainTable::PlainTable(QWidget* parent) : QTableView(parent)
{
    setSelectionMode(QAbstractItemView::NoSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setShowGrid(false);
    setWordWrap(false);
    setFrameShape(QFrame::NoFrame);
    verticalHeader()->setVisible(false);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setStretchLastSection(true);
}

void PlainTable::setWidest(QList<QStringList> widest)
{
    widest_ = std::move(widest);
    resizeToFont();
}

void PlainTable::changeEvent(QEvent* event)
{
    QTableView::changeEvent(event);
    if (changesFont(*event)) resizeToFont();
}

void PlainTable::resizeToFont()
{
    fitRows(*this, fontMetrics());
    for (int column = 0; column + 1 < widest_.size(); ++column)
        setColumnWidth(column, columnWidthFor(*this, fontMetrics(), column, widest_[column]));
}

}  // namespace terratact
