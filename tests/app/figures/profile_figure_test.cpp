#include "app/figures/profile_figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "app/figures/canvas.h"
#include "core/infer/estimate/provenance.h"
#include "tests/support/picture.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

// Colours of the kinds of bins in app/figures/profile_figure.cpp.
constexpr unsigned kContact = 0x1558a6, kArm = 0x6a1b9a, kPrior = 0xb06400, kZone = 0xfff4d2,
                   kTruth = 0xd32f2f;

FigureInput flatGround()
{
    FigureInput input;
    input.title = "Flat ground";
    TerrainEstimate& e = input.estimate;
    e.ending = Ending::Converged;
    for (std::size_t i = 0; i < kBins; ++i) {
        e.height[i] = -0.24;
        e.sd[i] = 0.01;
        e.q10[i] = -0.26;
        e.q90[i] = -0.22;
        e.ceiling[i] = -0.20;
        e.rhat[i] = 1.0;
        e.ess[i] = 1000.0;
    }
    input.outline = {
        {OutlinePart::Kind::Body, {{-0.3, -0.2}, {0.3, -0.2}, {0.3, 0.0}, {-0.3, 0.0}}}};
    return input;
}

/// Returns the picture above its legend.
Picture plotOf(Picture picture)
{
    constexpr std::size_t kRows = 600;
    picture.height = kRows;
    picture.pixels.resize(kRows * static_cast<std::size_t>(picture.width));
    return picture;
}

TEST(ProfileTable, hasChainsOfASampledEstimateOnly)
{
    FigureInput input = flatGround();
    input.estimate.ending = Ending::Converged;
    EXPECT_NE(profileTable(input.estimate, std::nullopt).find("R-hat    ESS\n"), std::string::npos);
    input.estimate.ending = Ending::NotSampled;
    const std::string table = profileTable(input.estimate, input.estimate.height);
    EXPECT_EQ(table.find("R-hat"), std::string::npos);
    const auto line = [&table](int number) {
        std::size_t begin = 0;
        while (number-- > 0) begin = table.find('\n', begin) + 1;
        return table.substr(begin, table.find('\n', begin) - begin).size();
    };
    EXPECT_EQ(line(0), line(1)) << table;
}

class ProfileFigure : public testing::Test {
protected:
    Picture drawn(const FigureInput& input)
    {
        const std::string path = directory_.file("profile.png");
        const Status written = writeProfileFigure(path, input);
        EXPECT_TRUE(written);
        return readPng(path);
    }
    TemporaryDirectory directory_;
};

TEST_F(ProfileFigure, is1200By700WithAWhiteMarginAllAround)
{
    FigureInput input = flatGround();
    input.title = std::string(300, 'W');  // far wider than the picture
    input.estimate.warnings = {Message::verbatim(std::string(300, 'w')),
                               Message::verbatim("another")};
    input.previous = input.estimate;
    input.truth = input.estimate.height;
    input.estimate.origin[6] = Origin::Contact;  // with every entry the legend has two rows
    input.estimate.ceiling[5] = -0.22;
    input.estimate.origin[9] = Origin::Arm;
    input.estimate.ceiling[10] = std::numeric_limits<double>::infinity();
    const Picture picture = drawn(input);
    ASSERT_EQ(picture.width, 1200);
    ASSERT_EQ(picture.height, 700);
    for (int x = 0; x < picture.width; ++x)
        for (const int y : {0, 5, 694, 699})
            ASSERT_EQ(picture.at(x, y), 0xffffffU) << x << ' ' << y;
    for (int y = 0; y < picture.height; ++y)
        for (const int x : {0, 5, 1190, 1199})
            ASSERT_EQ(picture.at(x, y), 0xffffffU) << x << ' ' << y;
}

