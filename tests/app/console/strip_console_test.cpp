// Drives 5 m over hills in the console, and looks at the strip of felt ground. TERRATACT_PICTURES=DIR saves the
// pictures of docs/strip.md.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "app/runtime/resources.h"
#include "core/terrain/terrain_profile.h"
#include "tests/support/benches/bus_console_bench.h"
#include "tests/support/gui.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using gui::eventually;

/// Hills of 4 cm that the tracks follow.
TerrainProfile hills()
{
    std::vector<Vec2> points;
    for (int i = 0; i <= 180; ++i) {
        const double x = 0.05 * i;
        points.push_back({x, -0.02 * std::cos(2.0 * std::numbers::pi * x / 1.5)});
    }
    return TerrainProfile(std::move(points));
}

/// A console with the shipped model, and a quick robot on hills.
struct StripConsole : BusConsole {
    bool openOnHills()
    {
        SimulatedRobot::Options simulation;
        simulation.startX = 1.0;
        robot = std::make_unique<RobotInProcess>(
            bus, model, SimulatedRobot(model, hills(), simulation),
            RobotOnBus::Options{.firstEpoch = 9, .speed = 10.0}, time());
        window = console(bus.join("can0"), CanSource::Mode::Transmit,
                         modelFileLoader(resourcePath("models/default.ttm"), model));
        window->resize(1440, 900);
        gui::showActive(*window);
        Settings settings = window->exploration().options().settings;
        settings.method = Method::Trail;
        window->exploration().setSettings(settings);
        window->exploration().setDriveSpeed(0.1);
        return eventually([&] { return !modelInUse(*window).isEmpty(); }, 60000);
    }
    /// Returns the odometry [m].
    double travelled() const
    {
        const auto latest = window->acquisition().latest();
        return latest ? latest->sample.measurement.travelled.value_or(0.0) : 0.0;
    }
    /// Drives on by key W, at least so far [m].
    bool drivesOn(double metres)
    {
        if (!drives()) return false;
        const double begin = travelled();
        const bool arrives = eventually([&] { return travelled() > begin + metres; }, 60000);
        QTest::keyRelease(window.get(), Qt::Key_W);
        return arrives && robotIs(RobotActivity::Halted);
    }
    /// Explores and refuses the probe.
    bool explores()
    {
        if (!exploresUntilAsked()) return false;
        QTest::keyClick(window.get(), Qt::Key_N);
        return reaches(AtemPhase::Presenting);
    }
    /// Explores every half metre up to this way [m], and leaves the last estimate. The picture then shows remembered
    /// ground.
    bool feelsUpTo(double way)
    {
        while (travelled() < way)
            if (!explores() || !drivesOn(0.5)) return false;
        if (!explores() || !drivesOn(0.1)) return false;
        return eventually(
            [&] { return window->terrain()->accessibleDescription().contains("driven since"); });
    }
    /// Returns the left bins of the strip, rear to front.
    std::vector<SeenBin> remembered() const
    {
        return window->exploration().estimation().remembered().side[0];
    }
    /// Returns the x of the picture's left end [m].
    double leftEnd() const { return window->terrain()->pointAt({0.0, 0.0}).x(); }
};

TEST_F(StripConsole, zoomedOutShowsFiveMetresOfGround)
{
    ASSERT_TRUE(openOnHills());
    ASSERT_TRUE(feelsUpTo(1.5));
    const std::vector<SeenBin> early = remembered();
    ASSERT_FALSE(early.empty());
    EXPECT_LT(early.front().x, -1.0) << "behind the robot";
    EXPECT_GT(early.back().x, 0.3) << "ahead of it";
    picture("strip-live");

    ASSERT_TRUE(feelsUpTo(5.0));
    const std::vector<SeenBin> late = remembered();
    ASSERT_FALSE(late.empty());
    EXPECT_LT(late.front().x, -4.5);
    EXPECT_GT(leftEnd(), late.front().x) << "it lies beyond the picture";
    window->terrain()->zoom(100.0, 0.0);
    EXPECT_LT(leftEnd(), late.front().x);
    picture("strip-zoomed-out");
}

}  // namespace
}  // namespace terratact
