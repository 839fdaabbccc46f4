// Tests files of the strip of felt ground: what a reader gets back of them, and what is refused.
#include "app/figures/report/strip_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "app/figures/report/strip_figure.h"
#include "app/recording/export/strip_export.h"
#include "core/store/file_read.h"
#include "tests/support/felt_strip.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

constexpr double kPixels = (1200.0 - 90.0) / kStripPiece;  // [px/m]

struct StripFile : testing::Test {
    TemporaryDirectory directory;
    RobotModel robot = absolem();
    std::shared_ptr<const Strip> strip = std::make_shared<const Strip>(feltStrip());

    std::string file(const std::string& name, std::optional<int> section = {},
                     const std::string& title = "Strip of a test")
    {
        const std::string path = directory.file(name);
        const Status done = writeStrip(path, strip, robot, title, section);
        EXPECT_TRUE(done) << done.error().text;
        return done ? *readFile(path, 1U << 26U) : std::string();
    }
    std::string refusal(const std::string& name, std::optional<int> section = {})
    {
        const std::string path = directory.file(name);
        const Status done = writeStrip(path, strip, robot, "Strip of a test", section);
        EXPECT_FALSE(readFile(path, 1U << 26U)) << "half written";
        return done ? std::string() : done.error().text;
    }
};

/// Returns the heights [px] of the left side's bands, in the order of drawing.
std::vector<double> leftBands(const std::string& svg)
{
    std::vector<double> heights;
    static const std::regex kBand(  // as attributes or as style, by cairo's version
        "fill-opacity(?::|=\")0.25;?\"[^>]* d=\"M ([0-9.]+) ([0-9.]+) L ([0-9.]+) ([0-9.]+) L "
        "([0-9.]+) ([0-9.]+)");
    for (auto at = std::sregex_iterator(svg.begin(), svg.end(), kBand);
         at != std::sregex_iterator(); ++at)
        heights.insert(heights.end(), std::stod((*at)[6].str()) - std::stod((*at)[2].str()));
    return heights;
}

int countOf(const std::string& text, const std::string& part)
{
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

int dashedLines(const std::string& svg)
{
    static const std::regex kDashes("stroke-dasharray(?::|=\")5[ ,]+4");
    return static_cast<int>(std::distance(std::sregex_iterator(svg.begin(), svg.end(), kDashes),
                                          std::sregex_iterator()));
}

TEST_F(StripFile, svgDrawsTheBandsToScale)
{
    const std::vector<double> bands = leftBands(file("one.svg", 1));
    ASSERT_EQ(bands.size(), kBins + 1U) << "the last one is the sample of the legend";
    const TerrainEstimate left = leftStepEstimate().side[0];
    for (std::size_t i = 0; i < kBins; ++i)
        EXPECT_NEAR(bands[i], kPixels * (left.q90[i] - left.q10[i]), 0.02) << "bin " << i;
}

TEST_F(StripFile, svgKeepsEveryNumber)
{
    const std::string svg = file("all.svg");
    EXPECT_NE(svg.find("<metadata>\n" + stripCsv(*strip, robot) + "</metadata>"),
              std::string::npos);
    EXPECT_NE(svg.find("<title>Strip of a test</title>"), std::string::npos);
    EXPECT_NE(svg.find("<desc>Ground of section 1 from -0.3 to 0.7 m along the way. Ground of "
                       "section 2"),
              std::string::npos);
    EXPECT_EQ(countOf(file("second.svg", 2), "\n2,turned,"), 2 * kBins);
    EXPECT_EQ(countOf(file("again.svg", 2), "\n1,first,"), 0);
}

TEST_F(StripFile, sidesDifferWithoutColour)
{
    const std::string svg = file("one.svg", 1);
    EXPECT_EQ(dashedLines(svg), kBins) << "the right side's line, and the legend's";
    EXPECT_EQ(leftBands(svg).size(), kBins + 1U) << "only left bands are filled";
}

TEST_F(StripFile, hostileTitleStaysText)
{
    const std::string svg = file("named.svg", {}, "<script>\n&\x1b[31m\"'</title>");
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    EXPECT_EQ(countOf(svg, "</title>"), 1);
    EXPECT_EQ(svg.find('\x1b'), std::string::npos);
}

TEST_F(StripFile, pngHasThePicturesSize)
{
    double height = 0.0;
    for (const DocumentPicture& piece : stripPictures(strip)) height += piece.height;
    const std::string png = file("strip.png");
    ASSERT_GT(png.size(), 24U);
    const auto number = [&](std::size_t at) {
        unsigned value = 0;
        for (std::size_t k = 0; k < 4; ++k)
            value = value * 256U + static_cast<unsigned char>(png[at + k]);
        return value;
    };
    EXPECT_EQ(png.substr(1, 3), "PNG");
    EXPECT_EQ(number(16), 1200U);
    EXPECT_EQ(number(20), static_cast<unsigned>(height));
}

TEST_F(StripFile, otherFormatsAreByTheEnding)
{
    EXPECT_EQ(file("strip.csv"), stripCsv(*strip, robot));
    EXPECT_EQ(file("strip.ply", 2), stripPly(*strip, robot, 2));
    EXPECT_EQ(file("strip.pdf").substr(0, 5), "%PDF-");
    EXPECT_EQ(countOf(file("strip.html"), "<svg"), 2) << "one picture for each section";
}

TEST_F(StripFile, refusalsNameTheFileAndTheReason)
{
    EXPECT_NE(refusal("strip.xyz").find("strip.xyz: the ending"), std::string::npos);
    EXPECT_NE(refusal("strip").find("expected .csv"), std::string::npos);
    for (const int section : {-1, 0, 3})
        EXPECT_NE(refusal("strip.svg", section).find("expected 1 to 2"), std::string::npos);
    strip = std::make_shared<const Strip>(robot);
    for (const char* name : {"strip.svg", "strip.png", "strip.pdf", "strip.csv", "strip.ply"})
        EXPECT_NE(refusal(name).find("no ground was felt"), std::string::npos) << name;
}

TEST_F(StripFile, aStripOfManySectionsIsNotDrawnOnOneSheet)
{
    Strip many(robot);
    Measurement line;
    line.travelled = 0.0;
    line.turned = 0.0;
    for (int k = 0; k < 100; ++k) {
        line.time += 0.1;
        *line.turned += 0.5;
        many.add(line);
        many.beginScene(line);
        many.enter(leftStepEstimate(), k);
    }
    ASSERT_EQ(many.sections().size(), 100U);
    strip = std::make_shared<const Strip>(many);
    EXPECT_NE(refusal("strip.png").find("choose one section, or pages (.pdf)"), std::string::npos);
    EXPECT_FALSE(file("strip.png", 100).empty());
    EXPECT_FALSE(file("strip.pdf").empty());
}

}  // namespace
}  // namespace terratact
