#pragma once

#include <string>

#include "app/figures/canvas.h"
#include "core/infer/estimate/variant.h"

namespace terratact {

/// How figures draw a method's results.
struct MethodLook {
    Colour colour{0x8e3fbf};
    Shape shape = Shape::Circle;
    double size = 12.0;   ///< [px]
    std::string words;    ///< as the paper writes it
    bool hollow = false;  ///< a baseline
};

MethodLook lookOf(Method method);

/// By label: a method, "method/what tells it apart", or a baseline.
MethodLook lookOf(const std::string& label);

void drawMarker(Canvas& canvas, const MethodLook& look, Point at, double scale);

}  // namespace terratact
