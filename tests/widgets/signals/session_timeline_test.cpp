#include "widgets/signals/session_timeline.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QWheelEvent>

#include "tests/support/gui.h"

namespace terratact {
namespace {

using namespace gui;

Timeline someTimeline()
{
    Timeline t{.begin = 10.0, .end = 110.0, .lanes = {{.name = "link"}, {.name = "scenes"}}};
    t.lanes[0].spans << TimelineSpan{10.0, 60.0, TimelineSeverity::Good, "link: up"};
    t.lanes[1].marks << TimelineMark{50.0, TimelineSeverity::Plain, "scene 1"};
    t.gaps << TimelineSpan{80.0, 90.0, TimelineSeverity::Bad, "DAMAGED"};
    return t;
}

struct TheTimeline : testing::Test {
    TheTimeline()
    {
        timeline.resize(900, 120);
        timeline.setTimeline(someTimeline());
        timeline.showAll();
        showActive(timeline);
    }
    SessionTimeline timeline;
};

TEST_F(TheTimeline, pixelsAndTimesAreEachOthersInverse)
{
    for (const double zoom : {1.0, 4.0, 100.0}) {
        timeline.zoom(zoom, 55.0);
        for (const double t : {timeline.first(), 55.0, timeline.last()})
            EXPECT_NEAR(timeline.secondsAt(timeline.pixelOf(t)), t, 1e-9) << zoom;
    }
    timeline.showAll();
    EXPECT_DOUBLE_EQ(timeline.first(), 10.0);
    EXPECT_DOUBLE_EQ(timeline.last(), 110.0);
    EXPECT_LT(timeline.pixelOf(10.0), timeline.pixelOf(60.0));
}

TEST_F(TheTimeline, zoomKeepsTheTimeUnderTheMouseAndStaysInTheSession)
{
    const double at = 40.0, pixel = timeline.pixelOf(at);
    timeline.zoom(5.0, at);
    EXPECT_NEAR(timeline.pixelOf(at), pixel, 1e-6);
    timeline.zoom(1e-3, at);
    EXPECT_DOUBLE_EQ(timeline.first(), 10.0);
    EXPECT_DOUBLE_EQ(timeline.last(), 110.0);
    timeline.zoom(1e9, at);
    EXPECT_GE(timeline.last() - timeline.first(), SessionTimeline::kMinSpan * 0.999);
    for (const double hostile : kHostile) timeline.zoom(hostile, hostile);
    EXPECT_LT(timeline.first(), timeline.last());
}

TEST_F(TheTimeline, aClickAndADragChooseATime)
{
    QSignalSpy seeks(&timeline, &SessionTimeline::seekWanted);
    const auto point = [&](double t) {
        return QPoint(qRound(timeline.pixelOf(t)), timeline.height() / 2);
    };
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, point(35.0));
    ASSERT_EQ(seeks.count(), 1);
    EXPECT_NEAR(seeks[0][0].toDouble(), 35.0, 0.1);
    QTest::mousePress(&timeline, Qt::LeftButton, {}, point(35.0));
    QTest::mouseMove(&timeline, point(70.0));
    QTest::mouseRelease(&timeline, Qt::LeftButton, {}, point(70.0));
    EXPECT_NEAR(seeks.last()[0].toDouble(), 70.0, 0.1);
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, QPoint(0, 60));  // on a lane's name
    EXPECT_DOUBLE_EQ(seeks.last()[0].toDouble(), 10.0);
}

TEST_F(TheTimeline, theWheelZoomsAndTurnsThePage)
{
    const auto turn = [&](int by, Qt::KeyboardModifiers with) {
        const QPointF at(timeline.pixelOf(60.0), 60.0);
        QWheelEvent event(at, timeline.mapToGlobal(at), {}, {0, by}, Qt::NoButton, with,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&timeline, &event);
    };
    turn(240, Qt::NoModifier);
    const double first = timeline.first(), span = timeline.last() - first;
    EXPECT_LT(span, 99.0);
    turn(-120, Qt::ShiftModifier);
    EXPECT_GT(timeline.first(), first);
    EXPECT_NEAR(timeline.last() - timeline.first(), span, 1e-9);
}

TEST_F(TheTimeline, followsThePlayheadWhereItWasInView)
{
    timeline.showSpan(20.0, 30.0);
    timeline.setPlayhead(25.0);
    timeline.setPlayhead(31.0);
    EXPECT_LE(timeline.first(), 31.0);
    EXPECT_GE(timeline.last(), 31.0);
    timeline.showSpan(80.0, 90.0);  // the operator has scrolled elsewhere
    timeline.setPlayhead(32.0);
    EXPECT_DOUBLE_EQ(timeline.first(), 80.0);
}

TEST_F(TheTimeline, describesWhatIsUnderThePointer)
{
    const auto textAt = [&](double t, double y) {
        return timeline.textAt({timeline.pixelOf(t), y});
    };
    const double firstLane = 40.0, secondLane = timeline.height() - 10.0;
    EXPECT_TRUE(textAt(30.0, firstLane).contains("link: up"));
    EXPECT_TRUE(textAt(70.0, firstLane).isEmpty());
    EXPECT_TRUE(textAt(50.0, secondLane).contains("scene 1"));
    EXPECT_TRUE(textAt(85.0, secondLane).contains("DAMAGED"));
}

TEST_F(TheTimeline, drawsAGapAcrossAllLanesAndNeverWhatIsNotFinite)
{
    const QImage whole = painted(timeline);
    ASSERT_FALSE(whole.isNull());
    Timeline without = someTimeline();
    without.gaps.clear();
    timeline.setTimeline(without);
    const QImage bridged = painted(timeline);
    const int x = qRound(timeline.pixelOf(85.0));
    int differ = 0;
    for (int y = 24; y < timeline.height() - 4; ++y)
        for (int dx = -8; dx <= 8; ++dx)
            differ += whole.pixel(x + dx, y) != bridged.pixel(x + dx, y) ? 1 : 0;
    EXPECT_GT(differ, 100);

    Timeline hostile = someTimeline();
    for (const double value : kHostile) {
        hostile.lanes[0].spans << TimelineSpan{value, 50.0} << TimelineSpan{20.0, value};
        hostile.lanes[1].marks << TimelineMark{value};
        hostile.gaps << TimelineSpan{value, value};
        hostile.begin = hostile.end = value;
        timeline.setTimeline(hostile);
        timeline.setPlayhead(value);
        timeline.setCursors(value, value);
        EXPECT_FALSE(painted(timeline).isNull()) << value;
    }
}

TEST(TimeWords, areAsShortAsTheStepAllows)
{
    EXPECT_EQ(timeText(3723.4567), "1:02:03.457");
    EXPECT_EQ(timeText(3723.4567, 1.0), "1:02:03");
    EXPECT_EQ(timeText(59.9996), "0:01:00.000");
    EXPECT_EQ(timeText(-1.5, 0.1), QString(QChar(0x2212)) + "0:00:01.5");
    for (const double hostile : kHostile) EXPECT_EQ(timeText(hostile), "--");
}

}  // namespace
}  // namespace terratact
