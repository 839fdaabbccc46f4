// Tests when a robot stood still with flippers pressed.
#include "core/mapping/standing_presses.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace terratact {
namespace {

using Places = std::vector<std::size_t>;

/// Lines every 0.1 s; `change` makes each from its number.
std::vector<TelemetryLine> lines(int count, const std::function<void(int, Measurement&)>& change)
{
    std::vector<TelemetryLine> all;
    for (int i = 0; i < count; ++i) {
        TelemetryLine line{.time = i * std::int64_t{100'000'000}};
        line.measurement.frontLeftCurrent = line.measurement.frontRightCurrent = 1.5;
        change(i, line.measurement);
        all.push_back(line);
    }
    return all;
}

TEST(StandingPresses, thePressEndsInOneScene)
{
    const auto press = lines(20, [](int i, Measurement& m) {
        if (i < 4 || i >= 12) m.frontLeftCurrent = 0.4;  // mean 0.95 A
    });
    EXPECT_EQ(standingPresses(press, {}), (Places{8}));
}

TEST(StandingPresses, aShortPressIsNone)
{
    const auto press = [](int begin) {
        return lines(20, [begin](int i, Measurement& m) {
            if (i < begin || i >= 12) m.frontLeftCurrent = 0.4;
        });
    };
    EXPECT_EQ(standingPresses(press(6), {}), (Places{8})) << "0.5 s";
    EXPECT_TRUE(standingPresses(press(7), {}).empty()) << "0.4 s";
}

TEST(StandingPresses, movementEndsThePose)
{
    const auto turned = lines(20, [](int i, Measurement& m) { m.rearLeft = i < 10 ? 0.0 : 0.05; });
    EXPECT_EQ(standingPresses(turned, {}), (Places{7, 16}));
    const auto noise = lines(20, [](int i, Measurement& m) { m.pitch = i % 2 == 0 ? 0.0 : 0.015; });
    EXPECT_EQ(standingPresses(noise, {}), (Places{16}));
    const auto driven = lines(20, [](int i, Measurement& m) { m.travelled = 0.006 * i; });
    EXPECT_TRUE(standingPresses(driven, {}).empty());
}

TEST(StandingPresses, aGapEndsThePress)
{
    auto press = lines(20, [](int, Measurement&) {});
    for (std::size_t i = 10; i < press.size(); ++i) press[i].time += 1'000'000'000;
    EXPECT_EQ(standingPresses(press, {}), (Places{6, 16}));
}

TEST(StandingPresses, forcesCountWithoutCurrents)
{
    const auto press = lines(10, [](int, Measurement& m) {
        m.missing[kFrontCurrentFeature] = m.missing[kRearCurrentFeature] = true;
        m.force = {0, 0, 0, 2.5, 2.6, 0};
    });
    EXPECT_EQ(standingPresses(press, {}), (Places{6}));
    EXPECT_TRUE(standingPresses(press, {.minForce = 5.2}).empty());
    const auto blind = lines(10, [](int, Measurement& m) { m.missing.set(); });
    EXPECT_TRUE(standingPresses(blind, {.minForce = 0.0}).empty()) << "neither is measured";
}

TEST(StandingPresses, theRobotsWordCountsFirst)
{
    const auto said = lines(20, [](int i, Measurement& m) {
        m.activity = i < 5  ? RobotActivity::Pressed
                   : i < 10 ? RobotActivity::Probing
                            : RobotActivity::Pressing;
        m.frontLeftCurrent = m.frontRightCurrent = 0.0;
    });
    EXPECT_EQ(standingPresses(said, {.byActivity = true}), (Places{6}));
    EXPECT_TRUE(standingPresses(said, {}).empty());
}

TEST(StandingPresses, fallingTimesAreRefused)
{
    auto press = lines(3, [](int, Measurement&) {});
    press[2].time = 0;
    EXPECT_THROW(standingPresses(press, {}), std::invalid_argument);
}

TEST(MovedAt, looksBackForTheTimeOfStandingStill)
{
    const auto turned = lines(20, [](int i, Measurement& m) { m.pitch = i < 10 ? 0.0 : 0.5; });
    const auto moved = movedAt(turned, {});
    for (std::size_t i = 0; i < moved.size(); ++i) EXPECT_EQ(moved[i], i >= 10 && i < 15) << i;
}

}  // namespace
}  // namespace terratact
