// Tests measuring height and slope between two points of the picture.
#include "widgets/terrain/measured_line.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/benches/terrain_bench.h"

namespace terratact {
namespace {

using Kind = MeasuredEnd::Kind;

MeasuredEnd felt(double x, double z)
{
    return {.at = {x, z}, .kind = Kind::Felt, .sd = 0.01, .word = "felt"};
}

TEST(MeasuredSlope, isRearToFrontInAnyOrder)
{
    const MeasuredEnd a = felt(0.1, -0.2), b = felt(0.4, 0.1);
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
        const MeasuredSlope slope = measuredSlope(one, other);
        EXPECT_NEAR(slope.distance, 0.3, 1e-12);
        EXPECT_NEAR(slope.rise.value(), 0.3, 1e-12);
        EXPECT_NEAR(slope.slope.value(), std::numbers::pi / 4.0, 1e-12);
    }
}

TEST(MeasuredSlope, isUnknownWhereAnEndIsNotFelt)
{
    const MeasuredEnd unfelt{.at = {0.4, 0.1}, .word = "not felt"};
    const MeasuredSlope slope = measuredSlope(felt(0.1, 0.0), unfelt);
    EXPECT_NEAR(slope.distance, 0.3, 1e-12);
    EXPECT_FALSE(slope.rise);
    EXPECT_FALSE(slope.slope);
    const QString text = measuredText(felt(0.1, 0.0), unfelt).join('\n');
    EXPECT_TRUE(text.contains("0.30 m apart · rise and slope unknown: not felt"));
    EXPECT_TRUE(text.contains("rear: +0.000 m ± 0.010 m (felt)"));
    EXPECT_TRUE(text.endsWith("front: not felt")) << text.toStdString();
}

TEST(MeasuredSlope, ofOnePointHasNoDirection)
{
    EXPECT_FALSE(measuredSlope(felt(0.1, 0.0), felt(0.1, 0.0)).slope);
    EXPECT_NEAR(measuredSlope(felt(0.1, 0.0), felt(0.1, 0.2)).slope.value(), std::numbers::pi / 2.0,
                1e-12);
}

/// An estimate that is felt up to bin 7, with a slope of 45° between the bins 6 and 7.
struct Measuring : TerrainView {
    Measuring()
    {
        TerrainEstimate e = stepEstimate();
        for (std::size_t i = 0; i < kBins; ++i) {
            e.touch[i] = i <= 7 ? Touch::Felt : Touch::NotFelt;
            e.height[i] = i >= 7 ? -0.1 : -0.2;
            e.sd[i] = 0.012;
        }
        view.setEstimate(e);
        view.setMeasuring(true);
        QCoreApplication::processEvents();
    }
    void dragTo(QPointF from, QPointF to)
    {
        const auto send = [&](QEvent::Type type, QPointF metres) {
            const QPointF at = view.pixelOf(metres.x(), metres.y());
            QMouseEvent event(type, at, view.canvas()->mapToGlobal(at), Qt::LeftButton,
                              type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                              Qt::NoModifier);
            QCoreApplication::sendEvent(view.canvas(), &event);
        };
        send(QEvent::MouseButtonPress, from);
        send(QEvent::MouseMove, to);
        send(QEvent::MouseButtonRelease, to);
    }
    QString text() { return view.measuredLines().join('\n'); }
};

TEST_F(Measuring, aDragMeasuresFromBinToBin)
{
    dragTo({binCentre(6) + 0.02, -0.21}, {binCentre(7) - 0.02, -0.09});
    EXPECT_TRUE(text().startsWith("0.10 m apart · rise +0.100 m · slope +45.0°"))
        << text().toStdString();
    EXPECT_TRUE(text().contains("rear: −0.200 m ± 0.012 m (felt)")) << text().toStdString();
    EXPECT_FALSE(view.isZoomed()) << "a drag does not pan meanwhile";
}

TEST_F(Measuring, anEndOnGroundThatIsNotFeltSaysSo)
{
    dragTo({binCentre(6), -0.2}, {binCentre(9), -0.1});
    EXPECT_TRUE(text().contains("unknown")) << text().toStdString();
    EXPECT_TRUE(text().endsWith("front: not felt"));
    dragTo({binCentre(6), -0.2}, {binCentre(9), 0.2});
    EXPECT_TRUE(text().contains("unknown")) << "nor is a point above it known";
}

TEST_F(Measuring, aPointAboveFeltGroundHasNoBand)
{
    dragTo({binCentre(6), -0.2}, {binCentre(6), 0.1});
    EXPECT_TRUE(text().contains("front: +0.100 m (free point)")) << text().toStdString();
}

TEST_F(Measuring, theArrowKeysMeasureFromBinToBin)
{
    view.setMeasuring(false);
    EXPECT_TRUE(view.measuredLines().isEmpty());
    view.inspect(6);
    view.setMeasuring(true);
    int chosen = 0;
    QObject::connect(&view, &TerrainProfileView::binChosen, &view, [&] { ++chosen; });
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_TRUE(text().contains("slope +45.0°")) << text().toStdString();
    EXPECT_TRUE(view.accessibleDescription().contains("slope +45.0°"));
    QTest::keyClick(&view, Qt::Key_Return);
    EXPECT_EQ(chosen, 0) << "Enter asks for no probe meanwhile";
    EXPECT_TRUE(text().startsWith("0.00 m apart")) << text().toStdString();
    for (int k = 0; k < 3; ++k) QTest::keyClick(&view, Qt::Key_Left);
    EXPECT_TRUE(text().startsWith("0.30 m apart · rise +0.100 m")) << text().toStdString();
}

TEST_F(Measuring, followsANewEstimate)
{
    dragTo({binCentre(6), -0.2}, {binCentre(7), -0.1});
    TerrainEstimate e = stepEstimate();
    e.touch.fill(Touch::NotFelt);
    view.setEstimate(e);
    EXPECT_TRUE(text().contains("unknown")) << text().toStdString();
}

TEST_F(TerrainView, remembersGroundWhereItMeasures)
{
    view.clearEstimate("moved");
    view.setRemembered(remembered());
    view.setMeasuring(true);
    QTest::keyClick(&view, Qt::Key_Left);
    const QString text = view.measuredLines().join('\n');
    EXPECT_TRUE(text.contains("(remembered)")) << text.toStdString();
    EXPECT_TRUE(text.contains("slope")) << text.toStdString();
}

}  // namespace
}  // namespace terratact
