#include "core/learn/data/profile_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "core/base/text.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct ProfileFileTest : testing::Test {
    Result<ProfileFile> read(const std::string& content, double step = 0.1, bool blocks = false)
    {
        return readProfiles(dir.write("profile.csv", content), step, blocks);
    }
    testing::AssertionResult refuses(const std::string& content,
                                     std::initializer_list<std::string_view> parts)
    {
        return refused(read(content), dir.file("profile.csv"), parts);
    }
    TemporaryDirectory dir;
};

using Points = std::vector<Vec2>;

TEST_F(ProfileFileTest, readsPointsWithAVerticalFace)
{
    const Points expected{{-1.0, 0.0}, {0.5, 0.0}, {0.5, 0.2}, {2.0, 0.25}};
    const std::string points = "-1,0\n0.5,0\n0.5,0.2\n2,0.25\n";
    for (const std::string header : {"", "x,z\n", "x_m,z_m\n"}) {
        const Result<ProfileFile> file = read(header + points);
        ASSERT_TRUE(file) << file.error().text;
        ASSERT_EQ(file->profiles.size(), 1U);
        EXPECT_EQ(file->profiles[0].points(), expected);
    }
}

TEST_F(ProfileFileTest, readsEveryLineOfHeightsAsAProfileOfItsOwnLength)
{
    const Result<ProfileFile> file = read("0,0.1,0.2\n0.000,-0.019,-0.038,-0.060\n", 0.03);
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->profiles.size(), 2U);
    EXPECT_EQ(file->profiles[0].points(),
              TerrainProfile::fromSamples({0.0, 0.1, 0.2}, 0.03, false).points());
    EXPECT_EQ(file->profiles[1].points(),
              TerrainProfile::fromSamples({0.0, -0.019, -0.038, -0.060}, 0.03, false).points());
}

TEST_F(ProfileFileTest, readsHeightsUnderAHeaderAsBlocks)
{
    const Result<ProfileFile> file = read("h_-0.3,h_-0.2,h_-0.1\r\n0,0.2,0\r\n", 0.1, true);
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->profiles.size(), 1U);
    EXPECT_EQ(file->profiles[0].points(),
              TerrainProfile::fromSamples({0.0, 0.2, 0.0}, 0.1, true).points());
    EXPECT_EQ(file->profiles[0].heightAt(0.06), 0.2);
}

TEST_F(ProfileFileTest, pointsSurviveARoundTripThroughText)
{
    std::mt19937_64 rng(5);
    for (int i = 0; i < 100; ++i) {
        Points points{{-3.0, 1.5}};
        while (points.size() < 40) {
            const double dx = rng() % 3 == 0 ? 0.0 : std::uniform_real_distribution(0.0, 0.3)(rng);
            points.push_back(
                {points.back().x + dx, std::uniform_real_distribution(-3.0, 3.0)(rng)});
        }
        std::string text;
        for (const Vec2& p : points) text += numberText(p.x) + "," + numberText(p.z) + "\n";
        const Result<ProfileFile> file = read(text);
        ASSERT_TRUE(file) << file.error().text;
        ASSERT_EQ(file->profiles.at(0).points(), points);
    }
}

TEST_F(ProfileFileTest, refusesPointsThatGoBack)
{
    EXPECT_TRUE(refuses("x,z\n0,0\n0.5,0\n0.4,0\n", {"line 4", "x decreases from 0.5 to 0.4"}));
    EXPECT_TRUE(refuses("0,0\n", {"line 1", "only point"}));
    EXPECT_TRUE(refuses("0,0\n1,0,0\n", {"line 2", "3 fields", "x,z"}));
    EXPECT_TRUE(refuses("0,0\n1\n", {"line 2", "1 fields", "x,z"}));
    EXPECT_TRUE(refuses("z,x\n0,0\n1,0\n", {"line 1", "x,z"}));
    EXPECT_TRUE(refuses("x_mm,z_mm\n0,0\n1,0\n", {"line 1", "x,z"}));
}

TEST_F(ProfileFileTest, refusesLinesOfOtherForms)
{
    EXPECT_TRUE(refuses("0,0,0\n0,0\n", {"line 2", "2 fields", "three heights"}));
    EXPECT_TRUE(refuses("0\n1\n", {"line 1", "1 fields"}));
    EXPECT_TRUE(refuses("a,b,c\n0,0,0\n0,0,0,0\n", {"line 3", "4 fields", "header has 3"}));
    EXPECT_TRUE(refuses("a,b,c\n", {"line 1", "no profile"}));
    EXPECT_TRUE(refuses("1,\"a, b\",2\n", {"line 1", "field 2", "not a number"}));
    EXPECT_TRUE(refuses("height\n0.1\n", {"line 1", "header of one column"}));
}

