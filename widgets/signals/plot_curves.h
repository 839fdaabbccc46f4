#pragma once

#include <qwt_plot_item.h>

#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "core/series/series_view.h"

namespace terratact {

/// One signal of a time plot.
struct TimePlotCurve {
    QString name, unit;
    SeriesView view;
    bool isHeld = false;  ///< a value holds until the next one
};

/// Returns the lines of a curve [px]. They go from the lowest to the highest value of each column,
/// and on to the next one. They break at pauses. until: time up to which a held value is drawn [s].
std::vector<QPolygonF> curveLines(const TimePlotCurve& curve, const QwtScaleMap& x,
                                  const QwtScaleMap& y, double until);

/// Returns the range of the visible values; empty: there are none.
std::optional<std::pair<double, double>> visibleRange(const std::vector<TimePlotCurve>& curves);

/// Draws the curves of a row with their numbers, the cursor, a legend and the box that is being drawn.
class PlotCurves final : public QwtPlotItem {
public:
    std::vector<TimePlotCurve> curves;
    double until = 0.0;            ///< [s] end of the data
    std::optional<double> cursor;  ///< [s]
    std::optional<QRectF> box;     ///< [px]
    bool isChosen = false;

    static constexpr std::size_t kMaxCurves = 4;  ///< curves with a colour of their own
    static QColor colourOf(std::size_t curve);
    /// Returns "1 pitch 0.12 rad": number, name and value at the cursor.
    static QString legendOf(std::size_t curve, const TimePlotCurve& its);

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;

private:
    void drawNumber(QPainter& painter, std::size_t curve, QPointF end, const QRectF& canvas) const;
    void drawLegend(QPainter& painter, const QRectF& canvas) const;
};

}  // namespace terratact
