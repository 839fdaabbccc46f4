#pragma once

#include <string>

#include "app/figures/canvas.h"
#include "core/infer/estimate/variant.h"

namespace terratact {

/// Style of a method's results in figures.
struct MethodStyle {
    Colour colour{0x8e3fbf};
    Shape shape = Shape::Circle;
    double size = 12.0;   ///< [px]
    std::string words;    ///< name in the paper
    bool hollow = false;  ///< true for a baseline
};

MethodStyle styleOf(Method method);

/// Returns the style of a label: a method, "method/variant", or a baseline.
MethodStyle styleOf(const std::string& label);

void drawMarker(Canvas& canvas, const MethodStyle& look, Point at, double scale);

}  // namespace terratact
