#pragma once

#include <QPointF>
#include <optional>
#include <utility>
#include <vector>

#include "widgets/base/plain_plot.h"
#include "widgets/signals/plot_curves.h"

class QwtPlotGrid;

namespace terratact {

/// A span of time and of values, as drawn with the mouse.
struct PlotBox {
    double from = 0.0, to = 0.0;  ///< [s]
    double low = 0.0, high = 0.0;
};

/// One row of time plots: up to four signals over time, with a cursor. The pointer moves the cursor and a click fixes
/// it. A drag draws a box to zoom to. A drag with the right or the middle button, or with Shift, moves in time. The
/// wheel zooms at the pointer, with Shift it moves. GUI thread only.
class TimePlot final : public PlainPlot {
    Q_OBJECT
public:
    explicit TimePlot(QWidget* parent = nullptr);

    void setCurves(std::vector<TimePlotCurve> curves);
    const std::vector<TimePlotCurve>& curves() const;
    /// span: [s]. zero: time that the scale names 0 [s]. until: end of the data [s].
    void setSpan(double from, double to, double zero, double until);
    void setCursor(std::optional<double> seconds);
    /// Sets the range of the values; empty: it follows the visible values.
    void setValues(const std::optional<std::pair<double, double>>& range);
    void setTimeScaleShown(bool shown);  ///< of all rows, the lowest one shows it
    void setChosen(bool chosen);
    int valueExtent() const;          ///< [px] width of the scale of values
    void setValueExtent(int pixels);  ///< the same for all rows, so that times are below each other
    void show();                      ///< draws what was set

    double low() const { return low_; }
    double high() const { return high_; }

    void restyle() override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void pointed(double seconds);  ///< the pointer is at this time
    void left();                   ///< the pointer has left
    void clicked(double seconds);
    void boxed(const terratact::PlotBox& box);
    void zoomed(double factor, double at);  ///< factor > 1: closer; at: keeps its place [s]
    void moved(double seconds);             ///< [s] later
    void chosen();

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

private:
    void fitValues();
    double timeAt(double pixel) const;
    double valueAt(double pixel) const;
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    void describeRow();

    PlotCurves* items_ = nullptr;
    QwtPlotGrid* grid_ = nullptr;
    double from_ = 0.0, to_ = 1.0, zero_ = 0.0;  ///< [s]
    double low_ = 0.0, high_ = 1.0;
    std::optional<std::pair<double, double>> values_;
    std::optional<QPointF> pressedAt_;  ///< [px]
    double grabbed_ = 0.0;              ///< [s] time that is dragged
    bool drags_ = false;                ///< moves in time, else draws a box
};

}  // namespace terratact