TEST_F(ProfileFigure, showsEveryKindOfBinInItsOwnColour)
{
    FigureInput input = flatGround();
    const Picture plain = drawn(input);
    input.estimate.origin[6] = Origin::Contact;
    input.estimate.origin[9] = Origin::Arm;
    input.estimate.ceiling[10] = std::numeric_limits<double>::infinity();
    input.truth = input.estimate.height;
    const Picture all = drawn(input);
    for (const unsigned colour : {kContact, kArm, kPrior, kZone}) {
        EXPECT_EQ(plain.count(colour), 0) << std::hex << colour;
        EXPECT_GT(all.count(colour), 30) << std::hex << colour;
    }
    EXPECT_EQ(plain.count(kTruth), 0);
}

TEST_F(ProfileFigure, usesThePatternsOfTheScreenForKindsOfBin)
{
    const auto dashesOf = [](const FigureInput& input) {
        static const std::regex kDashes("stroke-dasharray[:=]\"?([0-9.]+(?:[, ]+[0-9.]+)*)");
        const std::string svg = svgText(kProfileWidth, kProfileHeight,
                                        [&](Canvas& canvas) { drawProfile(canvas, input); });
        std::set<std::string> found;
        for (std::sregex_iterator at(svg.begin(), svg.end(), kDashes), end; at != end; ++at) {
            std::string numbers = (*at)[1].str();
            std::ranges::replace(numbers, ',', ' ');
            std::istringstream in(numbers);
            std::vector<double> dashes;
            for (double dash = 0.0; in >> dash;) dashes.push_back(dash);
            const double least = std::ranges::min(dashes);
            std::string ratios;
            for (const double dash : dashes)
                ratios += std::to_string(std::lround(10.0 * dash / least)) + ' ';
            found.insert(ratios);
        }
        return found;
    };
    FigureInput input = flatGround();
    input.estimate.origin.fill(Origin::Contact);
    const std::set<std::string> solid = dashesOf(input);  // dashes of the ceilings
    input.estimate.origin[4] = Origin::Sampled;
    EXPECT_EQ(dashesOf(input).count("30 10 "), 1U) << "6 and 2 widths";
    EXPECT_EQ(dashesOf(input).size(), solid.size() + 1);
    input.estimate.origin[5] = Origin::Sampled;
    input.estimate.ceiling[5] = -0.215;
    EXPECT_EQ(dashesOf(input).count("30 15 10 15 "), 1U) << "constrained by the body";
    input.estimate.origin[10] = Origin::Sampled;
    input.estimate.ceiling[10] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(dashesOf(input).count("10 10 "), 1U) << "prior only";
    EXPECT_EQ(dashesOf(input).size(), solid.size() + 3);
    for (const Provenance one : kProvenances)
        for (const Provenance other : kProvenances)
            if (one != other) {
                EXPECT_FALSE(barPattern(one).width == barPattern(other).width
                             && barPattern(one).dashes == barPattern(other).dashes)
                    << name(one) << " and " << name(other);
            }
}

TEST_F(ProfileFigure, marksAreFilledAsFarAsBinsWereFelt)
{
    const auto inkOf = [this](Touch touch) {
        FigureInput input = flatGround();
        input.estimate.origin[6] = Origin::Contact;
        input.estimate.q10[6] = input.estimate.q90[6] = input.estimate.height[6];
        input.estimate.touch[6] = touch;
        return plotOf(drawn(input)).count(kContact);
    };
    const auto full = inkOf(Touch::Felt), half = inkOf(Touch::FeltInPart),
               open = inkOf(Touch::Bounded);
    EXPECT_GT(half, open + 30);
    EXPECT_GT(full, half + 30);
    EXPECT_EQ(inkOf(Touch::Remembered), full);
    EXPECT_EQ(inkOf(Touch::NotFelt), open);
    EXPECT_EQ(inkOf(Touch::Unrecorded), full) << "an older recording does not tell";
}

