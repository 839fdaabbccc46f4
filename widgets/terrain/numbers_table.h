#pragma once

#include <optional>

#include "core/infer/estimate/estimate.h"
#include "widgets/base/plain_table.h"

namespace terratact {

/// The scene as numbers, one row per bin from rear to front. Screen readers read it cell by cell; Ctrl+C copies it.
class NumbersTable final : public HeadedTable {
    Q_OBJECT
public:
    enum Column {
        Bin,
        Height,
        Sd,
        Low,
        High,
        Ceiling,
        From,
        Touched,
        Step,
        Rhat,
        Ess,
        TwoHeaps,
        kColumns
    };

    explicit NumbersTable(QWidget* parent = nullptr);

    /// stepLimit: height of a step to the next bin that counts as an obstacle [m].
    void setEstimate(const TerrainEstimate& estimate, double stepLimit);
    void clearEstimate();

    /// Returns all cells with their headings, separated by tabs.
    QString text() const;
    void copy() const;  ///< copies text() to the clipboard

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void set(int row, Column column, const QString& text);
};

}  // namespace terratact
