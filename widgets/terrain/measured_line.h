#pragma once

#include <qwt_plot_item.h>

#include <QPointF>
#include <QString>
#include <QStringList>
#include <array>
#include <cstdint>
#include <optional>

namespace terratact {

/// An end of a measurement in the picture.
struct MeasuredEnd {
    enum class Kind : std::uint8_t {
        Felt,        ///< on ground that is felt at this pose
        Remembered,  ///< on ground that was felt along the way
        Unfelt,      ///< no ground is felt there: nothing is known of its height
        Free         ///< a point above or below felt ground
    };
    QPointF at;  ///< [m] DEM frame; the height of an unfelt end is only drawn
    Kind kind = Kind::Unfelt;
    double sd = 0.0;  ///< [m] of the height, if felt or remembered
    QString word{};   ///< in the operator's language: "felt", "bounded", "remembered"
    bool isKnown() const { return kind != Kind::Unfelt; }
};

/// Distance, rise and slope between two ends, from rear to front. A rise ahead is positive.
struct MeasuredSlope {
    double distance = 0.0;       ///< [m] horizontal
    std::optional<double> rise;  ///< [m]; empty: an end is not felt
    std::optional<double>
        slope;  ///< [rad] atan2(rise, distance); empty: no rise, or both ends are one point
};
MeasuredSlope measuredSlope(const MeasuredEnd& a, const MeasuredEnd& b);

/// Returns the measurement as lines. The first have distance, rise and slope. The last have both ends with their
/// bands, or state that an end is not felt.
QStringList measuredText(const MeasuredEnd& a, const MeasuredEnd& b);

/// Draws a measurement: both ends, the line between them, and its two legs. The words stand in a frame at the upper
/// right, or below if an end is there. The same frame states how much closer the picture is shown.
class MeasuredLine final : public QwtPlotItem {
public:
    MeasuredLine();
    std::optional<std::array<MeasuredEnd, 2>> ends;
    QStringList lines;  ///< in the frame; none: there is no frame

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;

private:
    void drawFrame(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
                   const QRectF& canvas) const;
};

}  // namespace terratact
