#pragma once

#include <qwt_plot_item.h>
#include <qwt_symbol.h>

#include <QColor>
#include <QPainterPath>
#include <QPen>
#include <QPointF>
#include <QString>
#include <optional>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/robot/force_sensor.h"

namespace terratact {

/// Returns the colour of the side that is drawn lighter.
QColor lightened(const QColor& colour);

/// Draws a side's line [px]: solid for the right side, hollow (two thin lines) for the left one. dashed: only the prior
/// supports it. A hollow line has its core in the card's colour.
void drawSideLine(QPainter& painter, const QPainterPath& path, Side side, const QColor& colour,
                  bool dashed);

/// Returns the pen of a line of this width [px], and the same where only the prior supports the line.
QPen sideLinePen(const QColor& colour, double width);
QPen sidePriorPen(const QColor& colour, double width);

/// Width of a side's line and of the core of a hollow one [px].
inline constexpr double kSideLine = 3.0, kHollowLine = 6.0, kHollowCore = 3.0;

/// The other side of a two-track estimate. It is lighter than the side in full and stands beside it: the left side
/// kAside to the rear, the right side kAside to the front. Bins have small marks of their provenance and thin bars.
class LightSide final : public QwtPlotItem {
public:
    static constexpr double kAside = 0.028;  ///< [m]

    LightSide();
    std::optional<TerrainEstimate> estimate;  ///< empty: nothing is drawn
    Side side = Side::Left;
    double aside() const { return side == Side::Left ? -kAside : kAside; }

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;

private:
    void drawLines(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y) const;
    void drawBins(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y) const;
};

/// The letters of the sides at both ends of their lines. Tags that would overlap move apart.
class SideTags final : public QwtPlotItem {
public:
    struct Tag {
        Side side = Side::Left;
        QPointF rear, front;  ///< [m] ends of the line
        bool isFull = true;   ///< the side is drawn in full
    };
    SideTags();
    std::vector<Tag> tags;

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
};

/// The legend entry of a side's line; it draws nothing in the plot.
class SideKey final : public QwtPlotItem {
public:
    explicit SideKey(Side side);
    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;

private:
    Side side_;
};

}  // namespace terratact