TEST_F(ProfileFileTest, refusesWhatIsNotAFiniteNumber)
{
    for (const char* bad : {"inf", "-Infinity"}) {
        EXPECT_TRUE(
            refuses("0,0,0\n0," + std::string(bad) + ",0\n", {"line 2", "field 2", "not finite"}));
        EXPECT_TRUE(
            refuses(std::string(bad) + ",0,0\n0,0,0\n", {"line 1", "field 1", "not finite"}));
        EXPECT_TRUE(
            refuses("0,0\n1," + std::string(bad) + "\n", {"line 2", "field 2", "not finite"}));
    }
    EXPECT_TRUE(refuses("0,0,0\n0,,0\n", {"line 2", "field 2", "is empty"}));
    EXPECT_TRUE(refuses("0,0,nan\n", {"line 1", "field 3", "not measured"}));
    for (const char* bad : {"x", "1e999", "0;1"})
        EXPECT_TRUE(refuses("0,0,0\n0," + std::string(bad) + ",0\n",
                            {"line 2", "field 2", "not a number"}));
    EXPECT_TRUE(refuses("a,0,0\n0,0,0\n", {"line 1", "field 1", "not a number"}));
}

TEST_F(ProfileFileTest, refusesOneColumnWithDecimalCommas)
{
    EXPECT_TRUE(refuses("0,00\n0,00\n0,02\n0,05\n", {"x does not advance", "decimal commas"}));
    EXPECT_TRUE(refuses("0,95\n0,98\n1,00\n", {"decimal commas"}));
    EXPECT_TRUE(refuses("0,0\n0,5\n0,3\n1,0\n", {"decimal commas", "x_m,z_m"}));
    EXPECT_TRUE(refuses("height\n0,00\n0,02\n", {"line 1", "header of one column"}));
    EXPECT_TRUE(refuses("0,00,0,02,0,05\n", {"line 1", "decimal commas"}));
    EXPECT_TRUE(refuses("0,0,0,1,0,2\n", {"line 1", "decimal commas"}));
    EXPECT_TRUE(refuses("\"0,00\"\n\"0,02\"\n", {"line 1", "save numbers with a point"}));
    EXPECT_TRUE(read("0,0\n1,0\n2,1\n"));
    EXPECT_TRUE(read("0,0,1,1\n"));
    EXPECT_TRUE(read("x_m,z_m\n0,0\n0,1\n0,2\n1,2\n"));
}

TEST_F(ProfileFileTest, readsPointsAndHeightsAsSpreadsheetsWriteThem)
{
    const Result<ProfileFile> plain = read("0,0\n0.5,0.05\n");
    ASSERT_TRUE(plain);
    for (const char* text : {"x;z\n0,0;0,0\n0,5;0,05\n", "x_m\tz_m\n0\t0\n0,5\t0,05",
                             "\"x\",\"z\"\n\"m\",\"m\"\n0,0\n0.5,0.05\n\n",
                             "# x,z\n0,0\n0.5,0.05\n", "0,0;0,0\n0,5;0,05\n"}) {
        const Result<ProfileFile> file = read(text);
        ASSERT_TRUE(file) << file.error().text;
        EXPECT_EQ(file->profiles.at(0).points(), plain->profiles.at(0).points()) << text;
    }
    EXPECT_EQ(read("0,00;0,02;0,05\n")->profiles.at(0).points(),
              read("0.00,0.02,0.05\n")->profiles.at(0).points());
}

TEST_F(ProfileFileTest, refusesHeightsInMillimetres)
{
    EXPECT_TRUE(read("100,105,95\n"));
    EXPECT_TRUE(refuses("0,0,0\n100,105.1,95\n", {"line 2", "105.1", "5 m", "mm"}));
    EXPECT_TRUE(refuses("0,0\n0.1,0\n0.2,-200\n", {"line 3", "-200", "mm"}));
    EXPECT_TRUE(refuses("0,0\n1200,0\n", {"line 2", "1200", "mm"}));
}

TEST_F(ProfileFileTest, refusesTornAndEmptyFiles)
{
    EXPECT_TRUE(refuses("", {"is empty"}));
    EXPECT_TRUE(refuses("a,b,c\n0,0", {"line 2", "torn"}));
    const std::string none = dir.file("none.csv");
    EXPECT_TRUE(refused(readProfiles(none, 0.1, false), none, {"cannot be opened"}));
}

TEST_F(ProfileFileTest, boundsTheNumbersOfAFile)
{
    std::string line = "0";
    for (int i = 1; i < 100'000; ++i) line += ",0";
    line += "\n";
    std::string content;
    for (int i = 0; i < 20; ++i) content += line;
    EXPECT_TRUE(read(content));
    EXPECT_TRUE(refuses(content + "0,0,0\n", {"line 21", "the 2000000 numbers"}));
}

TEST_F(ProfileFileTest, throwsForAnInvalidStep)
{
    for (const double step : {0.0, -0.1, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_THROW(static_cast<void>(read("0,0,0\n", step)), std::invalid_argument) << step;
}

TEST_F(ProfileFileTest, refusesPointColumnsAmongHeights)
{
    EXPECT_TRUE(refuses("x,y,z\n0,0,0\n5,0,0\n", {"line 1", "3 columns", "x_m,z_m"}));
    EXPECT_TRUE(refuses("x_m,z_m,sd_m\n0,0,0\n5,0,0\n", {"line 1", "3 columns"}));
    EXPECT_TRUE(read("x_m,z_m,\n0,0,\n5,0,\n"));
    EXPECT_TRUE(read("a,b,c\n0,0,0\n"));
}

}  // namespace
}  // namespace terratact