TEST_F(ProfileFigure, hasEqualAxes)
{
    // Two equal square marks, 0.3 m apart in x and in z, span a square of pixels.
    FigureInput input = flatGround();
    for (const auto& [bin, height] : {std::pair(3U, -0.3), std::pair(6U, 0.0)}) {
        input.estimate.origin[bin] = Origin::Contact;
        input.estimate.height[bin] = input.estimate.q10[bin] = input.estimate.q90[bin] = height;
    }
    const auto [left, right, top, bottom] = plotOf(drawn(input)).extent(kContact);
    EXPECT_NEAR(right - left, bottom - top, 2);
    EXPECT_GT(right - left, 200);
}

TEST_F(ProfileFigure, growsWithWhatItShows)
{
    FigureInput input = flatGround();
    input.estimate.origin[10] = Origin::Arm;
    for (const double height : {0.05, 0.5, 3.0}) {
        input.estimate.height[10] = height;
        input.estimate.q10[10] = height - 0.1;
        input.estimate.q90[10] = height + 0.1;
        const auto [left, right, top, bottom] = drawn(input).extent(kArm);
        EXPECT_GE(top, 84) << height;  // inside the frame
        EXPECT_LE(right, 1170) << height;
    }
}

TEST_F(ProfileFigure, leavesRoomForTheProbeAboveATallBar)
{
    FigureInput input = flatGround();
    input.estimate.origin[9] = Origin::Contact;
    input.estimate.q90[9] = 0.6;
    input.proposedBin = 9;
    const auto [left, right, top, bottom] = drawn(input).extent(kContact);
    EXPECT_GT(top, 84 + 45);
}

TEST_F(ProfileFigure, isSvgByEndingAndRefusesUnknownEndings)
{
    const std::string svg = directory_.file("profile.svg");
    ASSERT_TRUE(writeProfileFigure(svg, flatGround()));
    EXPECT_NE(contentOf(svg).find("<svg"), std::string::npos);
    const std::string other = directory_.file("profile.bmp");
    EXPECT_TRUE(refused(writeProfileFigure(other, flatGround()), other, {".png, .svg or .pdf"}));
    const std::string nowhere = directory_.file("none/profile.png");
    EXPECT_TRUE(refused(writeProfileFigure(nowhere, flatGround()), nowhere, {"cannot be written"}));
    EXPECT_EQ(directory_.entries(), std::set<std::string>{"profile.svg"});
}

TEST(ProfileTable, hasARowPerBinWithKindAndError)
{
    FigureInput input = flatGround();
    TerrainEstimate& e = input.estimate;
    e.origin[8] = Origin::Contact;
    e.origin[9] = Origin::Arm;
    e.ceiling[10] = std::numeric_limits<double>::infinity();
    Heights truth = e.height;
    truth[10] = -0.29;
    const std::string table = profileTable(e, truth);
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 13);
    EXPECT_NE(
        table.find(
            "  -0.3  -0.240    10  -0.260 … -0.220    -0.200  sampled      not recorded   1.000   "
            "1000   -0.240     +0\n"),
        std::string::npos)
        << table;
    EXPECT_NE(table.find("  +0.5  -0.240    10  -0.260 … -0.220    -0.200  contact "),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("  +0.6  -0.240    10  -0.260 … -0.220    -0.200  arm "),
              std::string::npos)
        << table;
    EXPECT_NE(
        table.find(
            "  +0.7  -0.240    10  -0.260 … -0.220         -  prior only   not recorded   1.000   "
            "1000   -0.290    +50\n"),
        std::string::npos)
        << table;
    EXPECT_EQ(profileTable(e, std::nullopt).find("truth"), std::string::npos);
}

TEST(ProfileTable, hasRowsOfOneWidthAlsoOfChainsThatAreStuck)
{
    FigureInput input = flatGround();
    input.estimate.rhat[3] = 1e12;
    const std::string text = profileTable(input.estimate, input.estimate.height);
    EXPECT_NE(text.find("  > 100 "), std::string::npos) << text;
    std::istringstream table(text);
    std::string line;
    std::set<std::size_t> widths;
    std::getline(table, line);
    std::getline(table, line);
    while (std::getline(table, line)) widths.insert(line.size());
    EXPECT_EQ(widths.size(), 1U);
}

}  // namespace
}  // namespace terratact
