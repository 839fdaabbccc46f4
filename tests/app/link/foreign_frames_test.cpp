// Tests frames that a DBC file describes: values, rates, ages and freshness.
#include "app/link/foreign_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "app/link/frame_history.h"
#include "tests/support/devices/frame_tap.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

/// Frames of a payload described by a DBC file: 100 Hz; even numbers belong to group 0.
struct Described : Tapping {
    Described()
    {
        const TemporaryDirectory directory;
        auto book = std::make_shared<DbcBook>();
        EXPECT_TRUE(book->add(directory.write(
            "gas.dbc", "BO_ 291 Gas: 8 P\n SG_ Group M : 0|8@1+ (1,0) [0|0] \"\" C\n"
                       " SG_ Oxygen : 15|16@0- (0.01,0) [0|0] \"%\" C\n"
                       " SG_ Even m0 : 24|8@1+ (1,0) [0|0] \"\" C\n"
                       " SG_ Odd m1 : 24|8@1+ (1,0) [0|0] \"\" C\n"
                       "BO_ 292 Slow: 1 P\n SG_ Count : 0|8@1+ (1,0) [0|0] \"\" C\n"
                       "BO_ 293 Turns: 2 P\n SG_ Turn M : 0|8@1+ (1,0) [0|0] \"\" C\n"
                       " SG_ Third m3 : 8|8@1+ (1,0) [0|0] \"\" C\n"
                       "BA_ \"GenMsgCycleTime\" BO_ 292 1000;\n"
                       "BA_ \"GenMsgCycleTime\" BO_ 293 100;\n")));
        tap.describe(book);
    }
    static BusFrame gas(std::uint8_t group, double oxygen, std::uint8_t value, double time)
    {
        const auto raw = static_cast<std::uint16_t>(std::lround(100.0 * oxygen));
        return {.frame = {.id = 291,
                          .length = 4,
                          .data = {group, static_cast<std::uint8_t>(raw >> 8U),
                                   static_cast<std::uint8_t>(raw & 0xFFU), value}},
                .time = time};
    }
    TappedFrame described(std::uint32_t id, double now) const
    {
        for (const TappedFrame& frame : tap.frames(now))
            if (frame.described && frame.newest.id == id) return frame;
        ADD_FAILURE() << "no such frame";
        return {};
    }
};

TEST_F(Described, haveValuesExtremesRatesAgesAndHistories)
{
    for (int i = 0; i < 300; ++i) {
        const double time = 0.01 * i;
        add(gas(static_cast<std::uint8_t>(i % 2), i < 100 ? 20.5 : -1.25,
                static_cast<std::uint8_t>(i), time));
        tap.tick(time);
    }
    const TappedFrame frame = described(291, 3.0);
    EXPECT_EQ(frame.described->message.name, "Gas");
    ASSERT_EQ(frame.payload.size(), 4U);
    EXPECT_EQ(frame.payload[1].last, -1.25);
    EXPECT_EQ(frame.payload[1].least, -1.25);
    EXPECT_EQ(frame.payload[1].most, 20.5);
    EXPECT_NEAR(frame.rate, 100.0, 5.0);
    EXPECT_NEAR(frame.times[1].rate, 100.0, 5.0);
    EXPECT_NEAR(frame.times[2].rate, 50.0, 3.0) << "in every other frame";
    EXPECT_NEAR(frame.times[2].age.value(), 0.02, 1e-9);
    EXPECT_NEAR(frame.times[3].age.value(), 0.01, 1e-9);
    EXPECT_EQ(frame.payload[3].last, 299.0 - 256.0);
    EXPECT_FLOAT_EQ(frame.payload[1].history.back(), -1.25F);
    EXPECT_FLOAT_EQ(frame.payload[1].history[TappedSignal::kPoints - 25], 20.5F);
    EXPECT_TRUE(std::isnan(frame.payload[1].history[0])) << "before the beginning";
    EXPECT_EQ(tap.trace().back().trouble, FrameTrouble::None) << "somebody knows it";
    EXPECT_EQ(tap.load().troubles[static_cast<std::size_t>(FrameTrouble::Unknown)], 0U);
    tap.forgetExtremes();
    EXPECT_FALSE(described(291, 3.0).payload[1].least);
}

TEST_F(Described, aSignalThatIsNoLongerSelectedGrowsOld)
{
    for (int i = 0; i < 400; ++i) {
        add(gas(i < 100 ? static_cast<std::uint8_t>(i % 2) : 0, 20.0, 7, 0.01 * i));
        tap.tick(0.01 * i);
    }
    const TappedFrame frame = described(291, 4.0);
    EXPECT_NEAR(frame.age.value(), 0.01, 1e-9);
    EXPECT_NEAR(frame.times[3].age.value(), 3.01, 1e-9);
    EXPECT_LT(frame.times[3].fresh, 3.0);
    EXPECT_EQ(frame.times[3].rate, 0.0);
    EXPECT_TRUE(std::isnan(frame.payload[3].history.back()));
    EXPECT_FLOAT_EQ(frame.payload[2].history.back(), 7.0F);
}

