#include "drivers/operator_panel.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "tests/support/devices/fake_gpio_lines.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kAtem = 0, kApprove = 1, kStop = 3;  // inputs
constexpr LampState kDark{};
constexpr LampState kLink{.link = true};

PanelConfig config()
{
    PanelConfig panel;
    panel.name = "test";
    panel.chipLabel = "fake";
    for (const PanelContact c : kAllPanelContacts) panel.inputs[c].line.name = name(c);
    for (std::size_t i = 0; i < kPanelOutputs; ++i)
        panel.outputs[i].line.name = kPanelOutputNames[i];
    return panel;
}

/// A panel on a fake chip, with a clock of the test.
struct Panel : testing::Test {
    Panel() { chip.move(kStop, true); }

    PanelReport poll(const LampState& lamps = kDark)
    {
        now += 0.01;
        report = panel.poll(lamps, 0ms);
        return report;
    }
    PanelReport pollFor(double seconds, const LampState& lamps = kDark)
    {
        for (double end = now + seconds - 0.005; now < end;) poll(lamps);
        return report;
    }
    OperatorPanel::Open opener()
    {
        return [this](const GpioRequest& request) { return chip.open(request); };
    }

    double now = 50.0;
    FakeGpioChip chip;
    OperatorPanel panel{config(), opener(), [this] { return now; }};
    PanelReport report;
};

TEST(PanelRequest, asksForTheLinesAsTheyAreWired)
{
    PanelConfig panel = config();
    panel.inputs[PanelContact::Atem].to = ContactTo::Supply;
    panel.inputs[PanelContact::Approve].resistor = PullResistor::External;
    panel.inputs[PanelContact::Stop].line = {"", 7U};
    panel.outputs[3].litWhenLow = true;
    const GpioRequest request = requestOf(panel);
    EXPECT_EQ(request.chipLabel, "fake");
    EXPECT_EQ(request.consumer, "terratact");
    ASSERT_EQ(request.inputs.size(), kPanelContacts);
    EXPECT_EQ(request.inputs[0].name, "atem");
    EXPECT_FALSE(request.inputs[0].activeLow);
    EXPECT_EQ(request.inputs[0].bias, GpioBias::PullDown);
    EXPECT_TRUE(request.inputs[1].activeLow);
    EXPECT_EQ(request.inputs[1].bias, GpioBias::AsIs);
    EXPECT_EQ(request.inputs[2].bias, GpioBias::PullUp);
    EXPECT_EQ(request.inputs[3].offset, 7U);
    ASSERT_EQ(request.outputs.size(), kPanelOutputs);
    EXPECT_EQ(request.outputs[0].name, "link_lamp");
    EXPECT_FALSE(request.outputs[0].activeLow);
    EXPECT_TRUE(request.outputs[3].activeLow);
}

TEST_F(Panel, isThereAndReleasesStopAfter30Ms)
{
    EXPECT_TRUE(poll().state.present);
    EXPECT_TRUE(report.state.stop);
    pollFor(0.05);
    EXPECT_FALSE(report.state.stop);
    EXPECT_EQ(report.trouble.english(), "");
}

TEST_F(Panel, stopsAtTheFirstReadingAfterAStopEdge)
{
    pollFor(0.1);
    ASSERT_FALSE(report.state.stop);
    chip.move(kStop, false, 77.25);
    EXPECT_TRUE(poll().state.stop);
    EXPECT_EQ(report.stopEdge, 77.25);
    pollFor(0.1);
    chip.move(kStop, true);
    pollFor(0.05);
    ASSERT_FALSE(report.state.stop);
    chip.move(kStop, false);
    chip.move(kStop, true);
    EXPECT_TRUE(poll().state.stop) << "open for an instant between two looks";
    EXPECT_EQ(report.counters.edges[PanelContact::Stop], 4U);
}

