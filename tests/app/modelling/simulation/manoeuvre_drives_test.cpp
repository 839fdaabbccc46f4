// Tests scripted drives that turn, reverse and probe.
#include "app/modelling/simulation/manoeuvre_drives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/robot/robot_model.h"

namespace terratact {
namespace {

std::vector<ManoeuvreLine> drivenBy(Manoeuvre manoeuvre, std::uint64_t seed = 3)
{
    static const RobotModel robot =
        *readRobotModel(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
    std::mt19937_64 rng(seed);
    return driveManoeuvre(robot, kHazardGrounds[0], std::nullopt, manoeuvre, rng);
}

/// Returns the largest change of the heading and the largest way back between two lines.
std::pair<double, double> changesOf(const std::vector<ManoeuvreLine>& lines)
{
    double turn = 0.0, back = 0.0;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        const Measurement& from = lines[k - 1].driven.line;
        const Measurement& to = lines[k].driven.line;
        turn = std::max(turn, std::abs(*to.turned - *from.turned));
        back = std::max(back, *from.travelled - *to.travelled);
    }
    return {turn, back};
}

TEST(ManoeuvreDrives, eachDoesWhatItIsNamedFor)
{
    EXPECT_GT(changesOf(drivenBy(Manoeuvre::Turn)).first, 0.02);
    EXPECT_LT(changesOf(drivenBy(Manoeuvre::Reverse)).first, 0.02);
    EXPECT_GT(changesOf(drivenBy(Manoeuvre::Reverse)).second, 0.02);
    EXPECT_EQ(changesOf(drivenBy(Manoeuvre::Curve)).second, 0.0);
    const auto curve = drivenBy(Manoeuvre::Curve);
    const auto headings = std::ranges::minmax_element(
        curve, {}, [](const ManoeuvreLine& line) { return *line.driven.line.turned; });
    EXPECT_GT(*headings.max->driven.line.turned - *headings.min->driven.line.turned, 0.1);
    const auto probes = [](const std::vector<ManoeuvreLine>& lines) {
        return std::ranges::count_if(lines,
                                     [](const ManoeuvreLine& line) { return !line.arm.empty(); });
    };
    EXPECT_GT(probes(drivenBy(Manoeuvre::Probe)), 3);
    EXPECT_EQ(probes(curve), 0);
}

TEST(ManoeuvreDrives, levelGroundIsTrueEverywhere)
{
    const auto lines = drivenBy(Manoeuvre::Mixed);
    std::size_t scenes = 0;
    for (const ManoeuvreLine& line : lines) {
        if (!line.driven.isScene) continue;
        ++scenes;
        for (const OptionalHeights& side : line.driven.truth)
            for (std::size_t i = 1; i < kBins; ++i)
                EXPECT_NEAR(side[i].value(), side[0].value(), 1e-9);
        for (const ArmReading& reading : line.arm)
            EXPECT_NEAR(reading.height, *line.driven.truth[0][0], 0.05);
    }
    EXPECT_GT(scenes, 10U);
}

TEST(ManoeuvreDrives, areEqualForOneSeed)
{
    const auto first = drivenBy(Manoeuvre::Mixed, 5), again = drivenBy(Manoeuvre::Mixed, 5);
    ASSERT_EQ(first.size(), again.size());
    for (std::size_t k = 0; k < first.size(); ++k) {
        EXPECT_EQ(first[k].driven, again[k].driven);
        EXPECT_EQ(first[k].arm, again[k].arm);
    }
    EXPECT_NE(drivenBy(Manoeuvre::Mixed, 6).front().driven, first.front().driven);
}

}  // namespace
}  // namespace terratact
