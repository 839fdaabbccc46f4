#pragma once

#include <QColor>
#include <algorithm>
#include <array>
#include <cmath>

namespace terratact::gui {

using Rgb = std::array<double, 3>;  ///< linear RGB

/// Returns linear RGB.
inline Rgb linear(const QColor& colour)
{
    const auto one = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return {one(colour.redF()), one(colour.greenF()), one(colour.blueF())};
}

/// Returns the contrast ratio of WCAG 2.1, from relative luminance.
inline double contrast(const QColor& a, const QColor& b)
{
    const auto luminance = [](const QColor& colour) {
        const Rgb c = linear(colour);
        return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    };
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

}  // namespace terratact::gui
