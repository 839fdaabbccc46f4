#pragma once

#include <qwt_plot_item.h>

#include <array>
#include <optional>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/verdict/bimodality.h"

namespace terratact {

/// Draws some posterior draws as thin lines, which show how the bands arise.
class SampleLines final : public QwtPlotItem {
public:
    SampleLines();
    static constexpr std::size_t kMax = 60;
    std::vector<Heights> draws;  ///< at most kMax are drawn, evenly spaced

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;
};

/// A second method's estimate of the same scene, shifted to the right: open circles, thin bars and a dotted line.
class SecondEstimate final : public QwtPlotItem {
public:
    SecondEstimate();
    std::optional<TerrainEstimate> estimate;

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;
};

/// Mutes and hatches everything below it and states the reason; draws nothing if `words` is empty.
class StaleOverlay final : public QwtPlotItem {
public:
    StaleOverlay();
    QString words;

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
};

/// Draws both modes of a bin whose draws are bimodal, with their shares. The mean between them is almost never the true
/// height.
class TwoHeights final : public QwtPlotItem {
public:
    TwoHeights();
    std::array<std::optional<TwoModes>, kBins> modes;

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;
};

}  // namespace terratact
