#include "app/recording/export/strip_export.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/strip/strip_points.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/felt_strip.h"

namespace terratact {
namespace {

struct StripExport : testing::Test {
    RobotModel robot = absolem();
    Strip strip = feltStrip(robot);

    static std::vector<std::string> lines(const std::string& text)
    {
        std::vector<std::string> all;
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);) all.push_back(line);
        return all;
    }
};

TEST_F(StripExport, csvNamesEverySectionSideAndTouch)
{
    const auto csv = lines(stripCsv(strip, robot));
    ASSERT_EQ(csv.size(), 1U + 2 * 2 * kBins);
    EXPECT_EQ(csv[1],
              "1,first,left,0,-0.3,-0.3000,0.1985,-0.2500,0.0100,-0.2628,-0.2372,0.0000,track,"
              "0.100,7");
    EXPECT_NE(csv[2].find(",right,0,-0.3,-0.3000,-0.1985,"), std::string::npos) << csv[2];
    EXPECT_NE(csv.back().find("2,turned,right,0,0.7,0.7000,-0.2720,"), std::string::npos)
        << "on the flippers' line, in a frame of its own: " << csv.back();
    EXPECT_NE(csv.back().find(",not felt,"), std::string::npos);
}

TEST_F(StripExport, plyHasAVertexForEachBin)
{
    const auto ply = lines(stripPly(strip, robot));
    EXPECT_EQ(ply[0], "ply");
    EXPECT_EQ(ply[4], "element vertex 44");
    ASSERT_EQ(ply.size(), 14U + 44U);
    EXPECT_EQ(ply[14], "-0.3000 0.1985 -0.2500 0.0100 0.100 0 2 1");
    const auto second = lines(stripPly(strip, robot, 2));
    EXPECT_EQ(second[4], "element vertex 22");
    EXPECT_EQ(second[14].back(), '2');
    EXPECT_THROW(stripPly(strip, robot, 3), std::invalid_argument);
}

TEST_F(StripExport, plyLaysSectionsApart)
{
    const auto ply = lines(stripPly(strip, robot));
    EXPECT_NE(ply[3].find("sections are laid 1 m apart along x"), std::string::npos) << ply[3];
    constexpr std::size_t kFirst = 14, kOfSection = 2 * kBins;
    double end = -1e9, begin = 1e9;
    for (std::size_t k = 0; k < kOfSection; ++k) {
        end = std::max(end, std::stod(ply.at(kFirst + k)));
        begin = std::min(begin, std::stod(ply.at(kFirst + kOfSection + k)));
    }
    EXPECT_NEAR(begin - end, kSectionGap, 1e-4);
    EXPECT_EQ(lines(stripPly(strip, robot, 2)).at(kFirst).substr(0, 8), "-0.3000 ")
        << "one section alone keeps its frame";
}

TEST(LedgerText, namesTheTouches)
{
    StripLedger ledger;
    EXPECT_EQ(ledgerText(ledger), "");
    ledger.add(ScoredBy::Contact, {0.0, 0.01, -0.013, 0.013}, 0.0, 0.0);
    ledger.add(ScoredBy::Contact, {0.0, 0.01, -0.013, 0.013}, 0.1, 0.0);
    ledger.add(ScoredBy::Pass, {0.0, 0.01, -0.013, 0.013}, 0.0, 0.0);
    EXPECT_EQ(ledgerText(ledger), "80 % bands held at later contacts: 1 of 2, passes: 1 of 1");
}

TEST(StripPoints, followACurve)
{
    const RobotModel robot = absolem();
    Strip strip(robot, {.corrects = false});
    Measurement line;
    line.travelled = 0.0;
    line.turned = 0.0;
    strip.add(line);
    strip.beginScene(line);
    strip.enter(leftStepEstimate(), 1);
    constexpr double kRadius = 4.0;
    for (int k = 0; k < 100; ++k) {  // 1 m to the left
        *line.travelled += 0.01;
        *line.turned += 0.01 / kRadius;
        strip.add(line);
    }
    strip.beginScene(line);
    strip.enter(leftStepEstimate(), 2);
    const StripPoint last = pointsOf(strip, robot).back();
    const double turned = 1.0 / kRadius;
    const double ahead = robot.imu.x + last.along - 1.0;  // of the middle of the tracks
    EXPECT_NEAR(last.x,
                kRadius * std::sin(turned) + ahead * std::cos(turned)
                    + robot.lateral.flipperY * std::sin(turned) - robot.imu.x,
                2e-3);
    EXPECT_NEAR(last.y,
                kRadius * (1.0 - std::cos(turned)) + ahead * std::sin(turned)
                    - robot.lateral.flipperY * std::cos(turned),
                2e-3);
}

}  // namespace
}  // namespace terratact
