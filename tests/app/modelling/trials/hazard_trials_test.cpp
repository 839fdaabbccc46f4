#include "app/modelling/trials/hazard_trials.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

HazardLine lineOf(const char* ground, const char* hazard, PressStyle style, std::size_t clear)
{
    HazardLine line{ground, hazard, style, 0.05, {}};
    line.counts.scenes = 200;
    line.counts.contradicting = 3;
    line.counts.withStep = 100;
    line.counts.falseClear = 1;
    line.counts.flat = 80;
    line.counts.flatClear = clear;
    line.counts.pressed = 40;
    line.counts.pressedClear = clear;
    return line;
}

/// The row that begins with `what`, behind `section`.
std::string rowOf(const std::string& table, const std::string& section, const std::string& what)
{
    const std::size_t at = table.find("\n" + what + " ", table.find(section));
    return at == std::string::npos ? "" : table.substr(at + 1, table.find('\n', at + 1) - at - 1);
}

TEST(HazardTrials, totalsSeparatePressStylesAndGrounds)
{
    const std::vector<HazardLine> lines{lineOf("level", "none", PressStyle::Random, 20),
                                        lineOf("level", "drop", PressStyle::Random, 10),
                                        lineOf("soft", "drop", PressStyle::Random, 0),
                                        lineOf("level", "none", PressStyle::Console, 40)};
    const std::string table = hazardTable(lines, 0.05);
    EXPECT_EQ(rowOf(table, "random press, totals", "level, none"),
              "level, none                       200    100       0      0      1   10.00     80   "
              "  25     "
              "40     50    0.0    0.0      3");
    EXPECT_EQ(rowOf(table, "random press, totals", "level"),
              "level                             400    200       0      0      2   10.00    160   "
              "  19     "
              "80     38    0.0    0.0      6");
    EXPECT_EQ(rowOf(table, "random press, totals", "all"),
              "all                               600    300       0      0      3   10.00    240   "
              "  12    "
              "120     25    0.0    0.0      9");
    EXPECT_EQ(rowOf(table, "press of the console, totals", "all"),
              "all                               200    100       0      0      1   10.00     80   "
              "  50     "
              "40    100    0.0    0.0      3");
}

}  // namespace
}  // namespace terratact
