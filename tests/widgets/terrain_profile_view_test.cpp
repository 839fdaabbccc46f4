#include "widgets/terrain_profile_view.h"

#include <gtest/gtest.h>
#include <qwt_abstract_legend.h>
#include <qwt_plot_curve.h>

#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/bin_inspector.h"
#include "widgets/drawable.h"
#include "widgets/look.h"
#include "widgets/palette.h"
#include "widgets/provenance_marks.h"
#include "widgets/provenance_words.h"

namespace terratact {
namespace {

using gui::painted;
using gui::PaintWatch;

Outline square(double left, double bottom, double right, double top)
{
    return {{.kind = OutlinePart::Kind::Body,
             .points = {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}};
}

/// Colour of the canvas at a point of the DEM frame.
QColor colourAt(TerrainProfileView& view, double x, double z)
{
    const QImage image = painted(*view.canvas());
    return image.pixelColor(view.pixelOf(x, z).toPoint());
}

bool alike(const QColor& a, const QColor& b)
{
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green())
             + std::abs(a.blue() - b.blue())
         < 40;
}

struct TerrainView : testing::Test {
    TerrainView()
    {
        view.resize(900, 480);
        gui::showActive(view);
    }
    TerrainProfileView view;
};

TEST_F(TerrainView, aMetreIsAsLongUpwardsAsForwardsAtEverySize)
{
    view.setEstimate(stepEstimate());
    for (const QSize size :
         {QSize(900, 480), QSize(600, 600), QSize(1500, 400), QSize(421, 261), QSize(300, 900)}) {
        view.resize(size);
        QApplication::processEvents();
        const QPointF origin = view.pixelOf(0.0, 0.0);
        const double forwards = view.pixelOf(0.5, 0.0).x() - origin.x();
        const double upwards = origin.y() - view.pixelOf(0.0, 0.5).y();
        EXPECT_GT(forwards, 20.0);
        EXPECT_NEAR(forwards, upwards, 0.01 * forwards) << size.width() << " × " << size.height();
    }
}

TEST_F(TerrainView, whatIsNotLiveIsMutedAndSaysOfWhen)
{
    view.setOutline(square(-0.3, -0.1, 0.3, 0.1));
    view.setTruth(Heights{});
    view.setEstimate(stepEstimate());
    const QImage live = painted(*view.canvas());
    view.setStale(1.2);
    const QImage stale = painted(*view.canvas());
    // How far a spot stands out against the card.
    const auto contrast = [&](const QImage& image, double x, double z) {
        const QPoint at = view.pixelOf(x, z).toPoint();
        double sum = 0.0;
        for (int dx = -2; dx <= 2; ++dx)
            for (int dy = -2; dy <= 2; ++dy)
                sum +=
                    std::abs(qGray(image.pixel(at + QPoint(dx, dy))) - qGray(theme().card.rgb()));
        return sum;
    };
    const TerrainEstimate estimate = stepEstimate();
    for (const std::size_t bin : {0U, 3U, 8U}) {
        const double x = binCentre(static_cast<int>(bin)), z = estimate.height[bin];
        EXPECT_LT(contrast(stale, x, z), 0.7 * contrast(live, x, z)) << "bin " << bin;
    }
    const QPoint robot = view.pixelOf(-0.25, -0.07).toPoint();
    EXPECT_NE(stale.pixel(robot), live.pixel(robot));
    view.setStale(1.3);
    EXPECT_NE(painted(*view.canvas()), stale) << "its age goes on";
    for (const double age : gui::kHostile) {
        view.setStale(age);
        EXPECT_FALSE(painted(*view.canvas()).isNull());
    }
    view.setStale(std::nullopt);
    EXPECT_EQ(painted(*view.canvas()), live);
}

TEST_F(TerrainView, pixelsAndMetresMapBothWays)
{
    view.setEstimate(stepEstimate());
    for (const double x : {-0.3, 0.0, 0.65}) {
        const QPointF back = view.pointAt(view.pixelOf(x, -0.2));
        EXPECT_NEAR(back.x(), x, 1e-9);
        EXPECT_NEAR(back.y(), -0.2, 1e-9);
    }
}

/// Bins 3 to 7 in the order of kProvenances, each with a band of 0.3 m.
TerrainEstimate oneOfEachKind()
{
    TerrainEstimate e = stepEstimate();
    for (std::size_t kind = 0; kind < kProvenances.size(); ++kind) {
        const std::size_t i = 3 + kind;
        e.height[i] = -0.1;
        e.q10[i] = -0.25;
        e.q90[i] = 0.05;
        e.origin[i] = Origin::Sampled;
        e.ceiling[i] = 0.15;
        switch (kProvenances[kind]) {
        case Provenance::Arm: e.origin[i] = Origin::Arm; break;
        case Provenance::Contact: e.origin[i] = Origin::Contact; break;
        case Provenance::Constrained: e.ceiling[i] = e.q90[i]; break;
        case Provenance::Sampled: break;
        case Provenance::PriorOnly: e.ceiling[i] = std::numeric_limits<double>::infinity(); break;
        }
    }
    return e;
}

/// Of the upper half of a bin's bar in greys: how many pieces of ink lie one below the other, how long they are in all
/// [% of the bar] and how wide [px].
std::array<int, 3> inkOfBar(const TerrainProfileView& view, const QImage& image, int bin)
{
    const QPointF top = view.pixelOf(binCentre(bin), 0.04), bottom = view.pixelOf(0.0, -0.06);
    const int x = qRound(top.x()), height = qRound(bottom.y() - top.y());
    const auto isInk = [&](int dx, int y) {
        const int ground = qGray(image.pixel(x + 14, y));
        return std::abs(qGray(image.pixel(x + dx, y)) - ground) > 40;
    };
    int pieces = 0, length = 0, width = 0;
    for (int y = qRound(top.y()); y < qRound(bottom.y()); ++y) {
        const bool ink = isInk(0, y) || isInk(-1, y);
        const bool before = isInk(0, y - 1) || isInk(-1, y - 1);
        pieces += ink && !before ? 1 : 0;
        length += ink ? 1 : 0;
        int across = 0;
        for (int dx = -7; dx <= 7; ++dx) across += isInk(dx, y) ? 1 : 0;
        width = std::max(width, across);
    }
    return {pieces, 100 * length / height, width};
}

/// Of the strip below `top`, around x: how many pixels stand out from the card.
int inkIn(const QImage& image, double x, double top)
{
    int ink = 0;
    for (int y = qCeil(top); y < image.height(); ++y)
        for (int dx = -6; dx <= 6; ++dx) {
            const QRgb pixel = image.pixel(qRound(x) + dx, y);
            ink += std::abs(qGray(pixel) - qGray(theme().card.rgb())) > 50 ? 1 : 0;
        }
    return ink;
}

TEST_F(TerrainView, aLetterSaysOfEveryBinWhatSpeaksForItAndCoversNothing)
{
    const MarkLetters* letters = nullptr;
    for (const QwtPlotItem* item : view.itemList())
        if (const auto* found = dynamic_cast<const MarkLetters*>(item)) letters = found;
    ASSERT_TRUE(letters);
    TerrainEstimate deep = oneOfEachKind();
    deep.q10[1] = -0.9;
    for (const ThemeName name : {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast})
        for (const int percent : {80, 100, 200})
            for (const QSize size : {QSize(900, 480), QSize(500, 150)}) {
                applyLook(*qApp, name, percent);
                view.resize(size);
                for (const TerrainEstimate& e : {oneOfEachKind(), deep}) {
                    view.setEstimate(e);
                    gui::settle(view);
                    const std::string where = std::to_string(static_cast<int>(name)) + ", "
                                            + std::to_string(percent) + " %, "
                                            + std::to_string(size.width());
                    const QImage image = painted(*view.canvas());
                    const double strip = image.height() - MarkLetters::height(view.font());
                    for (int bin = 0; bin < kBins; ++bin) {
                        const auto k = static_cast<std::size_t>(bin);
                        EXPECT_EQ(letters->shown[k], provenance(e, bin));
                        EXPECT_GE(inkIn(image, view.pixelOf(binCentre(bin), 0.0).x(), strip), 8)
                            << where << ", bin " << bin;
                        EXPECT_LE(view.pixelOf(0.0, e.q10[k]).y(),
                                  image.height()
                                      - MarkLetters::reserved(view.font(), image.height()))
                            << where;
                    }
                }
            }
    applyLook(*qApp);
    EXPECT_GT(MarkLetters::reserved(view.font(), 480.0), 0.0);
    view.clearEstimate("none");
    for (const auto& shown : letters->shown) EXPECT_FALSE(shown);
}

TEST_F(TerrainView, everyBinAndItsBarLieOnTheCanvas)
{
    TerrainEstimate high = stepEstimate();
    high.height[10] = 0.6;
    high.q90[10] = 0.8;
    high.q10[0] = -0.9;
    view.setEstimate(high);
    const QRectF canvas = view.canvas()->rect();
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        for (const double z : {high.height[i], high.q10[i], high.q90[i]})
            EXPECT_TRUE(canvas.contains(view.pixelOf(binCentre(bin), z)))
                << "bin " << bin << " at " << z;
    }
}

TEST_F(TerrainView, marksStandWhereTheMeansAre)
{
    TerrainEstimate e = probedEstimate();
    view.setEstimate(e);
    EXPECT_TRUE(alike(colourAt(view, 0.0, e.height[3]), theme().sampled));
    EXPECT_TRUE(alike(colourAt(view, 0.5, e.height[8]), theme().contact));
    EXPECT_TRUE(alike(colourAt(view, 0.6, e.height[9]), theme().arm));
    EXPECT_TRUE(alike(colourAt(view, 0.7, e.height[10]), theme().card))
        << "an open mark: nothing but the prior";
}

TEST_F(TerrainView, kindsDifferInShapeAndNotOnlyInColour)
{
    // A square fills its corner; a circle and a triangle of that size do not fill their upper left one.
    TerrainEstimate e = probedEstimate();
    e.q10 = e.q90 = e.height;  // no bars in the way
    view.setEstimate(e);
    const QImage image = painted(*view.canvas());
    const auto upperLeft = [&](int bin) {
        const QPointF centre =
            view.pixelOf(binCentre(bin), e.height[static_cast<std::size_t>(bin)]);
        return image.pixelColor((centre + QPointF(-4.5, -4.5)).toPoint());
    };
    EXPECT_TRUE(alike(upperLeft(8), theme().contact));
    EXPECT_FALSE(alike(upperLeft(3), theme().sampled));
    EXPECT_FALSE(alike(upperLeft(9), theme().arm));
}

TEST_F(TerrainView, onlyPriorOnlyBinsLieInTheAmberZone)
{
    view.setEstimate(stepEstimate());
    const auto amber = [&](double x) { return colourAt(view, x, -0.37).blue() < 225; };
    EXPECT_TRUE(amber(0.57));
    EXPECT_TRUE(amber(0.73));
    EXPECT_FALSE(amber(0.53));
    EXPECT_FALSE(amber(0.77));
    view.clearEstimate("none");
    EXPECT_FALSE(amber(0.57));
}

TEST_F(TerrainView, aNoteLiesBelowTheZonesWords)
{
    view.setEstimate(stepEstimate());
    const auto strip = [&](int from, int to) {  // [px] below the upper edge
        return painted(*view.canvas()).copy(0, from, view.canvas()->width(), to - from);
    };
    const int words = 5 + scaled(20);
    const QImage zones = strip(0, words), below = strip(words, words + scaled(40));
    view.setEstimate(stepEstimate(), QString(120, QLatin1Char('n')));
    EXPECT_EQ(strip(0, words), zones);
    EXPECT_NE(strip(words, words + scaled(40)), below);
    EXPECT_TRUE(view.accessibleDescription().startsWith("nnnn"));
}

/// Half of the draws up on the step at +0.6 and +0.7 m, half down.
TerrainEstimate divided()
{
    TerrainEstimate e = stepEstimate();
    for (int d = 0; d < 200; ++d) {
        Heights h = e.height;
        if (d % 2 == 0) h[9] = h[10] = -0.25;
        e.draws.push_back(h);
    }
    return e;
}

TEST_F(TerrainView, aBinWithTwoHeightsShowsBoth)
{
    const auto marked = [&](double z) { return alike(colourAt(view, 0.63, z), theme().doubt); };
    view.setEstimate(stepEstimate());
    EXPECT_FALSE(marked(-0.25));
    view.setEstimate(divided());
    EXPECT_TRUE(marked(-0.25));
    EXPECT_TRUE(marked(-0.05));
}

TEST_F(TerrainView, drawsAndASecondMethodAreLayersOnDemand)
{
    view.setEstimate(divided());
    const QImage plain = painted(*view.canvas());
    view.setDrawsShown(true);
    const QImage withDraws = painted(*view.canvas());
    EXPECT_NE(plain, withDraws);
    view.setDrawsShown(false);
    EXPECT_EQ(painted(*view.canvas()), plain);
    TerrainEstimate second = stepEstimate();
    second.height[4] = -0.35;
    view.setSecond(second, "pafc");
    EXPECT_TRUE(alike(colourAt(view, 0.118, -0.35), theme().card));  // an open circle
    view.setSecond(std::nullopt, {});
    EXPECT_EQ(painted(*view.canvas()), plain);
}

/// What is left of stepEstimate() after 0.2 m.
Ghost ghost()
{
    return ghostOf(stepEstimate(), {.forward = 0.2, .way = 0.2, .upSd = 0.03});
}

TEST_F(TerrainView, theGhostIsDashedInABandAndSaysHowFarItWasDriven)
{
    view.clearEstimate("moved");
    const QImage without = painted(*view.canvas());
    view.setGhost(ghost());
    const auto greens = [&](double z) {  // along bins -0.3 … 0.2
        const QImage image = painted(*view.canvas());
        const int y = static_cast<int>(std::lround(view.pixelOf(0.0, z).y()));
        int count = 0, all = 0;
        for (double x = -0.25; x < 0.2; x += 0.002, ++all) {
            const auto isGreen = [&](int row) {  // it may lie between two
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
        QStringLiteral("0.20 m driven since · heights ± 3 cm")));
    view.setGhost(std::nullopt, "No ghost: the robot has turned");
    EXPECT_TRUE(view.accessibleDescription().contains("has turned"));
    view.setGhost(std::nullopt);
    EXPECT_EQ(painted(*view.canvas()), without);
}

TEST_F(TerrainView, aGhostThatIsNotFiniteOrHasHolesIsDrawnWhereItCanBe)
{
    Ghost broken = ghost();
    broken.bin[1]->height = std::numeric_limits<double>::quiet_NaN();
    broken.bin[3]->q90 = std::numeric_limits<double>::infinity();
    broken.bin[4].reset();
    view.setGhost(broken);
    const QImage image = painted(*view.canvas());
    ASSERT_FALSE(image.isNull());
    int drawn = 0;  // of a thin line of dashes
    for (int dy = -5; dy <= 5; ++dy)
        for (const int dx : {-1, 0, 1})
            drawn += image.pixelColor(view.pixelOf(-0.1, -0.22).toPoint() + QPoint(dx, dy))
                          != theme().card
                       ? 1
                       : 0;
    EXPECT_GT(drawn, 0) << "a bin alone, too";
}

TEST_F(TerrainView, theBinUnderTheMouseOrTheArrowKeysIsShownUpClose)
{
    view.setEstimate(divided());
    QTest::mouseMove(view.canvas(), view.pixelOf(0.6, -0.2).toPoint());
    QMouseEvent move(QEvent::MouseMove, view.pixelOf(0.6, -0.2), view.pixelOf(0.6, -0.2),
                     Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view.canvas(), &move);
    const BinInspector& inspector = *view.inspector();
    ASSERT_EQ(inspector.bin(), 9);
    EXPECT_TRUE(inspector.isVisible());
    EXPECT_TRUE(inspector.lines().join(' ').contains(QStringLiteral("either −0.25 m (50 %)")));
    ASSERT_EQ(inspector.histogram().size(), static_cast<std::size_t>(BinInspector::kClasses));
    EXPECT_EQ(inspector.histogram().front(), 100);
    EXPECT_EQ(inspector.histogram().back(), 100);
    QTest::keyClick(&view, Qt::Key_Left);
    EXPECT_EQ(inspector.bin(), 8);
    view.clearEstimate("none");
    EXPECT_FALSE(inspector.isVisible());
}

TEST_F(TerrainView, theRobotIsDrawnInMetresAroundTheImu)
{
    view.setOutline(square(-0.2, 0.05, 0.2, 0.15));
    EXPECT_FALSE(alike(colourAt(view, 0.12, 0.13), theme().card));
    EXPECT_TRUE(alike(colourAt(view, 0.12, 0.17), theme().card));
    view.setOutline({});
    EXPECT_TRUE(alike(colourAt(view, 0.12, 0.13), theme().card));
}

TEST_F(TerrainView, theProbeIsMarkedAboveItsBinOnly)
{
    view.setEstimate(stepEstimate());
    const auto purple = [&](double x) {
        const QImage image = painted(*view.canvas());
        const int px = static_cast<int>(std::lround(view.pixelOf(x, 0.0).x()));
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (const int dx : {-1, 0, 1})
                count += alike(image.pixelColor(px + dx, y), theme().accent) ? 1 : 0;
        return count;
    };
    EXPECT_EQ(purple(0.6), 0);
    view.setArmTip(ArmTip{.bin = 9});
    EXPECT_GT(purple(0.6), 10);
    EXPECT_EQ(purple(0.4), 0);
    view.setArmTip(std::nullopt);
    EXPECT_EQ(purple(0.6), 0);
    view.setArmTip(ArmTip{.bin = 99});
    EXPECT_FALSE(painted(view).isNull());
}

TEST_F(TerrainView, theArmsTipStandsWhereItTouched)
{
    using State = ArmTip::State;
    const auto purpleAt = [&](double x, double z, int up) {
        const QImage image = painted(*view.canvas());
        return alike(image.pixelColor(view.pixelOf(x, z).toPoint() - QPoint(0, up)),
                     theme().accent);
    };
    view.setArmTip(ArmTip{.state = State::Touched, .bin = 10, .height = -0.2});
    EXPECT_TRUE(purpleAt(0.7, -0.2, 20)) << "whether there is an estimate or not";
    EXPECT_FALSE(purpleAt(0.7, -0.2, 4)) << "not below the ground";
    EXPECT_FALSE(purpleAt(0.7, 0.05, 20)) << "where the arm comes from is not known";
    view.setArmTip(ArmTip{.state = State::Probing, .bin = 10});
    EXPECT_FALSE(purpleAt(0.7, -0.2, 20)) << "no height is believed";
    const TerrainEstimate e = stepEstimate();
    view.setEstimate(e);
    EXPECT_TRUE(purpleAt(0.7, e.q90[10], 18)) << "above the band";
    view.setArmTip(ArmTip{.state = State::Proposed, .bin = 10});
    EXPECT_FALSE(purpleAt(0.7, e.q90[10], 18)) << "open as long as it is a question";
    for (const double bad : gui::kHostile) {
        view.setArmTip(ArmTip{.state = State::Touched, .bin = 10, .height = bad});
        EXPECT_FALSE(painted(view).isNull());
    }
}

TEST_F(TerrainView, theTruthIsALevelLineOverEachBin)
{
    Heights truth;
    truth.fill(-0.33);
    const auto red = [&] {
        const QImage image = painted(*view.canvas());
        const QPoint at = view.pixelOf(0.03, -0.33).toPoint();
        for (int dy = -2; dy <= 2; ++dy) {
            const QColor colour = image.pixelColor(at + QPoint(0, dy));
            if (colour.red() - colour.green() > 60) return true;
        }
        return false;
    };
    EXPECT_FALSE(red());
    view.setTruth(truth);
    EXPECT_TRUE(red());
    view.setTruth(std::nullopt);
    EXPECT_FALSE(red());
}

TEST_F(TerrainView, saysEachBinInWords)
{
    view.setEstimate(stepEstimate());
    EXPECT_EQ(view.binText(8),
              QStringLiteral("bin 0.5 m: −0.05 m, 80 % in −0.06 … −0.04, contact"));
    EXPECT_TRUE(view.binText(10).endsWith(QStringLiteral("prior only")));
    EXPECT_EQ(view.accessibleDescription().count(QLatin1Char('\n')), kBins - 1);
    view.clearEstimate("explore first");
    EXPECT_EQ(view.accessibleDescription(), QStringLiteral("explore first"));
    EXPECT_TRUE(view.binText(8).isEmpty());
}

TEST(Painted, isNothingWhereItTakesSeconds)
{
    class Slow final : public QWidget {
        void paintEvent(QPaintEvent* /*event*/) override
        {
            for (const double began = threadMilliseconds(); threadMilliseconds() - began < 1200.0;)
                continue;
        }
    };
    Slow slow;
    slow.resize(20, 20);
    EXPECT_TRUE(gui::painted(slow).isNull());
}

TEST_F(TerrainView, hostileNumbersAreLeftOutAndTheRestIsDrawnAtOnce)
{
    for (const double bad : gui::kHostile) {
        TerrainEstimate e = stepEstimate();
        e.height[5] = e.q10[6] = e.q90[7] = e.ceiling[2] = bad;
        Heights truth = e.height;
        Outline outline = square(-0.2, 0.0, 0.2, 0.1);
        outline.front().points.push_back({bad, 0.05});
        outline.front().points.push_back({0.0, bad});
        view.setOutline(outline);
        view.setTruth(truth);
        view.setEstimate(e);
        view.setArmTip(ArmTip{.bin = 5});
        const QImage image = painted(view);
        ASSERT_FALSE(image.isNull()) << "a painter gets " << bad;
        EXPECT_GT(gui::colours(image), 20);
        EXPECT_TRUE(alike(colourAt(view, 0.5, e.height[8]), theme().contact)) << bad;
        (void)view.binText(5);
    }
}

TEST_F(TerrainView, hostileNumbersInItsLayersAreLeftOut)
{
    for (const double bad : gui::kHostile) {
        TerrainEstimate e = divided();
        e.draws[0][3] = e.draws[1][9] = bad;
        view.setEstimate(e);
        view.setDrawsShown(true);
        TerrainEstimate second = stepEstimate();
        second.height[2] = second.q10[4] = second.q90[5] = bad;
        view.setSecond(second, "pafc");
        view.inspect(3);
        ASSERT_FALSE(painted(view).isNull()) << bad;
        Ghost moved = ghost();
        moved.bin[1]->height = moved.bin[2]->q10 = moved.bin[3]->q90 = bad;
        moved.motion = {.forward = bad, .up = bad, .way = bad};
        view.clearEstimate("moved");
        view.setGhost(moved);
        view.setStale(bad);
        ASSERT_FALSE(painted(view).isNull()) << bad;
        view.setStale(std::nullopt);
        view.setGhost(std::nullopt);
    }
}

TEST_F(TerrainView, nothingButHostileNumbersLeavesAPicture)
{
    for (const double bad : gui::kHostile) {
        TerrainEstimate e;
        for (Heights* h : {&e.height, &e.sd, &e.q10, &e.q90, &e.ceiling}) h->fill(bad);
        view.setEstimate(e);
        ASSERT_FALSE(painted(view).isNull());
    }
}

TEST(PaintWatch, seesANumberThatACurveOfQwtPassesOn)
{
    QwtPlot plot;
    plot.resize(400, 300);
    plot.setAutoReplot(false);
    plot.setAxisScale(QwtPlot::xBottom, 0.0, 4.0);
    plot.setAxisScale(QwtPlot::yLeft, 0.0, 4.0);
    auto* curve = new QwtPlotCurve;
    curve->attach(&plot);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double y : {2.0, nan}) {
        curve->setSamples(QPolygonF{{0, 1}, {1, 2}, {2, y}, {3, 3}});
        plot.replot();
        PaintWatch watch(plot.size());
        QPainter painter(&watch);
        plot.drawCanvas(&painter);
        painter.end();
        EXPECT_EQ(watch.hostile() > 0, y != 2.0) << y;
    }
}

TEST(Drawable, aPathBreaksWhereANumberIsMissing)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const QPainterPath path = pathThrough({{0, 0}, {1, 1}, {2, nan}, {3, 3}, {4, 4}, {5, 1e9}});
    ASSERT_EQ(path.elementCount(), 4);
    EXPECT_TRUE(path.elementAt(2).isMoveTo());
    EXPECT_EQ(path.boundingRect(), QRectF(0, 0, 4, 4));
}

