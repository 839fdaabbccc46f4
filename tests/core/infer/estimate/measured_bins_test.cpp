#include "core/infer/estimate/measured_bins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "core/terrain/body_ceiling.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

/// Level, flippers up by 0.3 rad, element 5 alone on the ground.
struct Bench : testing::Test {
    RobotModel robot = absolem();
    Proprioception s;
    Settings settings;
    Heights ceiling{};

    Bench()
    {
        s.front = 0.3;
        s.frontCurrent = s.rearCurrent = 0.0;
        s.force.fill(0.0);
        s.force[4] = 20.0;
        ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);
    }
    MeasuredBins measure(std::span<const ArmReading> arm = {}) const
    {
        return measureBins(robot, s, arm, ceiling, settings);
    }
    int touched() const
    {
        const MeasuredBins measured = measure();
        for (int i = 0; i < kBins; ++i)
            if (measured.bin[static_cast<std::size_t>(i)]) return i;
        return -1;
    }
};

bool warns(const MeasuredBins& measured, std::string_view words)
{
    return std::any_of(
        measured.warnings.begin(), measured.warnings.end(),
        [words](const Message& w) { return w.english().find(words) != std::string::npos; });
}

using MeasuredBinsTest = Bench;

TEST_F(MeasuredBinsTest, holdTheContactUnlessContactsAreSwitchedOff)
{
    ASSERT_GE(touched(), 6);
    settings.contacts = ContactRule::None;
    EXPECT_EQ(touched(), -1);
    settings.contacts = ContactRule::Isolated;
    settings.method = Method::Pa;  // uses no forces
    EXPECT_EQ(touched(), -1);
}

TEST_F(MeasuredBinsTest, armReplacesAContactAndFlagsDisagreement)
{
    const int bin = touched();
    ASSERT_GE(bin, 0);
    const double contact = measure().bin[static_cast<std::size_t>(bin)]->height;
    const ArmReading near{bin, contact + 0.05, 0.03};
    const MeasuredBins agreeing = measure({&near, 1});
    EXPECT_EQ(agreeing.bin[static_cast<std::size_t>(bin)]->origin, Origin::Arm);
    EXPECT_FALSE(warns(agreeing, "disagree"));
    const ArmReading far{bin, contact - 0.2, 0.03};
    EXPECT_TRUE(warns(measure({&far, 1}), "disagree about bin"));
    EXPECT_TRUE(warns(measure({&far, 1}), "200 mm"));
}

TEST_F(MeasuredBinsTest, flagsReadingsInTheBodyAndRefusesInvalidOnes)
{
    const ArmReading inside{3, ceiling[3] + 0.1, 0.03};
    EXPECT_TRUE(warns(measure({&inside, 1}), "above the robot's own lower edge"));
    const ArmReading nonsense{3, 0.0, 0.0};
    EXPECT_THROW((void)measure({&nonsense, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
