#pragma once

#include <vector>

#include "core/terrain/outline.h"

class QwtPlot;
class QwtPlotShapeItem;

namespace terratact {

/// The robot's side view in a plot in metres: body, tracks, flippers, below the profile.
class RobotSketch {
public:
    explicit RobotSketch(QwtPlot& plot) : plot_(plot) {}

    /// What is not finite, or beyond 100 m, is left out.  Does not replot.
    void setOutline(const Outline& outline);
    void restyle() { setOutline(outline_); }  ///< in the theme as it is now

private:
    QwtPlotShapeItem* newPart();

    QwtPlot& plot_;
    Outline outline_;
    std::vector<QwtPlotShapeItem*> parts_;  ///< the plot's
};

}  // namespace terratact
