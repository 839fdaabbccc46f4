#include "widgets/terrain/profile_axes.h"

#include <qwt_plot.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>

#include "app/display/format.h"
#include "widgets/base/palette.h"
#include "widgets/terrain/terrain_items.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

constexpr std::array<int, 2> kAxes{QwtPlot::xBottom, QwtPlot::yLeft};
constexpr int kLetters = 13;  // [px] at 100 %

/// Returns the distance of two labels [m], at least `least`; close up it may be below 0.1 m.
double tickStep(double least, bool isCloseUp)
{
    for (const double step : {0.01, 0.02, 0.05})
        if (isCloseUp && step >= least) return step;
    for (const double step : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0})
        if (step >= least) return step;
    return 50.0;
}

}  // namespace

MetreScale::MetreScale(bool withPlus) : withPlus_(withPlus)
{
    enableComponent(QwtAbstractScaleDraw::Backbone, false);
    setTickLength(QwtScaleDiv::MajorTick, 5);
    setTickLength(QwtScaleDiv::MediumTick, 0);
    setTickLength(QwtScaleDiv::MinorTick, 0);
}

QwtText MetreScale::label(double value) const
{
    const double rounded = std::round(value * 100.0) / 100.0;
    if (!withPlus_ || rounded == 0.0) return format::lengthNumber(rounded, decimals_);
    return format::signedLengthNumber(rounded, decimals_);
}

void MetreScale::setDecimals(int decimals)
{
    if (decimals == decimals_) return;
    decimals_ = decimals;
    invalidateCache();
}

ProfileAxes::ProfileAxes(QwtPlot& plot) : plot_(plot)
{
    plot.setAxisScaleDraw(QwtPlot::xBottom, new MetreScale(false));
    plot.setAxisScaleDraw(QwtPlot::yLeft, new MetreScale(true));
}

void ProfileAxes::restyle()
{
    for (const int axis : kAxes) {
        plot_.setAxisFont(axis, sized(plot_.font(), kLetters));
        QPalette colours = plot_.axisWidget(axis)->palette();
        colours.setColor(QPalette::Text, theme().muted);
        colours.setColor(QPalette::WindowText, theme().muted);
        plot_.axisWidget(axis)->setPalette(colours);
    }
    plot_.axisScaleDraw(QwtPlot::yLeft)->setMinimumExtent(scaled(48));
    // Reserves half a label at both ends in any case, so that the canvas does not change with the ticks.
    plot_.axisWidget(QwtPlot::xBottom)->setMinBorderDist(scaled(22), scaled(22));
    plot_.axisWidget(QwtPlot::yLeft)->setMinBorderDist(scaled(10), scaled(10));
    name();
}

void ProfileAxes::name()
{
    // In a narrow plot one name for both axes saves width.
    constexpr int kNarrow = 400;  // [px] at 100 %
    const bool isNarrow = plot_.width() < scaled(kNarrow);
    const QString x =
        isNarrow ? TerrainProfileView::tr("forward, height [%1]").arg(format::lengthUnit())
                 : TerrainProfileView::tr("forward from the IMU [%1]").arg(format::lengthUnit());
    const QString y =
        isNarrow ? QString() : TerrainProfileView::tr("height [%1]").arg(format::lengthUnit());
    const QFont font = sized(plot_.font(), kLetters);
    const QwtText now = plot_.axisTitle(QwtPlot::xBottom);
    if (now.text() == x && now.font() == font && now.color() == theme().muted) return;
    for (const auto& [axis, words] : {std::pair(QwtPlot::xBottom, x), std::pair(QwtPlot::yLeft, y)})
        plot_.setAxisTitle(axis, inked(words, theme().muted, font));
}

/// Sets the ends of an axis [m] and its labels. scale: [px/m]
void ProfileAxes::setScale(int axis, double from, double to, double scale)
{
    const double least =
        scaled(axis == QwtPlot::xBottom ? 44 : 22);  // [px] minimum distance between labels
    const double step = tickStep(least / scale, zoom_ < 1.0);
    QList<double> centres;
    const auto last = static_cast<int>(std::floor(to / step + 1e-9));
    for (auto tick = static_cast<int>(std::ceil(from / step - 1e-9)); tick <= last; ++tick)
        centres << tick * step;
    static_cast<MetreScale*>(plot_.axisScaleDraw(axis))->setDecimals(step < 0.1 ? 2 : 1);
    plot_.setAxisScaleDiv(axis, QwtScaleDiv(from, to, {}, {}, centres));
}

bool ProfileAxes::fit(double bottom, double top, double below)
{
    // Rounds to steps, so that noise does not move the picture.
    bottom = std::floor(bottom / 0.05 + 1e-9) * 0.05;
    top = std::ceil(top / 0.05 - 1e-9) * 0.05;

    const double width = plot_.canvasMap(QwtPlot::xBottom).pDist();
    const double height = plot_.canvasMap(QwtPlot::yLeft).pDist() - below;
    if (!(width > 10.0 && height > 10.0)) return false;
    const double wide = (kRight - kLeft) * std::max(zoom_, 1.0);
    const double scale = std::min(width / wide, height / (top - bottom));  // [px/m] not close up
    const double spareZ = height / scale - (top - bottom);
    double from = bottom - spareZ * 0.6 - below / scale, to = top + spareZ * 0.4;
    const double closeUp = std::min(zoom_, 1.0);
    const double room = (1.0 - closeUp) * (to - from) / 2.0;
    rise_ = std::clamp(rise_, -room, room);
    const std::array<double, 7> wanted{bottom, top, width, height, zoom_, shift_, rise_};
    if (wanted == fitted_) return false;
    fitted_ = wanted;
    from += room + rise_;
    to -= room - rise_;
    const double shown = closeUp * width / scale;  // [m]
    setScale(QwtPlot::xBottom, middle() - shown / 2.0, middle() + shown / 2.0, scale / closeUp);
    setScale(QwtPlot::yLeft, from, to, scale / closeUp);
    plot_.updateAxes();
    return true;
}

}  // namespace terratact
