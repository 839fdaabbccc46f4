#include "widgets/terrain/terrain_profile_view.h"

#include <gtest/gtest.h>
#include <qwt_plot_textlabel.h>
#include <qwt_text.h>

#include <vector>

#include "tests/support/benches/terrain_bench.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/terrain_items.h"

namespace terratact {
namespace {

using gui::painted;

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

TEST_F(TerrainView, aCornerNeverCoversBinsOrNotes)
{
    struct Corner : QWidget {
        QSize sizeHint() const override { return {120, 70}; }
        QSize minimumSizeHint() const override { return {90, 70}; }
    };
    auto* const corner = new Corner;
    view.setCorner(corner);
    view.setEstimate(stepEstimate());
    view.resize(900, 480);
    QApplication::processEvents();
    EXPECT_TRUE(corner->isVisible());
    const double bins = view.canvas()->x() + view.pixelOf(binBegin(0), 0.0).x();
    EXPECT_LT(corner->geometry().right(), bins);
    EXPECT_TRUE(view.canvas()->geometry().contains(corner->geometry()));
    view.clearEstimate(QString(120, u'x'));
    EXPECT_FALSE(corner->isVisible()) << "the note needs the room";
    view.setEstimate(stepEstimate());
    EXPECT_TRUE(corner->isVisible());
    view.resize(340, 480);
    QApplication::processEvents();
    EXPECT_TRUE(corner->isVisible()) << "above the robot, where nothing is drawn";
    EXPECT_EQ(corner->size(), corner->minimumSizeHint());
    TerrainEstimate high = stepEstimate();
    high.height[0] = high.q90[0] = 0.9;
    view.resize(340, 300);
    view.setEstimate(high);
    QApplication::processEvents();
    EXPECT_FALSE(corner->isVisible()) << "a height is drawn there";
    view.setEstimate(stepEstimate());
    view.resize(340, 140);
    QApplication::processEvents();
    EXPECT_FALSE(corner->isVisible()) << "there is no room";
}

TEST_F(TerrainView, staleDrawingIsMutedAndShowsItsAge)
{
    view.setOutline(square(-0.3, -0.1, 0.3, 0.1));
    view.setTruth(Heights{});
    view.setEstimate(stepEstimate());
    const QImage live = painted(*view.canvas());
    view.setStale(1.2);
    const QImage stale = painted(*view.canvas());
    // Returns the contrast of a spot against the card.
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

TEST_F(TerrainView, aNoteLiesBelowTheZonesWords)
{
    view.setEstimate(stepEstimate());
    const auto strip = [&](int from,
                           int to) {  // rows from `from` to `to` [px] below the upper edge
        return painted(*view.canvas()).copy(0, from, view.canvas()->width(), to - from);
    };
    const int words = 5 + scaled(20);
    const QImage zones = strip(0, words), below = strip(words, words + scaled(40));
    view.setEstimate(stepEstimate(), QString(120, QLatin1Char('n')));
    EXPECT_EQ(strip(0, words), zones);
    EXPECT_NE(strip(words, words + scaled(40)), below);
    EXPECT_TRUE(view.accessibleDescription().startsWith("nnnn"));
}

template <class Item>
const Item* itemOf(const TerrainProfileView& view)
{
    for (QwtPlotItem* each : view.itemList())
        if (const auto* found = dynamic_cast<const Item*>(each)) return found;
    return nullptr;
}

/// Returns an estimate that is felt to a bin, bounded in the next two, then not felt.
TerrainEstimate feltTo(int felt)
{
    TerrainEstimate ramp = stepEstimate();
    for (int bin = 0; bin < kBins; ++bin)
        ramp.touch[static_cast<std::size_t>(bin)] = bin <= felt     ? Touch::Felt
                                                  : bin <= felt + 2 ? Touch::Bounded
                                                                    : Touch::NotFelt;
    return ramp;
}

TEST_F(TerrainView, theArmsWordAvoidsTheZonesWords)
{
    const auto* const zones = itemOf<BinZones>(view);
    const auto* const arm = itemOf<ArmMark>(view);
    ASSERT_TRUE(zones && arm);
    for (const QSize size : {QSize(900, 480), QSize(620, 300), QSize(480, 260)}) {
        view.resize(size);
        for (int felt = 7; felt < kBins; ++felt) {
            view.setEstimate(feltTo(felt));
            for (const auto state : {ArmTip::State::Proposed, ArmTip::State::Touched})
                for (int bin = kFirstAhead; bin < kBins; ++bin) {
                    view.setArmTip(ArmTip{.state = state, .bin = bin, .height = 0.1});
                    ASSERT_FALSE(painted(*view.canvas()).isNull());
                    ASSERT_FALSE(zones->words().empty());
                    for (const QRectF& word : zones->words()) {
                        EXPECT_FALSE(word.intersects(arm->word()))
                            << size.width() << " px, felt to bin " << felt << ", arm at " << bin;
                        EXPECT_FALSE(word.contains(view.pixelOf(0.0, 0.0)))
                            << size.width() << " px, felt to bin " << felt << ": over the IMU";
                    }
                    EXPECT_TRUE(QRectF(view.canvas()->rect()).contains(arm->word()));
                }
        }
    }
}

TEST_F(TerrainView, theArmAvoidsTheZonesTextAtEveryFontSize)
{
    const auto* const zones = itemOf<BinZones>(view);
    const auto* const arm = itemOf<ArmMark>(view);
    ASSERT_TRUE(zones && arm);
    for (const auto& [letters, size] :
         {std::pair(100, QSize(900, 480)), std::pair(150, QSize(900, 480)),
          std::pair(200, QSize(760, 420)), std::pair(200, QSize(1200, 700))}) {
        applyLook(*qApp, ThemeName::Day, letters);
        view.resize(size);
        for (int felt = 7; felt < kBins; ++felt) {
            view.setEstimate(feltTo(felt));
            for (const auto state : {ArmTip::State::Proposed, ArmTip::State::Touched})
                for (int bin = kFirstAhead; bin < kBins; ++bin) {
                    view.setArmTip(ArmTip{.state = state, .bin = bin, .height = 0.1});
                    ASSERT_FALSE(painted(*view.canvas()).isNull());
                    ASSERT_FALSE(zones->words().empty());
                    for (const QRectF& word : zones->words()) {
                        EXPECT_FALSE(word.intersects(arm->tip()))
                            << letters << " %, " << size.width() << " px, felt to bin " << felt
                            << ", arm at " << bin;
                    }
                }
        }
    }
    applyLook(*qApp);
}

TEST_F(TerrainView, aBinWithTwoHeightsShowsBoth)
{
    const auto marked = [&](double z) { return alike(colourAt(view, 0.63, z), theme().warning); };
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
    view.setSecond(equalSides(second), "pafc");
    EXPECT_TRUE(alike(colourAt(view, 0.118, -0.35), theme().card));  // an open circle
    view.setSecond(std::nullopt, {});
    EXPECT_EQ(painted(*view.canvas()), plain);
}

TEST_F(TerrainView, notesOfANarrowPictureDoNotOverlap)
{
    view.resize(480, 440);
    view.clearEstimate("The robot has moved since the last scene: explore again (A)");
    view.setRemembered(remembered());
    gui::settle(view);
    std::vector<QRectF> places;
    for (const QwtPlotItem* item : view.itemList(QwtPlotItem::Rtti_PlotTextLabel)) {
        const auto& label = static_cast<const QwtPlotTextLabel&>(*item);
        if (!label.isVisible() || label.text().isEmpty()) continue;
        const int margin = label.margin();
        const QRectF room =
            QRectF(view.canvas()->contentsRect()).adjusted(margin, margin, -margin, -margin);
        const double height = label.text().heightForWidth(room.width(), view.font());
        places.emplace_back(room.left(), room.top(), room.width(), height);
    }
    ASSERT_EQ(places.size(), 2U);
    EXPECT_FALSE(places[0].intersects(places[1])) << places[0].bottom() << " " << places[1].top();
}

/// Ground remembered over 5 m.
struct LongStrip : TerrainView {
    LongStrip()
    {
        SeenStrip strip;
        for (int k = -50; k <= 5; ++k)
            strip.side[0].push_back({.x = 0.1 * k,
                                     .band = {-0.25, 0.01, -0.27, -0.23},
                                     .felt = FeltBy::Track,
                                     .time = 0.0,
                                     .way = 0.1});
        view.clearEstimate("moved");
        view.setRemembered(strip);
        QCoreApplication::processEvents();  // the legend gets its line
    }
    double left() { return view.pointAt({0.0, 0.0}).x(); }
};

TEST_F(LongStrip, keysZoomOutToItsBeginAndBack)
{
    const double before = left();
    EXPECT_GT(before, -1.5);
    for (int k = 0; k < 20; ++k) QTest::keyClick(&view, Qt::Key_Minus);
    EXPECT_LT(left(), -5.2);
    EXPECT_GT(left(), -9.0) << "no farther than the strip";
    EXPECT_NEAR(view.pixelOf(1.0, 0.0).x() - view.pixelOf(0.0, 0.0).x(),
                view.pixelOf(0.0, 0.0).y() - view.pixelOf(0.0, 1.0).y(), 1e-6)
        << "a step looks as steep as it is";
    QTest::keyClick(&view, Qt::Key_0);
    EXPECT_NEAR(left(), before, 1e-9);
}

TEST_F(LongStrip, theWheelKeepsThePlaceUnderThePointer)
{
    view.pan(-2.0);
    const QPointF at = view.pixelOf(-2.2, -0.2);
    QWheelEvent wheel(at, view.canvas()->mapToGlobal(at), {}, {0, -240}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(view.canvas(), &wheel);
    EXPECT_TRUE(view.isZoomed());
    EXPECT_NEAR(view.pointAt(at).x(), -2.2, 0.1);
}

TEST_F(LongStrip, draggingPansWithinTheStripAndADoubleClickResets)
{
    const double before = left();
    const QPoint from = view.pixelOf(0.0, -0.1).toPoint(), to = view.pixelOf(0.5, -0.1).toPoint();
    const auto send = [&](QEvent::Type type, QPoint at) {
        QMouseEvent event(type, at, view.canvas()->mapToGlobal(at), Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(view.canvas(), &event);
    };
    send(QEvent::MouseButtonPress, from);
    send(QEvent::MouseMove, to);
    send(QEvent::MouseButtonRelease, to);
    EXPECT_NEAR(left(), before - 0.5, 0.02);
    for (int k = 0; k < 40; ++k) QTest::keyClick(&view, Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_LT(left(), -5.0);
    EXPECT_GT(left(), -6.0);
    int chosen = 0;
    QObject::connect(&view, &TerrainProfileView::binChosen, &view, [&] { ++chosen; });
    send(QEvent::MouseButtonDblClick, from);
    EXPECT_NEAR(left(), before, 1e-9);
    EXPECT_EQ(chosen, 0) << "that double click only resets";
    send(QEvent::MouseButtonDblClick, from);
    EXPECT_EQ(chosen, 1);
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

TEST_F(TerrainView, describesEachBinAsText)
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

}  // namespace
}  // namespace terratact
