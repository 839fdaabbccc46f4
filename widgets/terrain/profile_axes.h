#pragma once

#include <qwt_scale_draw.h>

#include <array>

class QwtPlot;

namespace terratact {

/// Ticks in the form "+0.1", "0.0", "−0.2"; every label as wide as the widest.
class MetreScale final : public QwtScaleDraw {
public:
    explicit MetreScale(bool withPlus);
    QwtText label(double value) const override;

private:
    bool withPlus_;
};

/// The two axes of a TerrainProfileView: one metre is as long upwards as forwards, whatever the size.
class ProfileAxes {
public:
    /// What is always in the picture [m]: the robot with its flippers out, and the bins.
    static constexpr double kLeft = -0.66, kRight = 0.80, kBottom = -0.42, kTop = 0.22;

    explicit ProfileAxes(QwtPlot& plot);

    void restyle();  ///< in theme and font as they are now
    void name();     ///< as the plot's width allows
    /// Fits the heights from bottom to top [m] into the canvas as it is, above `below` [px] that are left free; true
    /// when the scales had to change.
    bool fit(double bottom, double top, double below);

private:
    QwtPlot& plot_;
    std::array<double, 4>
        fitted_{};  ///< bottom, top [m], width, height [px] above `below` the scales were made for
};

}  // namespace terratact
