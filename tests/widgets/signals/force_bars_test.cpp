#include "widgets/signals/force_bars.h"

#include <gtest/gtest.h>
#include <qwt_plot_marker.h>
#include <qwt_text.h>

#include <QApplication>

#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

using Values = std::array<std::optional<double>, kForceElements>;

ForceArray arrayOf(const Values& newtons, const QString& name = {})
{
    ForceArray array;
    array.name = name;
    for (std::size_t e = 0; e < newtons.size(); ++e) array.elements[e].newtons = newtons[e];
    return array;
}

struct Forces : testing::Test {
    Forces()
    {
        bars.resize(420, 240);
        gui::showActive(bars);
    }
    void one(const Values& newtons, double time = 0.0) { bars.setForces({arrayOf(newtons)}, time); }
    void both(const Values& left, const Values& right, double time = 0.0)
    {
        bars.setForces({arrayOf(left, "L"), arrayOf(right, "R")}, time);
    }
    /// Returns the colour at the middle of a bar, `up` pixels above its foot.
    QColor colourIn(int element, int array, double up)
    {
        const QRectF rect = bars.barRect(element, array);
        return gui::painted(*bars.canvas())
            .pixelColor(QPointF(rect.center().x(), rect.bottom() - up).toPoint());
    }
    /// Returns the rectangles of texts on the canvas [px].
    std::vector<QRectF> letters() const
    {
        std::vector<QRectF> all;
        for (const QwtPlotItem* item : bars.itemList(QwtPlotItem::Rtti_PlotMarker)) {
            const auto* marker = static_cast<const QwtPlotMarker*>(item);
            if (!marker->isVisible() || marker->label().isEmpty()) continue;
            const QSizeF size = marker->label().textSize();
            const QPointF foot(bars.transform(QwtPlot::xBottom, marker->xValue()),
                               bars.transform(QwtPlot::yLeft, marker->yValue()));
            // Empty lines at the end reserve the place of another text.
            const QString text = marker->label().text();
            const double line = size.height() / static_cast<double>(text.count('\n') + 1);
            all.emplace_back(foot.x() - size.width() / 2.0, foot.y() - size.height(), size.width(),
                             line * static_cast<double>(text.trimmed().count('\n') + 1));
        }
        return all;
    }
    static void expectApart(const std::vector<QRectF>& labels)
    {
        for (std::size_t i = 0; i < labels.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_FALSE(labels[i].adjusted(0.5, 0.5, -0.5, -0.5).intersects(labels[j]))
                    << lookInForce().fontScale << " %: " << i << " and " << j;
    }
    ForceBars bars;
};

TEST_F(Forces, eachBarShowsItsNumber)
{
    one({0.24, 0.0, 1.0, 2.5, 6.44, std::nullopt});
    EXPECT_EQ(bars.numberText(0), "0.2");
    EXPECT_EQ(bars.numberText(4), "6.4");
    EXPECT_EQ(bars.numberText(5), "--") << "not measured is not zero";
    EXPECT_TRUE(bars.accessibleDescription().contains("element 5: 6.4 N, contact"));
}

TEST_F(Forces, touchingIsAboveTheThreshold)
{
    bars.setThreshold(2.0);
    one({1.99, 2.0, 2.01, 0.0, 0.0, std::nullopt});
    EXPECT_FALSE(bars.touching(0));
    EXPECT_FALSE(bars.touching(1));
    EXPECT_TRUE(bars.touching(2));
    EXPECT_FALSE(bars.touching(5));
    bars.setThreshold(3.0);
    EXPECT_FALSE(bars.touching(2));
}

TEST_F(Forces, noLabelTouchesAnother)
{
    for (const int scale : {100, 150, 200}) {
        applyLook(*qApp, ThemeName::Day, scale);
        bars.resize(bars.minimumSizeHint() * (scale / 100.0));
        both({15.2, 18.1, 17.0, 0.1, 12.5, 2.6}, {14.9, 18.4, 16.6, 0.3, 13.5, 2.8});
        QTest::qWait(20);
        const std::vector<QRectF> labels = letters();
        EXPECT_EQ(labels.size(), 8U) << "six elements, two groups in contact";
        expectApart(labels);
    }
    applyLook(*qApp);
}

TEST_F(Forces, aBarIsAsHighAsItsForce)
{
    one({0.0, 0.0, 0.0, 0.0, 8.0, 0.0});
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
    one({0.0, 0.0, 0.0, 0.0, 900.0, 0.0});
    EXPECT_GE(bars.fullScale(), 900.0);
    one({0.0, 0.0, 0.0, 0.0, 1.0, 0.0}, PeakHold::kHold + 1.0);
    EXPECT_LE(bars.fullScale(), 20.0);
}

TEST_F(Forces, hostileNumbersReadAsNotMeasured)
{
    for (const double bad : gui::kHostile) {
        ForceArray array = arrayOf({bad, 3.0, bad, bad, bad, bad});
        for (ForceElement& element : array.elements) element.volts = element.drift = bad;
        bars.setForces({array}, bad);
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
    one({1.0, 1.0, 1.0, 1.0, 1.0, 9.0});
    bars.clearForces();
    for (int element = 0; element < kForceElements; ++element)
        EXPECT_EQ(bars.numberText(element), "--");
}

TEST_F(Forces, ofTwoArraysStandSideBySide)
{
    both({0.0, 0.0, 0.0, 3.0, 8.0, 0.0}, {0.0, 0.0, 0.0, 6.0, 4.0, std::nullopt});
    ASSERT_EQ(bars.arrays(), 2);
    EXPECT_EQ(bars.legend(), "■ L  □ R");
    const QRectF left = bars.barRect(4, 0), right = bars.barRect(4, 1);
    EXPECT_LT(left.right(), right.left());
    EXPECT_LT(right.right(), bars.barRect(5, 0).left());
    EXPECT_NEAR(left.height(), 2.0 * right.height(), 1.5);
    EXPECT_NEAR(left.top(), bars.pixelOf(8.0), 1e-9);
    EXPECT_TRUE(bars.accessibleDescription().contains("element 5: L 8.0 N, R 4.0 N, contact"));
    EXPECT_TRUE(bars.accessibleDescription().contains("element 6: L 0.0 N, R -- N"));
    one({0.0, 0.0, 0.0, 3.0, 8.0, 0.0});
    EXPECT_EQ(bars.legend(), "");
    EXPECT_GT(bars.barRect(4).width(), 1.5 * left.width());
}

TEST_F(Forces, ofFourArraysShareTheRoomOfTheElementsThatTheyHave)
{
    std::vector<ForceArray> four;
    for (const char* name : {"L low", "L tip", "R low", "R tip"}) {
        four.push_back(arrayOf({1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, name));
        const bool low = QLatin1String(name).endsWith(QLatin1String("low"));
        for (std::size_t e = 0; e < kForceElements; ++e)
            if ((e < 3) != low) four.back().elements[e] = {.exists = false};
    }
    bars.setForces(four, 0.0);
    EXPECT_EQ(bars.arrays(), 4);
    EXPECT_EQ(bars.legend(), "■ L low  □ L tip  ▦ R low  ▤ R tip");
    EXPECT_TRUE(bars.barRect(0, 1).isNull()) << "there is no such element";
    EXPECT_FALSE(bars.barRect(0, 2).isNull());
    EXPECT_LT(bars.barRect(0, 0).right(), bars.barRect(0, 2).left());
    EXPECT_NEAR(bars.barRect(0, 0).width(), bars.barRect(5, 3).width(), 1e-9);
    EXPECT_TRUE(bars.accessibleDescription().contains("element 1: L low 1.0 N, R low 1.0 N\n"));
    EXPECT_TRUE(bars.touching(3)) << "what does not exist says nothing against it";
    const auto ink = [&](int element, int array) {
        const QRectF rect = bars.barRect(element, array).adjusted(4, 4, -4, -4);
        const QImage image = gui::painted(*bars.canvas()).copy(rect.toRect());
        return 1.0
             - static_cast<double>(gui::pixelsOf(image, theme().card))
                   / (image.width() * image.height());
    };
    EXPECT_GT(ink(2, 0), ink(2, 2) + 0.2) << "solid against crossed";
    bars.clearForces();
    EXPECT_TRUE(bars.barRect(0, 1).isNull());
}

TEST_F(Forces, touchAsTheMeanOfWhatTheArraysFeel)
{
    both({3.0, 3.0, std::nullopt, 0.0, 0.0, 0.0}, {0.0, 1.5, 2.5, 0.0, 0.0, std::nullopt});
    EXPECT_FALSE(bars.touching(0)) << "1.5 N";
    EXPECT_TRUE(bars.touching(1)) << "2.25 N";
    EXPECT_TRUE(bars.touching(2)) << "the other is broken";
    EXPECT_FALSE(bars.touching(5));
}

TEST_F(Forces, thePeakStandsForThreeSeconds)
{
    one({0.0, 0.0, 0.0, 0.0, 7.0, 0.0}, 10.0);
    one({0.0, 0.0, 0.0, 0.0, 3.0, 0.0}, 11.0);
    EXPECT_EQ(bars.peak(4), 7.0);
    one({0.0, 0.0, 0.0, 0.0, 1.0, 0.0}, 12.9);
    EXPECT_EQ(bars.peak(4), 7.0);
    const QImage image = gui::painted(*bars.canvas());
    const auto grey = [&](double newtons, int below) {
        const QPointF at(bars.barRect(4).left() + 2.0, bars.pixelOf(newtons) + below);
        return qGray(image.pixel(at.toPoint()));
    };
    EXPECT_LT(std::min(grey(7.0, 0), grey(7.0, -1)), grey(7.0, 8) - 60) << "a thin line";
    one({0.0, 0.0, 0.0, 0.0, 1.0, 0.0}, 13.1);
    EXPECT_EQ(bars.peak(4), 3.0) << "the largest of the last 3 s";
    one({0.0, 0.0, 0.0, 0.0, 0.5, 0.0}, 2.0);
    EXPECT_EQ(bars.peak(4), 0.5) << "the clock jumped back";
    bars.clearForces();
    EXPECT_FALSE(bars.peak(4));
}

TEST_F(Forces, aSaturatedElementShowsNoExactNumber)
{
    ForceArray left = arrayOf({0.0, 0.0, 0.0, 0.0, 19.7, 0.0}, "L");
    left.elements[4].saturated = true;
    bars.setForces({left, arrayOf({0.0, 0.0, 0.0, 0.0, 18.0, 0.0}, "R")}, 0.0);
    EXPECT_EQ(bars.numberText(4, 0), ">19");
    EXPECT_EQ(bars.numberText(4, 1), "18");
    EXPECT_TRUE(bars.accessibleDescription().contains("L >19 N saturated, R 18 N, contact"));
    EXPECT_TRUE(bars.toolTip().startsWith(bars.accessibleDescription()));
    const QColor mark = colourIn(4, 0, bars.barRect(4, 0).height() - 8.0);
    EXPECT_EQ(mark, theme().text) << "a triangle";
}

TEST_F(Forces, textsStayOnALowChart)
{
    for (const int scale : {100, 200}) {
        applyLook(*qApp, ThemeName::Day, scale);
        bars.resize(bars.minimumSizeHint() * (scale / 100.0));
        ForceArray left = arrayOf({0.0, 19.7, 19.7, 0.0, 4.0, 12.0}, "L"), right = left;
        for (const std::size_t element : {1U, 2U})
            left.elements[element].saturated = right.elements[element].saturated = true;
        right.name = "R";
        right.elements[1].newtons = 19.8;
        bars.setForces({left, right}, 0.0);
        QTest::qWait(20);
        for (const QRectF& label : letters()) EXPECT_GE(label.top(), 0.0) << scale;
        expectApart(letters());
        EXPECT_TRUE(bars.accessibleDescription().contains("L >19 N saturated, R >19 N saturated"));
    }
    applyLook(*qApp);
}

TEST_F(Forces, rawIsTheSameInVolts)
{
    ForceArray array = arrayOf({0.0, 0.0, 0.0, 0.0, 8.0, 0.0});
    for (ForceElement& element : array.elements) element.volts = 1.672;
    array.elements[4].volts = 4.5;
    bars.setForces({array}, 0.0);
    bars.setUnit(ForceBars::Unit::Volts);
    EXPECT_EQ(bars.numberText(0), "1.67");
    EXPECT_EQ(bars.numberText(4), "4.50");
    EXPECT_NEAR(bars.barRect(4).top(), bars.pixelOf(4.5), 1e-9);
    EXPECT_LE(bars.fullScale(), 10.0);
    EXPECT_TRUE(bars.touching(4)) << "volts do not change what touches";
    EXPECT_EQ(bars.peak(0), 1.672);
    EXPECT_TRUE(bars.accessibleDescription().contains("element 5: 4.50 V, contact"));
    const auto reds = [this] { return gui::pixelsOf(gui::painted(*bars.canvas()), theme().bad); };
    EXPECT_EQ(reds(), 0) << "no threshold in volts";
    bars.setUnit(ForceBars::Unit::Newtons);
    EXPECT_GT(reds(), 50);
    EXPECT_EQ(bars.numberText(4), "8.0");
}

TEST_F(Forces, aDriftedBiasStandsBelowItsElement)
{
    ForceArray left = arrayOf({0.0, 0.0, 0.4, 0.0, 0.0, 0.0}, "L"), right = left;
    right.name = "R";
    left.elements[1].drift = 0.29;
    left.elements[2].drift = 0.41;
    right.elements[2].drift = -0.72;
    bars.setForces({left, right}, 0.0);
    EXPECT_EQ(bars.driftText(0), "");
    EXPECT_EQ(bars.driftText(1), "") << "too small";
    EXPECT_EQ(bars.driftText(2), "bias −0.7 N") << "the larger one";
    EXPECT_TRUE(bars.accessibleDescription().contains("element 3: L 0.4 N, R 0.4 N, bias −0.7 N"));
    const auto amber = [this] { return gui::pixelsOf(gui::painted(bars), theme().warning); };
    EXPECT_GT(amber(), 5);
    bars.clearForces();
    EXPECT_EQ(amber(), 0);
}

TEST_F(Forces, noWordIsCutAtTheTopInALowChart)
{
    for (const int height : {64, 72, 80, 90, 100, 110, 120, 135, 150, 200, 260}) {
        bars.resize(340, height);
        for (const double force : {2.6, 5.3, 8.1, 12.4, 18.9, 24.0}) {
            SCOPED_TRACE(testing::Message() << height << " px, " << force << " N");
            const auto expectRoom = [&] {
                for (const QRectF& label : letters()) EXPECT_GE(label.top(), 0.0);
            };
            one({0.1, 0.0, 0.2, force, 0.0, 0.0});
            expectRoom();
            one({0.1, 12.3, 18.7, force, 0.0, 0.0});
            expectRoom();
            both({0.1, 0.0, 0.2, force, 11.1, 0.0}, {0.1, 0.0, 0.2, force, 0.0, 9.0});
            expectRoom();
            ForceArray left = arrayOf({0.1, 0.0, 0.2, force, 7.0, 0.0}, "L"), right = left;
            right.name = "R";
            left.elements[4].saturated = right.elements[4].saturated =
                true;  // two lines of numbers
            bars.setForces({left, right}, 0.0);
            expectRoom();
            bars.clearForces();
        }
    }
    bars.resize(340, 200);
    one({0.1, 0.0, 0.2, 8.1, 0.0, 0.0});
    EXPECT_EQ(letters().size(), 7U) << "with its word";
}

TEST_F(Forces, numbersHaveRoomAboveTheirBars)
{
    bars.resize(340, 140);
    for (const double force : {1.0, 7.9, 14.0, 19.9, 90.0, 390.0}) {
        both({0.0, 0.0, 0.0, 0.0, force, 0.0}, {0.0, 0.0, 0.0, 0.0, force, 0.0});
        EXPECT_GT(bars.pixelOf(force), 30.0) << force << ": number and contact above it";
    }
}

}  // namespace
}  // namespace terratact
