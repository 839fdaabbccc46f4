// Tests the rules that choose a bin to probe.
#include "app/modelling/trials/probe_trials.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/support/absolem.h"
#include "tests/support/estimates.h"

namespace terratact {
namespace {

struct RulesOfProbes : testing::Test {
    RulesOfProbes()
    {
        std::mt19937_64 rng(3);
        for (int k = 0; k < 400; ++k) {
            Heights draw = estimate.height;
            for (std::size_t i = 0; i < kBins; ++i)
                draw[i] += std::normal_distribution(0.0, estimate.sd[i])(rng);
            estimate.draws.push_back(draw);
        }
    }
    std::optional<int> choice(const std::string& rule, std::span<const ArmReading> read = {}) const
    {
        for (const NamedRule& known : rules)
            if (known.name == rule) return known.choose(estimate, read);
        ADD_FAILURE() << "no rule " << rule;
        return {};
    }
    TerrainEstimate estimate = stepEstimate();
    RobotModel robot = absolem();
    std::vector<NamedRule> rules = probeRules(robot, 0.1);
};

TEST_F(RulesOfProbes, chooseTheMostUncertainBin)
{
    EXPECT_EQ(choice("sd"), 9);
    EXPECT_EQ(choice("variance"), 9);
}

TEST_F(RulesOfProbes, chooseNoBinThatWasRead)
{
    const std::array read{ArmReading{.bin = 9, .height = -0.05, .sd = 0.03}};
    for (const char* rule : {"variance", "step"}) {
        const auto bin = choice(rule, read);
        ASSERT_TRUE(bin) << rule;
        EXPECT_NE(*bin, 9) << rule;
    }
}

TEST_F(RulesOfProbes, aRobotWithoutAnArmProbesNothing)
{
    robot.armSd = 0.0;
    EXPECT_FALSE(choice("sd"));
}

}  // namespace
}  // namespace terratact
