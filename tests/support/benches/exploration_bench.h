#pragma once

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

#include "app/display/translated.h"
#include "app/mission/exploration.h"
#include "app/runtime/steady_now.h"
#include "core/base/message.h"
#include "tests/support/bytes/messages.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/held_estimate.h"
#include "tests/support/scripted_source.h"

namespace terratact {

inline constexpr int kBin06 = 9;

/// An exploration with simulated telemetry and clock; only the estimator runs in a thread.
struct Bench : testing::Test {
    explicit Bench(CanSource* link = nullptr) : link_(link)
    {
        RobotModel robot;
        robot.armReachBegin = 0.35;
        robot.armReachEnd = 0.75;
        robot.armSd = 0.03;
        worker = std::make_unique<EstimatorWorker>([this]() -> Result<LoadedModel> {
            return LoadedModel{.estimate = [this](const EstimateRequest& r,
                                                  const Watch& w) { return estimate(r, w); },
                               .name = "fake.ttm",
                               .details = {}};
        });
        exploration =
            std::make_unique<Exploration>(source, robot, *worker, Exploration::Options{}, link);
        for (const auto signal : {&Exploration::happened, &Exploration::stateChanged})
            QObject::connect(exploration.get(), signal,
                             [this](const Message& text) { events << translated(text); });
        worker->start();
        EXPECT_TRUE(gui::eventually([this] { return events.contains("model fake.ttm loaded"); }));
        tick(3);
    }

    TwoTrackEstimate estimate(const EstimateRequest& request, const Watch& watch)
    {
        {
            const std::scoped_lock lock(mutex);
            asked = request;
        }
        ++estimates;
        waitWhile([&] { return blocked || (secondBlocked && !request.prober); }, watch);
        if (watch.cancelled()) throw Cancelled{};
        if (broken) throw std::runtime_error("the covariance is not positive definite");
        TerrainEstimate e = clear               ? clearEstimate()
                          : request.arm.empty() ? stepEstimate()
                                                : probedEstimate();
        if (withDraws) e.draws.assign(draws, e.height);  // all draws have the step
        if (stepInHalf)
            for (std::size_t d = 0; d < e.draws.size(); d += 2) e.draws[d].fill(e.height[0]);
        e.settings = request.settings;
        return equalSides(e);
    }

    RobotMoment moment() const
    {
        return {now, latest, link_ ? std::optional(link_->view()) : std::nullopt};
    }
    /// Runs ticks of 40 ms, each with fresh telemetry.
    void tick(int times = 1)
    {
        for (int i = 0; i < times; ++i) {
            line();
            exploration->tick(moment());
        }
    }
    /// Adds telemetry without polling.
    void line()
    {
        now += 0.04;
        latest = received(latest, {.measurement = telemetry, .truth = std::nullopt},
                          {SteadyTime(std::chrono::duration_cast<SteadyTime::duration>(
                               std::chrono::duration<double>(now))),
                           now});
        latest->suspicions = suspicions;
    }
    EstimateRequest lastAsked() const
    {
        const std::scoped_lock lock(mutex);
        return asked;
    }
    /// Runs ticks without telemetry.
    void tickInSilence(int times)
    {
        for (int i = 0; i < times; ++i) {
            now += 0.04;
            exploration->tick(moment());
        }
    }
    AtemPhase phase() const { return exploration->state().phase; }
    bool reaches(AtemPhase wanted)
    {
        // Runs slowly, so that an estimate in the other thread exceeds no time limit of this clock.
        return gui::eventually([&] {
            if (phase() == wanted) return true;
            tick();
            return phase() == wanted;
        });
    }
    /// Explores until the flippers move.
    bool begunToPress()
    {
        exploration->request();
        telemetry.activity = RobotActivity::Halted;
        if (!reaches(AtemPhase::Pressing)) return false;
        telemetry.activity = RobotActivity::Pressing;
        return true;
    }
    template <class C>
    int sent()
    {
        for (const Command& command : source.consumeCommands()) all.push_back(command);
        return static_cast<int>(std::count_if(
            all.begin(), all.end(), [](const Command& c) { return std::holds_alternative<C>(c); }));
    }
    ~Bench() override { releaseWorker(); }
    void releaseWorker()
    {
        workerHeld = false;
        workerHeld.notify_all();
    }

    /// Lets the blocked estimate end and waits until its answer is queued for this thread, not yet delivered. The
    /// worker stays held while workerHeld is set.
    bool answerIsQueued()
    {
        // Runs in the worker's thread, after all other receivers.
        const auto queued = std::make_shared<std::promise<void>>();
        QObject::connect(
            worker.get(), &EstimatorWorker::estimated, worker.get(),
            [this, queued] {
                queued->set_value();
                workerHeld.wait(true);
            },
            static_cast<Qt::ConnectionType>(Qt::DirectConnection | Qt::SingleShotConnection));
        blocked = false;
        return queued->get_future().wait_for(std::chrono::seconds(20)) == std::future_status::ready;
    }
    /// Waits until the worker has answered all requests and this thread has received the answers. The worker answers in
    /// order, so an additional request is answered last.
    bool settles()
    {
        constexpr double kNobodysLimit = 0.123;  // [m] a limit that only this request uses
        bool heard = false;
        const auto listening = QObject::connect(
            worker.get(), &EstimatorWorker::advised, exploration.get(),
            [&heard](int, const ProbeAdvice& a) { heard = heard || a.stepLimit == kNobodysLimit; });
        worker->advise(0, equalSides(stepEstimate()), RobotModel{}, kNobodysLimit);
        const bool settled = gui::eventually([&heard] { return heard; });
        QObject::disconnect(listening);
        return settled;
    }
    void press()
    {
        exploration->request();
        tick();
        telemetry.activity = RobotActivity::Halted;
        ASSERT_TRUE(reaches(AtemPhase::Pressing));
        telemetry.activity = RobotActivity::Pressed;
    }
    /// Explores until an estimate is under way; it ends when it is no longer blocked.
    void beginToEstimate()
    {
        blocked = true;
        press();
        ASSERT_TRUE(reaches(AtemPhase::Estimating));
        ASSERT_TRUE(gui::eventually([this] { return estimates > 0; }));
    }
    void propose()
    {
        press();
        ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    }

    std::atomic<int> estimates = 0;
    std::atomic<bool> blocked = false, broken = false, withDraws = false, stepInHalf = false;
    std::atomic<bool> clear = false;  ///< estimates are clearEstimate()
    std::atomic<std::size_t> draws = 200;
    std::atomic<bool> secondBlocked = false;  ///< also blocks previews
    std::atomic<bool> workerHeld = false;
    CanSource* link_;  ///< null: the source is no bus
    ScriptedSource source;
    std::unique_ptr<EstimatorWorker> worker;
    std::unique_ptr<Exploration> exploration;
    Measurement telemetry;
    std::vector<SensorSuspicion> suspicions;  ///< of every line from now on
    std::optional<Received> latest;
    mutable std::mutex mutex;
    EstimateRequest asked;  ///< newest request; guarded by the mutex
    double now = 1000.0;
    QStringList events;
    std::vector<Command> all;
};

}  // namespace terratact
