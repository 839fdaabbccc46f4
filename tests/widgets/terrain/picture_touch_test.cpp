// Tests the terrain's picture with fingers: synthesized touch events.
#include "widgets/terrain/picture_touch.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/benches/terrain_bench.h"
#include "widgets/terrain/bin_inspector.h"

namespace terratact {
namespace {

struct Touched : TerrainView {
    Touched()
    {
        view.setEstimate(stepEstimate());
        QCoreApplication::processEvents();
    }
    QPoint at(double x, double z) { return view.pixelOf(x, z).toPoint(); }
    double scale() { return view.pixelOf(1.0, 0.0).x() - view.pixelOf(0.0, 0.0).x(); }
    void tap(QPoint place)
    {
        QTest::touchEvent(view.canvas(), screen).press(0, place, view.canvas());
        QTest::touchEvent(view.canvas(), screen).release(0, place, view.canvas());
    }
    void pinch(QPoint a, QPoint b, QPoint toA, QPoint toB)
    {
        QWidget* const canvas = view.canvas();
        QTest::touchEvent(canvas, screen).press(0, a, canvas);
        QTest::touchEvent(canvas, screen).move(0, a, canvas).press(1, b, canvas);
        for (int step = 1; step <= 4; ++step)
            QTest::touchEvent(canvas, screen)
                .move(0, a + (toA - a) * step / 4, canvas)
                .move(1, b + (toB - b) * step / 4, canvas);
        QTest::touchEvent(canvas, screen).release(0, toA, canvas).release(1, toB, canvas);
    }
    QPointingDevice* screen = QTest::createTouchDevice();
};

TEST_F(Touched, aPinchZoomsAroundTheFingers)
{
    const double before = scale();
    const QPoint centre = at(0.3, -0.1);
    pinch(centre - QPoint(50, 0), centre + QPoint(50, 0), centre - QPoint(100, 0),
          centre + QPoint(100, 0));
    EXPECT_NEAR(scale() / before, 2.0, 0.05);
    EXPECT_NEAR(view.pointAt(centre).x(), 0.3, 0.01);
    EXPECT_NEAR(view.pointAt(centre).y(), -0.1, 0.01);
    pinch(centre - QPoint(100, 0), centre + QPoint(100, 0), centre - QPoint(40, 0),
          centre + QPoint(40, 0));
    EXPECT_NEAR(scale(), before, 1e-6) << "no farther away than the whole picture";
}

TEST_F(Touched, twoFingersPan)
{
    view.zoom(0.5, 0.1);
    const double before = scale();
    const QPoint centre = at(0.1, -0.1), moved = centre + QPoint(40, 20);
    const QPointF held = view.pointAt(centre);
    pinch(centre - QPoint(60, 0), centre + QPoint(60, 0), moved - QPoint(60, 0),
          moved + QPoint(60, 0));
    EXPECT_NEAR(scale(), before, 1.0);
    EXPECT_NEAR(view.pointAt(moved).x(), held.x(), 0.01);
    EXPECT_NEAR(view.pointAt(moved).y(), held.y(), 0.01);
}

TEST_F(Touched, aRestingFingerShowsTheNumbersOfItsBin)
{
    QTest::touchEvent(view.canvas(), screen).press(0, at(binCentre(7), -0.1), view.canvas());
    EXPECT_EQ(view.inspector()->bin(), -1) << "not at once";
    gui::eventually([&] { return view.inspector()->bin() == 7; });
    EXPECT_EQ(view.inspector()->bin(), 7);
    QTest::touchEvent(view.canvas(), screen).move(0, at(binCentre(8), -0.1), view.canvas());
    EXPECT_EQ(view.inspector()->bin(), 8) << "the finger slides to the next bin";
    EXPECT_FALSE(view.isZoomed());
    QTest::touchEvent(view.canvas(), screen).release(0, at(binCentre(8), -0.1), view.canvas());
}

TEST_F(Touched, aTapSelectsABinAndTwoTapsChooseIt)
{
    QSignalSpy chosen(&view, &TerrainProfileView::binChosen);
    tap(at(binCentre(6), -0.1));
    EXPECT_EQ(view.inspector()->bin(), 6);
    EXPECT_EQ(chosen.size(), 0);
    tap(at(binCentre(6), -0.1));
    EXPECT_EQ(chosen.size(), 1);
}

TEST_F(Touched, aPinchChoosesNoBin)
{
    QSignalSpy chosen(&view, &TerrainProfileView::binChosen);
    const QPoint centre = at(0.3, -0.1);
    for (int k = 0; k < 2; ++k)
        pinch(centre - QPoint(50, 0), centre + QPoint(50, 0), centre - QPoint(50, 0),
              centre + QPoint(50, 0));
    EXPECT_EQ(chosen.size(), 0);
    EXPECT_EQ(view.inspector()->bin(), -1);
}

TEST_F(Touched, aFingerMeasures)
{
    view.setMeasuring(true);
    const QPoint from = at(binCentre(2), -0.3), to = at(binCentre(5), -0.3);
    QWidget* const canvas = view.canvas();
    QTest::touchEvent(canvas, screen).press(0, from, canvas);
    for (int step = 1; step <= 4; ++step)
        QTest::touchEvent(canvas, screen).move(0, from + (to - from) * step / 4, canvas);
    QTest::touchEvent(canvas, screen).release(0, to, canvas);
    EXPECT_TRUE(view.measuredLines().first().startsWith("0.30 m apart"))
        << view.measuredLines().first().toStdString();
}

}  // namespace
}  // namespace terratact