TEST_F(Panel, seesAPressOnce)
{
    pollFor(0.1);
    chip.move(kAtem, true);
    int presses = 0;
    for (int i = 0; i < 20; ++i) presses += poll().state.pressed[PanelContact::Atem];
    EXPECT_EQ(presses, 1);
    EXPECT_TRUE(report.state.held(PanelContact::Atem));
}

TEST_F(Panel, lostEdgesDisturbEveryContact)
{
    pollFor(0.1);
    chip.move(kApprove, true);
    pollFor(0.1);
    ASSERT_TRUE(report.state.held(PanelContact::Approve));
    ASSERT_FALSE(report.state.stop);
    chip.loseEdges = true;
    poll();
    EXPECT_TRUE(report.state.stop);
    EXPECT_FALSE(report.state.held(PanelContact::Approve));
    EXPECT_EQ(report.counters.lostEdges, 1U);
    pollFor(0.05);
    EXPECT_FALSE(report.state.stop);
    EXPECT_TRUE(report.state.held(PanelContact::Approve));
}

TEST_F(Panel, isLostAndStoppedWhenTheChipIsGone)
{
    pollFor(0.1);
    chip.gone = true;
    poll();
    EXPECT_FALSE(report.state.present);
    EXPECT_TRUE(report.state.stop);
    EXPECT_EQ(report.state.time, now);
    EXPECT_EQ(report.trouble.english(), "the panel is absent: gpiochip0 [fake]: the chip is gone");
    EXPECT_EQ(report.counters.losses, 1U);
    EXPECT_EQ(chip.held, 0) << "what is gone is let go of";
    EXPECT_FALSE(panel.found());
}

TEST_F(Panel, comesBackWithinASecondOfItsChip)
{
    pollFor(0.1);
    chip.gone = true;
    pollFor(20.0);
    EXPECT_FALSE(report.state.present);
    EXPECT_LT(chip.openings, 30) << "not in every look";
    EXPECT_GT(chip.openings, 15);
    chip.gone = false;
    pollFor(1.1);
    EXPECT_TRUE(report.state.present);
    EXPECT_FALSE(report.state.stop);
    EXPECT_EQ(report.trouble.english(), "");
    ASSERT_TRUE(panel.found());
    EXPECT_EQ(panel.found()->label, "fake");
}

TEST_F(Panel, isSearchedSoonAfterAShortLoss)
{
    pollFor(0.1);
    chip.gone = true;
    poll();
    chip.gone = false;
    pollFor(0.12);
    EXPECT_TRUE(report.state.present);
}

TEST_F(Panel, isSearchedSoonAfterAShortLossBehindALongOne)
{
    pollFor(0.1);
    chip.gone = true;
    pollFor(20.0);
    chip.gone = false;
    pollFor(1.1);
    ASSERT_TRUE(report.state.present);
    chip.gone = true;
    pollFor(0.05);
    chip.gone = false;
    pollFor(0.12);
    EXPECT_TRUE(report.state.present);
}

TEST_F(Panel, hasNoLampsLitWhileItIsLost)
{
    pollFor(2.0, kLink);
    ASSERT_EQ(report.lamps, kLink);
    chip.gone = true;
    EXPECT_EQ(poll(kLink).lamps, kDark);
}

TEST_F(Panel, thatWasNeverThereHasAReason)
{
    chip.gone = true;
    EXPECT_EQ(poll().trouble.english(), "the panel is absent: no GPIO chip labelled fake");
    EXPECT_TRUE(report.state.stop);
    EXPECT_EQ(report.counters.losses, 0U);
    chip.gone = false;
    pollFor(0.2);
    EXPECT_TRUE(report.state.present);
}

TEST_F(Panel, doesNotTakeAButtonThatWasHeldWhenItCameUp)
{
    chip.move(kApprove, true);
    int presses = 0;
    for (int i = 0; i < 100; ++i) presses += poll().state.pressed[PanelContact::Approve];
    EXPECT_EQ(presses, 0);
    EXPECT_NE(report.trouble.english().find("approve was held"), std::string::npos)
        << report.trouble.english();
    chip.move(kApprove, false);
    pollFor(0.1);
    EXPECT_EQ(report.trouble.english(), "");
}

