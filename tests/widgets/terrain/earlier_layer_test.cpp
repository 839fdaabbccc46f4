#include "widgets/terrain/earlier_layer.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <vector>

#include "tests/support/benches/terrain_bench.h"
#include "tests/support/gui.h"
#include "widgets/terrain/profile_axes.h"

namespace terratact {
namespace {

using gui::painted;

/// Returns a section of one plane with 11 bins of level ground in its own frame.
EarlierSection levelSection(double height)
{
    EarlierSection section;
    for (int k = -3; k < 8; ++k)
        section.side[0].push_back({k * kBinWidth, height, 0.02, FeltBy::Track});
    return section;
}

std::vector<QPointF> allPoints(const EarlierLayer& layer)
{
    return layer.within(-1000.0, 1000.0);
}

TEST(EarlierLayer, eachSectionEndsBehindTheNextOne)
{
    EarlierLayer layer;
    layer.setSections({levelSection(-0.2), levelSection(-0.1)});
    layer.setRear(-2.0);
    ASSERT_EQ(layer.count(), 2U);
    const std::vector<QPointF> points = allPoints(layer);
    ASSERT_EQ(points.size(), 22U);
    EXPECT_NEAR(points[10].x(), -2.5, 1e-9) << "the front of the newest one";
    EXPECT_NEAR(points[0].x(), -3.5, 1e-9);
    EXPECT_NEAR(points[21].x(), -4.0, 1e-9) << "the front of the one before";
    EXPECT_EQ(points[21].y(), -0.1) << "in its own frame";
    EXPECT_NEAR(layer.begin(), -5.0, 1e-9);
}

TEST(EarlierLayer, whatRememberedGroundLeavesOutIsNotDrawn)
{
    EarlierSection section = levelSection(-0.2);
    section.side[0][9].sd = 0.16;
    section.side[0][10].felt = FeltBy::NotFelt;
    section.side[1] = section.side[0];  // of one plane, as well
    EarlierLayer layer;
    layer.setSections({section});
    EXPECT_EQ(allPoints(layer).size(), 9U);
    for (EarlierBin& bin : section.side[0]) bin.felt = FeltBy::NotFelt;
    layer.setSections({section});
    EXPECT_EQ(layer.count(), 0U);
}

struct EarlierGround : TerrainView {
    EarlierGround()
    {
        view.resize(700, 480);  // the height does not limit the scale
        QCoreApplication::processEvents();
    }
    double left() { return view.pointAt({0.0, 0.0}).x(); }
};

TEST_F(EarlierGround, windowReachesIt)
{
    view.setEstimate(stepEstimate());
    const QImage whole = painted(*view.canvas());
    const QString words = view.accessibleDescription();
    const double before = left();
    view.setEarlier({levelSection(-0.2), levelSection(-0.2)});
    EXPECT_EQ(painted(*view.canvas()), whole) << "the default window is as before";
    EXPECT_TRUE(view.accessibleDescription().contains("earlier sections of ground behind it: 2"));
    view.pan(-100.0);
    EXPECT_NEAR(left() - before, -2.0 * (EarlierLayer::kGap + 1.0) - 0.3, 0.02);
    const QImage earlier = painted(*view.canvas());
    view.setEarlier({});
    EXPECT_NEAR(left(), before, 0.02) << "nothing is there now";
    EXPECT_NE(painted(*view.canvas()), earlier);
    EXPECT_EQ(painted(*view.canvas()), whole);
    EXPECT_EQ(view.accessibleDescription(), words);
}

TEST_F(EarlierGround, staysBehindRememberedGround)
{
    view.clearEstimate("moved");
    SeenStrip strip = remembered();
    for (auto& side : strip.side)
        for (SeenBin& bin : side) bin.x -= 3.0;
    view.setEarlier({levelSection(-0.2)});
    view.setRemembered(strip);
    const double before = left();
    view.pan(-100.0);
    const double rear = strip.side[0].front().x - ProfileAxes::kLeft;
    EXPECT_NEAR(left() - before, rear - EarlierLayer::kGap - 1.0 - 0.3, 0.02);
}

TEST_F(EarlierGround, isThinAndMuted)
{
    view.setEarlier({levelSection(-0.2)});
    view.pan(-100.0);
    const QImage image = painted(*view.canvas());
    const QPoint at = view.pixelOf(ProfileAxes::kLeft - EarlierLayer::kGap - 0.5, -0.2).toPoint();
    int inked = 0, others = 0;
    for (int row = at.y() - 5; row <= at.y() + 5; ++row) {
        const QColor colour = image.pixelColor(at.x(), row);
        inked += colour != theme().card && colour != theme().grid ? 1 : 0;
        others += alike(colour, theme().sampled) ? 1 : 0;
    }
    EXPECT_GE(inked, 1);
    EXPECT_LE(inked, 2) << "neither a band nor marks";
    EXPECT_EQ(others, 0) << "not the ink of ground before the robot";
}

}  // namespace
}  // namespace terratact
