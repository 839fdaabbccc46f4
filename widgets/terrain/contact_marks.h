#pragma once

#include <qwt_plot_item.h>

#include <QPointF>
#include <QString>
#include <vector>

namespace terratact {

/// A contact of the robot with the ground.
struct ContactPoint {
    QPointF at;       ///< DEM frame [m]
    QString element;  ///< "L5"; empty: the point has no label
    bool operator==(const ContactPoint&) const = default;
};

/// Marks the contacts in the picture: a ring with a dot at each, and one word for all, "CONTACT L5 R5". Points that are
/// not drawable are left out.
class ContactMarks final : public QwtPlotItem {
public:
    ContactMarks();
    /// Returns true if the points differ from the ones before; they are drawn at the next replot.
    bool setPoints(std::vector<ContactPoint> points);
    const std::vector<ContactPoint>& points() const { return points_; }
    QString words() const;  ///< empty without a contact

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;

private:
    std::vector<ContactPoint> points_;
};

}  // namespace terratact
