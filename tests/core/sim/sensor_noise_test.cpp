#include "core/sim/sensor_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "core/learn/data/columns.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

constexpr double kSaturation = 20.0;

Proprioception exact()
{
    Proprioception s{
        .pitch = 0.2, .front = -0.1, .rear = 0.3, .frontCurrent = 1.0, .rearCurrent = -0.5};
    s.force = {0.0, 5.0, 10.0, 19.5, 2.0, 12.0};
    return s;
}

struct Moments {
    double mean = 0.0, sd = 0.0;
};

/// Returns the moments of what `pick` takes from noisy readings.
Moments momentsOf(const std::function<double(const Proprioception&)>& pick)
{
    constexpr int kDraws = 20000;
    std::mt19937_64 rng(11);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < kDraws; ++i) {
        const double x = pick(noisy(exact(), SensorNoise{}, kSaturation, rng));
        sum += x;
        squares += x * x;
    }
    const double mean = sum / kDraws;
    return {mean, std::sqrt(squares / kDraws - mean * mean)};
}

/// Five standard errors of 20000 draws.
void expectNormal(const Moments& found, double mean, double sd)
{
    EXPECT_NEAR(found.mean, mean, 5.0 * sd / std::sqrt(20000.0));
    EXPECT_NEAR(found.sd, sd, 5.0 * sd / std::sqrt(2.0 * 20000.0));
}

TEST(SensorNoise, hasTheStatedMoments)
{
    expectNormal(momentsOf([](const auto& s) { return s.pitch; }), 0.2, 0.0087);
    expectNormal(momentsOf([](const auto& s) { return s.front; }), -0.1, 0.0017);
    expectNormal(momentsOf([](const auto& s) { return s.rear; }), 0.3, 0.0017);
    expectNormal(momentsOf([](const auto& s) { return *s.frontCurrent; }), 1.0, 0.05);
    expectNormal(momentsOf([](const auto& s) { return *s.rearCurrent; }), -0.5, 0.05);
    expectNormal(momentsOf([](const auto& s) { return *s.force[1]; }), 5.0, std::hypot(0.5, 0.3));
    expectNormal(momentsOf([](const auto& s) { return *s.force[2]; }), 10.0, std::hypot(1.0, 0.3));
}

TEST(SensorNoise, keepsForcesBetweenZeroAndSaturation)
{
    std::mt19937_64 rng(12);
    double least = 1.0, most = 0.0;
    for (int i = 0; i < 1000; ++i)
        for (const auto& force : noisy(exact(), SensorNoise{}, kSaturation, rng).force) {
            least = std::min(least, *force);
            most = std::max(most, *force);
        }
    EXPECT_EQ(least, 0.0);
    EXPECT_EQ(most, kSaturation);
}

TEST(SensorNoise, keepsCurrentsPlausible)
{
    std::mt19937_64 rng(3);
    Proprioception s = exact();
    s.frontCurrent = 176.0;
    s.rearCurrent = -125.0;
    const Proprioception read = noisy(s, SensorNoise{}, kSaturation, rng);
    EXPECT_EQ(read.frontCurrent, kMaxSceneCurrent);
    EXPECT_EQ(read.rearCurrent, -kMaxSceneCurrent);
    TwoTrackReadings both;
    both.currents = {176.0, -125.0, 1.0, std::nullopt};
    const TwoTrackReadings found = noisy(both, SensorNoise::none(), kSaturation, rng);
    EXPECT_EQ(found.currents[0], kMaxSceneCurrent);
    EXPECT_EQ(found.currents[1], -kMaxSceneCurrent);
    EXPECT_EQ(found.currents[2], 1.0);
    EXPECT_FALSE(found.currents[3]);
}

TEST(SensorNoise, leavesOutWhatIsNotMeasured)
{
    Proprioception s = exact();
    s.frontCurrent.reset();
    s.force[3].reset();
    std::mt19937_64 rng(13);
    const Proprioception got = noisy(s, SensorNoise{}, kSaturation, rng);
    EXPECT_FALSE(got.frontCurrent);
    EXPECT_FALSE(got.force[3]);
    EXPECT_TRUE(got.rearCurrent && got.force[2]);
}

TEST(SensorNoise, ofNoneIsTheExactReading)
{
    std::mt19937_64 rng(14);
    EXPECT_EQ(noisy(exact(), SensorNoise::none(), kSaturation, rng), exact());
    const Heights h{-0.24, -0.24, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    EXPECT_EQ(noisy(h, SensorNoise::none(), rng), h);
}

TEST(SensorNoise, dependsOnTheSeedOnly)
{
    std::mt19937_64 a(1), b(1), c(2);
    const Proprioception first = noisy(exact(), SensorNoise{}, kSaturation, a);
    EXPECT_EQ(first, noisy(exact(), SensorNoise{}, kSaturation, b));
    EXPECT_NE(first, noisy(exact(), SensorNoise{}, kSaturation, c));
}

TEST(SensorNoise, ofTheScannerIsIndependentFromBinToBin)
{
    constexpr int kDraws = 20000;
    std::mt19937_64 rng(15);
    double square = 0.0, product = 0.0;
    for (int i = 0; i < kDraws; ++i) {
        const Heights h = noisy(Heights{}, SensorNoise{}, rng);
        square += h[4] * h[4];
        product += h[4] * h[5];
    }
    EXPECT_NEAR(std::sqrt(square / kDraws), 0.012, 0.012 * 5.0 / std::sqrt(2.0 * kDraws));
    EXPECT_NEAR(product / kDraws, 0.0, 0.012 * 0.012 * 5.0 / std::sqrt(kDraws));
}

TEST(SensorNoise, sidesOfAMeanBeyondTheRangeReadThatMean)
{
    const RobotModel robot = absolem();
    Measurement line;
    line.force.fill(2.0);
    line.force[1] = robot.forceSaturation + 5.0;
    std::mt19937_64 rng(17);
    const SideForces sides = sidesOf(line, SensorNoise{}, robot, rng);
    EXPECT_EQ(sides.left[1], line.force[1]);
    EXPECT_EQ(sides.right[1], line.force[1]);
    EXPECT_NE(sides.left[0], sides.right[0]);
    EXPECT_DOUBLE_EQ((*sides.left[0] + *sides.right[0]) / 2.0, 2.0);
}

TEST(SensorNoise, refusesInvalidDeviations)
{
    std::mt19937_64 rng(16);
    SensorNoise noise;
    noise.pitch = -0.1;
    EXPECT_THROW(noisy(exact(), noise, kSaturation, rng), std::invalid_argument);
    noise.pitch = std::nan("");
    EXPECT_THROW(noisy(Heights{}, noise, rng), std::invalid_argument);
    EXPECT_THROW(noisy(exact(), SensorNoise{}, 0.0, rng), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
