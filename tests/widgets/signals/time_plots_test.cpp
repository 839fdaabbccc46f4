// Tests the plots over time: lines, legends, shared axis, mouse, list of signals, numbers.
#include "widgets/signals/time_plots.h"

#include <gtest/gtest.h>
#include <qwt_scale_map.h>

#include <QLineEdit>
#include <QListWidget>
#include <QWheelEvent>
#include <cmath>
#include <limits>

#include "core/series/signal_series.h"
#include "tests/support/gui.h"
#include "widgets/base/theme.h"
#include "widgets/signals/plot_values.h"
#include "widgets/signals/signal_list.h"

namespace terratact {
namespace {

SeriesColumn column(double time, double low, double high, double last, std::uint64_t count = 2)
{
    return {time, {.last = last, .low = low, .high = high, .count = count}};
}

TimePlotCurve waveCurve(const QString& name, double from, double to)
{
    SignalSeries series(0.0);
    for (int i = 0; i <= 1000; ++i) series.add(0.1 * i, std::sin(0.1 * i));
    return {
        .name = name, .unit = "rad", .view = viewOf(series, from, to, 400, 0.5 * (from + to), 0.0)};
}

TimePlotsViewState someRows(std::size_t rows)
{
    TimePlotsViewState shown{.from = 10.0, .to = 50.0, .until = 100.0, .cursor = 30.0};
    for (std::size_t i = 0; i < rows; ++i)
        shown.rows.push_back(
            {.curves = {waveCurve("pitch", 10.0, 50.0), waveCurve("roll", 10.0, 50.0)}});
    return shown;
}

QwtScaleMap unitMap(double from, double to)
{
    QwtScaleMap map;
    map.setScaleInterval(from, to);
    map.setPaintInterval(0.0, 100.0);
    return map;
}

TEST(CurveLines, holdEveryPeakAndBreakAtPauses)
{
    TimePlotCurve curve{
        .name = "x",
        .unit = {},
        .view = {.columns = {column(1.0, 0.0, 5.0, 1.0), column(2.0, 2.0, 2.0, 2.0, 1),
                             column(9.0, 1.0, 1.0, 1.0, 1)},
                 .breakAfter = 3.0}};
    const auto lines = curveLines(curve, unitMap(0.0, 10.0), unitMap(0.0, 10.0), 10.0);
    ASSERT_EQ(lines.size(), 2U);
    ASSERT_EQ(lines[0].size(), 4);
    EXPECT_EQ(lines[0][1], QPointF(10.0, 50.0)) << "the peak";
    EXPECT_EQ(lines[0][3], QPointF(20.0, 20.0));
    EXPECT_EQ(lines[1].size(), 1) << "a lone value is a dot";
}

TEST(CurveLines, heldValuesAreSteps)
{
    const TimePlotCurve curve{.name = "p",
                              .unit = {},
                              .view = {.columns = {column(5.0, 0.5, 0.5, 0.5, 1)}, .before = 0.25},
                              .isHeld = true};
    const auto lines = curveLines(curve, unitMap(0.0, 10.0), unitMap(0.0, 1.0), 8.0);
    ASSERT_EQ(lines.size(), 1U);
    const QPolygonF expected{{0.0, 25.0}, {50.0, 25.0}, {50.0, 50.0}, {80.0, 50.0}};
    EXPECT_EQ(lines[0], expected) << "up to the end of the data, and not beyond";
}

TEST(CurveLines, hugeNumbersStayDrawable)
{
    const TimePlotCurve curve{
        .name = "x",
        .unit = {},
        .view = {.columns = {column(1.0, -1e300, 1e300, 0.0), column(1e18, 0.0, 0.0, 0.0)},
                 .breakAfter = 1e300}};
    for (const QPolygonF& line : curveLines(curve, unitMap(0.0, 1e-9), unitMap(0.0, 1e-9), 1.0))
        for (const QPointF& point : line) {
            EXPECT_LE(std::abs(point.x()), 20'000.0);
            EXPECT_LE(std::abs(point.y()), 20'000.0);
        }
}

struct PlotsOnScreen : testing::Test {
    PlotsOnScreen()
    {
        applyLook(*qApp);
        plots.resize(900, 400);
        gui::showActive(plots);
        plots.setViewState(someRows(3));
        QCoreApplication::processEvents();
    }
    QPoint inRow(int row, double share) const
    {
        const QWidget& canvas = *plots.row(row)->canvas();
        return {static_cast<int>(share * canvas.width()), canvas.height() / 2};
    }
    TimePlots plots;
};

TEST_F(PlotsOnScreen, rowsShareOneTimeAxis)
{
    ASSERT_EQ(plots.rows(), 3);
    for (int i = 1; i < 3; ++i) {
        const QWidget &first = *plots.row(0)->canvas(), &other = *plots.row(i)->canvas();
        EXPECT_EQ(first.mapTo(&plots, QPoint()).x(), other.mapTo(&plots, QPoint()).x());
        EXPECT_EQ(first.width(), other.width());
    }
    EXPECT_GT(gui::colours(gui::painted(plots)), 4);
    EXPECT_EQ(plots.row(0)->accessibleName(), "Plot of pitch, roll");
    auto shown = someRows(1);
    plots.setViewState(shown);
    EXPECT_EQ(plots.rows(), 1);
    shown.rows.clear();
    plots.setViewState(shown);
    EXPECT_EQ(plots.rows(), 0);
    EXPECT_GT(gui::colours(gui::painted(plots)), 2) << "it says what to do";
    shown = someRows(20);
    plots.setViewState(shown);
    EXPECT_EQ(plots.rows(), TimePlots::kMaxRows);
}

TEST_F(PlotsOnScreen, theScaleOfValuesFollowsWithoutTrembling)
{
    EXPECT_LT(plots.row(0)->low(), -0.99);
    EXPECT_GT(plots.row(0)->high(), 0.99);
    const double low = plots.row(0)->low();
    auto shown = someRows(3);
    for (auto& c : shown.rows[0].curves[0].view.columns) c.summary.low *= 0.98;
    plots.setViewState(shown);
    EXPECT_EQ(plots.row(0)->low(), low);
    shown.rows[0].values = {-5.0, 7.0};
    plots.setViewState(shown);
    EXPECT_EQ(plots.row(0)->low(), -5.0);
    EXPECT_EQ(plots.row(0)->high(), 7.0);
}

TEST_F(PlotsOnScreen, theMouseZoomsMovesAndPoints)
{
    double clicked = 0.0, moved = 0.0, factor = 0.0, at = 0.0;
    PlotBox box;
    int boxRow = -1;
    QObject::connect(&plots, &TimePlots::clicked, [&](double t) { clicked = t; });
    QObject::connect(&plots, &TimePlots::moved, [&](double s) { moved = s; });
    QObject::connect(&plots, &TimePlots::zoomed, [&](double f, double t) { factor = f, at = t; });
    QObject::connect(&plots, &TimePlots::boxed,
                     [&](int row, const PlotBox& b) { boxRow = row, box = b; });
    QWidget* const canvas = plots.row(1)->canvas();
    QTest::mouseClick(canvas, Qt::LeftButton, {}, inRow(1, 0.25));
    EXPECT_NEAR(clicked, 20.0, 0.2);
    QTest::mousePress(canvas, Qt::LeftButton, {}, inRow(1, 0.25) - QPoint(0, 30));
    QTest::mouseMove(canvas, inRow(1, 0.5));
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, inRow(1, 0.5) + QPoint(0, 20));
    EXPECT_EQ(boxRow, 1);
    EXPECT_NEAR(box.from, 20.0, 0.2);
    EXPECT_NEAR(box.to, 30.0, 0.2);
    EXPECT_LT(box.low, box.high);
    QTest::mousePress(canvas, Qt::RightButton, {}, inRow(1, 0.5));
    QMouseEvent move(QEvent::MouseMove, inRow(1, 0.75), canvas->mapToGlobal(inRow(1, 0.75)),
                     Qt::NoButton, Qt::RightButton, Qt::NoModifier);
    QCoreApplication::sendEvent(canvas, &move);
    QTest::mouseRelease(canvas, Qt::RightButton, {}, inRow(1, 0.75));
    EXPECT_NEAR(moved, -10.0, 0.2) << "the picture follows the pointer";
    QWheelEvent wheel(inRow(1, 0.5), canvas->mapToGlobal(inRow(1, 0.5)), {}, {0, 120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(canvas, &wheel);
    EXPECT_GT(factor, 1.0);
    EXPECT_NEAR(at, 30.0, 0.2);
}

TEST_F(PlotsOnScreen, hostileNumbersPaintQuickly)
{
    for (const double value : gui::kHostile) {
        TimePlotsViewState shown{.from = 0.0, .to = 10.0, .until = value, .cursor = value};
        TimePlotCurve curve{.name = "hostile", .unit = "x", .view = {}};
        for (int i = 0; i < 1000; ++i)
            curve.view.columns.push_back(column(0.01 * i, std::isfinite(value) ? -value : 0.0,
                                                std::isfinite(value) ? value : 1.0, 0.0));
        curve.view.atCursor = value;
        shown.rows.push_back({.curves = {curve}});
        plots.setViewState(shown);
        EXPECT_FALSE(gui::painted(plots).isNull()) << value;
    }
}

TEST(SignalListWidget, filtersAndIsDraggedWithoutTakingKeys)
{
    SignalList list;
    list.resize(240, 300);
    list.setSignals({{"telemetry:pitch", "telemetry · pitch [rad]", true},
                     {"bus:Attitude.Pitch", "bus · 022 Attitude Pitch [rad]", false},
                     {"telemetry:roll", "telemetry · roll [rad]", false}});
    gui::showActive(list);
    EXPECT_TRUE(list.list()->item(0)->text().startsWith("✓"));
    list.filter()->setText("pitch bus");
    EXPECT_TRUE(list.list()->item(0)->isHidden());
    EXPECT_FALSE(list.list()->item(1)->isHidden());
    list.filter()->clear();
    list.choose("telemetry:roll");
    EXPECT_EQ(list.chosenKey(), "telemetry:roll");
    QString wanted, dropped;
    int ended = 0;
    QObject::connect(&list, &SignalList::wanted, [&](const QString& key) { wanted = key; });
    QObject::connect(&list, &SignalList::dropped,
                     [&](const QString& key, const QPoint&) { dropped = key; });
    QObject::connect(&list, &SignalList::dragEnded, [&] { ++ended; });
    QTest::keyClick(list.list(), Qt::Key_Return);
    EXPECT_EQ(wanted, "telemetry:roll");
    QWidget* const area = list.list()->viewport();
    const QPoint from = list.list()->visualItemRect(list.list()->item(1)).center();
    QTest::mousePress(area, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, from + QPoint(300, 5),
                     area->mapToGlobal(from + QPoint(300, 5)), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(area, &move);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    QTest::mouseRelease(area, Qt::LeftButton, {}, from + QPoint(300, 5));
    EXPECT_EQ(dropped, "bus:Attitude.Pitch");
    EXPECT_EQ(ended, 1);
}

TEST(PlotValuesWidget, showsStatisticsOfWhatIsInSight)
{
    PlotValues table;
    SeriesSummary sum;
    for (const double value : {1.0, 2.0, 6.0}) sum.add(value);
    table.setValues({{.row = 2, .name = "pitch", .unit = "rad", .atCursor = 1.5, .visible = sum},
                     {.row = 3, .name = "nothing", .unit = ""}});
    EXPECT_EQ(table.rows(), 2);
    EXPECT_EQ(table.text(0, PlotValues::Cursor), "1.5");
    EXPECT_EQ(table.text(0, PlotValues::Least), "1");
    EXPECT_EQ(table.text(0, PlotValues::Most), "6");
    EXPECT_EQ(table.text(0, PlotValues::Mean), "3");
    EXPECT_EQ(table.text(0, PlotValues::Sd), "2.6458");
    EXPECT_EQ(table.text(0, PlotValues::Count), "3");
    EXPECT_EQ(table.text(1, PlotValues::Mean), "--");
}

}  // namespace
}  // namespace terratact
