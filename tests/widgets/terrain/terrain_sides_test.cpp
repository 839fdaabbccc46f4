// Tests the picture of two sides.
#include "widgets/terrain/terrain_profile_view.h"

#include <gtest/gtest.h>
#include <qwt_legend.h>
#include <qwt_legend_label.h>

#include "tests/support/benches/terrain_bench.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/provenance_marks.h"
#include "widgets/terrain/side_items.h"
#include "widgets/terrain/terrain_items.h"

namespace terratact {
namespace {

using gui::painted;

struct Sides : TerrainView {
    template <class Item>
    const Item& item() const
    {
        for (QwtPlotItem* each : view.itemList())
            if (const auto* found = dynamic_cast<const Item*>(each)) return *found;
        throw std::logic_error("no such item");
    }
    QStringList legend() const
    {
        QStringList texts;
        for (const QwtLegendLabel* label : view.legend()->findChildren<QwtLegendLabel*>())
            texts << label->text().text();
        return texts;
    }
};

TEST_F(Sides, onePlaneIsDrawnAsBefore)
{
    view.setEstimate(stepEstimate());
    const QImage plain = painted(*view.canvas());
    const QString spoken = view.accessibleDescription();
    view.setFullSide(Side::Left);
    for (const ShownSides sides : {ShownSides::Left, ShownSides::Right, ShownSides::Both}) {
        view.setShownSides(sides);
        EXPECT_EQ(painted(*view.canvas()), plain);
        EXPECT_EQ(view.accessibleDescription(), spoken);
        EXPECT_FALSE(view.sideInFull());
        EXPECT_EQ(view.sideToProbe(), ProbeSide::Middle);
    }
}

TEST_F(Sides, oneSideIsFullAndTheOtherOneBesideIt)
{
    view.setEstimate(leftStepEstimate());
    EXPECT_EQ(view.sideInFull(), Side::Right);
    EXPECT_TRUE(alike(colourAt(view, 0.5, -0.25), theme().contact)) << "the right mark";
    const QColor light = lightened(theme().contact);
    EXPECT_TRUE(alike(colourAt(view, 0.5 - LightSide::kAside, -0.05), light)) << "the left mark";
    view.setFullSide(Side::Left);
    EXPECT_EQ(view.sideInFull(), Side::Left);
    EXPECT_TRUE(alike(colourAt(view, 0.5, -0.05), theme().contact));
    EXPECT_TRUE(alike(colourAt(view, 0.5 + LightSide::kAside, -0.25), light));
}

TEST_F(Sides, linesDifferInStyleAndLetters)
{
    TwoTrackEstimate e = leftStepEstimate();
    for (TerrainEstimate& side : e.side) side.q10 = side.q90 = side.height;
    view.setEstimate(e);
    view.setShownSides(ShownSides::Left);
    EXPECT_TRUE(alike(colourAt(view, -0.15, -0.25), theme().card)) << "a hollow line";
    EXPECT_EQ(item<SideTags>().tags.size(), 1U);
    view.setShownSides(ShownSides::Right);
    EXPECT_TRUE(alike(colourAt(view, -0.15, -0.25), theme().sampled)) << "a solid line";
    view.setShownSides(ShownSides::Both);
    ASSERT_EQ(item<SideTags>().tags.size(), 2U);
    EXPECT_NE(item<SideTags>().tags[0].side, item<SideTags>().tags[1].side);
    EXPECT_TRUE(legend().contains("L: left")) << legend().join(' ').toStdString();
    EXPECT_TRUE(legend().contains("R: right"));
    view.setEstimate(stepEstimate());
    EXPECT_TRUE(item<SideTags>().tags.empty());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_FALSE(legend().contains("L: left"));
}

TEST_F(Sides, aZoneOfOneSideNamesTheSide)
{
    view.setEstimate(leftStepEstimate());
    EXPECT_FALSE(painted(*view.canvas()).isNull());
    const BinZones& zones = item<BinZones>();
    EXPECT_EQ(zones.full.letter, "R");
    EXPECT_TRUE(zones.full.shown[10]);
    ASSERT_TRUE(zones.light);
    EXPECT_FALSE(zones.light->shown[10]);
    const double amberOfOne = colourAt(view, 0.73, -0.37).blueF();
    TwoTrackEstimate both = leftStepEstimate();
    both.side[0].touch[10] = Touch::NotFelt;
    view.setEstimate(both);
    EXPECT_LT(colourAt(view, 0.73, -0.37).blueF(), amberOfOne) << "not felt on both sides";
    view.setShownSides(ShownSides::Left);
    view.setEstimate(leftStepEstimate());
    EXPECT_FALSE(zones.full.shown[10]);
    EXPECT_FALSE(zones.light);
}

TEST_F(Sides, wordsOfZonesDoNotOverlap)
{
    for (const QSize size : {QSize(900, 480), QSize(480, 260)}) {
        view.resize(size);
        for (int from = 6; from < kBins; ++from) {
            TwoTrackEstimate e = leftStepEstimate();
            for (int bin = 6; bin < kBins; ++bin) {
                const auto i = static_cast<std::size_t>(bin);
                e.side[0].touch[i] = bin < from ? Touch::Bounded : Touch::NotFelt;
                e.side[1].touch[i] = bin < from ? Touch::Felt : Touch::Bounded;
            }
            e.side[0].feltTo = 0.36;
            e.side[1].feltTo = 0.52;
            view.setEstimate(e);
            EXPECT_FALSE(painted(*view.canvas()).isNull());
            const std::vector<QRectF>& words = item<BinZones>().words();
            ASSERT_FALSE(words.empty());
            for (std::size_t a = 0; a < words.size(); ++a)
                for (std::size_t b = 0; b < a; ++b)
                    EXPECT_FALSE(words[a].intersects(words[b])) << size.width() << ", " << from;
        }
    }
}

TEST_F(Sides, lettersOfBothSidesHaveARowEach)
{
    view.setEstimate(leftStepEstimate());
    const MarkLetters& letters = item<MarkLetters>();
    EXPECT_EQ(letters.letter, "R");
    EXPECT_EQ(letters.lightLetter, "L");
    EXPECT_TRUE(letters.isLightAbove);
    ASSERT_TRUE(letters.light);
    EXPECT_EQ((*letters.light)[8], Provenance::Contact);
    EXPECT_EQ(MarkLetters::reserved(view.font(), 480.0, 2),
              2.0 * MarkLetters::reserved(view.font(), 480.0));
}

TEST_F(Sides, areDescribedOneAfterTheOther)
{
    view.setEstimate(leftStepEstimate());
    const QStringList lines = view.accessibleDescription().split('\n');
    ASSERT_EQ(lines.size(), 2 * kBins);
    EXPECT_EQ(lines[8],
              QStringLiteral("left, bin 0.5 m: −0.05 m, 80 % in −0.06 … −0.04, contact, felt"));
    EXPECT_EQ(lines[kBins + 10], QStringLiteral("right, bin 0.7 m: not felt"));
    view.setShownSides(ShownSides::Left);
    EXPECT_EQ(view.accessibleDescription().count("right"), 0);
}

TEST_F(Sides, aBinUpCloseHasBothSides)
{
    TwoTrackEstimate e = leftStepEstimate();
    for (int d = 0; d < 100; ++d) {
        e.side[0].draws.push_back(e.side[0].height);
        e.side[1].draws.push_back(e.side[1].height);
    }
    view.setEstimate(e);
    view.inspect(9);
    const BinInspector& inspector = *view.inspector();
    const QString text = inspector.lines().join('|');
    EXPECT_TRUE(text.contains(QStringLiteral("left: height −0.050 m"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("right: height −0.250 m"))) << text.toStdString();
    ASSERT_EQ(inspector.histogram().size(), inspector.rightHistogram().size());
    EXPECT_EQ(inspector.histogram().back(), 100);
    EXPECT_EQ(inspector.rightHistogram().front(), 100);
    EXPECT_FALSE(painted(view).isNull());
    view.setShownSides(ShownSides::Right);
    EXPECT_TRUE(inspector.rightHistogram().empty());
    EXPECT_TRUE(inspector.lines().front().contains("right"));
}

TEST_F(Sides, aChosenBinCarriesTheSideInFull)
{
    view.setEstimate(leftStepEstimate());
    std::vector<ProbePlace> chosen;
    QObject::connect(&view, &TerrainProfileView::binChosen,
                     [&](ProbePlace place) { chosen.push_back(place); });
    view.inspect(9);
    QTest::keyClick(&view, Qt::Key_Return);
    view.setShownSides(ShownSides::Left);
    view.inspect(7);
    QTest::keyClick(&view, Qt::Key_Return);
    view.setEstimate(stepEstimate());
    view.inspect(8);
    QTest::keyClick(&view, Qt::Key_Return);
    const std::vector<ProbePlace> expected{
        {9, ProbeSide::Right}, {7, ProbeSide::Left}, {8, ProbeSide::Middle}};
    EXPECT_EQ(chosen, expected);
}

TEST_F(Sides, hostileNumbersOfASideAreLeftOut)
{
    for (const double bad : gui::kHostile) {
        TwoTrackEstimate e = leftStepEstimate();
        e.side[0].height[4] = e.side[0].height[10] = e.side[0].q90[6] = bad;
        view.setEstimate(e);
        ASSERT_FALSE(painted(view).isNull()) << bad;
        EXPECT_TRUE(alike(colourAt(view, 0.5, -0.25), theme().contact)) << bad;
    }
}

}  // namespace
}  // namespace terratact
