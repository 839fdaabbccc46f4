#pragma once

#include <qwt_interval_symbol.h>
#include <qwt_plot_curve.h>
#include <qwt_symbol.h>

#include <QPen>
#include <array>
#include <optional>

#include "core/infer/estimate/provenance.h"

namespace terratact {

/// How a bin is drawn for what speaks for its height: no two alike in shape, in the pattern of the bar or in letter,
/// so that they are told apart without colours, too.
struct ProvenanceMark {
    QwtSymbol::Style shape;
    QColor line, fill;
    int size = 0;  ///< [px] at 100 %
    QPen bar;      ///< as barPattern() has it
};
ProvenanceMark markOf(Provenance provenance);  ///< in the theme in force

/// A bar whose stem has the pen's pattern and whose ends are solid and of one width.
class PatternBar final : public QwtIntervalSymbol {
public:
    explicit PatternBar(const QPen& pen);
    void draw(QPainter* painter, Qt::Orientation orientation, const QPointF& from,
              const QPointF& to) const override;
};

/// The marks of one kind of bins; the legend shows one upon a piece of its bar.
class MarkCurve final : public QwtPlotCurve {
public:
    explicit MarkCurve(Provenance provenance);
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;

private:
    Provenance provenance_;
};

/// A letter for each bin at the lower edge, below everything else where there is room for that.
class MarkLetters final : public QwtPlotItem {
public:
    MarkLetters();
    std::array<std::optional<Provenance>, kBins> shown{};
    static double height(const QFont& ofPlot);  ///< [px] of the strip they stand in
    /// [px] of it that the profile leaves free; none of a low canvas, where letters lie upon the lowest heights.
    static double reserved(const QFont& ofPlot, double canvasHeight);

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
};

}  // namespace terratact
