#pragma once

#include <string>

#include "app/figures/canvas.h"
#include "core/infer/estimate/variant.h"

namespace terratact {

/// How figures draw a method's results.
struct MethodStyle {
    Colour colour{0x8e3fbf};
    Shape shape = Shape::Circle;
    double size = 12.0;   ///< [px]
    std::string words;    ///< as the paper writes it
    bool hollow = false;  ///< a baseline
};

MethodStyle styleOf(Method method);

/// By label: a method, "method/what tells it apart", or a baseline.
MethodStyle styleOf(const std::string& label);

void drawMarker(Canvas& canvas, const MethodStyle& look, Point at, double scale);

}  // namespace terratact
