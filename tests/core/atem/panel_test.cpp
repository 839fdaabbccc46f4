#include "core/atem/panel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace terratact {
namespace {

constexpr double kPeriod = 0.01;  // [s] between readings of the panel
constexpr PanelContact kAtem = PanelContact::Atem, kApprove = PanelContact::Approve,
                       kRefuse = PanelContact::Refuse, kStop = PanelContact::Stop;

/// Contacts that are closed.
PerContact<bool> only(std::initializer_list<PanelContact> contacts)
{
    PerContact<bool> set;
    for (const PanelContact c : contacts) set[c] = true;
    return set;
}

/// A panel that is read every 10 ms.
struct Panel {
    PanelState poll(const PerContact<bool>& closed, const PerContact<bool>& disturbed = {})
    {
        now += kPeriod;
        state = nextPanel(state, {.now = now, .closed = closed, .disturbed = disturbed});
        for (const PanelContact c : kPanelButtons) presses[c] += state.pressed[c];
        return state;
    }
    PanelState lose()
    {
        now += kPeriod;
        state = nextPanel(state, {.now = now, .closed = std::nullopt, .disturbed = {}});
        return state;
    }
    /// Keeps the same levels without an edge for that long.
    PanelState rest(const PerContact<bool>& closed, double seconds)
    {
        for (double end = now + seconds - kPeriod / 2; now < end;) poll(closed);
        return state;
    }
    /// Starts the panel, with every button open and STOP closed for long enough.
    Panel& ready()
    {
        rest(only({kStop}), 0.1);
        return *this;
    }

