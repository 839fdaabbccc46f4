#pragma once

#include <QFontMetrics>
#include <QList>
#include <QStringList>
#include <QTableView>
#include <QTableWidget>

namespace terratact {

/// Returns true for events that follow a change of the font size.
bool changesFont(const QEvent& event);

/// Returns the width [px] of a column that fits its heading and all texts. letters: font metrics of the table or of its
/// parent, which may have a new font earlier.
int columnWidthFor(const QTableView& table, const QFontMetrics& letters, int column,
                   const QStringList& texts);

/// Sets the row height to that of the font; QTableView keeps a fixed height in pixels.
void fitRows(QTableView& table, const QFontMetrics& letters);

/// Makes a table a list from which the operator chooses one row. Nothing is edited, and Tab leaves it.
void chooseRows(QTableView& table);

/// A table at least as wide as its column headings.
class HeadedTable : public QTableWidget {
    Q_OBJECT
public:
    using QTableWidget::QTableWidget;
    QSize minimumSizeHint() const override;
};

/// A read-only table without editing, selection or moving columns. Rows and columns follow the font size.
class PlainTable : public QTableView {
    Q_OBJECT
public:
    explicit PlainTable(QWidget* parent = nullptr);

    /// Sets, per column of the model, the texts that must fit beside the heading. The last column takes the remaining
    /// width.
    void setWidest(QList<QStringList> widest);

protected:
    void changeEvent(QEvent* event) override;

private:
    void resizeToFont();

    QList<QStringList> widest_;
};

}  // namespace terratact
