#include "widgets/base/plain_plot.h"

#include <qwt_plot_canvas.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_widget.h>

#include <QEvent>
#include <QTimer>

#include "widgets/base/palette.h"

namespace terratact {

PlainPlot::PlainPlot(QWidget* parent) : QwtPlot(parent)
{
    setSizePolicy(QSizePolicy::Expanding,
                  QSizePolicy::Expanding);  // Qwt's policy would use sizeHint() as the minimum
    auto* canvas = new QwtPlotCanvas(this);
    canvas->setFrameStyle(QFrame::NoFrame);
    canvas->setFocusIndicator(QwtPlotCanvas::NoFocusIndicator);
    canvas->setPaintAttribute(QwtPlotCanvas::BackingStore,
                              false);  // every telemetry sample repaints the canvas
    setAutoReplot(false);
    setCanvas(canvas);
    plotLayout()->setAlignCanvasToScales(true);
    plotLayout()->setCanvasMargin(0);
    for (const int axis : {xBottom, yLeft}) axisWidget(axis)->setMargin(0);
}

void PlainPlot::changeEvent(QEvent* event)
{
    QwtPlot::changeEvent(event);
    // Restyles later, because the style sheet sets the palettes of the parts after this event.
    if (event->type() == QEvent::StyleChange) QTimer::singleShot(0, this, [this] { restyle(); });
}

void PlainPlot::styleScales(int letters)
{
    QFont small = font();
    small.setPixelSize(scaled(letters));
    for (const int axis : {xBottom, yLeft}) {
        setAxisFont(axis, small);
        QPalette colours = axisWidget(axis)->palette();
        colours.setColor(QPalette::Text, theme().muted);
        colours.setColor(QPalette::WindowText, theme().cardBorder);
        axisWidget(axis)->setPalette(colours);
    }
}

}  // namespace terratact
