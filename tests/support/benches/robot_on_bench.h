#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "app/console/main_window.h"
#include "app/link/robot_in_process.h"
#include "app/runtime/steady_now.h"
#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"
#include "tests/support/patient_clock.h"

namespace terratact {

/// A simulated robot in this process, two metres into the demonstration's terrain, at one end of a bus. A console at
/// another end must be destroyed first; the derived class owns its window.
struct RobotOnBench {
    void startRobot(RobotOnBus::Options options = {})
    {
        SimulatedRobot::Options simulation;
        simulation.startX = 2.0;
        robot = std::make_unique<RobotInProcess>(
            bus, model, SimulatedRobot(model, demoTerrain(), simulation), options, time());
    }
    /// Returns the bus's clock, for everyone at it.
    std::function<double()> time()
    {
        return [this] { return isRealTime ? steadyNow() : clock.now(); };
    }
    /// Returns the options of a window whose link is this bus end.
    MainWindow::Options linked(std::unique_ptr<CanBus> end, CanSource::Options options)
    {
        if (options.mode != CanSource::Mode::Replay) options.clock = time();  // a log has its own
        auto source = std::make_unique<CanSource>(std::move(end), model, std::move(options));
        MainWindow::Options console;
        console.robot = model;
        // by the machine's clock, so it is long
        if (!isRealTime) console.exploration.linkLostAfter = console.exploration.staleAfter = 3.0;
        console.link = source.get();
        console.inputClock = time();
        console.source = std::move(source);
        return console;
    }
    MainWindow::Options linked(CanSource::Options options)
    {
        return linked(bus.join("can0"), std::move(options));
    }

    RobotModel model = absolem();
    bool isRealTime = false;  ///< the machine's clock and the limits of use, for measurements
    PatientClock clock;
    MemoryBus bus{time()};
    std::unique_ptr<RobotInProcess> robot;
};

}  // namespace terratact
