#pragma once

#include <optional>

#include "core/infer/estimate/two_track_estimate.h"
#include "widgets/base/plain_table.h"

namespace terratact {

/// The scene as numbers, one row per bin from rear to front. Two sides have a row each per bin, and a column that names
/// the side. Screen readers read it cell by cell; Ctrl+C copies it.
class NumbersTable final : public HeadedTable {
    Q_OBJECT
public:
    enum Column {
        Bin,
        AtSide,  ///< hidden for one plane
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
    void setEstimate(const TwoTrackEstimate& estimate, double stepLimit);
    /// Shows an estimate of one plane.
    void setEstimate(const TerrainEstimate& plane, double stepLimit);
    void clearEstimate();

    /// Returns all cells of shown columns with their headings, separated by tabs.
    QString text() const;
    void copy() const;  ///< copies text() to the clipboard

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void hideChains(bool hidden);
    void setRows(bool twoSides);
    void setSide(const TerrainEstimate& estimate, double stepLimit, int firstRow, int rowsPerBin);
    void set(int row, Column column, const QString& text);
};

}  // namespace terratact
