#pragma once

#include <qwt_plot_item.h>
#include <qwt_scale_draw.h>

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "core/robot/measurement.h"

namespace terratact {

/// Horizontal extent of a bar on the element axis.
struct Span {
    double left, right;
};

/// Returns the extent of bar number `place` of the `bars` bars of an element.
Span spanOf(int element, int place, int bars);

/// Returns the bar's rectangle from zero to the value [px].
QRectF rectOf(Span span, double value, const QwtScaleMap& x, const QwtScaleMap& y);

/// Symbol and fill that distinguish the arrays; they repeat after four arrays.
struct ArrayLook {
    char16_t symbol;  ///< symbol in the legend
    bool outlined;
    Qt::BrushStyle pattern;  ///< pattern inside the outline
};
const ArrayLook& arrayLook(std::size_t array);

/// Scale of element names, or of notes that replace a name.
class ElementScale final : public QwtScaleDraw {
public:
    ElementScale();
    QwtText label(double value) const override;
    /// Sets the notes that replace element names; an empty note shows the name.
    void setNotes(const std::array<QString, kForceElements>& notes);
    const std::array<QString, kForceElements>& notes() const { return notes_; }
    static QString nameOf(int element);
    using QwtScaleDraw::invalidateCache;

protected:
    // Qwt's drawLabel() would align the lines of a note to the left.
    void drawLabel(QPainter* painter, double value) const override;

private:
    std::array<QString, kForceElements> notes_;
};

/// Shows the unit beside the highest tick.
class UnitScale final : public QwtScaleDraw {
public:
    UnitScale();
    QwtText label(double value) const override;
    void setUnit(const QString& unit);

private:
    QString unit_ = QStringLiteral("N");
};

/// Draws all bars with their peaks.
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
