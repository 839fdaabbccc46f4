// Tests the panel's driver with a real kernel: gpio-sim is the chip, and the test drives its lines. Built for each
// version of libgpiod.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <functional>
#include <random>
#include <stdexcept>
#include <thread>

#include "drivers/gpio_lines.h"
#include "drivers/operator_panel.h"
#include "tests/support/devices/gpio_sim.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kAtem = 0, kApprove = 1, kRefuse = 2, kStop = 3, kLinkLamp = 4, kBuzzer = 7;
constexpr const char* kLabel = "panel-test";
const std::vector<std::string> kNames{"ATEM", "APPROVE", "REFUSE",  "STOP",
                                      "LINK", "ARMED",   "PROBING", "BUZZER"};

double steadyNow()
{
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

/// Returns a panel with contacts to ground and the chip's internal resistors, on the lines of kNames.
PanelConfig config(PullResistor resistor = PullResistor::Internal)
{
    PanelConfig panel;
    panel.name = "simulated";
    panel.chipLabel = kLabel;
    for (std::size_t i = 0; i < kPanelContacts; ++i) {
        panel.inputs.values[i].line.name = kNames[i];
        panel.inputs.values[i].resistor = resistor;
    }
    for (std::size_t i = 0; i < kPanelOutputs; ++i)
        panel.outputs[i].line.name = kNames[kPanelContacts + i];
    return panel;
}

struct GpioKernel : testing::Test {
    void SetUp() override
    {
        if (!GpioSim::available())
            GTEST_SKIP() << "this kernel has no gpio-sim: run it with tests/kernel/run.sh";
        chip.emplace(kLabel, kNames);
    }
    std::unique_ptr<GpioLines> open(const PanelConfig& panel = config())
    {
        auto lines = openGpioLines(requestOf(panel));
        if (!lines) throw std::runtime_error(lines.error().text);
        return *std::move(lines);
    }
    Error refusal(const PanelConfig& panel)
    {
        auto lines = openGpioLines(requestOf(panel));
        return lines ? Error{"was accepted", 0} : lines.error();
    }
    /// Closes or opens a contact; a closed contact connects its line to ground.
    void close(std::size_t contact, bool closed = true) { chip->drive(contact, !closed); }

    std::optional<GpioSim> chip;
};

/// Returns all edges until none arrive for 50 ms.
GpioEdges edgesOf(GpioLines& lines)
{
    GpioEdges all;
    for (;;) {
        const auto edges = lines.readEdges(50ms);
        if (!edges) throw std::runtime_error(edges.error().text);
        all.lost |= edges->lost;
        if (edges->edges.empty()) return all;
        all.edges.insert(all.edges.end(), edges->edges.begin(), edges->edges.end());
    }
}

std::vector<bool> levelsOf(GpioLines& lines)
{
    const auto levels = lines.levels();
    if (!levels) throw std::runtime_error(levels.error().text);
    return *levels;
}

// ------------------------------------------------------------------------------------------ the lines

TEST_F(GpioKernel, linesAreFoundByTheChipsLabelAndTheirNames)
{
    const auto lines = open();
    EXPECT_EQ(lines->found().chip, chip->chip());
    EXPECT_EQ(lines->found().path, "/dev/" + chip->chip());
    EXPECT_EQ(lines->found().label, kLabel);
    EXPECT_EQ(lines->found().lines, kNames.size());
    for (unsigned i = 0; i < kPanelContacts; ++i) {
        EXPECT_EQ(lines->found().inputs.at(i).offset, i);
        EXPECT_EQ(lines->found().outputs.at(i).offset, i + kPanelContacts);
    }
}

TEST_F(GpioKernel, linesAreFoundByTheChipsNameAndTheirOffsets)
{
    PanelConfig panel = config();
    panel.chipLabel.clear();
    panel.chipName = chip->chip();
    panel.inputs[PanelContact::Stop].line = {"", 3U};
    EXPECT_EQ(open(panel)->found().inputs.at(3).name, "STOP");
}

TEST_F(GpioKernel, anEdgeHasInputDirectionAndTime)
{
    const auto lines = open();
    (void)edgesOf(*lines);
    const double before = steadyNow();
    close(kRefuse);
    const GpioEdges closing = edgesOf(*lines);
    ASSERT_EQ(closing.edges.size(), 1U);
    EXPECT_EQ(closing.edges[0].input, kRefuse);
    EXPECT_TRUE(closing.edges[0].active);
    EXPECT_GE(closing.edges[0].time, before);
    EXPECT_LE(closing.edges[0].time, steadyNow());
    EXPECT_EQ(levelsOf(*lines), (std::vector<bool>{false, false, true, false}));
    close(kRefuse, false);
    const GpioEdges opening = edgesOf(*lines);
    ASSERT_EQ(opening.edges.size(), 1U);
    EXPECT_FALSE(opening.edges[0].active);
    EXPECT_EQ(levelsOf(*lines), (std::vector<bool>(4, false)));
}

TEST_F(GpioKernel, anEdgeEndsTheWait)
{
    const auto lines = open();
    (void)edgesOf(*lines);
    std::jthread outside([this] {
        std::this_thread::sleep_for(50ms);
        close(kAtem);
    });
    const auto begin = Clock::now();
    const auto edges = lines->readEdges(20s);
    ASSERT_TRUE(edges);
    EXPECT_EQ(edges->edges.size(), 1U);
    EXPECT_LT(Clock::now() - begin, 10s);
}

TEST_F(GpioKernel, aTimeoutIsAnEmptyAnswer)
{
    const auto lines = open();
    (void)edgesOf(*lines);
    const auto edges = lines->readEdges(1ms);
    ASSERT_TRUE(edges);
    EXPECT_TRUE(edges->edges.empty());
    EXPECT_FALSE(edges->lost);
}

TEST_F(GpioKernel, aContactToTheSupplyIsActiveWhileHigh)
{
    PanelConfig panel = config();
    panel.inputs[PanelContact::Atem].to = ContactTo::Supply;
    const auto lines = open(panel);
    EXPECT_FALSE(levelsOf(*lines)[kAtem]) << "held low by the chip's resistor";
    chip->drive(kAtem, true);
    EXPECT_TRUE(levelsOf(*lines)[kAtem]);
}

TEST_F(GpioKernel, outputsStartInactiveAndFollow)
{
    PanelConfig panel = config();
    panel.outputs[3].litWhenLow = true;
    const auto lines = open(panel);
    EXPECT_FALSE(chip->level(kLinkLamp));
    EXPECT_TRUE(chip->level(kBuzzer)) << "dark is high here";
    ASSERT_TRUE(lines->set(0, true));
    ASSERT_TRUE(lines->set(3, true));
    EXPECT_TRUE(chip->level(kLinkLamp));
    EXPECT_FALSE(chip->level(kBuzzer));
    EXPECT_THROW((void)lines->set(4, true), std::invalid_argument);
}

TEST_F(GpioKernel, edgesBeyondTheKernelsRoomAreLostButTheLevelIsRight)
{
    // libgpiod 1 keeps 16 edges of each line without reporting losses; libgpiod 2 the 256 requested, numbered.
    constexpr int kRoom = LIBGPIOD == 1 ? 16 : 256;
    const auto lines = open();
    (void)edgesOf(*lines);
    for (int i = 0; i < kRoom + 41; ++i) {
        close(kStop, i % 2 == 0);
        std::this_thread::sleep_for(12ms);  // gpio-sim delivers one edge per tick of 10 ms
    }
    const GpioEdges edges = edgesOf(*lines);
    EXPECT_EQ(edges.edges.size(), static_cast<std::size_t>(kRoom));
    EXPECT_EQ(edges.lost, LIBGPIOD == 2);
    for (const GpioEdge& edge : edges.edges) ASSERT_EQ(edge.input, kStop);
    EXPECT_EQ(levelsOf(*lines), (std::vector<bool>{false, false, false, true}));
    close(kAtem);
    EXPECT_EQ(edgesOf(*lines).edges.size(), 1U) << "and goes on";
}

TEST_F(GpioKernel, aMissingChipErrorListsTheLabels)
{
    PanelConfig panel = config();
    panel.chipLabel = "elsewhere";
    const Error error = refusal(panel);
    EXPECT_EQ(error.code, ENODEV) << error.text;
    EXPECT_NE(error.text.find("'elsewhere'"), std::string::npos) << error.text;
    EXPECT_NE(error.text.find(kLabel), std::string::npos) << error.text;
}

TEST_F(GpioKernel, aMissingLineErrorListsTheNames)
{
    PanelConfig panel = config();
    panel.inputs[PanelContact::Stop].line.name = "HALT";
    const Error error = refusal(panel);
    EXPECT_EQ(error.code, ENOENT) << error.text;
    EXPECT_NE(error.text.find("'HALT'"), std::string::npos) << error.text;
    EXPECT_NE(error.text.find("ATEM, APPROVE, REFUSE, STOP"), std::string::npos) << error.text;
}

TEST_F(GpioKernel, aLineInUseIsAnsweredWithItsHolder)
{
    const auto first = open();
    const Error error = refusal(config());
    EXPECT_EQ(error.code, EBUSY) << error.text;
    EXPECT_NE(error.text.find("'terratact' holds it"), std::string::npos) << error.text;
    EXPECT_NE(error.text.find("'ATEM'"), std::string::npos) << error.text;
}

TEST_F(GpioKernel, linesAreFreeAgainOnceClosedAndAfterARefusal)
{
    PanelConfig half = config();
    half.outputs[3].line = half.outputs[2].line;
    half.outputs[3].line.name = "nowhere";
    for (int i = 0; i < 20; ++i) {
        open();
        (void)refusal(half);
    }
    EXPECT_TRUE(openGpioLines(requestOf(config())));
}

TEST_F(GpioKernel, aDeviceFileThatMayNotBeOpenedIsAnsweredWithTheCure)
{
    ASSERT_EQ(::seteuid(65534), 0);
    const Error error = refusal(config());
    ASSERT_EQ(::seteuid(0), 0);
    EXPECT_EQ(error.code, EACCES) << error.text;
    EXPECT_NE(error.text.find("/dev/" + chip->chip()), std::string::npos) << error.text;
    EXPECT_NE(error.text.find("usermod -aG gpio"), std::string::npos) << error.text;
}

TEST_F(GpioKernel, everyCallReportsALostChip)
{
    const auto lines = open();
    chip->unplug();
    const auto edges = lines->readEdges(1s);
    ASSERT_FALSE(edges);
    EXPECT_EQ(edges.error().code, ENODEV) << edges.error().text;
    const auto levels = lines->levels();
    ASSERT_FALSE(levels);
    EXPECT_EQ(levels.error().code, ENODEV) << levels.error().text;
    const auto set = lines->set(0, true);
    ASSERT_FALSE(set);
    EXPECT_EQ(set.error().code, ENODEV) << set.error().text;
}

// ------------------------------------------------------------------------------------------ the panel

struct PanelKernel : GpioKernel {
    /// Polls until the condition is true, for at most ten seconds.
    bool until(const std::function<bool(const PanelReport&)>& so)
    {
        const auto limit = Clock::now() + 10s;
        while (Clock::now() < limit)
            if (so(poll())) return true;
        return false;
    }
    const PanelReport& poll()
    {
        report = panel.poll(lamps, 10ms);
        for (const PanelContact c : kPanelButtons) presses[c] += report.state.pressed[c];
        return report;
    }
    void pollFor(std::chrono::milliseconds time)
    {
        const auto limit = Clock::now() + time;
        while (Clock::now() < limit) poll();
    }
    bool isReady()
    {
        poll();
        close(kStop);
        return until([](const PanelReport& r) { return r.state.present && !r.state.stop; });
    }

    OperatorPanel panel{config(), openGpioLines};
    PanelReport report;
    PerContact<int> presses;
    LampState lamps;
};

TEST_F(PanelKernel, aBrokenWireOfStopStops)
{
    pollFor(300ms);
    EXPECT_TRUE(report.state.present) << report.trouble.english();
    EXPECT_TRUE(report.state.stop) << "nothing is connected: the resistor holds the line open";
    close(kStop);
    EXPECT_TRUE(until([](const PanelReport& r) { return !r.state.stop; }));
    close(kStop, false);
    EXPECT_TRUE(poll().state.stop) << "in the very next look";
}

TEST_F(PanelKernel, aStopOpenedBetweenTwoPollsStops)
{
    ASSERT_TRUE(isReady()) << report.trouble.english();
    close(kStop, false);
    close(kStop, true);
    EXPECT_TRUE(poll().state.stop);
    EXPECT_GT(report.stopEdge, 0.0);
    EXPECT_LE(report.stopEdge, report.state.time);
    EXPECT_TRUE(until([](const PanelReport& r) { return !r.state.stop; }));
}

TEST_F(PanelKernel, eachButtonIsPressedOnce)
{
    ASSERT_TRUE(isReady()) << report.trouble.english();
    pollFor(100ms);
    for (const PanelContact c : kPanelButtons) {
        close(static_cast<std::size_t>(c));
        EXPECT_TRUE(until([c](const PanelReport& r) { return r.state.held(c); })) << name(c);
        close(static_cast<std::size_t>(c), false);
        EXPECT_TRUE(until([c](const PanelReport& r) { return !r.state.held(c); })) << name(c);
        pollFor(100ms);
        EXPECT_EQ(presses[c], 1) << name(c);
    }
}

TEST_F(PanelKernel, bouncingContactsEndInTheRightState)
{
    ASSERT_TRUE(isReady()) << report.trouble.english();
    std::mt19937_64 rng(4);
    std::uniform_int_distribution<int> count(17, 80);
    std::uniform_int_distribution<std::size_t> which(0, 3);
    std::array<bool, kPanelContacts> closed{false, false, false, true};
    for (int burst = 0; burst < 100; ++burst) {
        const std::size_t contact = which(rng);
        for (int i = count(rng); i > 0; --i) close(contact, closed[contact] = !closed[contact]);
        poll();
        ASSERT_FALSE(report.state.contacts.values[contact].trusted) << "burst " << burst;
        const bool settled = until([&](const PanelReport& r) {
            return r.state.time - r.state.contacts.values[contact].since > 0.05;
        });
        ASSERT_TRUE(settled);
        for (std::size_t i = 0; i < kPanelContacts; ++i)
            ASSERT_EQ(report.state.contacts.values[i].trusted, closed[i]) << "burst " << burst;
        ASSERT_EQ(report.state.stop, !closed[kStop]) << "burst " << burst;
    }
}

TEST_F(PanelKernel, aChipThatIsUnpluggedIsLostAndComesBack)
{
    ASSERT_TRUE(isReady()) << report.trouble.english();
    for (int i = 1; i <= 20; ++i) {
        chip->unplug();
        poll();
        ASSERT_FALSE(report.state.present) << "in the very next look";
        ASSERT_TRUE(report.state.stop);
        ASSERT_NE(report.trouble.english().find("absent"), std::string::npos)
            << report.trouble.english();
        if (i % 2 == 0) pollFor(150ms);
        chip->plugIn();
        ASSERT_TRUE(until([](const PanelReport& r) { return r.state.present; }))
            << report.trouble.english();
        ASSERT_TRUE(report.state.stop) << "until STOP is seen closed";
        close(kStop);
        ASSERT_TRUE(until([](const PanelReport& r) { return !r.state.stop; }))
            << report.trouble.english();
        ASSERT_EQ(report.counters.losses, static_cast<std::uint64_t>(i));
    }
}

TEST_F(PanelKernel, aPanelThatIsInUseComesUpOnceItIsFree)
{
    auto other = open();
    EXPECT_FALSE(poll().state.present);
    EXPECT_NE(report.trouble.english().find("holds it"), std::string::npos)
        << report.trouble.english();
    other.reset();
    EXPECT_TRUE(until([](const PanelReport& r) { return r.state.present; }))
        << report.trouble.english();
}

TEST_F(PanelKernel, lampsAreTestedLitAndLeftDark)
{
    std::array<bool, kPanelOutputs> seen{};
    const auto poll = [&](const PanelReport&) {
        for (std::size_t i = 0; i < kPanelOutputs; ++i) seen[i] |= chip->level(kLinkLamp + i);
        return seen == std::array<bool, kPanelOutputs>{true, true, true, true};
    };
    EXPECT_TRUE(until(poll)) << "the test lights each";
    lamps = {.link = true, .buzzer = true};
    EXPECT_TRUE(until([&](const PanelReport& r) { return r.lamps == lamps; }));
    EXPECT_TRUE(chip->level(kLinkLamp));
    EXPECT_TRUE(chip->level(kBuzzer));
    EXPECT_FALSE(chip->level(kLinkLamp + 1));
    {
        OperatorPanel other(config(), openGpioLines);
        EXPECT_FALSE(other.poll({}, 0ms).state.present) << "one console at a time";
    }
    EXPECT_TRUE(chip->level(kLinkLamp)) << "which the other leaves alone";
}

TEST_F(GpioKernel, aPanelThatEndsLeavesItsLampsDark)
{
    {
        OperatorPanel panel(config(), openGpioLines);
        (void)panel.poll({}, 0ms);
        ASSERT_TRUE(chip->level(kLinkLamp)) << "being tested";
    }
    for (std::size_t i = 0; i < kPanelOutputs; ++i) EXPECT_FALSE(chip->level(kLinkLamp + i)) << i;
}

TEST_F(GpioKernel, aButtonHeldWhenThePanelComesUpIsNoPress)
{
    OperatorPanel panel(config(PullResistor::External), openGpioLines);
    for (const std::size_t open : {kAtem, kRefuse}) close(open, false);
    close(kApprove);
    close(kStop);
    PanelReport report;
    for (int i = 0; i < 30; ++i) {
        report = panel.poll({}, 10ms);
        ASSERT_FALSE(report.state.pressed[PanelContact::Approve]);
    }
    EXPECT_EQ(report.state.contacts[PanelContact::Approve].phase, ButtonPhase::HeldAtStart);
    EXPECT_FALSE(report.state.stop);
    EXPECT_NE(report.trouble.english().find("approve was held"), std::string::npos)
        << report.trouble.english();
}

}  // namespace
}  // namespace terratact
