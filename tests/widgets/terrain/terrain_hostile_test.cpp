// Tests numbers that no robot should send: they are left out, and the rest is drawn at once.
#include "widgets/terrain/terrain_profile_view.h"

#include <gtest/gtest.h>
#include <qwt_plot_curve.h>

#include "tests/support/benches/terrain_bench.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

using gui::painted;
using gui::PaintWatch;

TEST_F(TerrainView, rememberedGroundWithHolesIsDrawnWhereItCanBe)
{
    SeenStrip broken = remembered();  // bin k is at k · 0.1 m − 0.5 m
    broken.side[0][3].band.height = std::numeric_limits<double>::quiet_NaN();
    broken.side[0][5].band.q90 = std::numeric_limits<double>::infinity();
    view.setRemembered(broken);
    const QImage image = painted(*view.canvas());
    ASSERT_FALSE(image.isNull());
    int drawn = 0;  // pixels of the thin dashed line
    for (int dy = -5; dy <= 5; ++dy)
        for (const int dx : {-1, 0, 1})
            drawn += image.pixelColor(view.pixelOf(-0.1, -0.22).toPoint() + QPoint(dx, dy))
                          != theme().card
                       ? 1
                       : 0;
    EXPECT_GT(drawn, 0) << "a bin alone, too";
}

TEST_F(TerrainView, hostileNumbersAreLeftOutAndTheRestIsDrawnAtOnce)
{
    for (const double bad : gui::kHostile) {
        TerrainEstimate e = stepEstimate();
        e.height[5] = e.q10[6] = e.q90[7] = e.ceiling[2] = bad;
        Heights truth = e.height;
        Outline outline = square(-0.2, 0.0, 0.2, 0.1);
        outline.front().points.push_back({bad, 0.05});
        outline.front().points.push_back({0.0, bad});
        view.setOutline(outline);
        view.setTruth(truth);
        view.setEstimate(e);
        view.setArmTip(ArmTip{.bin = 5});
        const QImage image = painted(view);
        ASSERT_FALSE(image.isNull()) << "a painter gets " << bad;
        EXPECT_GT(gui::colours(image), 20);
        EXPECT_TRUE(alike(colourAt(view, 0.5, e.height[8]), theme().contact)) << bad;
        (void)view.binText(5);
    }
}

TEST_F(TerrainView, hostileNumbersInItsLayersAreLeftOut)
{
    for (const double bad : gui::kHostile) {
        TerrainEstimate e = divided();
        e.draws[0][3] = e.draws[1][9] = bad;
        view.setEstimate(e);
        view.setDrawsShown(true);
        TerrainEstimate second = stepEstimate();
        second.height[2] = second.q10[4] = second.q90[5] = bad;
        view.setSecond(equalSides(second), "pafc");
        view.inspect(3);
        ASSERT_FALSE(painted(view).isNull()) << bad;
        SeenStrip moved = remembered();
        moved.side[0][3].band.height = moved.side[0][4].band.q10 = bad;
        moved.side[0][5].band.q90 = moved.side[0][6].band.sd = bad;
        moved.side[0][7].way = bad;
        view.clearEstimate("moved");
        view.setRemembered(moved);
        view.setStale(bad);
        ASSERT_FALSE(painted(view).isNull()) << bad;
        view.setStale(std::nullopt);
        view.setRemembered({});
    }
}

TEST_F(TerrainView, nothingButHostileNumbersLeavesAPicture)
{
    for (const double bad : gui::kHostile) {
        TerrainEstimate e;
        for (Heights* h : {&e.height, &e.sd, &e.q10, &e.q90, &e.ceiling}) h->fill(bad);
        view.setEstimate(e);
        ASSERT_FALSE(painted(view).isNull());
    }
}

TEST(Painted, isNullIfPaintingTakesSeconds)
{
    class Slow final : public QWidget {
        void paintEvent(QPaintEvent* /*event*/) override
        {
            for (const double began = threadMilliseconds(); threadMilliseconds() - began < 1200.0;)
                continue;
        }
    };
    Slow slow;
    slow.resize(20, 20);
    EXPECT_TRUE(gui::painted(slow).isNull());
}

TEST(PaintWatch, seesANumberThatACurveOfQwtPassesOn)
{
    QwtPlot plot;
    plot.resize(400, 300);
    plot.setAutoReplot(false);
    plot.setAxisScale(QwtPlot::xBottom, 0.0, 4.0);
    plot.setAxisScale(QwtPlot::yLeft, 0.0, 4.0);
    auto* curve = new QwtPlotCurve;
    curve->attach(&plot);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double y : {2.0, nan}) {
        curve->setSamples(QPolygonF{{0, 1}, {1, 2}, {2, y}, {3, 3}});
        plot.replot();
        PaintWatch watch(plot.size());
        QPainter painter(&watch);
        plot.drawCanvas(&painter);
        painter.end();
        EXPECT_EQ(watch.hostile() > 0, y != 2.0) << y;
    }
}

TEST(Drawable, aPathBreaksWhereANumberIsMissing)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const QPainterPath path = pathThrough({{0, 0}, {1, 1}, {2, nan}, {3, 3}, {4, 4}, {5, 1e9}});
    ASSERT_EQ(path.elementCount(), 4);
    EXPECT_TRUE(path.elementAt(2).isMoveTo());
    EXPECT_EQ(path.boundingRect(), QRectF(0, 0, 4, 4));
}

}  // namespace
}  // namespace terratact