TEST_F(Panel, testsItsLampsWhenItComesUpForTheFirstTimeOnly)
{
    poll(kDark);
    EXPECT_EQ(chip.outputs, (std::vector<bool>{true, false, false, false}));
    pollFor(0.95);
    EXPECT_EQ(chip.outputs, (std::vector<bool>{false, false, false, true}));
    pollFor(0.5);
    EXPECT_EQ(chip.outputs, (std::vector<bool>(4, false)));
    chip.gone = true;
    poll();
    chip.gone = false;
    pollFor(0.5, kLink);
    ASSERT_TRUE(report.state.present);
    EXPECT_EQ(chip.writes.size(), kPanelOutputs) << "each once, as they are to be";
    EXPECT_EQ(chip.outputs, (std::vector<bool>{true, false, false, false}));
}

TEST_F(Panel, writesALampOnlyWhenItChanges)
{
    pollFor(2.0, kDark);
    chip.writes.clear();
    pollFor(1.0, kLink);
    EXPECT_EQ(chip.writes, (std::vector<std::pair<std::size_t, bool>>{{0, true}}));
    EXPECT_EQ(report.lamps, kLink);
    pollFor(1.0, {.link = true, .armed = true, .buzzer = true});
    EXPECT_EQ(chip.writes.size(), 3U);
    EXPECT_EQ(chip.outputs, (std::vector<bool>{true, true, false, true}));
}

TEST_F(Panel, reportsAFailingLampAndRetries)
{
    pollFor(2.0, kDark);
    chip.setError = EIO;
    poll(kLink);
    EXPECT_EQ(report.trouble.english(),
              "the panel's link_lamp does not obey: fake: input/output error");
    EXPECT_EQ(report.lamps, kDark);
    EXPECT_TRUE(report.state.present) << "its buttons work";
    chip.setError = 0;
    poll(kLink);
    EXPECT_EQ(report.trouble.english(), "");
    EXPECT_EQ(report.lamps, kLink);
    EXPECT_TRUE(chip.outputs[0]);
}

TEST(OperatorPanelEnd, leavesTheLampsDark)
{
    FakeGpioChip chip;
    double now = 0.0;
    {
        OperatorPanel panel(
            config(), [&](const GpioRequest& request) { return chip.open(request); },
            [&] { return now; });
        (void)panel.poll(kDark, 0ms);
        now = 10.0;
        (void)panel.poll(kDark, 0ms);
        (void)panel.poll(kLink, 0ms);
        ASSERT_TRUE(chip.outputs[0]);
    }
    EXPECT_EQ(chip.outputs, (std::vector<bool>(4, false)));
    EXPECT_EQ(chip.held, 0);
}

TEST_F(Panel, keepsTheRightStateThrough100000Overflows)
{
    std::mt19937_64 rng(18);
    std::uniform_int_distribution<int> count(17, 60);
    std::uniform_int_distribution<std::size_t> which(0, 3);
    pollFor(0.1);
    std::array<bool, kPanelContacts> level{false, false, false, true};
    for (int burst = 0; burst < 100'000; ++burst) {
        const std::size_t input = which(rng);
        // within one millisecond: no reading between
        for (int edges = count(rng); edges > 0; --edges)
            chip.move(input, level[input] = !level[input]);
        poll();
        ASSERT_EQ(report.state.contacts.values[input].closed, level[input]) << "burst " << burst;
        ASSERT_FALSE(report.state.contacts.values[input].trusted) << "burst " << burst;
        pollFor(0.04);
        for (std::size_t i = 0; i < kPanelContacts; ++i)
            ASSERT_EQ(report.state.contacts.values[i].trusted, level[i]) << "burst " << burst;
        ASSERT_EQ(report.state.stop, !level[kStop]) << "burst " << burst;
    }
    EXPECT_GT(chip.dropped, 100'000);
}

}  // namespace
}  // namespace terratact
