#include "app/link/acquisition.h"

#include <gtest/gtest.h>

#include <mutex>
#include <vector>

#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"

namespace terratact {
namespace {

TEST(AcquisitionTest, keepsTheNewestOnly)
{
    ScriptedSource source;
    const Acquisition acquisition(source);
    ASSERT_TRUE(
        gui::eventually([&] { return acquisition.latest() && acquisition.latest()->count > 20; }));
    const auto first = acquisition.latest();
    ASSERT_TRUE(gui::eventually([&] { return acquisition.latest()->count > first->count; }));
    const auto second = acquisition.latest();
    EXPECT_EQ(second->sample.measurement.time - first->sample.measurement.time,
              static_cast<double>(second->count - first->count));
    EXPECT_GE(second->arrived, first->arrived);
    EXPECT_GT(acquisition.rate(), 5.0);
}

TEST(AcquisitionTest, notifiesOfEverySampleAfterItIsTheLatest)
{
    ScriptedSource source;
    source.setSilent(true);
    std::mutex mutex;
    std::vector<std::uint64_t> counts;
    const Acquisition* reader = nullptr;
    const auto heard = [&] {
        const std::scoped_lock lock(mutex);
        counts.push_back(reader->latest()->count);
    };
    const Acquisition acquisition(source, heard);
    {
        const std::scoped_lock lock(mutex);
        reader = &acquisition;
    }
    source.setSilent(false);
    constexpr std::size_t kEnough = 10;
    ASSERT_TRUE(gui::eventually([&] {
        const std::scoped_lock lock(mutex);
        return counts.size() >= kEnough;
    }));
    source.setSilent(true);
    ASSERT_TRUE(gui::eventually([&] {
        return std::chrono::steady_clock::now() - acquisition.latest()->arrived
             > std::chrono::milliseconds(200);
    }));
    const std::scoped_lock lock(mutex);
    EXPECT_EQ(counts.size(), acquisition.latest()->count);
    for (std::size_t n = 0; n < counts.size(); ++n) EXPECT_EQ(counts[n], n + 1);
}

TEST(AcquisitionTest, silenceLeavesTheLastAndItsAge)
{
    ScriptedSource source;
    const Acquisition acquisition(source);
    ASSERT_TRUE(gui::eventually([&] { return acquisition.latest().has_value(); }));
    source.setSilent(true);
    const auto age = [&] {
        return std::chrono::steady_clock::now() - acquisition.latest()->arrived;
    };
    EXPECT_TRUE(gui::eventually([&] { return age() > std::chrono::milliseconds(200); }));
    EXPECT_TRUE(gui::eventually([&] { return acquisition.rate() == 0.0; }));
}

TEST(AcquisitionTest, sourceErrorIsReportedUntilTheNextTelemetry)
{
    ScriptedSource source;
    source.setTrouble("can0 is down");
    const Acquisition acquisition(source);
    ASSERT_TRUE(gui::eventually([&] { return acquisition.trouble().english() == "can0 is down"; }));
    EXPECT_FALSE(acquisition.latest());
    source.setTrouble("");
    EXPECT_TRUE(
        gui::eventually([&] { return acquisition.latest() && acquisition.trouble().empty(); }));
}

TEST(AcquisitionTest, endsPromptlyOnASilentSource)
{
    ScriptedSource source;
    source.setSilent(true);
    QElapsedTimer timer;
    {
        const Acquisition acquisition(source);
        timer.start();
    }
    EXPECT_LT(timer.elapsed(), 2000);
}

TEST(AcquisitionTest, aPressIsRememberedFromItsFirstLineToItsEnd)
{
    using enum RobotActivity;
    std::optional<Received> latest;
    std::vector<std::uint64_t> began;  // 0: not pressed
    for (const RobotActivity activity : {Halted, Probing, Pressing, Pressed, Pressed, Probing,
                                         Pressed, Pressing, Pressed, Driving, Stopped}) {
        Measurement m;
        m.activity = activity;
        m.time = static_cast<double>(began.size() + 1);
        latest = received(latest, {.measurement = m, .truth = std::nullopt}, {});
        EXPECT_EQ(latest->count, began.size() + 1);
        began.push_back(latest->press ? latest->press->count : 0);
        if (latest->press) {
            EXPECT_EQ(latest->press->sample.measurement.time,
                      static_cast<double>(latest->press->count));
        }
    }
    EXPECT_EQ(began, (std::vector<std::uint64_t>{0, 0, 0, 4, 4, 4, 4, 0, 9, 0, 0}));
}

TEST(AcquisitionTest, suspendCountsAsTelemetrySilence)
{
    const auto unbrokenFrom = [](double steady, double sleepless) {
        std::optional<Received> latest;
        for (int i = 0; i < 3; ++i) {
            const double late = i == 2 ? 1.0 : 0.0;
            const std::chrono::duration<double> at(0.05 * i + late * steady);
            latest = received(latest, {},
                              {SteadyTime(std::chrono::duration_cast<SteadyTime::duration>(at)),
                               0.05 * i + late * sleepless});
        }
        return latest->unbrokenFrom;
    };
    EXPECT_EQ(unbrokenFrom(0.9, 0.9), 1U);
    EXPECT_EQ(unbrokenFrom(1.1, 1.1), 3U);
    EXPECT_EQ(unbrokenFrom(0.0, 60.0), 3U);
}

}  // namespace
}  // namespace terratact
