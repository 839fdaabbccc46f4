// Tests zooming and panning of the terrain's picture.
#include <gtest/gtest.h>

#include <QWheelEvent>

#include "tests/support/benches/terrain_bench.h"
#include "widgets/terrain/bin_inspector.h"

namespace terratact {
namespace {

struct CloseUp : TerrainView {
    CloseUp()
    {
        view.setEstimate(stepEstimate());
        QCoreApplication::processEvents();
    }
    double scale() { return view.pixelOf(1.0, 0.0).x() - view.pixelOf(0.0, 0.0).x(); }
    void send(QEvent::Type type, QPointF at)
    {
        QMouseEvent event(type, at, view.canvas()->mapToGlobal(at), Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(view.canvas(), &event);
    }
};

TEST_F(CloseUp, wheelKeepsThePlaceUnderThePointer)
{
    const double before = scale();
    const QPointF at = view.pixelOf(0.5, -0.05), place = view.pointAt(at);
    QWheelEvent wheel(at, view.canvas()->mapToGlobal(at), {}, {0, 480}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(view.canvas(), &wheel);
    EXPECT_NEAR(scale(), before * std::pow(1.25, 4), 0.005 * scale());
    EXPECT_NEAR(view.pointAt(at).x(), place.x(), 1e-3);
    EXPECT_NEAR(view.pointAt(at).y(), place.y(), 1e-3);
    EXPECT_NEAR(view.pixelOf(0.0, 0.0).y() - view.pixelOf(0.0, 1.0).y(), scale(), 1e-6)
        << "a step looks as steep as it is";
}

TEST_F(CloseUp, keysComeCloserToALimitAndBack)
{
    const double before = scale();
    for (int k = 0; k < 40; ++k) QTest::keyClick(&view, Qt::Key_Plus);
    EXPECT_NEAR(scale(), 8.0 * before, 0.005 * scale()) << "about two bins";
    for (int k = 0; k < 40; ++k) QTest::keyClick(&view, Qt::Key_Minus);
    EXPECT_NEAR(scale(), before, 1e-6);
    EXPECT_FALSE(view.isZoomed());
    QTest::keyClick(&view, Qt::Key_Plus);
    QTest::keyClick(&view, Qt::Key_0);
    EXPECT_FALSE(view.isZoomed());
}

TEST_F(CloseUp, draggingAndKeysPanWithinTheWholePicture)
{
    const QPointF low = view.pointAt({0.0, view.canvas()->height() - 1.0});
    for (int k = 0; k < 6; ++k) QTest::keyClick(&view, Qt::Key_Plus);
    const QPointF from = view.pixelOf(0.1, -0.1), to = from + QPointF(40, -30);
    send(QEvent::MouseButtonPress, from);
    send(QEvent::MouseMove, to);
    send(QEvent::MouseButtonRelease, to);
    EXPECT_NEAR(view.pointAt(to).x(), 0.1, 1e-3);
    EXPECT_NEAR(view.pointAt(to).y(), -0.1, 1e-3);
    for (int k = 0; k < 20; ++k) QTest::keyClick(&view, Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_NEAR(view.pointAt({0.0, view.canvas()->height() - 1.0}).y(), low.y(), 0.01);
    for (int k = 0; k < 20; ++k) QTest::keyClick(&view, Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_GT(view.pointAt({0.0, 0.0}).x(), -0.9) << "not beyond the robot";
}

TEST_F(CloseUp, aDoubleClickResetsBeforeItAsksForAProbe)
{
    int chosen = 0;
    QObject::connect(&view, &TerrainProfileView::binChosen, &view, [&] { ++chosen; });
    view.zoom(0.5, 0.3);
    send(QEvent::MouseButtonDblClick, view.pixelOf(0.3, -0.1));
    EXPECT_FALSE(view.isZoomed());
    EXPECT_EQ(chosen, 0);
    send(QEvent::MouseButtonDblClick, view.pixelOf(0.3, -0.1));
    EXPECT_EQ(chosen, 1);
}

TEST_F(CloseUp, thePictureSaysThatItIsCloseUp)
{
    const QImage whole = gui::painted(*view.canvas());
    view.zoom(0.999, 0.3);
    const QImage closer = gui::painted(*view.canvas());
    const QRect corner(closer.width() - 160, 4, 150, 20);
    EXPECT_NE(closer.copy(corner), whole.copy(corner));
}

}  // namespace
}  // namespace terratact
