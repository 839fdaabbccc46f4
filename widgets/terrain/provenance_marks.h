#pragma once

#include <qwt_interval_symbol.h>
#include <qwt_plot_curve.h>
#include <qwt_symbol.h>

#include <QPen>
#include <array>
#include <optional>

#include "core/infer/estimate/provenance.h"

namespace terratact {

/// Mark of a bin by the provenance of its height. All marks differ in shape, bar pattern and letter, so that colour is
/// not the only cue.
struct ProvenanceMark {
    QwtSymbol::Style shape;
    QColor line, fill;
    int size = 0;  ///< [px] at 100 %
    QPen bar;      ///< pen as returned by barPattern()
};
ProvenanceMark markOf(Provenance provenance);  ///< Returns the mark in the current theme.

/// A bar whose stem has the pen's pattern; its ends are solid and of one width.
class PatternBar final : public QwtIntervalSymbol {
public:
    explicit PatternBar(const QPen& pen);
    void draw(QPainter* painter, Qt::Orientation orientation, const QPointF& from,
              const QPointF& to) const override;
};

/// The marks of one provenance; the legend shows a mark on a piece of its bar.
class MarkCurve final : public QwtPlotCurve {
public:
    explicit MarkCurve(Provenance provenance);
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;

private:
    Provenance provenance_;
};

/// Draws a letter for each bin at the lower edge, below the profile if the canvas is high enough.
class MarkLetters final : public QwtPlotItem {
public:
    MarkLetters();
    std::array<std::optional<Provenance>, kBins> shown{};
    static double height(const QFont& ofPlot);  ///< [px] height of the strip of letters
    /// Returns the part of the strip that the profile leaves free [px]. It is 0 for a low canvas, where letters cover
    /// the lowest heights.
    static double reserved(const QFont& ofPlot, double canvasHeight);

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
};

}  // namespace terratact
