#pragma once

#include <QHeaderView>
#include <QStringList>
#include <QTableView>
#include <algorithm>

namespace terratact {

/// A table to be read: nothing to edit, choose or move in it.  widest: for each column the longest text it has room
/// for beside its name; the last one takes what is left.
inline void makePlain(QTableView& table, const QStringList& widest)
{
    constexpr int kRowSpace = 6, kColumnSpace = 24;  // [px]
    table.setSelectionMode(QAbstractItemView::NoSelection);
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setTabKeyNavigation(false);
    table.setShowGrid(false);
    table.setWordWrap(false);
    table.setFrameShape(QFrame::NoFrame);
    table.verticalHeader()->setVisible(false);
    table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + kRowSpace);
    table.horizontalHeader()->setHighlightSections(false);
    table.horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    for (int column = 0; column + 1 < widest.size(); ++column) {
        const QString name = table.model()->headerData(column, Qt::Horizontal).toString();
        const int text = std::max(table.fontMetrics().horizontalAdvance(widest[column]),
                                  table.fontMetrics().horizontalAdvance(name));
        table.setColumnWidth(column, text + kColumnSpace);
    }
    table.horizontalHeader()->setStretchLastSection(true);
}

}  // namespace terratact
