#include "widgets/force_bars.h"

#include <qwt_column_symbol.h>
#include <qwt_plot_barchart.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>

#include <QEvent>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "widgets/palette.h"
#include "widgets/words.h"

namespace terratact {
namespace {

/// A bar in one colour, hatched where it touches.
class ForceColumn final : public QwtColumnSymbol {
public:
    explicit ForceColumn(bool touching) : QwtColumnSymbol(QwtColumnSymbol::Box), touching_(touching)
    {
    }
    void draw(QPainter* painter, const QwtColumnRect& column) const override
    {
        const QRectF bar = column.toRect().normalized();
        painter->save();
        painter->fillRect(bar, touching_ ? theme().contact : theme().force);
        QColor hatch = theme().card;
        hatch.setAlpha(110);
        if (touching_) painter->fillRect(bar, QBrush(hatch, Qt::BDiagPattern));
        painter->restore();
    }

private:
    bool touching_;
};

class ElementScale final : public QwtScaleDraw {
public:
    ElementScale()
    {
        enableComponent(QwtAbstractScaleDraw::Ticks, false);
        enableComponent(QwtAbstractScaleDraw::Backbone, true);
    }
    QwtText label(double value) const override
    {
        const int element = static_cast<int>(std::lround(value)) + 1;
        if (element == 1) return ForceBars::tr("1 pivot");
        if (element == kForceElements) return ForceBars::tr("%1 tip").arg(element);
        return QString::number(element);
    }
};

}  // namespace

class ForceChart final : public QwtPlotBarChart {
public:
    ForceChart()
    {
        setLayoutPolicy(QwtPlotAbstractBarChart::AutoAdjustSamples);
        setSpacing(18);
        setMargin(8);
    }
    std::array<bool, kForceElements> touching{};

