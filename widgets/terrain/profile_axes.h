#pragma once

#include <qwt_scale_draw.h>

#include <array>

class QwtPlot;

namespace terratact {

/// Scale labels "+0.1", "0.0", "−0.2", all of the same width. Close up they have two decimals.
class MetreScale final : public QwtScaleDraw {
public:
    explicit MetreScale(bool withPlus);
    QwtText label(double value) const override;
    void setDecimals(int decimals);

private:
    bool withPlus_;
    int decimals_ = 1;
};

/// The two axes of a TerrainProfileView, with equal scale in x and z at every size.
class ProfileAxes {
public:
    /// Extent that is always visible [m]: the robot with extended flippers, and the bins.
    static constexpr double kLeft = -0.66, kRight = 0.80, kBottom = -0.42, kTop = 0.22;

    explicit ProfileAxes(QwtPlot& plot);

    /// Shows `zoom` times the extent in x, shifted forward by `shift` [m]. Below a zoom of 1 the heights are shown
    /// close up, too, shifted upwards by `rise` [m]. Takes effect with fit(), which keeps them within the whole
    /// picture.
    void setWindow(double zoom, double shift, double rise = 0.0)
    {
        zoom_ = zoom;
        shift_ = shift;
        rise_ = rise;
    }
    double zoom() const { return zoom_; }
    double shift() const { return shift_; }  ///< [m]
    double rise() const { return rise_; }    ///< [m]
    /// Return the ends of the window [m].
    double left() const { return middle() - zoom_ * (kRight - kLeft) / 2.0; }
    double right() const { return middle() + zoom_ * (kRight - kLeft) / 2.0; }

    void restyle();  ///< applies the current theme and font
    void name();     ///< names the axes as the width allows
    /// Fits the heights from bottom to top [m] into the canvas, with `below` [px] left free at the lower edge. Returns
    /// true if the scales changed.
    bool fit(double bottom, double top, double below);

private:
    void setScale(int axis, double from, double to, double scale);
    double middle() const { return (kLeft + kRight) / 2.0 + shift_; }

    QwtPlot& plot_;
    double zoom_ = 1.0, shift_ = 0.0, rise_ = 0.0;
    /// The bottom, top [m], width and height [px] above `below`, zoom, shift and rise of the last fit.
    std::array<double, 7> fitted_{};
};

}  // namespace terratact
