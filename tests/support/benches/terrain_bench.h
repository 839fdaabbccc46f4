#pragma once

#include <gtest/gtest.h>

#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {

inline Outline square(double left, double bottom, double right, double top)
{
    return {{.kind = OutlinePart::Kind::Body,
             .points = {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}};
}

/// Returns the canvas colour at a point of the DEM frame.
inline QColor colourAt(TerrainProfileView& view, double x, double z)
{
    const QImage image = gui::painted(*view.canvas());
    return image.pixelColor(view.pixelOf(x, z).toPoint());
}

inline bool alike(const QColor& a, const QColor& b)
{
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green())
             + std::abs(a.blue() - b.blue())
         < 40;
}

struct TerrainView : testing::Test {
    TerrainView()
    {
        view.resize(900, 480);
        gui::showActive(view);
    }
    TerrainProfileView view;
};

/// Returns an estimate with half of the draws up on the step at +0.6 and +0.7 m, half down.
inline TerrainEstimate divided()
{
    TerrainEstimate e = stepEstimate();
    for (int d = 0; d < 200; ++d) {
        Heights h = e.height;
        if (d % 2 == 0) h[9] = h[10] = -0.25;
        e.draws.push_back(h);
    }
    return e;
}

/// Returns stepEstimate() as remembered after 0.2 m. The estimate was felt where it is not prior only.
inline SeenStrip remembered()
{
    const TerrainEstimate e = stepEstimate();
    SeenStrip strip;
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        strip.side[0].push_back({.x = binCentre(bin) - 0.2,
                                 .band = widened({e.height[i], e.sd[i], e.q10[i], e.q90[i]}, 0.03),
                                 .felt = e.priorOnly(bin) ? FeltBy::NotFelt : FeltBy::Track,
                                 .time = 0.0,
                                 .way = 0.2});
    }
    strip.side[1] = strip.side[0];
    return strip;
}

}  // namespace terratact
