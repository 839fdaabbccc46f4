#include "core/learn/data/probe_file.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct ProbeFileTest : testing::Test {
    Result<std::vector<ProbeReading>> read(const std::string& lines)
    {
        return readProbeReadings(dir.write("probes.csv", "place,height_m,truth_m\n" + lines));
    }
    testing::AssertionResult refuses(const std::string& lines,
                                     std::initializer_list<std::string_view> parts)
    {
        return refused(read(lines), dir.file("probes.csv"), parts);
    }
    TemporaryDirectory dir;
};

TEST_F(ProbeFileTest, readsReadingsWithAndWithoutTruth)
{
    const auto readings =
        read("step,-0.12,-0.10\nstep,-0.08,-0.10\nfloor,-0.31,\nfloor,-0.3,nan\n");
    ASSERT_TRUE(readings) << readings.error().text;
    const std::vector<ProbeReading> expected{{"step", -0.12, -0.10},
                                             {"step", -0.08, -0.10},
                                             {"floor", -0.31, std::nullopt},
                                             {"floor", -0.3, std::nullopt}};
    EXPECT_EQ(*readings, expected);
}

TEST_F(ProbeFileTest, refusesWhatItCannotRead)
{
    EXPECT_TRUE(refuses("", {"no reading"}));
    EXPECT_TRUE(refuses("a,1\n", {"line 2", "2 fields"}));
    EXPECT_TRUE(refuses(",1,\n", {"line 2", "names no place"}));
    EXPECT_TRUE(refuses("a,1,2\na,x,\n", {"line 3", "height_m"}));
    EXPECT_TRUE(refuses("a,nan,1\n", {"line 2", "height_m", "not measured"}));
    EXPECT_TRUE(refuses("-,mm,mm\na,1,1\n", {"line 2", "height_m is 'mm'", "its unit m"}));
    EXPECT_TRUE(refuses("a,-120,\n", {"line 2", "in mm"}));
    const auto other = readProbeReadings(dir.write("other.csv", "x,z\n1,2\n"));
    EXPECT_TRUE(refused(other, dir.file("other.csv"), {"line 1", "place,height_m,truth_m"}));
}

TEST_F(ProbeFileTest, refusesTwoTruthsOfAPlace)
{
    EXPECT_TRUE(refuses("a,0.1,0\nb,0.1,0.1\na,0.2,\na,0.2,0.5\n",
                        {"line 5", "truth_m of place 'a' is 0.5, and 0 in line 2"}));
    EXPECT_TRUE(refuses("a,0.1,0\na,0.1,0.001\n", {"line 3", "in line 2"}));
    EXPECT_TRUE(read("a,0.1,0.1\na,0.2,0.10\na,0.2,0.10000001\n"));
}

TEST_F(ProbeFileTest, boundsTheNumberOfReadings)
{
    std::string lines;
    for (std::size_t i = 0; i < kMaxProbeReadings; ++i) lines += "a,0,\n";
    EXPECT_TRUE(read(lines));
    EXPECT_TRUE(refuses(lines + "a,0,\n", {"line 100002", "one reading more"}));
}

}  // namespace
}  // namespace terratact
