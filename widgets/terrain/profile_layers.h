#pragma once

#include <qwt_plot_item.h>

#include <array>
#include <optional>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/verdict/bimodality.h"
#include "core/infer/verdict/ghost.h"

namespace terratact {

/// Some of the draws as thin lines: what the bands are made of.
class SampleLines final : public QwtPlotItem {
public:
    SampleLines();
    static constexpr std::size_t kMax = 60;
    std::vector<Heights> draws;  ///< at most kMax of them are drawn, evenly picked

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;
};

/// A second method's estimate of the same scene: open circles, thin bars and a dotted line, a little to the right.
class SecondEstimate final : public QwtPlotItem {
public:
    SecondEstimate();
    std::optional<TerrainEstimate> estimate;

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;
};

/// The last estimate while the robot drives on: a dashed line in a band without marks.
class GhostLayer final : public QwtPlotItem {
public:
    GhostLayer();
    std::optional<Ghost> ghost;

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;
};

/// Mutes and hatches all that lies below it, and says why; nothing where `words` is empty.
class StaleOverlay final : public QwtPlotItem {
public:
    StaleOverlay();
    QString words;

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
};

/// Where the draws of a bin fall into two heaps: both heights with their shares, in place of a mean that is
/// hardly ever true.
class TwoHeights final : public QwtPlotItem {
public:
    TwoHeights();
    std::array<std::optional<TwoModes>, kBins> modes;

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;
};

}  // namespace terratact
