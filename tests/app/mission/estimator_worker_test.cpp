#include "app/display/translated.h"
#include "app/mission/estimator_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

#include "tests/support/estimates.h"
#include "tests/support/gui.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

/// Receives the worker's signals in the test's thread; a signal spy would record in the worker's thread.
struct Listener : QObject {
    explicit Listener(EstimatorWorker& worker)
    {
        connect(&worker, &EstimatorWorker::modelLoaded, this,
                [this](const QString& name) { loaded << name; });
        connect(&worker, &EstimatorWorker::modelFailed, this,
                [this](const Message& why) { noModel << translated(why); });
        connect(&worker, &EstimatorWorker::estimated, this,
                [this](int job, const TwoTrackEstimate& e, double seconds) {
                    estimated << job;
                    last = e;
                    EXPECT_GE(seconds, 0.0);
                    EXPECT_EQ(QThread::currentThread(), thread());
                });
        connect(&worker, &EstimatorWorker::failed, this, [this](int job, const Message& why) {
            failed << job;
            reasons << translated(why);
        });
    }
    QStringList loaded, noModel, reasons;
    QList<int> estimated, failed;
    TwoTrackEstimate last;
};

ModelLoader loaderOf(Estimator estimator)
{
    return [estimator = std::move(estimator)]() -> Result<LoadedModel> {
        return LoadedModel{.estimate = estimator, .name = "fake.ttm", .details = "made up"};
    };
}

/// An estimate that runs until it is cancelled or released.
struct Gate {
    std::atomic<bool> open = false;
    std::atomic<bool> deaf = false;  ///< ignores cancellation
    std::atomic<int> started = 0, cancelled = 0;

    Estimator estimator()
    {
        return [this](const EstimateRequest& request, const Watch& watch) {
            ++started;
            while (!open) {
                if (!deaf && watch.cancelled()) {
                    ++cancelled;
                    throw Cancelled{};
                }
                watch.progress(0.5);
                std::this_thread::sleep_for(1ms);  // a watch can only be asked
            }
            TerrainEstimate e = stepEstimate();
            e.settings = request.settings;
            return equalSides(e);
        };
    }
};

EstimateRequest withSeed(std::uint64_t seed)
{
    EstimateRequest request;
    request.settings.seed = seed;
    return request;
}

TEST(Worker, loadsTheModelThenEstimates)
{
    Gate gate;
    gate.open = true;
    EstimatorWorker worker(loaderOf(gate.estimator()));
    Listener heard(worker);
    worker.start();
    const int job = worker.request(withSeed(5));
    ASSERT_TRUE(gui::eventually([&] { return !heard.estimated.isEmpty(); }));
    EXPECT_EQ(heard.loaded, QStringList{"fake.ttm"});
    EXPECT_EQ(heard.estimated, QList<int>{job});
    EXPECT_EQ(heard.last.side[0].settings.seed, 5U);
    EXPECT_FALSE(worker.progress());
}

TEST(Worker, theNewestRequestWins)
{
    Gate gate;
    EstimatorWorker worker(loaderOf(gate.estimator()));
    Listener heard(worker);
    worker.start();
    worker.request(withSeed(1));
    ASSERT_TRUE(gui::eventually([&] { return gate.started == 1; }));
    int last = 0;
    gate.deaf = true;  // this thread may be too slow to make all requests at once
    for (std::uint64_t seed = 2; seed <= 20; ++seed) last = worker.request(withSeed(seed));
    gate.deaf = false;
    ASSERT_TRUE(gui::eventually([&] { return gate.started == 2; }))
        << "those in between never start";
    EXPECT_EQ(gate.cancelled, 1);
    gate.open = true;
    ASSERT_TRUE(gui::eventually([&] { return !heard.estimated.isEmpty(); }));
    EXPECT_EQ(heard.estimated, QList<int>{last});
    EXPECT_EQ(heard.last.side[0].settings.seed, 20U);
    EXPECT_EQ(gate.started, 2);
    EXPECT_TRUE(heard.failed.isEmpty()) << "being overtaken is no failure";
}

TEST(Worker, cancelEndsTheJobWithoutAResult)
{
    Gate gate;
    EstimatorWorker worker(loaderOf(gate.estimator()));
    Listener heard(worker);
    worker.start();
    worker.request(withSeed(1));
    ASSERT_TRUE(gui::eventually([&] { return worker.progress().value_or(0.0) == 0.5; }));
    worker.cancel();
    EXPECT_FALSE(worker.progress());
    ASSERT_TRUE(gui::eventually([&] { return gate.cancelled == 1; }));
    gate.open = true;
    worker.request(withSeed(2));
    ASSERT_TRUE(gui::eventually([&] { return !heard.estimated.isEmpty(); }));
    EXPECT_EQ(heard.last.side[0].settings.seed, 2U);
    EXPECT_EQ(heard.estimated.size(), 1);
    EXPECT_TRUE(heard.failed.isEmpty());
}

TEST(Worker, anErrorOfTheEstimateIsReported)
{
    EstimatorWorker worker(loaderOf([](const EstimateRequest&, const Watch&) -> TwoTrackEstimate {
        throw std::invalid_argument("draws must be 1 or more");
    }));
    Listener heard(worker);
    worker.start();
    const int job = worker.request({});
    ASSERT_TRUE(gui::eventually([&] { return !heard.failed.isEmpty(); }));
    EXPECT_EQ(heard.failed, QList<int>{job});
    EXPECT_EQ(heard.reasons, QStringList{"draws must be 1 or more"});
    EXPECT_FALSE(worker.progress());
}

