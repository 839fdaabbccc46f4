#include "widgets/terrain/readings/rear_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

constexpr double kDegree = 3.14159265358979 / 180.0;

struct Behind : testing::Test {
    static void SetUpTestSuite()
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
    }
    Behind() { gui::showActive(view); }

    /// Returns the mean row of the pixels of a colour in the left or right half [px]; NaN without any.
    double meanRow(const QColor& colour, bool left)
    {
        const QImage image = view.grab().toImage();
        double sum = 0.0;
        int count = 0;
        for (int x = left ? 0 : image.width() / 2; x < (left ? image.width() / 2 : image.width());
             ++x)
            for (int y = 0; y < image.height(); ++y)
                if (image.pixelColor(x, y).rgb() == colour.rgb()) sum += y, ++count;
        return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
    }
    RearView view{{.trackY = 0.2,
                   .trackWidth = 0.1,
                   .flipperY = 0.27,
                   .flipperWidth = 0.05,
                   .trackBottom = -0.07,
                   .trackTop = 0.11,
                   .bodyBottom = 0.02,
                   .bodyTop = 0.2,
                   .flipperPivotZ = 0.02,
                   .flipperPivotRadius = 0.09,
                   .flipperTipRadius = 0.03,
                   .flipperLength = 0.3,
                   .flipperTaper = 0.2}};
};

TEST_F(Behind, saysWhichSideIsUp)
{
    EXPECT_EQ(view.text(), QStringLiteral("--"));
    view.setPose(RearView::Pose{.roll = 3.2 * kDegree});
    EXPECT_EQ(view.text(), QString()) << "the drive strip shows the roll";
    view.setPose(RearView::Pose{.roll = -3.2 * kDegree, .crossSlope = -5.0 * kDegree});
    EXPECT_EQ(view.text(), QStringLiteral("cross slope 5.0° R up"));
    EXPECT_TRUE(view.accessibleDescription().contains(QStringLiteral("roll 3.2° R up; cross")));
    view.setPose(RearView::Pose{.crossSlope = 0.01 * kDegree});
    EXPECT_EQ(view.text(), QStringLiteral("cross slope 0.0°")) << "no side is up";
}

TEST_F(Behind, saysTheSameInShortWhereItIsNarrow)
{
    view.setPose(RearView::Pose{.roll = -3.2 * kDegree, .crossSlope = 12.4 * kDegree});
    EXPECT_EQ(view.shortText(), QStringLiteral("cross ↑L 12°"));
    view.resize(view.minimumSizeHint());
    EXPECT_FALSE(std::isnan(meanRow(theme().robotTrack, true))) << "the robot is drawn";
    EXPECT_LT(view.minimumSizeHint().height(), view.sizeHint().height()) << "flat";
    const int tall = view.sizeHint().height();
    view.setPose(RearView::Pose{.roll = 0.0});
    EXPECT_EQ(view.shortText(), QString());
    EXPECT_LT(view.sizeHint().height(), tall) << "one line less";
}

TEST_F(Behind, isSpokenWithBothFlippers)
{
    view.setPose(RearView::Pose{
        .roll = 3.2 * kDegree, .frontLeft = 40.0 * kDegree, .frontRight = -12.0 * kDegree});
    EXPECT_EQ(view.accessibleName(), QStringLiteral("View from behind"));
    EXPECT_EQ(view.accessibleDescription(),
              QStringLiteral("From behind: roll 3.2° L up; front flippers L +40.0°, R −12.0°"));
    view.setPose(std::nullopt);
    EXPECT_EQ(view.accessibleDescription(), QStringLiteral("From behind: not known"));
}

TEST_F(Behind, drawsTheRaisedSideHigher)
{
    view.setPose(RearView::Pose{.roll = 12.0 * kDegree});
    const QColor track = theme().robotTrack;
    EXPECT_LT(meanRow(track, true), meanRow(track, false) - 3.0) << "left side up";
    view.setPose(RearView::Pose{.roll = -12.0 * kDegree});
    EXPECT_GT(meanRow(track, true), meanRow(track, false) + 3.0);
}

TEST_F(Behind, drawsEachFlipperAtItsAngle)
{
    view.setPose(RearView::Pose{.frontLeft = 0.7, .frontRight = -0.3});
    const QColor flipper = theme().robotFlipper;
    EXPECT_LT(meanRow(flipper, true), meanRow(flipper, false) - 3.0) << "the left tip is higher";
}

TEST_F(Behind, showsNoAngleBeyondATurn)
{
    for (const double bad : gui::kHostile) {
        view.setPose(RearView::Pose{.roll = bad, .frontLeft = bad});
        EXPECT_EQ(view.text(), QStringLiteral("--")) << bad;
        EXPECT_FALSE(gui::painted(view).isNull()) << bad;
    }
}

}  // namespace
}  // namespace terratact
