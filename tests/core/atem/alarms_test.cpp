#include "core/atem/alarms.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace terratact {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Events of one alarm: 'r'aise, 'c'lear, 'a'cknowledge.
struct Life {
    std::string events;
    std::optional<AlarmState> then;  ///< empty: gone
};

struct LifeCycle : testing::TestWithParam<Life> {};

TEST_P(LifeCycle, endsAsDrawn)
{
    AlarmList list;
    double now = 0.0;
    for (const char event : GetParam().events) {
        now += 1.0;
        if (event == 'r')
            list.raise("link", Message::verbatim("link lost"), Severity::Critical, now);
        if (event == 'c') list.clear("link", now);
        if (event == 'a') list.acknowledge("link");
    }
    const auto& alarms = list.alarms();
    ASSERT_EQ(alarms.size(), GetParam().then ? 1U : 0U);
    if (GetParam().then) {
        EXPECT_EQ(alarms[0].state, *GetParam().then);
    }
}

using S = AlarmState;
INSTANTIATE_TEST_SUITE_P(EveryArrow, LifeCycle,
                         testing::Values(Life{"", {}}, Life{"c", {}}, Life{"a", {}},
                                         Life{"r", S::Unacknowledged},
                                         Life{"rr", S::Unacknowledged}, Life{"ra", S::Acknowledged},
                                         Life{"rar", S::Acknowledged}, Life{"raa", S::Acknowledged},
                                         Life{"rc", S::Returned}, Life{"rcc", S::Returned},
                                         Life{"rcr", S::Unacknowledged}, Life{"rca", {}},
                                         Life{"rac", {}}, Life{"racr", S::Unacknowledged},
                                         Life{"racra", S::Acknowledged}),
                         [](const auto& test) { return "on_" + test.param.events; });

/// A minute with events at some seconds, and the seconds at which the alarm then sounds.
struct Minute {
    std::string name;
    std::vector<std::pair<double, std::string>> events;
    std::vector<double> sounds;
};

struct Sounds : testing::TestWithParam<Minute> {};

void apply(AlarmList& list, const std::string& event, double now)
{
    const std::string id = event.substr(1);
    switch (event[0]) {
    case '!': list.raise(id, Message::verbatim(id), Severity::Critical, now); break;
    case '?': list.raise(id, Message::verbatim(id), Severity::Caution, now); break;
    case '-': list.clear(id, now); break;
    case 'a': list.acknowledgeAll(); break;
    case 's': list.silence(now + 60.0); break;
    default: FAIL() << event;
    }
}

TEST_P(Sounds, followNewAlarmsAndTheirPeriod)
{
    AlarmList list;
    std::vector<double> sounds;
    for (int second = 1; second <= 60; ++second) {
        for (const auto& [at, event] : GetParam().events)
            if (at == second) apply(list, event, second);
        if (list.consumeSound(second)) sounds.push_back(second);
        EXPECT_FALSE(list.consumeSound(second)) << "it has sounded already";
    }
    EXPECT_EQ(sounds, GetParam().sounds);
}

INSTANTIATE_TEST_SUITE_P(
    Minutes, Sounds,
    testing::Values(
        Minute{"nothing", {}, {}}, Minute{"untilSeen", {{5, "!link"}, {27, "a"}}, {5, 15, 25}},
        Minute{"aCautionIsSilent", {{5, "?drops"}}, {}},
        Minute{"aCautionThatGrowsWorse", {{5, "?bus"}, {8, "!bus"}, {9, "a"}}, {8}},
        Minute{"noneOnReturn", {{5, "!link"}, {8, "-link"}}, {5}},
        Minute{"aSecondOneAtOnce", {{5, "!link"}, {7, "!panel"}, {20, "a"}}, {5, 7, 17}},
        Minute{"oneEventSoundsOnce", {{5, "!bus"}, {6, "!link"}, {20, "a"}}, {5, 15}},
        Minute{"manyAtOnceSoundOnce", {{5, "!link"}, {5, "!panel"}, {6, "a"}}, {5}},
        Minute{
            "oneThatFlutters",
            {{5, "!link"}, {6, "-link"}, {7, "!link"}, {8, "-link"}, {9, "!link"}, {10, "-link"}},
            {5}},
        Minute{"acknowledgedAndBackSoon",
               {{5, "!link"}, {6, "a"}, {7, "-link"}, {8, "!link"}, {20, "a"}},
               {5, 15}},
        Minute{"silence", {{5, "!link"}, {7, "s"}}, {5}},
        Minute{"newAlarmBreaksTheSilence",
               {{5, "!link"}, {7, "s"}, {30, "!panel"}, {33, "a"}},
               {5, 30}},
        Minute{"aFlutteringOneDoesNot", {{5, "!link"}, {7, "s"}, {8, "-link"}, {9, "!link"}}, {5}}),
    [](const auto& test) { return test.param.name; });

