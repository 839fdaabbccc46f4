#pragma once

#include <vector>

#include "core/terrain/outline.h"

class QwtPlot;
class QwtPlotShapeItem;

namespace terratact {

/// Side view of the robot in a plot in metres: body, tracks and flippers, drawn below the profile.
class RobotSketch {
public:
    /// isFar: drawn lighter, behind the side that is near.
    explicit RobotSketch(QwtPlot& plot, bool isFar = false) : plot_(plot), isFar_(isFar) {}

    /// Sets the outline without replotting. Points that are not finite or beyond 100 m are left out.
    void setOutline(const Outline& outline);
    const Outline& outline() const { return outline_; }
    void restyle() { setOutline(outline_); }  ///< applies the current theme

private:
    QwtPlotShapeItem* newPart();

    QwtPlot& plot_;
    bool isFar_ = false;
    Outline outline_;
    std::vector<QwtPlotShapeItem*> parts_;  ///< owned by the plot
};

}  // namespace terratact
