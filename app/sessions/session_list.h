#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <QStringList>
#include <cstdint>
#include <vector>

#include "app/recording/session_listing.h"

namespace terratact {

/// Return texts of a recording in the operator's language.
QString verdictsText(const ListedSession& session);  ///< "2 CLEAR · 1 BLOCKED"; empty: none
QString
stateText(const ListedSession& session);  ///< "sealed", "being recorded", "cannot be read" …
QString notesText(const ListedSession& session);  ///< "2: at the door; turned here"
QString sizeText(std::int64_t bytes);             ///< "12.3 MB", "40 kB"
QString durationText(double seconds);             ///< "1:02:03"
/// Returns the local begin, "2026-11-23 12:18:27"; where only the last write is known "before 2026-11-23 12:18:27".
QString beginText(const ListedSession& session);

/// The recordings of a folder as a table model, a row for each.
class SessionList final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column {
        Ground,
        Begins,
        Robot,  ///< of a file that cannot be read: the reason, which fills the columns to Notes
        Lasts,
        Verdicts,
        Notes,
        Probes,
        Alarms,
        Size,
        State,
        kColumns
    };
    static constexpr int kSortRole = Qt::UserRole;        ///< the value to sort by
    static constexpr int kSearchRole = Qt::UserRole + 1;  ///< all texts of a row, in column 0

    using QAbstractTableModel::QAbstractTableModel;

    void clear();
    void add(std::vector<ListedSession> sessions);
    const ListedSession& at(int row) const { return rows_[static_cast<std::size_t>(row)].session; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    struct Row {
        ListedSession session;
        QString search;
    };
    QVariant sortValue(const ListedSession& session, int column) const;

    std::vector<Row> rows_;
};

/// Sorts the recordings and shows those that hold every word of a search.
class SearchedSessions final : public QSortFilterProxyModel {
    Q_OBJECT
public:
    explicit SearchedSessions(SessionList& list, QObject* parent);

    /// Words in any order, separated by blanks; upper and lower case are equal.
    void search(const QString& words);
    const ListedSession& at(int row) const;

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    SessionList& list_;
    QStringList words_;
};

}  // namespace terratact
