#pragma once

#include <qwt_plot.h>

#include <array>
#include <optional>

#include "core/robot/measurement.h"

class QwtPlotGrid;
class QwtPlotMarker;

namespace terratact {

class ForceChart;

/// Six live bars with their numbers, element 1 at the pivot and 6 at the tip, and the threshold line.
/// A bar above the threshold is blue, hatched and says "contact".  An element without a value reads "--".
class ForceBars final : public QwtPlot {
    Q_OBJECT
public:
    explicit ForceBars(QWidget* parent = nullptr);

    void setForces(const std::array<std::optional<double>, kForceElements>& newtons);
    void clearForces();  ///< nothing measured: every element reads "--"
    void setThreshold(double newtons);

    bool touching(int element) const;                ///< index 0 … 5
    QString numberText(int element) const;           ///< as shown above the bar
    double pixelOf(double newtons) const;            ///< canvas y
    double fullScale() const { return fullScale_; }  ///< [N]

    QSize sizeHint() const override { return {380, 140}; }
    QSize minimumSizeHint() const override { return {260, 120}; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void restyle();  ///< in theme and font as they are now
    void show();

    std::array<std::optional<double>, kForceElements> force_{};
    double threshold_ = 2.0;   // [N]
    double fullScale_ = 10.0;  // [N]
    ForceChart* chart_ = nullptr;
    QwtPlotGrid* grid_ = nullptr;
    QwtPlotMarker* thresholdLine_ = nullptr;
    std::array<QwtPlotMarker*, kForceElements> numbers_{};
};

}  // namespace terratact
