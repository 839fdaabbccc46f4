#pragma once

#include <qwt_plot_item.h>

#include <array>
#include <vector>

#include "core/strip/strip.h"

namespace terratact {

/// Ground that was felt before (core/strip/strip.h), as seen from the robot: a line in a band, without marks. The line
/// is dashed where the ground was felt, and dotted where it was bounded or felt in part. Ground that was not felt, or
/// has an sd above kMaxSd, is not drawn. With an estimate, only the ground behind the estimate is drawn. The lines of
/// left and right begin with L and R.
class RememberedLayer final : public QwtPlotItem {
public:
    static constexpr double kMaxSd = 0.15;  ///< [m]
    /// Farthest bin that a line is drawn to [m].
    static constexpr double kNeighbour = 1.5 * kBinWidth;

    RememberedLayer();

    void setStrip(const SeenStrip& strip, bool isBesideEstimate);
    const SeenStrip& strip() const { return strip_; }
    bool isBesideEstimate() const { return isBesideEstimate_; }
    /// Returns the bins that are drawn, left and right; of one plane the left ones alone.
    const std::array<std::vector<SeenBin>, 2>& drawn() const { return drawn_; }
    bool isShown() const { return !drawn_[0].empty() || !drawn_[1].empty(); }

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;

private:
    SeenStrip strip_;
    bool isBesideEstimate_ = false;
    std::array<std::vector<SeenBin>, 2> drawn_;
};

}  // namespace terratact