    double now = 1000.0;
    PanelState state;
    PerContact<int> presses;
};

TEST(Panel, assertsStopUntilItsContactHasBeenSeenClosedFor30Ms)
{
    EXPECT_TRUE(PanelState{}.stop) << "before anything is known";
    Panel panel;
    EXPECT_TRUE(panel.poll(only({kStop})).stop) << "at 0 ms";
    EXPECT_TRUE(panel.poll(only({kStop})).stop) << "at 10 ms";
    EXPECT_TRUE(panel.poll(only({kStop})).stop) << "at 20 ms";
    panel.poll(only({kStop}));
    EXPECT_FALSE(panel.poll(only({kStop})).stop);
    EXPECT_TRUE(panel.state.present);
}

TEST(Panel, assertsStopInTheVeryTickItsContactIsOpen)
{
    Panel panel = Panel().ready();
    ASSERT_FALSE(panel.state.stop);
    EXPECT_TRUE(panel.poll(only({})).stop);
}

TEST(Panel, assertsStopForAnOpeningBetweenTwoReadings)
{
    Panel panel = Panel().ready();
    EXPECT_TRUE(panel.poll(only({kStop}), only({kStop})).stop);
    EXPECT_TRUE(panel.poll(only({kStop})).stop);
    EXPECT_TRUE(panel.poll(only({kStop})).stop);
    panel.poll(only({kStop}));
    EXPECT_FALSE(panel.poll(only({kStop})).stop) << "closed and quiet for 30 ms";
}

TEST(Panel, assertsStopWhileItsContactBouncesForEver)
{
    Panel panel = Panel().ready();
    for (int i = 0; i < 1000; ++i) ASSERT_TRUE(panel.poll(only({kStop}), only({kStop})).stop) << i;
}

TEST(Panel, takesABrokenWireForAPressedStop)
{
    Panel panel;
    for (int i = 0; i < 1000; ++i) ASSERT_TRUE(panel.poll(only({})).stop) << i;
}

TEST(Panel, countsOnePressPerClosing)
{
    for (const PanelContact button : kPanelButtons) {
        Panel panel = Panel().ready();
        panel.rest(only({kStop, button}), 0.2);
        EXPECT_EQ(panel.presses[button], 1) << name(button);
        EXPECT_TRUE(panel.state.held(button));
        panel.rest(only({kStop}), 0.2);
        EXPECT_FALSE(panel.state.held(button));
        panel.rest(only({kStop, button}), 0.2);
        EXPECT_EQ(panel.presses[button], 2) << name(button);
        for (const PanelContact other : kPanelButtons)
            EXPECT_EQ(panel.presses[other], other == button ? 2 : 0) << name(other);
    }
}

TEST(Panel, reportsAPressInOneTickOnly)
{
    Panel panel = Panel().ready();
    int ticks = 0;
    for (int i = 0; i < 100; ++i) ticks += panel.poll(only({kStop, kAtem})).pressed[kAtem];
    EXPECT_EQ(ticks, 1);
}

TEST(Panel, takesNoPressBefore30MsWithoutAnEdge)
{
    Panel panel = Panel().ready();
    panel.rest(only({kStop, kApprove}), 0.03);
    EXPECT_EQ(panel.presses[kApprove], 0) << "seen closed at 0, 10 and 20 ms";
    panel.poll(only({kStop, kApprove}), only({kApprove}));
    panel.rest(only({kStop, kApprove}), 0.02);
    EXPECT_EQ(panel.presses[kApprove], 0) << "an edge began the wait anew";
    panel.rest(only({kStop, kApprove}), 0.02);
    EXPECT_EQ(panel.presses[kApprove], 1);
}

TEST(Panel, forgetsAPressThatIsShorterThan30Ms)
{
    Panel panel = Panel().ready();
    panel.rest(only({kStop, kRefuse}), 0.02);
    panel.rest(only({kStop}), 0.2);
    EXPECT_EQ(panel.presses[kRefuse], 0);
}

TEST(Panel, letsGoWithTheFirstEdge)
{
    Panel panel = Panel().ready();
    panel.rest(only({kStop, kApprove}), 0.1);
    ASSERT_TRUE(panel.state.held(kApprove));
    EXPECT_FALSE(panel.poll(only({kStop, kApprove}), only({kApprove})).held(kApprove));
}

TEST(Panel, takesAGlitchOfAHeldButtonForNoNewPress)
{
    Panel panel = Panel().ready();
    panel.rest(only({kStop, kApprove}), 0.1);
    panel.poll(only({kStop}), only({kApprove}));
    panel.rest(only({kStop, kApprove}), 0.1);
    EXPECT_EQ(panel.presses[kApprove], 1);
    EXPECT_TRUE(panel.state.held(kApprove)) << "the same press goes on";
}

TEST(Panel, ignoresAButtonHeldAtStartUntilItIsReleased)
{
    for (const PanelContact button : kPanelButtons) {
        Panel panel;
        panel.rest(only({kStop, button}), 5.0);
        EXPECT_EQ(panel.presses[button], 0);
        EXPECT_FALSE(panel.state.held(button));
        EXPECT_EQ(panel.state.contacts[button].phase, ButtonPhase::HeldAtStart);
        panel.rest(only({kStop}), 0.1);
        panel.rest(only({kStop, button}), 0.1);
        EXPECT_EQ(panel.presses[button], 1) << "let go and pressed";
        EXPECT_EQ(panel.state.contacts[button].phase, ButtonPhase::Pressed);
    }
}

TEST(Panel, countsAGlitchAtStartAsHeld)
{
    Panel panel;
    panel.poll(only({kStop}));
    panel.rest(only({kStop, kAtem}), 1.0);
    EXPECT_EQ(panel.presses[kAtem], 0);
    EXPECT_EQ(panel.state.contacts[kAtem].phase, ButtonPhase::HeldAtStart);
}

TEST(Panel, takesAButtonHeldForTenMinutesForStuck)
{
    Panel panel = Panel().ready();
    panel.rest(only({kStop, kApprove}), 600.0);
    EXPECT_TRUE(panel.state.held(kApprove));
    panel.rest(only({kStop, kApprove}), 0.1);
    EXPECT_FALSE(panel.state.held(kApprove));
    EXPECT_EQ(panel.state.contacts[kApprove].phase, ButtonPhase::Stuck);
    panel.poll(only({kStop}), only({kApprove}));
    panel.rest(only({kStop, kApprove}), 1.0);
    EXPECT_FALSE(panel.state.held(kApprove)) << "a glitch is no letting go";
    panel.rest(only({kStop}), 0.1);
    panel.rest(only({kStop, kApprove}), 0.1);
    EXPECT_TRUE(panel.state.held(kApprove));
    EXPECT_EQ(panel.presses[kApprove], 2);
}

TEST(Panel, isStoppedWithoutPressesWhenItIsLost)
{
    Panel panel = Panel().ready();
    panel.rest(only({kStop, kApprove}), 0.1);
    ASSERT_TRUE(panel.state.held(kApprove));
    panel.lose();
    EXPECT_FALSE(panel.state.present);
    EXPECT_TRUE(panel.state.stop);
    EXPECT_FALSE(panel.state.held(kApprove));
    EXPECT_EQ(panel.state.pressed, PerContact<bool>{});
}

TEST(Panel, restartsWhenItReturns)
{
    Panel panel = Panel().ready();
    panel.lose();
    EXPECT_TRUE(panel.poll(only({kStop, kApprove})).stop);
    EXPECT_TRUE(panel.state.present);
    panel.rest(only({kStop, kApprove}), 1.0);
    EXPECT_FALSE(panel.state.stop);
    EXPECT_EQ(panel.presses[kApprove], 0) << "held while it came back";
    EXPECT_EQ(panel.state.contacts[kApprove].phase, ButtonPhase::HeldAtStart);
}

TEST(Panel, refusesATimeThatIsNotFinite)
{
    for (const double now :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_THROW((void)nextPanel({}, {.now = now, .closed = only({}), .disturbed = {}}),
                     std::invalid_argument);
}

// ------------------------------------------------------------------- every arrow of a button's phases

struct Arrow {
    ButtonPhase from;
    bool closed;
    double quiet;  ///< [s] since the last change
    double held;   ///< [s] since the press
    ButtonPhase to;
};

TEST(ButtonPhases, followTheTable)
{
    using enum ButtonPhase;
    const std::vector<Arrow> table{
        {Starting, false, 0.02, 0.0, Starting},       {Starting, false, 0.03, 0.0, Released},
        {Starting, true, 0.02, 0.0, Starting},        {Starting, true, 0.03, 0.0, HeldAtStart},
        {Released, false, 0.00, 0.0, Released},       {Released, false, 9.00, 0.0, Released},
        {Released, true, 0.02, 0.0, Released},        {Released, true, 0.03, 0.0, Pressed},
        {Pressed, false, 0.02, 1.0, Pressed},         {Pressed, false, 0.03, 1.0, Released},
        {Pressed, true, 599.0, 599.9, Pressed},       {Pressed, true, 599.0, 600.1, Stuck},
        {Pressed, false, 0.01, 600.1, Stuck},         {Pressed, false, 0.03, 600.1, Released},
        {HeldAtStart, true, 900.0, 0.0, HeldAtStart}, {HeldAtStart, false, 0.02, 0.0, HeldAtStart},
        {HeldAtStart, false, 0.03, 0.0, Released},    {Stuck, true, 900.0, 900.0, Stuck},
        {Stuck, false, 0.02, 900.0, Stuck},           {Stuck, false, 0.03, 900.0, Released},
    };
    const double now = 5000.0;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Arrow& arrow = table[i];
        PanelState state;
        state.present = true;
        ContactState& button = state.contacts[kRefuse];
        button.phase = arrow.from;
        button.closed = arrow.closed;
        button.since = now - arrow.quiet;
        button.pressedAt = now - arrow.held;
        PerContact<bool> closed;
        closed[kRefuse] = arrow.closed;
        // 1 ns late, because the difference of two times is not exact
        state = nextPanel(state, {.now = now + 1e-9, .closed = closed, .disturbed = {}});
        EXPECT_EQ(state.contacts[kRefuse].phase, arrow.to) << "row " << i;
    }
}

// -------------------------------------------------------------------------------- bouncing contacts

/// Returns the edges of one bouncing contact: more than 16 within 1 ms, ending at `level`.
std::vector<double> bounce(double begin, bool changes, std::mt19937_64& rng)
{
    std::uniform_int_distribution<int> pairs(8, 40);
    std::uniform_real_distribution<double> within(0.0, 0.001);
    std::vector<double> edges(static_cast<std::size_t>(2 * pairs(rng) + (changes ? 1 : 0)));
    for (double& edge : edges) edge = begin + within(rng);
    std::sort(edges.begin(), edges.end());
    return edges;
}

/// Returns the contact's level at a time, from its first level and its edges.
bool levelAt(bool first, const std::vector<double>& edges, double time)
{
    const auto passed = std::upper_bound(edges.begin(), edges.end(), time) - edges.begin();
    return first != (passed % 2 != 0);
}

bool edgeBetween(const std::vector<double>& edges, double from, double to)
{
    const auto first = std::upper_bound(edges.begin(), edges.end(), from);
    return first != edges.end() && *first <= to;
}

TEST(BouncingContacts, endInTheRightStateIn100000RandomTraces)
{
    std::mt19937_64 rng(20160211);
    std::bernoulli_distribution coin(0.5);
    std::uniform_real_distribution<double> when(0.0, 0.05), period(0.0005, 0.01);
    for (int trace = 0; trace < 100'000; ++trace) {
        const PanelContact contact = kAllPanelContacts[static_cast<std::size_t>(trace) % 4];
        const bool first = coin(rng), changes = coin(rng), last = first != changes;
        Panel panel;
        PerContact<bool> closed = only({kStop});
        // A button is open first, so that the next closing is a press.
        panel.rest(closed, 0.05);
        closed[contact] = first;
        panel.rest(closed, 0.05);
        const int before = contact == kStop ? 0 : panel.presses[contact];

        const std::vector<double> edges = bounce(panel.now + when(rng), changes, rng);
        const double end = edges.back() + PanelLimits{}.settle + 0.0101;
        bool wasOpen = false;
        while (panel.now <= end) {
            const double from = panel.now;
            panel.now += period(rng) - kPeriod;  // poll() adds the period
            const double now = panel.now + kPeriod;
            closed[contact] = levelAt(first, edges, now);
            PerContact<bool> disturbed;
            disturbed[contact] = edgeBetween(edges, from, now);
            panel.poll(closed, disturbed);
            if (disturbed[contact] || !closed[contact]) {
                wasOpen = true;
                ASSERT_FALSE(panel.state.contacts[contact].trusted) << "trace " << trace;
            }
        }
        ASSERT_TRUE(wasOpen);
        ASSERT_EQ(panel.state.contacts[contact].closed, last) << "trace " << trace;
        ASSERT_EQ(panel.state.contacts[contact].trusted, last) << "trace " << trace;
        if (contact == kStop) {
            ASSERT_EQ(panel.state.stop, !last) << "trace " << trace;
        } else {
            ASSERT_EQ(panel.state.held(contact), last) << "trace " << trace;
            ASSERT_EQ(panel.presses[contact] - before, !first && last ? 1 : 0) << "trace " << trace;
        }
    }
}

// -------------------------------------------------------------------------------- words and lamps

TEST(PanelWords, nameEveryButtonsFault)
{
    for (const PanelContact c : kPanelButtons) {
        const std::string held = buttonTrouble(c, ButtonPhase::HeldAtStart).english();
        EXPECT_NE(held.find(name(c)), std::string::npos) << held;
        EXPECT_NE(held.find("until it is released"), std::string::npos) << held;
        EXPECT_NE(buttonTrouble(c, ButtonPhase::Stuck).english(), held);
        for (const ButtonPhase fine :
             {ButtonPhase::Starting, ButtonPhase::Released, ButtonPhase::Pressed})
            EXPECT_TRUE(buttonTrouble(c, fine).empty());
    }
}

TEST(LampTest, lightsEachOutputAloneInTheOrderOfItsNames)
{
    std::vector<std::array<bool, kPanelOutputs>> seen;
    for (int ms = 0; ms < 5000; ms += 10) {
        const auto lamps = lampTest(ms / 1000.0);
        if (!lamps) break;
        const auto outputs = outputsOf(*lamps);
        if (seen.empty() || seen.back() != outputs) seen.push_back(outputs);
    }
    const std::vector<std::array<bool, kPanelOutputs>> expected{{true, false, false, false},
                                                                {false, true, false, false},
                                                                {false, false, true, false},
                                                                {false, false, false, true},
                                                                {false, false, false, false}};
    EXPECT_EQ(seen, expected);
}

TEST(LampTest, isOverAfter1300Ms)
{
    EXPECT_TRUE(lampTest(0.0));
    EXPECT_TRUE(lampTest(1.29));
    for (const double elapsed : {-0.01, 1.31, 1e9, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_FALSE(lampTest(elapsed)) << elapsed;
}

}  // namespace
}  // namespace terratact
