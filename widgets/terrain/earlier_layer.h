#pragma once

#include <qwt_plot_item.h>

#include <QPointF>
#include <array>
#include <cstddef>
#include <vector>

#include "core/strip/strip.h"

namespace terratact {

/// Ground that was felt before a break (Strip::earlier()): a thin muted line for each side, without a band or marks.
/// Its place relative to the robot is unknown. So each section ends kGap behind the next one, at heights in its own
/// frame. A dashed rule in the gap has the reason of the break. It has no legend entry. What RememberedLayer would
/// leave out is not drawn.
class EarlierLayer final : public QwtPlotItem {
public:
    static constexpr double kGap = 0.5;  ///< [m]

    EarlierLayer();

    void setSections(const std::vector<EarlierSection>& sections);
    const std::vector<EarlierSection>& sections() const { return sections_; }
    /// Sets the rear end of the ground before which nothing is joined [m]. The newest section ends kGap behind it.
    void setRear(double rear) { rear_ = rear; }
    std::size_t count() const { return stretches_.size(); }  ///< sections that are drawn
    /// Returns the rear end of the oldest section that is drawn [m]; without one, the rear end set.
    double begin() const { return rear_ + (stretches_.empty() ? 0.0 : stretches_.back().begin); }
    /// Returns the points that are drawn between two places [m].
    std::vector<QPointF> within(double left, double right) const;

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;

private:
    /// A section as it is drawn [m]; x from rear_.
    struct Stretch {
        std::array<std::vector<QPointF>, 2> side{};
        double begin = 0.0, end = 0.0;
        SectionStart next = SectionStart::Turned;
    };
    static Stretch stretchOf(const EarlierSection& section, double end);
    void drawRule(QPainter& painter, const Stretch& stretch, const QwtScaleMap& x,
                  const QRectF& canvas) const;

    std::vector<EarlierSection> sections_;
    std::vector<Stretch> stretches_;  ///< newest first
    double rear_ = 0.0;
};

}  // namespace terratact
