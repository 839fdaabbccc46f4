#include "widgets/signals/time_plot.h"

#include <qwt_plot_grid.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>

#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "app/display/format.h"
#include "widgets/base/palette.h"
#include "widgets/signals/session_timeline.h"

namespace terratact {
namespace {

constexpr double kBoxLeast = 5.0;  // [px] a smaller one is a click

/// Labels of a time scale: "1:02:03".
class TimeScaleDraw final : public QwtScaleDraw {
public:
    QwtText label(double value) const override
    {
        const bool isBefore = value < zero - 0.5 * step;  // nothing was there
        return isBefore ? QwtText() : QwtText(timeText(value - zero, step));
    }
    using QwtScaleDraw::invalidateCache;
    double zero = 0.0, step = 1.0;  ///< [s]
};

/// Labels of values with five digits.
class ValueScaleDraw final : public QwtScaleDraw {
public:
    ValueScaleDraw() { enableComponent(QwtAbstractScaleDraw::Backbone, false); }
    QwtText label(double value) const override { return format::significant(value, 5); }
};

constexpr std::array kPlotAxes{QwtPlot::xBottom, QwtPlot::yLeft};

}  // namespace

TimePlot::TimePlot(QWidget* parent) : PlainPlot(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAxisScaleDraw(QwtPlot::xBottom, new TimeScaleDraw);
    setAxisScaleDraw(QwtPlot::yLeft, new ValueScaleDraw);
    setAxisMaxMajor(QwtPlot::yLeft, 4);
    setAxisMaxMinor(QwtPlot::yLeft, 0);
    grid_ = new QwtPlotGrid;
    grid_->attach(this);
    items_ = new PlotCurves;
    items_->setZ(10.0);
    items_->attach(this);
    canvas()->setMouseTracking(true);
    canvas()->setCursor(Qt::CrossCursor);
    canvas()->installEventFilter(this);
    restyle();
}

void TimePlot::restyle()
{
    setCanvasBackground(theme().card);
    styleScales(12);
    for (const int axis : kPlotAxes) {
        axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MajorTick, 4);
        axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MediumTick, 0);
        axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MinorTick, 0);
    }
    axisWidget(QwtPlot::xBottom)->setMinBorderDist(scaled(30), scaled(30));
    axisWidget(QwtPlot::yLeft)->setMinBorderDist(scaled(4), scaled(4));
    grid_->setMajorPen(theme().grid, 0.0);
    replot();
}

void TimePlot::setCurves(std::vector<TimePlotCurve> curves)
{
    items_->curves = std::move(curves);
    if (items_->curves.size() > PlotCurves::kMaxCurves)
        items_->curves.resize(PlotCurves::kMaxCurves);
    describeRow();
}

const std::vector<TimePlotCurve>& TimePlot::curves() const
{
    return items_->curves;
}

void TimePlot::describeRow()
{
    QStringList names, values;
    for (std::size_t i = 0; i < items_->curves.size(); ++i) {
        names << items_->curves[i].name;
        values << PlotCurves::legendOf(i, items_->curves[i]);
    }
    const QString name =
        tr("Plot of %1").arg(names.isEmpty() ? tr("nothing") : names.join(QStringLiteral(", ")));
    if (accessibleName() != name) setAccessibleName(name);
    const QString description = values.join(QStringLiteral("; "));
    if (hasFocus() && accessibleDescription() != description) setAccessibleDescription(description);
}

void TimePlot::setSpan(double from, double to, double zero, double until)
{
    from_ = from;
    to_ = to;
    zero_ = zero;
    items_->until = std::isfinite(until) ? until : to;
}

void TimePlot::setCursor(std::optional<double> seconds)
{
    items_->cursor = seconds && std::isfinite(*seconds) ? seconds : std::nullopt;
}

void TimePlot::setValues(const std::optional<std::pair<double, double>>& range)
{
    values_ = range;
}

void TimePlot::setTimeScaleShown(bool shown)
{
    static_cast<TimeScaleDraw*>(axisScaleDraw(QwtPlot::xBottom))
        ->enableComponent(QwtAbstractScaleDraw::Labels, shown);
}

void TimePlot::setChosen(bool chosen)
{
    items_->isChosen = chosen;
}

int TimePlot::valueExtent() const
{
    return static_cast<int>(
        std::ceil(axisScaleDraw(QwtPlot::yLeft)->extent(axisFont(QwtPlot::yLeft))));
}

void TimePlot::setValueExtent(int pixels)
{
    axisScaleDraw(QwtPlot::yLeft)->setMinimumExtent(pixels);
}

