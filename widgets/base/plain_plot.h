#pragma once

#include <qwt_plot.h>

namespace terratact {

/// A plot of live data. The canvas has no frame and no backing store and is aligned with its scales. Only replot()
/// redraws it, and the plot may shrink and grow freely.
class PlainPlot : public QwtPlot {
    Q_OBJECT
public:
    explicit PlainPlot(QWidget* parent);

    /// Applies the current theme and font; runs by itself soon after they change.
    virtual void restyle() = 0;

protected:
    void changeEvent(QEvent* event) override;
    /// Sets font and colours of both scales. letters: height [px] at 100 %.
    void styleScales(int letters);
};

}  // namespace terratact
