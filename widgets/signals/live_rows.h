#pragma once

#include <QAbstractTableModel>
#include <cstddef>
#include <utility>
#include <vector>

namespace terratact {

/// Rows of a table that change several times a second. Numbers are on the right of their columns, texts on the left.
template <class Row, int columns>
class LiveRows : public QAbstractTableModel {
public:
    using QAbstractTableModel::QAbstractTableModel;

    void setRows(std::vector<Row> rows)
    {
        if (rows.size() != rows_.size()) {
            beginResetModel();
            rows_ = std::move(rows);
            endResetModel();
            return;
        }
        rows_ = std::move(rows);
        if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
    }
    const Row& row(int i) const { return rows_.at(static_cast<std::size_t>(i)); }

    int rowCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(rows_.size());
    }
    int columnCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : columns;
    }
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override
    {
        if (orientation != Qt::Horizontal) return {};
        if (role == Qt::DisplayRole) return heading(section);
        if (role == Qt::TextAlignmentRole) return alignment(section);
        return {};
    }

protected:
    virtual QString heading(int column) const = 0;
    virtual bool isNumber(int column) const = 0;

    QVariant alignment(int column) const
    {
        return QVariant::fromValue(
            Qt::Alignment((isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
    }

private:
    std::vector<Row> rows_;
};

}  // namespace terratact
