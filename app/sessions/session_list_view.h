#pragma once

#include <QTableView>
#include <QTimer>

namespace terratact {

class SearchedSessions;

/// The table of recordings: a thumbnail of the last estimate in the first column, a row for each
/// file. Columns sort by a click on their heading, or by their number with Alt (Alt+1 … Alt+9,
/// Alt+0). A second time gives the other order.
class SessionListView final : public QTableView {
    Q_OBJECT
public:
    explicit SessionListView(SearchedSessions& sessions, QWidget* parent = nullptr);

    void sortBy(int column);  ///< the other order if the column is sorted already

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void resizeToFont();
    void spanSoon();
    void spanReasons();  ///< lets the reasons of unreadable files fill several columns

    SearchedSessions& sessions_;
    QTimer span_;
};

}  // namespace terratact
