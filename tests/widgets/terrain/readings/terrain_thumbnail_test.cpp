// Tests the small picture of an estimate in lists.
#include "widgets/terrain/readings/terrain_thumbnail.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <limits>

#include "tests/support/estimates.h"
#include "widgets/base/palette.h"

namespace terratact {
namespace {

QImage pictureOf(const TwoTrackEstimate& estimate, QSize size = {110, 45})
{
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::magenta);
    QPainter painter(&image);
    drawTerrainThumbnail(painter, QRectF({0.0, 0.0}, QSizeF(size)), estimate);
    return image;
}

/// Returns the mean row of the estimate's line in some columns; −1: no line.
double lineIn(const QImage& image, int from, int to)
{
    double sum = 0.0;
    int count = 0;
    for (int x = from; x < to; ++x)
        for (int y = 1; y < image.height() - 1; ++y)
            if (const QColor colour = image.pixelColor(x, y); colour.green() - colour.red() > 70) {
                sum += y;
                ++count;
            }
    return count > 0 ? sum / count : -1.0;
}

TEST(TerrainThumbnail, risesWhereTheEstimateRises)
{
    const QImage image = pictureOf(equalSides(stepEstimate()));
    const double behind = lineIn(image, 10, 50), ahead = lineIn(image, 90, 100);
    ASSERT_GT(behind, 0.0);
    ASSERT_GT(ahead, 0.0);
    EXPECT_NEAR(behind - ahead, 0.2 / kThumbnailSpan * 45.0, 2.0) << "a step of 0.2 m";
}

TEST(TerrainThumbnail, sidesThatDifferHaveALineEach)
{
    EXPECT_NE(pictureOf(leftStepEstimate()), pictureOf(equalSides(stepEstimate())));
    TwoTrackEstimate right = leftStepEstimate();
    std::swap(right.side[0], right.side[1]);
    EXPECT_NE(pictureOf(right), pictureOf(leftStepEstimate())) << "solid and dashed";
}

TEST(TerrainThumbnail, measuredBinsAreMarked)
{
    TerrainEstimate unmarked = stepEstimate();
    unmarked.origin.fill(Origin::Sampled);
    const QImage with = pictureOf(equalSides(stepEstimate()));
    const QImage without = pictureOf(equalSides(unmarked));
    long differing = 0;
    for (int y = 0; y < with.height(); ++y)
        for (int x = 0; x < with.width(); ++x) differing += with.pixel(x, y) != without.pixel(x, y);
    EXPECT_GE(differing, 8);
    EXPECT_LE(differing, 40) << "one mark, at +0.5 m";
}

TEST(TerrainThumbnail, hugeNumbersStayInside)
{
    TerrainEstimate huge = stepEstimate();
    huge.height[9] = huge.q90[9] = 1e12;
    huge.q10[9] = -1e12;
    huge.height[10] = std::numeric_limits<double>::quiet_NaN();
    QImage image(QSize(130, 60), QImage::Format_RGB32);
    image.fill(Qt::magenta);
    QPainter painter(&image);
    drawTerrainThumbnail(painter, QRectF(10.0, 10.0, 110.0, 40.0), equalSides(huge));
    painter.end();
    EXPECT_EQ(image.pixelColor(5, 30), QColor(Qt::magenta));
    EXPECT_EQ(image.pixelColor(60, 55), QColor(Qt::magenta));
}

}  // namespace
}  // namespace terratact
