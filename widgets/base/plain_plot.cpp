#include "widgets/base/plain_plot.h"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_layout.h>

namespace terratact {

void makePlain(QwtPlot& plot)
{
    plot.setAutoReplot(false);
    plot.setSizePolicy(QSizePolicy::Expanding,
                       QSizePolicy::Expanding);  // Qwt's policy would use sizeHint() as the minimum
    auto* canvas = new QwtPlotCanvas(&plot);
    canvas->setFrameStyle(QFrame::NoFrame);
    canvas->setFocusIndicator(QwtPlotCanvas::NoFocusIndicator);
    canvas->setPaintAttribute(QwtPlotCanvas::BackingStore,
                              false);  // every telemetry sample repaints the canvas
    plot.setCanvas(canvas);
    plot.plotLayout()->setAlignCanvasToScales(true);
    plot.plotLayout()->setCanvasMargin(0);
}

}  // namespace terratact