TEST_F(Described, areFreshForThreeOfTheirPeriods)
{
    add({.frame = {.id = 292, .length = 1, .data = {9}}, .time = 0.0});
    for (int i = 0; i < 29; ++i) tap.tick(0.1 * i);
    EXPECT_NEAR(described(292, 2.8).times[0].fresh, 3.0, 1e-9) << "the file's, of one frame alone";
    EXPECT_FLOAT_EQ(described(292, 2.8).payload[0].history.back(), 9.0F) << "no gaps between";
    for (int i = 29; i < 40; ++i) tap.tick(0.1 * i);
    EXPECT_TRUE(std::isnan(described(292, 3.9).payload[0].history.back()));
}

TEST_F(Described, areNotFreshAgainOnceTheyHaveEnded)
{
    constexpr double kPeriod = 0.1;
    for (int i = 0; i < 20; ++i) {
        add(gas(0, 20.0, 7, kPeriod * i));
        tap.tick(kPeriod * i);
    }
    const double ended = 19 * kPeriod;
    for (int i = 1; i < 60; ++i) {
        const double now = ended + 0.05 * i;
        tap.tick(now);
        EXPECT_NEAR(described(291, now).times[1].fresh, 3 * kPeriod, 1e-9) << now;
    }
}

TEST_F(Described, areFreshUntilTheirNextTurn)
{
    for (int i = 0; i < 40; ++i) {
        add({.frame = {.id = 293, .length = 2, .data = {static_cast<std::uint8_t>(i % 10), 7}},
             .time = 0.1 * i});
        tap.tick(0.1 * i);
        if (i < 20) continue;  // each group has had two turns
        const TappedFrame frame = described(293, 0.1 * i);
        EXPECT_NEAR(frame.times[0].fresh, 0.3, 1e-9) << "the file's";
        EXPECT_LE(frame.times[1].age.value(), frame.times[1].fresh) << i;
        EXPECT_FLOAT_EQ(frame.payload[1].history.back(), 7.0F) << "no gaps between, " << i;
    }
}

TEST_F(Described, anOutageIsNoPeriod)
{
    double time = 0.0;
    const auto run = [&](int frames, double interval) {
        for (int i = 0; i < frames; ++i) add(gas(0, 20.0, 7, time += interval));
    };
    const auto fresh = [&] { return described(291, time).times[1].fresh; };
    run(20, 0.1);
    run(1, 600.0);
    EXPECT_NEAR(fresh(), 0.3, 1e-9) << "the first after it";
    run(20, 0.1);
    EXPECT_NEAR(fresh(), 0.3, 1e-9);
    run(2, 4.0);
    EXPECT_NEAR(fresh(), 12.0, 1e-9) << "it has become rarer";
    run(1, 21.0);
    run(1, 900.0);
    EXPECT_NEAR(fresh(), 3.0 * UsualInterval::kMax, 1e-9) << "whatever comes";
}

TEST_F(Described, anOutageBeforeThereWasAnyPeriodIsNoneEither)
{
    double time = 0.0;
    for (const double interval : {0.0, 600.0, 0.1, 0.1}) add(gas(0, 20.0, 7, time += interval));
    EXPECT_NEAR(described(291, time).times[1].fresh, 0.3, 1e-9);
}

TEST_F(Described, aBurstIsNoPeriod)
{
    double time = 0.0;
    for (int burst = 0; burst < 4; ++burst) {
        time += 2.0;
        for (int i = 0; i < 5; ++i) add(gas(0, 20.0, 7, time += 0.001));
    }
    EXPECT_NEAR(described(291, time).times[1].fresh, 6.0, 0.01);
}

TEST_F(Described, needsAllBytesOfASignal)
{
    add({.frame = {.id = 291, .length = 2, .data = {0, 7}}, .time = 0.0});
    const TappedFrame frame = described(291, 0.0);
    EXPECT_EQ(frame.payload[0].last, 0.0);
    EXPECT_FALSE(frame.payload[1].last);
    EXPECT_FALSE(frame.times[1].age);
}

TEST_F(Described, areRawBytesWithoutTheirDbcFile)
{
    add(gas(0, 20.0, 1, 0.0));
    tap.describe(nullptr);
    EXPECT_TRUE(tap.frames(0.0).empty()) << "forgotten";
    add(gas(0, 20.0, 1, 0.1));
    ASSERT_EQ(tap.frames(0.1).size(), 1U);
    EXPECT_FALSE(tap.frames(0.1)[0].described);
    EXPECT_EQ(tap.trace().back().trouble, FrameTrouble::Unknown);
    EXPECT_EQ(tap.trace().front().trouble, FrameTrouble::None) << "as it was judged then";
}

}  // namespace
}  // namespace terratact
