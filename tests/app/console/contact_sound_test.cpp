// Tests that the window plays contacts: pitch by the element, rate by the force, level and off, apart from alarms.
#include <gtest/gtest.h>

#include <vector>

#include "app/console/main_window.h"
#include "core/atem/contact_cue.h"
#include "tests/support/absolem.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

using gui::eventually;

/// What was asked of the loudspeaker; it outlives the window.
struct Asked {
    struct Tick {
        double pitch, level, at;  ///< [Hz], 0 … 1, [s]
    };
    std::vector<Tick> ticks;
    int alarms = 0;
};

class WitnessedSound final : public AlarmSound {
public:
    explicit WitnessedSound(Asked& asked) : asked_(asked) {}
    void sound() override { ++asked_.alarms; }
    void tick(double pitch, double level) override
    {
        asked_.ticks.push_back({pitch, level, steadyNow()});
    }

private:
    Asked& asked_;
};

struct ContactSound : testing::Test {
    ContactSound()
    {
        applyLook(*qApp);
        MainWindow::Options options;
        options.robot = absolem();
        auto source = std::make_unique<ScriptedSource>();
        robot = source.get();
        press(0, 0.0);
        options.source = std::move(source);
        options.exploration.linkLostAfter = options.exploration.staleAfter = 10.0;
        options.alarmSound = std::make_unique<WitnessedSound>(asked);
        window = std::make_unique<MainWindow>(std::move(options));
        gui::showActive(*window);
    }
    /// The driving robot presses one element of the left front flipper.
    void press(std::size_t element, double newtons)
    {
        Measurement line;
        line.activity = RobotActivity::Driving;
        SideForces forces;
        forces.left.fill(0.0);
        forces.right.fill(0.0);
        forces.left.at(element) = newtons;
        setSides(line, forces);
        robot->setMeasurement(line);
    }
    bool ticksOn(std::size_t more)
    {
        const std::size_t before = asked.ticks.size();
        return eventually([&] { return asked.ticks.size() >= before + more; });
    }
    /// Returns the shortest time [s] between ticks of the last `count`.
    double shortestOf(std::size_t count) const
    {
        double shortest = 1e9;
        for (std::size_t i = asked.ticks.size() - count + 1; i < asked.ticks.size(); ++i)
            shortest = std::min(shortest, asked.ticks[i].at - asked.ticks[i - 1].at);
        return shortest;
    }

    Asked asked;
    ScriptedSource* robot = nullptr;  ///< the window owns it
    std::unique_ptr<MainWindow> window;
};

TEST_F(ContactSound, isPlayedWithPitchByElementAndLevelOfTheSettings)
{
    press(0, 12.0);
    ASSERT_TRUE(ticksOn(2));
    EXPECT_DOUBLE_EQ(asked.ticks.back().pitch, kPivotPitch);
    EXPECT_DOUBLE_EQ(asked.ticks.back().level, 0.5) << "the default";
    press(5, 12.0);
    ASSERT_TRUE(ticksOn(3));
    EXPECT_NEAR(asked.ticks.back().pitch, 528.0, 1.0);
    window->preferences().change([](Preferences& p) { p.contactSound = 20; });
    ASSERT_TRUE(ticksOn(2));
    EXPECT_DOUBLE_EQ(asked.ticks.back().level, 0.2);
}

TEST_F(ContactSound, isFasterForALargerForce)
{
    press(2, 3.0);
    ASSERT_TRUE(ticksOn(3));
    const double weak = shortestOf(2);
    press(2, 30.0);
    ASSERT_TRUE(ticksOn(4));
    EXPECT_LT(shortestOf(2), weak);
    EXPECT_GE(weak, contactTone([] {
                        FlipperContacts contacts;
                        contacts.flippers[0][2] = {3.0, true};
                        return contacts;
                    }())
                            ->period
                        - 0.02);
}

TEST_F(ContactSound, isOffAtLevelNoneAndWithoutAContact)
{
    window->preferences().change([](Preferences& p) { p.contactSound = 0; });
    press(2, 30.0);
    const auto seen = [&] { return window->acquisition().latest()->count; };
    ASSERT_TRUE(eventually([&] { return window->acquisition().latest().has_value(); }));
    const std::uint64_t from = seen();
    ASSERT_TRUE(eventually([&] { return seen() > from + 200; }));
    EXPECT_TRUE(asked.ticks.empty());
    window->preferences().change([](Preferences& p) { p.contactSound = 50; });
    ASSERT_TRUE(ticksOn(1));
}

TEST_F(ContactSound, goesOnWhereAlarmsAreSilent)
{
    window->preferences().change([](Preferences& p) { p.sound = false; });
    const int before = asked.alarms;  // the first telemetry may come late on a busy machine
    press(2, 30.0);
    EXPECT_TRUE(ticksOn(3)) << "alarms and contacts have settings of their own";
    EXPECT_EQ(asked.alarms, before);
}

}  // namespace
}  // namespace terratact
