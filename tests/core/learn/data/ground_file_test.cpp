#include "core/learn/data/ground_file.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/learn/data/profile_file.h"
#include "tests/support/real_ground.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct GroundFileTest : testing::Test {
    Result<GroundFile> read(const std::string& content, double step = 0.1, bool blocks = false)
    {
        return readGrounds(dir.write("ground.csv", content), step, blocks);
    }
    testing::AssertionResult refuses(const std::string& content,
                                     std::initializer_list<std::string_view> parts)
    {
        return refused(read(content), dir.file("ground.csv"), parts);
    }
    TemporaryDirectory dir;
};

using Heights = std::vector<double>;

std::vector<Vec2> pointsOf(const Heights& heights, double step, bool blocks = false)
{
    return TerrainProfile::fromSamples(heights, step, blocks).points();
}

TEST_F(GroundFileTest, readsLinesAtSeveralY)
{
    const auto file = read("source,y_m,step_m,heights_m\n"
                           "a map,0.2,0.03,0,0.01,0.02,0.03\n"
                           "a map,-0.2,0.05,0.1,0.2\n");
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->grounds.size(), 1U);
    const GroundLines& ground = file->grounds[0];
    ASSERT_EQ(ground.lines().size(), 2U);
    EXPECT_EQ(ground.under(0.272).points(), pointsOf({0, 0.01, 0.02, 0.03}, 0.03));
    EXPECT_EQ(ground.under(-0.1985).points(), pointsOf({0.1, 0.2}, 0.05));
}

TEST_F(GroundFileTest, readsSeveralGroundsByTheirPair)
{
    const auto file =
        read("pair;y_m;heights_m\r\n1;0,2;0;0,1;;\r\n1;-0,2;0;0,2\r\nb;0;0;0,3\r\n", 0.2, true);
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->grounds.size(), 2U);
    EXPECT_EQ(file->grounds[0].under(0.2).points(), pointsOf({0, 0.1}, 0.2, true));
    EXPECT_EQ(file->grounds[0].under(-0.2).points(), pointsOf({0, 0.2}, 0.2, true));
    EXPECT_TRUE(file->grounds[1].isOnePlane());
}

TEST_F(GroundFileTest, skipsRemarksUnitsAndEmptyRecords)
{
    const auto file = read("pair,y_m,heights_m\n-,[m],m\n#1, a remark\n1,0.2,0,0.1\n,,,\n"
                           "#2,0.2,0,0.3\n");
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->grounds.size(), 2U);  // '#2' is a name
    EXPECT_EQ(file->grounds[0].under(0.2).points(), pointsOf({0, 0.1}, 0.1));
    EXPECT_TRUE(refuses("y_m,heights_m\nmm,mm\n", {"line 2", "y_m is not a number: 'mm'"}));
}

TEST_F(GroundFileTest, namesTheLineOfASecondTable)
{
    EXPECT_TRUE(refuses("y_m,heights_m\n0.2,0,0.1\ny_m,heights_m\n0.3,0,0.1\n",
                        {"line 3: repeats the header: a second table begins here"}));
}

TEST_F(GroundFileTest, readsTheFormsOfAPlaneAsEqualLines)
{
    for (const std::string text : {"x_m,z_m\n0,0\n1,0\n1,0.2\n3,0.2\n", "0,0.1,0.2\n0,0,0,0.1\n",
                                   "h_0,h_1,h_2\n0,0.1,0.2\n"}) {
        const auto file = read(text);
        const auto plane = readProfiles(dir.file("ground.csv"), 0.1, false);
        ASSERT_TRUE(file && plane) << file.error().text;
        ASSERT_EQ(file->grounds.size(), plane->profiles.size());
        for (std::size_t i = 0; i < plane->profiles.size(); ++i) {
            EXPECT_TRUE(file->grounds[i].isOnePlane());
            EXPECT_EQ(file->grounds[i].under(0.2).points(), plane->profiles[i].points());
        }
    }
    EXPECT_TRUE(refuses("x_m,z_m\n0,0\n-1,0\n", {"line 3", "x decreases"}));
}

TEST_F(GroundFileTest, refusesLinesThatCannotBe)
{
    const std::string head = "pair,y_m,heights_m\n";
    EXPECT_TRUE(refuses("pair,y_m\n1,0.2\n", {"line 1", "without heights_m as its last column"}));
    EXPECT_TRUE(refuses("y_m,y_m,heights_m\n", {"line 1", "has the column y_m twice"}));
    EXPECT_TRUE(refuses(head, {"no line follows it"}));
    EXPECT_TRUE(refuses(head + "1,0.2\n", {"line 2", "has no heights", "from field 3 on"}));
    EXPECT_TRUE(refuses(head + "1,0.2,0.5\n", {"line 2", "fewer than the two heights"}));
    EXPECT_TRUE(refuses(head + "1,0.2,0,nan,0\n", {"line 2", "field 4"}));
    EXPECT_TRUE(refuses(head + "1,0.2,0,6\n", {"line 2", "more than 5 m", "in mm?"}));
    EXPECT_TRUE(refuses(head + "1,0.2,0,1\n1,-0.2,-20,-20\n", {"line 3", "more than 5 m"}));
    EXPECT_TRUE(refuses(head + "1,0.2,1e7,1e7\n", {"line 2", "more than 1000 km from 0"}));
    EXPECT_TRUE(refuses(head + "1,left,0,1\n", {"line 2", "y_m"}));
    EXPECT_TRUE(refuses(head + "1,198.5,0,1\n", {"line 2", "y_m is 198.5", "-2 to 2"}));
    EXPECT_TRUE(refuses(head + "1,0.2,0,1\n1,0.2,0,1\n", {"line 3", "y_m is 0.2 again"}));
    std::string many = head;
    for (int i = 0; i < 65; ++i) many += "1," + std::to_string(i * 0.01) + ",0,1\n";
    EXPECT_TRUE(refuses(many, {"line 66", "one line more than the 64"}));
    EXPECT_TRUE(refuses(head + "1,0.2,0,1\n2,0.2,0,1\n1,-0.2,0,1\n",
                        {"line 4", "is of pair '1'", "do not stand together"}));
    EXPECT_TRUE(refuses(head + "1,0.2,0,1,nan\n", {"line 2", "field 5 is not measured"}));
    EXPECT_TRUE(refuses("heights_m,y_m,heights_m\n", {"line 1", "the column heights_m twice"}));
    EXPECT_TRUE(refuses("step_m,y_m,heights_m\n0,0.2,0,1\n", {"step_m is 0", "0.001 to 10"}));
    EXPECT_THROW((void)read(head, 0.0), std::invalid_argument);
}

TEST_F(GroundFileTest, isNamedWhereOnePlaneIsExpected)
{
    const std::string path = dir.write("ground.csv", "y_m,heights_m\n0.2,0,0\n");
    EXPECT_TRUE(
        refused(readProfiles(path, 0.1, false), path, {"line 1", "column y_m", "one plane"}));
}

TEST(RealGround, isReadWithFourLinesForEachPair)
{
    const auto path = realGround("track_pairs.csv");
    if (!path) GTEST_SKIP() << "TERRATACT_TERRAIN names no folder";
    const auto file = readGrounds(*path, 0.1, false);
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->grounds.size(), 480U);
    for (const GroundLines& ground : file->grounds) EXPECT_EQ(ground.lines().size(), 4U);
}

}  // namespace
}  // namespace terratact