/// Keeps the range while the values fill it well, so that a live scale does not tremble.
void TimePlot::fitValues()
{
    if (values_) {
        std::tie(low_, high_) = *values_;
        return;
    }
    const auto sight = visibleRange(items_->curves);
    if (!sight) return;
    // Qwt's scale engine takes no larger numbers.
    constexpr double kLargest = 1e30;
    const double low = std::clamp(sight->first, -kLargest, kLargest);
    const double high = std::clamp(sight->second, -kLargest, kLargest);
    const double range = high_ - low_;
    const double wanted = std::max({high - low, 1e-3, 1e-3 * std::abs(high)});
    if (low >= low_ && high <= high_ && wanted > 0.4 * range) return;
    const double middle = 0.5 * (low + high);
    low_ = middle - 0.6 * wanted;
    high_ = middle + 0.75 * wanted;  // room for the legend
}

void TimePlot::show()
{
    fitValues();
    auto* const scale = static_cast<TimeScaleDraw*>(axisScaleDraw(QwtPlot::xBottom));
    const double step =
        timeStep(to_ - from_, std::max(2.0, static_cast<double>(canvas()->width()) / scaled(86)));
    QList<double> ticks;
    for (double k = std::ceil((from_ - zero_) / step);
         zero_ + k * step <= to_ && ticks.size() < 100; k += 1.0)
        ticks << zero_ + k * step;
    if (scale->zero != zero_ || scale->step != step) scale->invalidateCache();
    scale->zero = zero_;
    scale->step = step;
    setAxisScaleDiv(QwtPlot::xBottom, QwtScaleDiv(from_, to_, {}, {}, ticks));
    setAxisScale(QwtPlot::yLeft, low_, high_);
    replot();
}

double TimePlot::timeAt(double pixel) const
{
    return canvasMap(QwtPlot::xBottom).invTransform(pixel);
}

double TimePlot::valueAt(double pixel) const
{
    return canvasMap(QwtPlot::yLeft).invTransform(pixel);
}

void TimePlot::press(const QMouseEvent& event)
{
    setFocus(Qt::MouseFocusReason);
    emit chosen();
    pressedAt_ = event.position();
    grabbed_ = timeAt(event.position().x());
    drags_ = event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::ShiftModifier);
}

void TimePlot::move(const QMouseEvent& event)
{
    const QPointF at = event.position();
    if (!pressedAt_) {
        emit pointed(timeAt(at.x()));
    } else if (drags_) {
        emit moved(grabbed_ - timeAt(at.x()));
    } else {
        items_->box = QRectF(*pressedAt_, at).normalized();
        replot();
    }
}

void TimePlot::release(const QMouseEvent& event)
{
    if (!pressedAt_) return;
    const QRectF box =
        QRectF(*pressedAt_, event.position()).normalized() & QRectF(canvas()->rect());
    const bool wasDrag = drags_;
    pressedAt_.reset();
    items_->box.reset();
    replot();
    if (wasDrag) return;
    if (box.width() < kBoxLeast) {
        emit clicked(timeAt(event.position().x()));
        return;
    }
    // A flat box zooms in time alone.
    const bool isFlat = box.height() < kBoxLeast * 2.0;
    emit boxed({timeAt(box.left()), timeAt(box.right()), isFlat ? low_ : valueAt(box.bottom()),
                isFlat ? high_ : valueAt(box.top())});
}

void TimePlot::wheel(const QWheelEvent& event)
{
    constexpr double kTurn = 120.0, kZoom = 1.25, kMove = 0.1;
    const double turns = (event.angleDelta().y() + event.angleDelta().x()) / kTurn;
    if (event.modifiers().testFlag(Qt::ShiftModifier))
        emit moved(-kMove * turns * (to_ - from_));
    else
        emit zoomed(std::pow(kZoom, turns), timeAt(event.position().x()));
}

bool TimePlot::eventFilter(QObject* object, QEvent* event)
{
    if (object != canvas()) return QwtPlot::eventFilter(object, event);
    switch (event->type()) {
    case QEvent::MouseButtonPress: press(*static_cast<QMouseEvent*>(event)); return true;
    case QEvent::MouseMove: move(*static_cast<QMouseEvent*>(event)); return true;
    case QEvent::MouseButtonRelease: release(*static_cast<QMouseEvent*>(event)); return true;
    case QEvent::Wheel: wheel(*static_cast<QWheelEvent*>(event)); return true;
    case QEvent::Leave: emit left(); break;
    default: break;
    }
    return QwtPlot::eventFilter(object, event);
}

void TimePlot::focusInEvent(QFocusEvent* event)
{
    QwtPlot::focusInEvent(event);
    emit chosen();
    describeRow();
}

QSize TimePlot::sizeHint() const
{
    return {scaled(480), scaled(120)};
}

QSize TimePlot::minimumSizeHint() const
{
    return {scaled(160), scaled(44)};
}

}  // namespace terratact
