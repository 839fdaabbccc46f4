#pragma once

#include <memory>
#include <utility>

#include "app/console/main_window.h"
#include "app/link/robot_in_process.h"
#include "app/runtime/steady_now.h"
#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"

namespace terratact {

/// A simulated robot in this process, two metres into the demonstration's terrain, at one end of a bus. A console at
/// another end must be destroyed first; the derived class owns its window.
struct RobotOnBench {
    void startRobot(RobotOnBus::Options options = {})
    {
        SimulatedRobot::Options simulation;
        simulation.startX = 2.0;
        robot = std::make_unique<RobotInProcess>(
            bus, model, SimulatedRobot(model, demoTerrain(), simulation), options);
    }
    /// Returns the options of a window whose link is this bus end.
    MainWindow::Options linked(std::unique_ptr<CanBus> end, CanSource::Options options) const
    {
        auto source = std::make_unique<CanSource>(std::move(end), model, std::move(options));
        MainWindow::Options console;
        console.robot = model;
        console.link = source.get();
        console.source = std::move(source);
        return console;
    }
    MainWindow::Options linked(CanSource::Options options)
    {
        return linked(bus.join("can0"), std::move(options));
    }

    RobotModel model = absolem();
    MemoryBus bus{steadyNow};
    std::unique_ptr<RobotInProcess> robot;
};

}  // namespace terratact
