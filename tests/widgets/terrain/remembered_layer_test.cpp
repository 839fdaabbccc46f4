#include "widgets/terrain/remembered_layer.h"

#include <gtest/gtest.h>

#include "tests/support/benches/terrain_bench.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

using gui::painted;

TEST_F(TerrainView, rememberedGroundHasDotsAWordAndItsBar)
{
    TerrainEstimate felt = stepEstimate();
    felt.touch.fill(Touch::Felt);
    TerrainEstimate remembered = felt;
    remembered.touch[7] = remembered.touch[8] = Touch::Remembered;
    view.setEstimate(felt);
    const QImage without = painted(*view.canvas());
    view.setEstimate(remembered);
    const QImage with = painted(*view.canvas());
    EXPECT_NE(without, with);
    for (const int bin : {7, 8}) {
        EXPECT_TRUE(view.binText(bin).endsWith("remembered")) << view.binText(bin).toStdString();
        EXPECT_NE(view.binText(bin).indexOf("80 %"), -1) << "its height is known";
    }
    EXPECT_TRUE(view.binText(9).endsWith("felt"));
}

TEST_F(TerrainView, rememberedGroundIsDashedInABandWithItsDistance)
{
    view.clearEstimate("moved");
    const QImage without = painted(*view.canvas());
    view.setRemembered(remembered());
    const auto greens = [&](double z) {  // along bins -0.3 … 0.2
        const QImage image = painted(*view.canvas());
        const int y = static_cast<int>(std::lround(view.pixelOf(0.0, z).y()));
        int count = 0, all = 0;
        for (double x = -0.25; x < 0.2; x += 0.002, ++all) {
            const auto isGreen = [&](int row) {  // the line may lie between two rows
                const int column = static_cast<int>(view.pixelOf(x, 0.0).x());
                return alike(image.pixelColor(column, row), theme().sampled);
            };
            count += isGreen(y - 1) || isGreen(y) || isGreen(y + 1) ? 1 : 0;
        }
        return static_cast<double>(count) / all;
    };
    EXPECT_GT(greens(-0.25), 0.3);
    EXPECT_LT(greens(-0.25), 0.8) << "dashed: an estimate is not";
    EXPECT_FALSE(alike(colourAt(view, 0.05, -0.27), QColor(theme().sampled)));
    EXPECT_NE(colourAt(view, 0.05, -0.27), theme().card) << "in its band";
    EXPECT_EQ(colourAt(view, 0.6, -0.05), theme().card) << "nothing where nothing was estimated";
    EXPECT_TRUE(view.accessibleDescription().contains(
        QStringLiteral("0.20 m driven since · heights ± 0.03 m")));
    view.setRemembered({}, "Nothing is remembered here: the robot has turned");
    EXPECT_TRUE(view.accessibleDescription().contains("has turned"));
    view.setRemembered({});
    EXPECT_EQ(painted(*view.canvas()), without);
}

TEST_F(TerrainView, rememberedGroundOfBothSidesIsDrawn)
{
    view.clearEstimate("moved");
    const QImage without = painted(*view.canvas());
    SeenStrip both = remembered();
    both.onePlane = false;
    for (SeenBin& bin : both.side[1]) bin.band = raised(bin.band, 0.1);
    view.setRemembered(both);
    EXPECT_NE(colourAt(view, 0.05, -0.27), theme().card) << "the left band";
    EXPECT_NE(colourAt(view, 0.05, -0.17), theme().card) << "the right band";
    const QImage drawn = painted(*view.canvas());
    both.side[0].clear();
    view.setRemembered(both);
    EXPECT_NE(painted(*view.canvas()), drawn);
    EXPECT_TRUE(view.accessibleDescription().contains(QStringLiteral("0.20 m driven since")));
    view.setRemembered({});
    EXPECT_EQ(painted(*view.canvas()), without);
}

TEST_F(TerrainView, besideAnEstimateOnlyTheGroundBehindItIsRemembered)
{
    view.setEstimate(stepEstimate());
    SeenStrip strip = remembered();
    view.setRemembered(strip);
    EXPECT_NE(colourAt(view, -0.45, -0.27), theme().card) << "behind";
    EXPECT_FALSE(view.accessibleDescription().contains("remembered")) << "the estimate stands";
    strip.side[0].erase(strip.side[0].begin(), strip.side[0].begin() + 2);
    view.setRemembered(strip);
    const QImage image = painted(*view.canvas());
    view.setRemembered({});
    EXPECT_EQ(painted(*view.canvas()), image) << "the estimate's own place shows the estimate";
}

TEST_F(TerrainView, groundThatIsNotFeltOrTooUncertainIsNotRemembered)
{
    view.clearEstimate("moved");
    const QImage without = painted(*view.canvas());
    SeenStrip strip = remembered();
    for (SeenBin& bin : strip.side[0]) bin.felt = FeltBy::NotFelt;
    view.setRemembered(strip);
    EXPECT_EQ(painted(*view.canvas()), without);
    strip = remembered();
    for (SeenBin& bin : strip.side[0]) bin.band.sd = 0.16;
    view.setRemembered(strip);
    EXPECT_EQ(painted(*view.canvas()), without);
}

}  // namespace
}  // namespace terratact
