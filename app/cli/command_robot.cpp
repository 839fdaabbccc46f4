#include <fmt/core.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <random>

#include "app/cli/commands.h"
#include "app/link/robot_service.h"
#include "app/link/robot_setup.h"
#include "app/runtime/print_text.h"
#include "app/runtime/steady_now.h"
#include "drivers/socketcan.h"

namespace terratact {
namespace {

std::atomic<bool> stopAsked = false;

void interrupt(int)
{
    stopAsked = true;
}

}  // namespace

Status runRobot(const RobotOptions& options)
{
    const auto model = readRobotModel(options.robot);
    if (!model) return model.error();
    const auto ground = robotGround(options.terrain, options.seed);
    if (!ground) return ground.error();
    std::random_device device;
    const auto onBus =
        withFault({.firstEpoch = static_cast<std::uint8_t>(1 + device() % 255),
                   .firstChallenge = static_cast<std::uint16_t>(1 + device() % 65535),
                   .speed = options.speed},
                  options.fault);
    if (!onBus) return onBus.error();
    auto bus = SocketCan::open({.interface = options.can, .transmit = true, .maxUnconfirmed = 0});
    if (!bus) return bus.error();

    SimulatedRobot::Options simulation;
    simulation.startX = ground->start;
    simulation.seed = options.seed;
    RobotOnBus robot(*model, SimulatedRobot(*model, ground->lines, simulation), *onBus);
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    const double end = options.seconds > 0.0 ? steadyNow() + options.seconds : HUGE_VAL;
    printText("simulated robot on {}; Ctrl+C ends it\n", options.can);
    const double began = steadyNow();
    return serveRobot(
        **bus, robot, [&] { return !stopAsked && steadyNow() < end; },
        [&](const std::string& what) {
            printText("{:8.2f} s  {}\n", steadyNow() - began, what);
            std::fflush(stdout);
        });
}

}  // namespace terratact