TEST(AlarmList, soundsAgainWhenTheSilenceIsOver)
{
    AlarmList list;
    list.raise("link", Message::verbatim(""), Severity::Critical, 0.0);
    EXPECT_TRUE(list.consumeSound(0.0));
    list.silence(120.0);
    EXPECT_DOUBLE_EQ(list.silentFor(20.0), 100.0);
    EXPECT_FALSE(list.consumeSound(119.0));
    EXPECT_TRUE(list.consumeSound(120.0));
    EXPECT_DOUBLE_EQ(list.silentFor(121.0), 0.0);
}

TEST(AlarmList, sortsTheMostUrgentFirst)
{
    AlarmList list;
    list.raise("seen", Message::verbatim(""), Severity::Critical, 1.0);
    list.acknowledge("seen");
    list.raise("gone", Message::verbatim(""), Severity::Critical, 2.0);
    list.clear("gone", 3.0);
    list.raise("old", Message::verbatim(""), Severity::Critical, 4.0);
    list.raise("new", Message::verbatim(""), Severity::Critical, 5.0);
    list.raise("caution", Message::verbatim(""), Severity::Caution, 6.0);
    std::vector<std::string> order;
    for (const Alarm& alarm : list.alarms()) order.push_back(alarm.id);
    EXPECT_EQ(order, (std::vector<std::string>{"new", "old", "caution", "gone", "seen"}));
    EXPECT_EQ(list.count(AlarmState::Unacknowledged), 3U);
    list.acknowledgeAll();
    EXPECT_EQ(list.alarms().size(), 4U) << "what has returned is gone once it was seen";
    EXPECT_EQ(list.count(AlarmState::Acknowledged), 4U);
}

TEST(AlarmList, keepsTheNewestTextAndCountsHowOftenItCame)
{
    AlarmList list;
    list.raise("link", Message::verbatim("for 1 s"), Severity::Critical, 1.0);
    list.raise("link", Message::verbatim("for 2 s"), Severity::Critical, 2.0);
    EXPECT_EQ(list.alarms()[0].text.english(), "for 2 s");
    EXPECT_EQ(list.alarms()[0].since, 1.0);
    list.clear("link", 3.0);
    EXPECT_EQ(list.alarms()[0].returned, 3.0);
    list.raise("link", Message::verbatim("again"), Severity::Critical, 4.0);
    EXPECT_EQ(list.alarms()[0].since, 4.0);
    EXPECT_EQ(list.alarms()[0].raised, 2U);
}

TEST(AlarmList, timeCountsFromWhenTheCauseBecameWorse)
{
    AlarmList list;
    const auto raise = [&](Severity severity, double now) {
        list.raise("attitude", Message::verbatim("steep"), severity, now);
        return list.alarms()[0].since;
    };
    EXPECT_EQ(raise(Severity::Caution, 1.0), 1.0);
    EXPECT_EQ(raise(Severity::Caution, 2.0), 1.0);
    EXPECT_EQ(raise(Severity::Critical, 40.0), 40.0);
    EXPECT_EQ(raise(Severity::Critical, 41.0), 40.0);
    EXPECT_EQ(raise(Severity::Caution, 50.0), 40.0) << "it did not begin again";
    EXPECT_EQ(list.alarms()[0].raised, 1U);
}

TEST(AlarmList, dropsTheLeastUrgentWhenFull)
{
    AlarmList list;
    list.raise("returned", Message::verbatim(""), Severity::Critical, 0.0);
    list.clear("returned", 0.0);
    for (std::size_t i = 0; i < AlarmList::kMax; ++i)
        list.raise(std::to_string(i), Message::verbatim(""), Severity::Critical,
                   1.0 + static_cast<double>(i));
    ASSERT_EQ(list.alarms().size(), AlarmList::kMax);
    for (const Alarm& alarm : list.alarms()) EXPECT_NE(alarm.id, "returned");
}

TEST(AlarmList, refusesTimesThatAreNotFinite)
{
    AlarmList list;
    EXPECT_THROW(list.raise("x", Message::verbatim(""), Severity::Caution, kNaN),
                 std::invalid_argument);
    EXPECT_THROW(list.clear("x", kNaN), std::invalid_argument);
    EXPECT_THROW(list.silence(std::numeric_limits<double>::infinity()), std::invalid_argument);
    EXPECT_THROW((void)list.consumeSound(kNaN), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
