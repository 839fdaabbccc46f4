#pragma once

#include <optional>

#include "core/infer/estimate/estimate.h"
#include "widgets/base/plain_table.h"

namespace terratact {

/// The scene as numbers: a row per bin, rear to front.  A screen reader reads it cell by cell, Ctrl+C copies it.
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

    /// stepLimit: [m] of the step to the next bin.
    void setEstimate(const TerrainEstimate& estimate, double stepLimit);
    void clearEstimate();

    /// All cells with their headings, columns apart by tabs.
    QString text() const;
    void copy() const;  ///< text() to the clipboard

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void set(int row, Column column, const QString& text);
};

}  // namespace terratact
