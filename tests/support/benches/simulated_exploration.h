#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "app/display/translated.h"
#include "app/mission/exploration.h"
#include "core/sim/simulated_robot.h"
#include "tests/support/absolem.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"

namespace terratact {

/// An exploration of the simulated robot, with a model file. Time is simulated; only the estimator runs in a thread.
struct SimulatedExploration {
    static constexpr double kTick = 0.04;  ///< [s]

    SimulatedExploration(const GroundLines& ground, const SimulatedRobot::Options& simulation,
                         Exploration::Options wanted = {},
                         const std::string& model = TERRATACT_SOURCE_DIR
                         "/resources/models/default.ttm")
        : options(std::move(wanted)), robot(absolem(), ground, simulation),
          worker(modelFileLoader(model, absolem())), exploration(source, absolem(), worker, options)
    {
        QObject::connect(&exploration, &Exploration::happened,
                         [this](const Message& text) { events << translated(text); });
    }
    /// Loads the model.
    void begin()
    {
        worker.start();
        EXPECT_TRUE(gui::eventually(
            [this] { return events.join('\n').contains(QRegularExpression("model .* loaded")); }));
        tick(3);
    }
    void tick(int times = 1)
    {
        for (int i = 0; i < times; ++i) {
            step();
            Measurement line = robot.measure();
            if (change) change(line);
            latest = received(latest, {.measurement = line, .truth = std::nullopt},
                              {SteadyTime(std::chrono::duration_cast<SteadyTime::duration>(
                                   std::chrono::duration<double>(now))),
                               now});
            latest->suspicions = suspicions;
            exploration.tick({now, latest, std::nullopt});
        }
    }
    /// Lets time pass without telemetry.
    void loseTelemetry(double seconds)
    {
        for (double t = 0.0; t < seconds; t += kTick) {
            step();
            exploration.tick({now, latest, std::nullopt});
        }
    }
    bool reaches(AtemPhase phase)
    {
        return gui::eventually([&] {
            if (exploration.state().phase != phase) tickUnlessComputing();
            return exploration.state().phase == phase;
        });
    }
    /// Drives by a distance [m] of the true way, then halts. The robot gets the commands directly.
    void driveBy(double metres)
    {
        const double from = robot.pose().base.x;
        tick(2);  // the end of an exploration halts the robot
        robot.command(DriveCommand{.speed = metres < 0.0 ? -0.2 : 0.2});
        for (int i = 0; i < 1000 && std::abs(robot.pose().base.x - from) < std::abs(metres); ++i)
            tick();
        robot.command(HaltCommand{});
        tick(5);
    }
    /// Lets time pass, except while the worker computes: its time limit is one of simulated time.
    void tickUnlessComputing()
    {
        const AtemPhase phase = exploration.state().phase;
        if (phase == AtemPhase::Estimating || phase == AtemPhase::EstimatingAgain)
            exploration.tick({now, latest, std::nullopt});
        else
            tick();
    }
    /// Explores; a probe that is proposed is refused.
    bool explore()
    {
        exploration.request();
        const bool ended = gui::eventually([&] {
            const AtemPhase phase = exploration.state().phase;
            if (phase == AtemPhase::ProposingProbe) exploration.refuse(exploration.proposal()->id);
            if (phase == AtemPhase::Presenting && estimation().estimate()) return true;
            tickUnlessComputing();
            return false;
        });
        return ended;
    }
    const Estimation& estimation() const { return exploration.estimation(); }
    Method method() const { return estimation().estimate()->side[0].settings.method; }
    std::string memory() const { return translated(estimation().memoryText()).toStdString(); }
    std::string eventText() const { return events.join('\n').toStdString(); }

    Exploration::Options options;
    SimulatedRobot robot;
    ScriptedSource source;
    EstimatorWorker worker;
    Exploration exploration;
    std::function<void(Measurement&)> change;  ///< changes every line of telemetry
    std::vector<SensorSuspicion> suspicions;   ///< of every line from now on
    std::optional<Received> latest;
    double now = 1000.0;
    QStringList events;

private:
    void step()
    {
        for (const Command& command : source.consumeCommands()) robot.command(command);
        robot.step(kTick);
        now += kTick;
    }
};

}  // namespace terratact