TEST(Worker, unreadableModelFailsEveryRequestWithItsReason)
{
    EstimatorWorker worker([]() -> Result<LoadedModel> {
        return Error{"x.ttm: cannot be opened", 2};
    });
    Listener heard(worker);
    worker.start();
    worker.request({});
    ASSERT_TRUE(gui::eventually([&] { return !heard.failed.isEmpty(); }));
    EXPECT_EQ(heard.noModel, QStringList{"x.ttm: cannot be opened"});
    EXPECT_EQ(heard.reasons, QStringList{"x.ttm: cannot be opened"});
}

TEST(Worker, aMissingModelFileIsNamed)
{
    EstimatorWorker worker(modelFileLoader("/nowhere/none.ttm", {}));
    Listener heard(worker);
    worker.start();
    ASSERT_TRUE(gui::eventually([&] { return !heard.noModel.isEmpty(); }));
    EXPECT_TRUE(heard.noModel.front().contains("/nowhere/none.ttm"));
}

TEST(Worker, anotherModelCancelsTheJobAndServesTheNext)
{
    Gate before, after;
    after.open = true;
    EstimatorWorker worker(loaderOf(before.estimator()));
    Listener heard(worker);
    worker.start();
    worker.request(withSeed(1));
    ASSERT_TRUE(gui::eventually([&] { return before.started == 1; }));
    worker.load([&]() -> Result<LoadedModel> {
        return LoadedModel{.estimate = after.estimator(), .name = "next.ttm", .details = {}};
    });
    const int job = worker.request(withSeed(2));
    ASSERT_TRUE(gui::eventually([&] { return !heard.estimated.isEmpty(); }));
    EXPECT_EQ(before.cancelled, 1);
    EXPECT_EQ(heard.estimated, QList<int>{job});
    EXPECT_EQ(after.started, 1);
    EXPECT_EQ(heard.loaded, (QStringList{"fake.ttm", "next.ttm"}));
}

TEST(Worker, keepsTheModelWhenTheNextCannotBeLoaded)
{
    Gate gate;
    gate.open = true;
    EstimatorWorker worker(loaderOf(gate.estimator()));
    Listener heard(worker);
    QStringList kept;
    QObject::connect(&worker, &EstimatorWorker::modelKept, &heard,
                     [&](const Message& why) { kept << translated(why); });
    worker.start();
    worker.load(modelFileLoader("/nowhere/none.ttm", RobotModel{}));
    worker.load([]() -> Result<LoadedModel> { throw std::runtime_error("out of memory"); });
    const int job = worker.request(withSeed(3));
    ASSERT_TRUE(gui::eventually([&] { return !heard.estimated.isEmpty(); }));
    EXPECT_EQ(heard.estimated, QList<int>{job});
    ASSERT_EQ(kept.size(), 2);
    EXPECT_TRUE(kept[0].contains("/nowhere/none.ttm"));
    EXPECT_EQ(kept[1], "out of memory");
    EXPECT_TRUE(heard.noModel.isEmpty());
    EXPECT_EQ(heard.loaded, QStringList{"fake.ttm"});
}

TEST(Worker, aModelMayComeAfterOneThatFailed)
{
    Gate gate;
    gate.open = true;
    EstimatorWorker worker(modelFileLoader("/nowhere/none.ttm", RobotModel{}));
    Listener heard(worker);
    worker.start();
    ASSERT_TRUE(gui::eventually([&] { return heard.noModel.size() == 1; }));
    worker.load(loaderOf(gate.estimator()));
    worker.request(withSeed(4));
    ASSERT_TRUE(gui::eventually([&] { return !heard.estimated.isEmpty(); }));
    EXPECT_EQ(heard.noModel.size(), 1);
}

TEST(Worker, endsSamplingAtTheTimeLimit)
{
    std::atomic<int> limited = 0, ended = 0;
    EstimatorWorker worker([&] {
        return Result<LoadedModel>(
            LoadedModel{.estimate =
                            [&](const EstimateRequest&, const Watch& watch) {
                                if (watch.outOfTime) ++limited;
                                for (int i = 0; i < 20'000 && watch.outOfTime; ++i) {
                                    if (watch.outOfTime() && ++ended) break;
                                    std::this_thread::sleep_for(1ms);  // a watch can only be asked
                                }
                                return equalSides(stepEstimate());
                            },
                        .name = "fake.ttm",
                        .details = {}});
    });
    Listener heard(worker);
    worker.start();
    worker.request({});
    ASSERT_TRUE(gui::eventually([&] { return heard.estimated.size() == 1; }));
    EXPECT_EQ(limited, 0);
    EstimateRequest request;
    request.seconds = 0.05;
    worker.request(request);
    ASSERT_TRUE(gui::eventually([&] { return heard.estimated.size() == 2; }));
    EXPECT_EQ(ended, 1);
}

TEST(Worker, endsPromptlyInTheMiddleOfAJob)
{
    Gate gate;
    QElapsedTimer timer;
    {
        EstimatorWorker worker(loaderOf(gate.estimator()));
        worker.start();
        worker.request({});
        ASSERT_TRUE(gui::eventually([&] { return gate.started == 1; }));
        timer.start();
    }
    EXPECT_LT(timer.elapsed(), 2000);
    EXPECT_EQ(gate.cancelled, 1);
}

TEST(Worker, endsEvenIfItNeverStarted)
{
    const EstimatorWorker worker(loaderOf({}));
}

}  // namespace
}  // namespace terratact
