#include "app/console/connection/robot_connection.h"

#include <random>
#include <utility>

#include "app/link/can_check.h"
#include "app/link/robot_setup.h"
#include "app/runtime/print_text.h"
#include "app/runtime/steady_now.h"
#include "core/atem/panel_file.h"
#include "drivers/can_bus.h"
#include "drivers/can_interface.h"
#include "drivers/gpio_lines.h"
#include "drivers/log_replay.h"
#include "drivers/socketcan.h"

namespace terratact {
namespace {

using OnFrames = std::function<void(std::span<const BusFrame>)>;

constexpr double kNominalBitrate = 500e3;  // [bit/s] bit rate of the real robot's bus
constexpr double kDemoSpeed = 4.0;         // simulated seconds per second while a picture is made

std::uint64_t drawn()
{
    std::random_device device;
    return (std::uint64_t{device()} << 32U) | device();
}

Result<std::unique_ptr<BuiltInRobot>> builtInRobot(const RobotModel& model,
                                                   const ConsoleOptions& options)
{
    const auto ground = robotGround(options.terrain, options.seed);
    if (!ground) return ground.error();
    const auto onBus = withFault({.firstEpoch = static_cast<std::uint8_t>(1 + drawn() % 255),
                                  .firstChallenge = static_cast<std::uint16_t>(1 + drawn() % 65535),
                                  .speed = options.isPicture() ? kDemoSpeed : 1.0},
                                 options.fault);
    if (!onBus) return onBus.error();
    SimulatedRobot::Options simulation;
    simulation.startX = ground->start;
    simulation.seed = options.seed;
    return std::make_unique<BuiltInRobot>(model, SimulatedRobot(model, ground->lines, simulation),
                                          *onBus);
}

std::unique_ptr<CanSource> sourceOn(BuiltInRobot& builtIn, const RobotModel& robot,
                                    OnFrames onFrames)
{
    return std::make_unique<CanSource>(
        builtIn.bus.join(kInternalBus), robot,
        CanSource::Options{.mode = CanSource::Mode::Transmit,
                           .name = "SIMULATED ROBOT",
                           .link = {.seed = drawn()},
                           .truth = [&builtIn] { return builtIn.robot.truth(); },
                           .bitrate = kNominalBitrate,
                           .nominal = true,
                           .received = std::move(onFrames)});
}

Result<std::unique_ptr<CanBus>> namedBus(const ConsoleOptions& options)
{
    if (!options.replay.empty()) {
        auto log = LogReplay::open(options.replay,
                                   {.interface = options.interface, .speed = options.speed});
        if (!log) return log.error();
        for (const Message& remark : (*log)->remarks())
            printText(stderr, "terratact-console: {}\n", remark.english());
        return std::unique_ptr<CanBus>(std::move(*log));
    }
    auto bus = SocketCan::open({.interface = options.can, .transmit = options.transmit});
    if (!bus) return bus.error();
    if (const std::string warning = (*bus)->warning(); !warning.empty())
        printText(stderr, "terratact-console: {}\n", warning);
    return std::unique_ptr<CanBus>(std::move(*bus));
}

std::unique_ptr<CanSource> sourceOn(std::unique_ptr<CanBus> bus, const RobotModel& robot,
                                    const ConsoleOptions& options, OnFrames onFrames)
{
    using Mode = CanSource::Mode;
    const Mode mode = !options.replay.empty() ? Mode::Replay
                    : options.transmit        ? Mode::Transmit
                                              : Mode::Listen;
    std::optional<double> bitrate;
    if (const auto known = controllerFrom(linkDetails(options.can)).bitrate)
        bitrate = static_cast<double>(*known);
    return std::make_unique<CanSource>(std::move(bus), robot,
                                       CanSource::Options{.mode = mode,
                                                          .link = {.seed = drawn()},
                                                          .waits = mode == Mode::Replay,
                                                          .bitrate = bitrate,
                                                          .received = std::move(onFrames)});
}

}  // namespace

BuiltInRobot::BuiltInRobot(const RobotModel& model, const SimulatedRobot& simulated,
                           const RobotOnBus::Options& options)
    : bus(steadyNow), robot(bus, model, simulated, options)
{
}

Result<RobotConnection> connectRobot(const RobotModel& robot, const ConsoleOptions& options,
                                     const std::shared_ptr<SessionRecorder>& recorder)
{
    OnFrames onFrames;
    if (recorder)
        onFrames = [recorder](std::span<const BusFrame> frames) { recorder->add(frames); };
    RobotConnection connection;
    if (!options.can.empty() || !options.replay.empty()) {
        auto bus = namedBus(options);
        if (!bus) return bus.error();
        connection.replay = dynamic_cast<LogReplay*>(bus->get());
        connection.source = sourceOn(std::move(*bus), robot, options, std::move(onFrames));
    } else {
        auto builtIn = builtInRobot(robot, options);
        if (!builtIn) return builtIn.error();
        connection.builtIn = std::move(*builtIn);
        connection.source = sourceOn(*connection.builtIn, robot, std::move(onFrames));
    }
    return connection;
}

Result<std::unique_ptr<OperatorPanel>> openPanel(const ConsoleOptions& options)
{
    if (options.panel.empty()) return std::unique_ptr<OperatorPanel>();
    const auto panel = readPanelFile(options.panel);
    if (!panel) return panel.error();
    return std::make_unique<OperatorPanel>(*panel, openGpioLines);
}

}  // namespace terratact
