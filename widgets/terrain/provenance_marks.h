#pragma once

#include <qwt_interval_symbol.h>
#include <qwt_plot_curve.h>
#include <qwt_symbol.h>

#include <QBrush>
#include <QPen>
#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "core/infer/estimate/provenance.h"

namespace terratact {

/// Mark of a bin by the provenance of its height. All marks differ in shape, bar pattern and letter, so that colour is
/// not the only cue.
struct ProvenanceMark {
    QwtSymbol::Style shape;
    QColor line;
    int size = 0;  ///< [px] at 100 %
    QPen bar;      ///< with the pattern of barPattern()
};
/// Returns the mark in the current theme. Its fill is markFill()'s (core/infer/estimate/provenance.h).
ProvenanceMark markOf(Provenance provenance);

/// Returns the brush of a mark in a colour. The unfilled part of a mark has the card's colour.
QBrush brushOf(MarkFill fill, const QColor& colour);

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
    /// fills: one of each point.
    void setMarks(const QVector<QPointF>& points, std::vector<MarkFill> fills);
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;

protected:
    void drawSymbols(QPainter* painter, const QwtSymbol& symbol, const QwtScaleMap& x,
                     const QwtScaleMap& y, const QRectF& canvas, int from, int to) const override;

private:
    Provenance provenance_;
    std::vector<MarkFill> fills_;
};

/// Draws a letter for each bin at the lower edge, below the profile if the canvas is high enough.
/// Where the canvas leaves both rows free, each of two sides has one, left above. Else the side in
/// full alone has one.
class MarkLetters final : public QwtPlotItem {
public:
    using Row = std::array<std::optional<Provenance>, kBins>;
    MarkLetters();
    Row shown{};               ///< of the side that is drawn in full
    std::optional<Row> light;  ///< of the side that is drawn lighter
    QString letter;            ///< of the side in full; empty: one plane
    QString lightLetter;
    bool isLightAbove = false;                  ///< the lighter side is the left one
    static double height(const QFont& ofPlot);  ///< [px] height of a row of letters
    /// Returns the part of the rows that the profile leaves free [px]. It is 0 for a low canvas, where letters cover
    /// the lowest heights.
    static double reserved(const QFont& ofPlot, double canvasHeight, int rows = 1);

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;

private:
    void drawRow(QPainter& painter, const QwtScaleMap& x, double top, const Row& row,
                 const QString& of) const;
};

}  // namespace terratact