    QwtColumnSymbol* specialSymbol(int index, const QPointF& /*sample*/) const override
    {
        return new ForceColumn(touching[static_cast<std::size_t>(index)]);
    }
};

ForceBars::ForceBars(QWidget* parent) : QwtPlot(parent)
{
    setAccessibleName(tr("Forces on the front flippers"));
    setAutoReplot(false);
    auto* frame = new QwtPlotCanvas(this);
    frame->setFrameStyle(QFrame::NoFrame);
    frame->setFocusIndicator(QwtPlotCanvas::NoFocusIndicator);
    setCanvas(frame);
    plotLayout()->setAlignCanvasToScales(true);
    plotLayout()->setCanvasMargin(0);
    setAxisScaleDraw(QwtPlot::xBottom, new ElementScale);
    setAxisScale(QwtPlot::xBottom, -0.5, kForceElements - 0.5, 1.0);
    QList<double> elements;
    for (int i = 0; i < kForceElements; ++i) elements << i;
    setAxisScaleDiv(QwtPlot::xBottom, QwtScaleDiv(-0.5, kForceElements - 0.5, {}, {}, elements));
    axisScaleDraw(QwtPlot::yLeft)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
    axisScaleDraw(QwtPlot::yLeft)->enableComponent(QwtAbstractScaleDraw::Ticks, false);
    for (const int axis : {static_cast<int>(QwtPlot::xBottom), static_cast<int>(QwtPlot::yLeft)})
        axisWidget(axis)->setMargin(0);

    grid_ = new QwtPlotGrid;
    grid_->enableX(false);
    grid_->attach(this);

    chart_ = new ForceChart;
    chart_->setZ(10.0);
    chart_->attach(this);

    thresholdLine_ = new QwtPlotMarker;
    thresholdLine_->setLineStyle(QwtPlotMarker::HLine);
    thresholdLine_->setZ(20.0);
    thresholdLine_->attach(this);

    for (std::size_t i = 0; i < kForceElements; ++i) {
        numbers_[i] = new QwtPlotMarker;
        numbers_[i]->setLabelAlignment(Qt::AlignTop | Qt::AlignHCenter);
        numbers_[i]->setSpacing(2);
        numbers_[i]->setZ(30.0);
        numbers_[i]->attach(this);
    }
    restyle();
}

void ForceBars::restyle()
{
    setCanvasBackground(theme().card);
    QFont small = font();
    small.setPixelSize(scaled(13));
    for (const int axis : {static_cast<int>(QwtPlot::xBottom), static_cast<int>(QwtPlot::yLeft)}) {
        setAxisFont(axis, small);
        QPalette colours = axisWidget(axis)->palette();
        colours.setColor(QPalette::Text, theme().muted);
        colours.setColor(QPalette::WindowText, theme().cardBorder);
        axisWidget(axis)->setPalette(colours);
    }
    axisScaleDraw(QwtPlot::xBottom)->setMinimumExtent(scaled(24));
    axisScaleDraw(QwtPlot::yLeft)->setMinimumExtent(scaled(26));
    grid_->setMajorPen(theme().grid, 1.0);
    thresholdLine_->setLinePen(theme().bad, 1.5, Qt::DashLine);
    show();
}

void ForceBars::changeEvent(QEvent* event)
{
    QwtPlot::changeEvent(event);
    // Later: the style sheet still has the palettes of the parts to set.
    if (event->type() == QEvent::StyleChange) QTimer::singleShot(0, this, [this] { restyle(); });
}

void ForceBars::setForces(const std::array<std::optional<double>, kForceElements>& newtons)
{
    force_ = newtons;
    for (auto& force : force_) {
        if (force && !(std::isfinite(*force) && std::abs(*force) <= 1000.0)) force.reset();
    }
    show();
}

void ForceBars::clearForces()
{
    force_.fill(std::nullopt);
    show();
}

void ForceBars::setThreshold(double newtons)
{
    if (!(newtons >= 0.0 && newtons <= 1000.0)) return;
    threshold_ = newtons;
    show();
}

bool ForceBars::touching(int element) const
{
    const auto& force = force_.at(static_cast<std::size_t>(element));
    return force && *force > threshold_;
}

QString ForceBars::numberText(int element) const
{
    const auto& force = force_.at(static_cast<std::size_t>(element));
    return force ? words::number(*force, 1) : words::kNothing;
}

double ForceBars::pixelOf(double newtons) const
{
    return canvasMap(QwtPlot::yLeft).transform(newtons);
}

void ForceBars::show()
{
    double largest = threshold_;
    for (const auto& force : force_) largest = std::max(largest, force.value_or(0.0));
    // The scale grows at once and shrinks late, so that the bars do not jump.
    constexpr std::array kScales{5.0,   10.0,  20.0,  30.0,  40.0,  50.0,   80.0,
                                 100.0, 150.0, 200.0, 400.0, 800.0, 1000.0, 1400.0};
    const auto fits = [&](double share) {
        return *std::find_if(kScales.begin(), kScales.end() - 1,
                             [&](double scale) { return largest <= share * scale; });
    };
    if (largest > 0.75 * fullScale_) fullScale_ = fits(0.75);
    if (largest < 0.3 * fullScale_) fullScale_ = std::max(10.0, fits(0.6));

    constexpr std::array kSteps{1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0};
    const double step = *std::find_if(kSteps.begin(), kSteps.end() - 1,
                                      [this](double s) { return fullScale_ / s <= 5.0; });
    QList<double> ticks;
    const int count = static_cast<int>(std::floor(fullScale_ / step + 1e-9));
    for (int i = 0; i <= count; ++i) ticks << i * step;
    setAxisScaleDiv(QwtPlot::yLeft, QwtScaleDiv(0.0, fullScale_, {}, {}, ticks));

    QVector<QPointF> bars;
    QStringList spoken;
    for (int element = 0; element < kForceElements; ++element) {
        const auto i = static_cast<std::size_t>(element);
        const double height = std::max(0.0, force_[i].value_or(0.0));
        bars << QPointF(element, height);
        chart_->touching[i] = touching(element);
        QwtText label(touching(element) ? numberText(element) + QLatin1Char('\n') + tr("contact")
                                        : numberText(element));
        QFont face = font();
        face.setPixelSize(scaled(13));
        face.setBold(touching(element));
        label.setFont(face);
        label.setColor(touching(element) ? theme().contact : theme().muted);
        // Above the threshold line too, which would strike it out.
        label.setBackgroundBrush(theme().card);
        numbers_[i]->setValue(element, std::max(height, threshold_));
        numbers_[i]->setLabel(label);
        spoken << tr("element %1: %2 N%3")
                      .arg(element + 1)
                      .arg(numberText(element), touching(element) ? tr(", contact") : QString());
    }
    chart_->setSamples(bars);
    thresholdLine_->setYValue(threshold_);
    setAccessibleDescription(spoken.join(QLatin1Char('\n')));
    replot();
}

}  // namespace terratact
