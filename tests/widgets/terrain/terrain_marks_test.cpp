// Tests the marks of a bin: symbol, bar and letter of its provenance.
#include "widgets/terrain/terrain_profile_view.h"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/support/benches/terrain_bench.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/contact_marks.h"
#include "widgets/terrain/provenance_marks.h"
#include "widgets/terrain/provenance_text.h"

namespace terratact {
namespace {

using gui::painted;

/// Returns an estimate with bins 3 to 7 in the order of kProvenances, each with a band of 0.3 m.
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

/// Returns for the upper half of a bin's bar: number of ink pieces, their total length [% of the bar], width [px].
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

/// Returns the number of pixels around x, in the strip below `top`, that differ from the card.
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

TEST_F(TerrainView, contactsAreRingsWithOneWord)
{
    const auto ringsOf = [this] { return gui::pixelsOf(painted(view), theme().felt.area); };
    view.setContacts({});
    const int before = ringsOf();
    const ContactPoint left{{0.45, -0.1}, "L5"}, right{{0.45, -0.1}, "R5"};
    view.setContacts({left, right, {{std::nan(""), 0.0}, "L6"}});
    const ContactMarks* marks = nullptr;
    for (const QwtPlotItem* item : view.itemList())
        if (const auto* found = dynamic_cast<const ContactMarks*>(item)) marks = found;
    ASSERT_TRUE(marks);
    EXPECT_EQ(marks->words(), "CONTACT L5 R5") << "a place that cannot be drawn has no word";
    EXPECT_GT(ringsOf(), before + 100);
    const QImage image = painted(*view.canvas());
    const QPoint at = view.pixelOf(0.45, -0.1).toPoint();
    EXPECT_EQ(image.pixelColor(at), theme().felt.text) << "the dot";
    view.setContacts({});
    EXPECT_EQ(marks->words(), "");
    EXPECT_EQ(ringsOf(), before) << "nothing stays";
}

TEST_F(TerrainView, aLetterMarksTheOriginOfEveryBin)
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
    // A square fills its corner; a circle or triangle of that size leaves its upper left corner empty.
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

TEST_F(TerrainView, marksAreFilledAsFarAsBinsWereFelt)
{
    TerrainEstimate e = probedEstimate();
    e.q10 = e.q90 = e.height;  // no bars in the way
    constexpr int kBin = 8;    // a square
    const auto inkIn = [&](Touch touch, double below) {
        e.touch[kBin] = touch;
        view.setEstimate(e);
        const QPointF centre = view.pixelOf(binCentre(kBin), e.height[kBin]);
        return alike(painted(*view.canvas()).pixelColor((centre + QPointF(-3.0, below)).toPoint()),
                     theme().contact);
    };
    const std::tuple<Touch, bool, bool> expected[]{
        {Touch::Felt, true, true},        {Touch::Remembered, true, true},
        {Touch::FeltInPart, false, true}, {Touch::Bounded, false, false},
        {Touch::NotFelt, false, false},   {Touch::Unrecorded, true, true},
    };
    for (const auto& [touch, upper, lower] : expected) {
        EXPECT_EQ(inkIn(touch, -3.0), upper) << name(touch);
        EXPECT_EQ(inkIn(touch, 3.0), lower) << name(touch);
    }
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
