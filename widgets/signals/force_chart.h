#pragma once

#include <qwt_plot_item.h>
#include <qwt_scale_draw.h>

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "core/robot/measurement.h"

namespace terratact {

/// Of a bar, on the axis of the elements.
struct Span {
    double left, right;
};

/// Of the bar at `place` among as many as `bars` of an element.
Span spanOf(int element, int place, int bars);

/// From zero to the value [px].
QRectF rectOf(Span span, double value, const QwtScaleMap& x, const QwtScaleMap& y);

/// How the bars of an array are told from those of the others; arrays beyond the four that there are begin anew.
struct ArrayLook {
    char16_t symbol;  ///< in the legend
    bool outlined;
    Qt::BrushStyle pattern;  ///< within the outline
};
const ArrayLook& arrayLook(std::size_t array);

/// The elements' names, or a note that stands instead of one.
class ElementScale final : public QwtScaleDraw {
public:
    ElementScale();
    QwtText label(double value) const override;
    /// What stands instead of an element's name; empty: the name.
    void setNotes(const std::array<QString, kForceElements>& notes);
    const std::array<QString, kForceElements>& notes() const { return notes_; }
    static QString nameOf(int element);
    using QwtScaleDraw::invalidateCache;

protected:
    // Qwt's own would set the lines of a note flush left.
    void drawLabel(QPainter* painter, double value) const override;

private:
    std::array<QString, kForceElements> notes_;
};

/// Says the unit beside its highest tick.
class UnitScale final : public QwtScaleDraw {
public:
    UnitScale();
    QwtText label(double value) const override;
    void setUnit(const QString& unit);

private:
    QString unit_ = QStringLiteral("N");
};

/// All bars with their peaks.
class ForceChart final : public QwtPlotItem {
public:
    struct Bar {
        Span span;
        double value;
        std::optional<double> peak;
        bool touching, saturated;
        ArrayLook look;
    };
    std::vector<Bar> bars;

    void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
              const QRectF& canvas) const override;
};

}  // namespace terratact
