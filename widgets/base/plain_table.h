#pragma once

#include <QFontMetrics>
#include <QList>
#include <QStringList>
#include <QTableView>
#include <QTableWidget>

namespace terratact {

/// Whether it is of those that come where the size of letters has changed.
bool changesLetters(const QEvent& event);

/// The width [px] of a table's column that has room for its name and for each of the texts.  letters: of the table, or of
/// what it is in, which may know of a change before it does.
int columnWidthFor(const QTableView& table, const QFontMetrics& letters, int column,
                   const QStringList& texts);

/// Makes the rows as high as the letters need.  A QTableView's are so many pixels whatever its letters are.
void fitRows(QTableView& table, const QFontMetrics& letters);

/// A table that is as wide at least as the names of its columns need.
class HeadedTable : public QTableWidget {
    Q_OBJECT
public:
    using QTableWidget::QTableWidget;
    QSize minimumSizeHint() const override;
};

/// A table to be read: nothing to edit, choose or move in it.  Its rows and columns follow the size of the letters.
class PlainTable : public QTableView {
    Q_OBJECT
public:
    explicit PlainTable(QWidget* parent = nullptr);

    /// For each column of the model the texts it has room for beside its name; the last column takes what is left.
    void setWidest(QList<QStringList> widest);

protected:
    void changeEvent(QEvent* event) override;

private:
    void resizeToFont();

    QList<QStringList> widest_;
};

}  // namespace terratact