TEST_F(TerrainView, noTwoKindsOfBinsHaveAShapeAPatternOrAWordInCommon)
{
    view.resize(1200, 800);
    for (const ThemeName name : {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast}) {
        applyLook(*qApp, name);
        view.restyle();
        view.setEstimate(oneOfEachKind());
        QApplication::processEvents();
        const QImage image = painted(*view.canvas());
        std::set<QString> words, letters;
        std::set<int> shapes;
        for (std::size_t a = 0; a < kProvenances.size(); ++a) {
            const Provenance one = kProvenances[a];
            ASSERT_EQ(provenance(oneOfEachKind(), 3 + static_cast<int>(a)), one);
            words.insert(provenanceWord(one));
            letters.insert(provenanceLetter(one));
            shapes.insert(markOf(one).shape);
            const auto inkOfOne = inkOfBar(view, image, 3 + static_cast<int>(a));
            EXPECT_GT(inkOfOne[1], 0) << terratact::name(one);
            for (std::size_t b = 0; b < a; ++b) {
                const auto other = inkOfBar(view, image, 3 + static_cast<int>(b));
                const bool differ = std::abs(inkOfOne[0] - other[0]) >= 2
                                 || std::abs(inkOfOne[1] - other[1]) >= 15
                                 || std::abs(inkOfOne[2] - other[2]) >= 2;
                EXPECT_TRUE(differ)
                    << "theme " << static_cast<int>(name) << ": " << terratact::name(one) << " ("
                    << inkOfOne[0] << " pieces, " << inkOfOne[1] << " %, " << inkOfOne[2]
                    << " px) and " << terratact::name(kProvenances[b]) << " (" << other[0] << ", "
                    << other[1] << " %, " << other[2] << " px)";
            }
        }
        EXPECT_EQ(words.size(), kProvenances.size());
        EXPECT_EQ(letters.size(), kProvenances.size());
        EXPECT_EQ(shapes.size(), kProvenances.size());
    }
    applyLook(*qApp);
}

}  // namespace
}  // namespace terratact
