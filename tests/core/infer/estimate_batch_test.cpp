#include "core/infer/estimate_batch.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <stdexcept>
#include <vector>

#include "tests/support/toy_clearance.h"

namespace terratact {
namespace {

ModelData everyMethod()
{
    ModelData model = toyModel();
    const ClearanceConditionalData data =
        plausibleConditionals(clearanceTraining(model, absolem()));
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        model.clearance.conditionalOpen[i] = data.at(bin, Regime::Open).hyper;
        model.clearance.conditionalCovered[i] = data.at(bin, Regime::Covered).hyper;
    }
    return model;
}

struct BatchBench {
    RobotModel robot = absolem();
    Models models{everyMethod(), robot};
    std::vector<Scene> scenes = someScenes(3, 42);
};

const BatchBench& batchBench()
{
    static const BatchBench shared;
    return shared;
}

/// A scene with a reading of the arm, or none.
struct Task {
    Scene scene;
    std::vector<ArmReading> arm;
    Settings settings;
};

/// Scenes that differ in their known bins, in their number of chains and in their end.
std::vector<Task> tasks(Method method, ScanOrder scan, int chains)
{
    std::vector<Task> all;
    for (std::size_t k = 0; k < 9; ++k) {
        Task task{batchBench().scenes[k], {}, {}};
        if (k % 3 == 1) task.arm.push_back({static_cast<int>(k), -0.1, 0.0005});
        task.settings.method = method;
        task.settings.scan = scan;
        task.settings.chains = chains;
        task.settings.draws = 30 * chains;  // the first check comes after 25 sweeps of each chain
        task.settings.burnIn = static_cast<int>(k);
        task.settings.stopEarly = k % 2 == 0;
        task.settings.precision = k == 4 ? Precision::Double : Precision::Single;
        task.settings.seed = 10 + k;
        all.push_back(std::move(task));
    }
    return all;
}

std::vector<TerrainEstimate> alone(const std::vector<Task>& tasks)
{
    std::vector<TerrainEstimate> estimates;
    for (const Task& t : tasks)
        estimates.push_back(
            estimateTerrain(t.scene.s, t.arm, batchBench().robot, batchBench().models, t.settings));
    return estimates;
}

void add(EstimateBatch& batch, const std::vector<Task>& tasks, std::size_t k,
         const Watch& watch = {})
{
    batch.add(k, tasks[k].scene.s, tasks[k].arm, tasks[k].settings, watch);
}

struct Batched {
    std::vector<TerrainEstimate> estimates;
    std::size_t most = 0;           ///< scenes at once
    std::vector<std::size_t> left;  ///< scenes in the order of their end
};

Batched together(const std::vector<Task>& tasks)
{
    Batched result{std::vector<TerrainEstimate>(tasks.size()), 0, {}};
    EstimateBatch batch(batchBench().robot, batchBench().models);
    std::size_t next = 0;
    while (true) {
        while (next < tasks.size() && batch.hasRoomFor(tasks[next].settings))
            add(batch, tasks, next++);
        result.most = std::max(result.most, next - result.left.size());
        if (batch.empty()) return result;
        for (auto& [number, estimate] : batch.next()) {
            result.estimates[number] = std::move(estimate);
            result.left.push_back(number);
        }
    }
}

TEST(EstimateBatch, givesEverySceneTheEstimateItHasAlone)
{
    for (const Method method : {Method::Pa, Method::Pafc, Method::Clearance})
        for (const ScanOrder scan : {ScanOrder::Forward, ScanOrder::Reverse, ScanOrder::Random})
            for (const int chains : {3, 8, 13}) {
                if (scan == ScanOrder::Random && chains != 8) continue;
                const auto scenes = tasks(method, scan, chains);
                const Batched batched = together(scenes);
                EXPECT_EQ(batched.estimates, alone(scenes))
                    << name(method) << ' ' << static_cast<int>(scan) << ' ' << chains;
                const std::size_t fits = static_cast<std::size_t>(kBatchChains / chains);
                EXPECT_EQ(batched.most,
                          scan == ScanOrder::Random ? 1 : std::min(fits, scenes.size()));
            }
}

TEST(EstimateBatch, leavesScenesAloneThatGainNothing)
{
    for (const auto& [chains, inducing, most] :
         {std::array{8, 0, 8}, std::array{8, 40, 1}, std::array{8, kFewRows + 1, 8},
          std::array{4, 40, 9}, std::array{64, 0, 1}}) {
        auto scenes = tasks(Method::Pafc, ScanOrder::Forward, chains);
        for (Task& task : scenes) {
            task.settings.inducing = inducing;
            task.settings.draws = 4 * chains;
        }
        const Batched batched = together(scenes);
        EXPECT_EQ(batched.most, static_cast<std::size_t>(most)) << chains << ' ' << inducing;
        EXPECT_EQ(batched.estimates, alone(scenes));
    }
}

TEST(EstimateBatch, replacesAnEndedSceneWithTheNext)
{
    auto scenes = tasks(Method::Pafc, ScanOrder::Forward, 32);  // two at once
    for (std::size_t k = 0; k < 4; ++k) {
        scenes[k].settings.stopEarly = false;
        scenes[k].settings.burnIn = 0;
        scenes[k].settings.draws = 32 * (k == 0 ? 60 : 10);
    }
    scenes.resize(4);
    const Batched batched = together(scenes);
    EXPECT_EQ(batched.left, (std::vector<std::size_t>{1, 2, 3, 0}));
    EXPECT_EQ(batched.estimates, alone(scenes));
}

TEST(EstimateBatch, takesScenesWithNothingToSample)
{
    auto scenes = tasks(Method::Pafc, ScanOrder::Forward, 4);
    scenes.resize(3);
    scenes[0].settings.method = Method::Local;
    for (int bin = 0; bin < kBins; ++bin) scenes[1].arm.push_back({bin, -0.1, 0.01});
    EstimateBatch batch(batchBench().robot, batchBench().models);
    for (std::size_t k = 0; k < scenes.size(); ++k) add(batch, scenes, k);
    EXPECT_FALSE(batch.hasRoomFor(scenes[0].settings));  // an estimate is ready
    std::set<std::size_t> seen;
    const auto expected = alone(scenes);
    while (!batch.empty())
        for (const auto& [number, estimate] : batch.next()) {
            EXPECT_EQ(estimate, expected[number]);
            seen.insert(number);
        }
    EXPECT_EQ(seen.size(), 3U);
    EXPECT_TRUE(batch.next().empty());
}

TEST(EstimateBatch, isUnchangedByARefusedScene)
{
    auto scenes = tasks(Method::Pafc, ScanOrder::Forward, 4);
    scenes.resize(3);
    const auto expected = alone(scenes);
    scenes[1].settings.draws = 0;
    EstimateBatch batch(batchBench().robot, batchBench().models);
    add(batch, scenes, 0);
    EXPECT_THROW(add(batch, scenes, 1), std::invalid_argument);
    add(batch, scenes, 2);
    while (!batch.empty())
        for (const auto& [number, estimate] : batch.next()) {
            EXPECT_NE(number, 1U);
            EXPECT_EQ(estimate, expected[number]);
        }
}

TEST(EstimateBatch, isCancelledAtAnyBin)
{
    const auto scenes = tasks(Method::Clearance, ScanOrder::Forward, 4);
    for (const int most : {0, 200, 777}) {
        int polls = 0;
        Watch watch;
        watch.cancelled = [&] { return ++polls > most; };
        EstimateBatch batch(batchBench().robot, batchBench().models);
        const auto run = [&] {
            for (std::size_t k = 0; k < 3; ++k) add(batch, scenes, k, watch);
            while (!batch.empty()) (void)batch.next();
        };
        EXPECT_THROW(run(), Cancelled) << most;
        EXPECT_EQ(polls, most + 1);
    }
}

TEST(EstimateBatch, endsASceneByItsOwnTime)
{
    auto scenes = tasks(Method::Pafc, ScanOrder::Forward, 4);
    for (Task& task : scenes) task.settings.stopEarly = false;
    int asked = 0;
    Watch hurried;
    hurried.outOfTime = [&] { return ++asked > 5; };
    EstimateBatch batch(batchBench().robot, batchBench().models);
    add(batch, scenes, 0, hurried);
    add(batch, scenes, 1);
    const auto first = batch.next();
    ASSERT_EQ(first.size(), 1U);
    EXPECT_EQ(first[0].number, 0U);
    EXPECT_EQ(first[0].estimate.ending, Ending::Time);
    EXPECT_EQ(first[0].estimate.draws.size(), 4U * (kMinKept + 5));
    EXPECT_EQ(batch.next().at(0).estimate, alone({scenes[1]}).front());
}

}  // namespace
}  // namespace terratact
