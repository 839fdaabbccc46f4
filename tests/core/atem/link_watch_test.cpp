#include "core/atem/link_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace terratact {
namespace {

struct Watching : testing::Test {
    LinkWatch watch;
    double now = 100.0, heard = 100.0;  ///< [s]
    bool othersCome = false;
    std::vector<std::string> said;  ///< each text that differs from the one before it

    void poll(bool comes)
    {
        now += 0.04;
        if (comes) heard = now;
        const LinkAccount& link = watch.poll({.now = now,
                                              .age = now - heard,
                                              .alive = now - heard <= 0.25,
                                              .othersCome = othersCome});
        if (said.empty() || said.back() != describe(link).english)
            said.push_back(describe(link).english);
    }
    void pass(double seconds, bool comes)
    {
        for (const double until = now + seconds; now < until;) poll(comes);
    }
};

using Said = std::vector<std::string>;

TEST_F(Watching, isSilentUntilTheFirstTelemetryAndUpWithIt)
{
    EXPECT_STREQ(describe(watch.poll({.now = 1.0})).english, "no telemetry yet");
    poll(true);
    EXPECT_EQ(watch.account(), (LinkAccount{.standing = LinkStanding::Up, .alive = true}));
}

TEST_F(Watching, reportsALossAtOnceAndItsEndAfterASecond)
{
    pass(2.0, true);
    pass(0.3, false);
    EXPECT_FALSE(watch.account().alive);
    pass(0.9, true);
    EXPECT_TRUE(watch.account().alive) << "at once";
    EXPECT_EQ(said, (Said{"link is up", "link lost"})) << "not steady yet";
    pass(0.2, true);
    EXPECT_EQ(said.back(), "link is up");
    EXPECT_EQ(watch.account().gaps, 1);
}

TEST_F(Watching, unsteadyLinkIsOneEventWithACount)
{
    pass(2.0, true);
    for (int i = 0; i < 7; ++i) {
        pass(0.4, false);
        pass(0.5, true);
    }
    EXPECT_EQ(said, (Said{"link is up", "link lost", "link unsteady"}));
    EXPECT_EQ(watch.account().gaps, 7);
    EXPECT_NEAR(watch.account().longest, 0.4, 0.05);
    pass(1.0, true);
    EXPECT_EQ(said.back(), "link is up");
    EXPECT_EQ(watch.account().gaps, 7) << "for whoever tells of its end";
    pass(0.4, false);
    EXPECT_EQ(watch.account().gaps, 1) << "another trouble";
    EXPECT_EQ(said.back(), "link lost");
}

TEST_F(Watching, longSilenceIsALossWhateverCameBefore)
{
    pass(1.0, true);
    for (int i = 0; i < 2; ++i) {
        pass(0.4, false);
        pass(0.3, true);
    }
    EXPECT_EQ(said.back(), "link unsteady");
    pass(0.9, false);
    EXPECT_EQ(said.back(), "link unsteady");
    pass(0.2, false);
    EXPECT_EQ(said.back(), "link lost");
}

TEST_F(Watching, missingTelemetryAloneIsNoLostLink)
{
    pass(1.0, true);
    othersCome = true;
    pass(0.5, false);
    pass(0.5, true);
    pass(0.5, false);
    EXPECT_EQ(said, (Said{"link is up", "telemetry lost", "telemetry unsteady"}));
    othersCome = false;
    pass(1.0, false);
    EXPECT_EQ(said.back(), "link lost");
}

TEST_F(Watching, endOfALogIsNoLoss)
{
    pass(1.0, true);
    pass(0.5, false);
    EXPECT_STREQ(describe(watch.poll({.now = now, .age = 0.5, .ended = true})).english,
                 "end of the log");
    EXPECT_EQ(watch.account().gaps, 0);
}

TEST_F(Watching, refusesTimesThatAreNotFinite)
{
    EXPECT_THROW((void)watch.poll({.now = std::nan("")}), std::invalid_argument);
    EXPECT_THROW((void)watch.poll({.now = 1.0, .age = INFINITY}), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
