#pragma once

#include <QList>
#include <QWidget>
#include <optional>
#include <utility>
#include <vector>

#include "widgets/signals/time_plot.h"

class QLabel;
class QVBoxLayout;

namespace terratact {

/// A row of TimePlots.
struct TimePlotRow {
    std::vector<TimePlotCurve> curves{};
    std::optional<std::pair<double, double>>
        values{};  ///< range; empty: follows the visible values
};

/// What TimePlots shows.
struct TimePlotsViewState {
    std::vector<TimePlotRow> rows{};
    double from = 0.0, to = 1.0;  ///< [s]
    double zero = 0.0;            ///< [s] time that the scale names 0
    double until = 0.0;           ///< [s] end of the data
    std::optional<double> cursor{};
    int chosen = 0;  ///< row that buttons act on; −1: none
};

/// Rows of signals with one time axis and one cursor. The rows share the height. GUI thread only.
class TimePlots final : public QWidget {
    Q_OBJECT
public:
    static constexpr int kMaxRows = 6;

    explicit TimePlots(QWidget* parent = nullptr);

    void setViewState(TimePlotsViewState viewState);
    const TimePlotsViewState& viewState() const { return viewState_; }
    TimePlot* row(int index) const { return rows_.at(index); }
    int rows() const { return static_cast<int>(rows_.size()); }
    /// Returns the row at a place of the screen: rows() below the last one; −1: elsewhere.
    int rowAt(const QPoint& global) const;
    int columns() const;  ///< [px] width of the rows' canvas, at least 2
    /// Marks the row that a signal would be dropped on; −1: none.
    void setTarget(int row);

signals:
    void pointed(double seconds);
    void pointerLeft();
    void clicked(double seconds);
    void boxed(int row, const terratact::PlotBox& box);
    void zoomed(double factor, double at);
    void moved(double seconds);
    void rowChosen(int row);

private:
    void setRows(int count);
    void alignRows();

    TimePlotsViewState viewState_;
    int target_ = -1;
    QList<TimePlot*> rows_;
    QVBoxLayout* column_ = nullptr;
    QLabel* empty_ = nullptr;  ///< shown without rows
};

}  // namespace terratact
