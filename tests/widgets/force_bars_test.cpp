#include "widgets/force_bars.h"

#include <gtest/gtest.h>

#include "tests/support/gui.h"
#include "widgets/palette.h"

namespace terratact {
namespace {

struct Forces : testing::Test {
    Forces()
    {
        bars.resize(420, 240);
        gui::showActive(bars);
    }
    ForceBars bars;
};

TEST_F(Forces, eachBarSaysItsNumber)
{
    bars.setForces({0.24, 0.0, 1.0, 2.5, 6.44, std::nullopt});
    EXPECT_EQ(bars.numberText(0), "0.2");
    EXPECT_EQ(bars.numberText(4), "6.4");
    EXPECT_EQ(bars.numberText(5), "--") << "not measured is not zero";
    EXPECT_TRUE(bars.accessibleDescription().contains("element 5: 6.4 N, contact"));
}

TEST_F(Forces, touchingIsAboveTheThreshold)
{
    bars.setThreshold(2.0);
    bars.setForces({1.99, 2.0, 2.01, 0.0, 0.0, std::nullopt});
    EXPECT_FALSE(bars.touching(0));
    EXPECT_FALSE(bars.touching(1));
    EXPECT_TRUE(bars.touching(2));
    EXPECT_FALSE(bars.touching(5));
    bars.setThreshold(3.0);
    EXPECT_FALSE(bars.touching(2));
}

TEST_F(Forces, aBarIsAsHighAsItsForce)
{
    bars.setForces({0.0, 0.0, 0.0, 0.0, 8.0, 0.0});
    const QImage image = gui::painted(*bars.canvas());
    const double px = image.width() * 4.5 / 6.0;
    const auto blue = [&](double newtons) {
        const QColor colour =
            image.pixelColor(QPoint(static_cast<int>(px), static_cast<int>(bars.pixelOf(newtons))));
        return colour.blue() - colour.red() > 60;
    };
    EXPECT_TRUE(blue(7.5));
    EXPECT_TRUE(blue(0.5));
    EXPECT_FALSE(blue(8.6) && blue(9.8)) << "only the number stands above the bar";
}

TEST_F(Forces, theScaleFollowsLargeForcesAndComesBack)
{
    bars.setForces({0.0, 0.0, 0.0, 0.0, 900.0, 0.0});
    EXPECT_GE(bars.fullScale(), 900.0);
    bars.setForces({0.0, 0.0, 0.0, 0.0, 1.0, 0.0});
    EXPECT_LE(bars.fullScale(), 20.0);
}

TEST_F(Forces, hostileNumbersReadAsNotMeasured)
{
    for (const double bad : gui::kHostile) {
        bars.setForces({bad, 3.0, bad, bad, bad, bad});
        bars.setThreshold(bad);
        EXPECT_EQ(bars.numberText(0), "--");
        EXPECT_TRUE(bars.touching(1)) << "the threshold stays what it was";
        const QImage image = gui::painted(bars);
        ASSERT_FALSE(image.isNull()) << bad;
        EXPECT_GT(gui::colours(image), 5);
    }
}

TEST_F(Forces, clearedBarsReadNothing)
{
    bars.setForces({1.0, 1.0, 1.0, 1.0, 1.0, 9.0});
    bars.clearForces();
    for (int element = 0; element < kForceElements; ++element)
        EXPECT_EQ(bars.numberText(element), "--");
}

}  // namespace
}  // namespace terratact
