#include <fmt/core.h>

#include <atomic>
#include <charconv>
#include <cmath>
#include <csignal>
#include <random>

#include "app/commands.h"
#include "app/robot_service.h"
#include "app/steady_now.h"
#include "core/learn/profile_file.h"
#include "core/sim/random_terrain.h"
#include "core/sim/terrain_shapes.h"
#include "drivers/socketcan.h"

namespace terratact {
namespace {

std::atomic<bool> interrupted = false;

void interrupt(int)
{
    interrupted = true;
}

struct Ground {
    TerrainProfile profile;
    double start = 0.0;  ///< [m] where the robot begins
};

Result<Ground> groundOf(const RobotOptions& options)
{
    constexpr double kRoomBehind = 0.7;  // [m] for the rear flippers
    if (options.terrain.empty()) return Ground{demoTerrain(), kDemoStep - 1.1};
    if (options.terrain == "varied") {
        std::mt19937_64 rng(options.seed);
        const TerrainProfile varied = randomVariedTerrain(rng);
        return Ground{varied, varied.begin() + kRoomBehind};
    }
    auto file = readProfiles(options.terrain, 0.1, false);
    if (!file) return file.error();
    return Ground{file->profiles.front(), file->profiles.front().begin() + kRoomBehind};
}

struct Fault {
    RobotFault kind = RobotFault::None;
    double at = 0.0;  ///< [s]
};

// "silence", "silence@12.5".
Result<Fault> faultFrom(const std::string& text)
{
    const std::size_t sign = text.find('@');
    const auto kind = robotFaultFromName(std::string_view(text).substr(0, sign));
    Fault fault;
    bool good = kind.has_value();
    if (good) fault.kind = *kind;
    if (sign != std::string::npos) {
        const char* const begin = text.data() + sign + 1;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(begin, end, fault.at);
        good = good && error == std::errc() && stop == end && fault.at >= 0.0 && fault.at < 1e9;
    }
    if (good) return fault;
    std::string names;
    for (const RobotFault known : kRobotFaults) names += fmt::format(" {}", name(known));
    return Error{
        fmt::format("--fault {}: expected NAME or NAME@SECONDS, NAME one of{}", text, names), 0};
}

}  // namespace

Status runRobot(const RobotOptions& options)
{
    const auto model = readRobotModel(options.robot);
    if (!model) return model.error();
    const auto ground = groundOf(options);
    if (!ground) return ground.error();
    const auto fault = faultFrom(options.fault);
    if (!fault) return fault.error();
    auto bus = SocketCan::open({.interface = options.can, .transmit = true, .maxUnconfirmed = 0});
    if (!bus) return bus.error();

    SimulatedRobot::Options simulation;
    simulation.startX = ground->start;
    simulation.seed = options.seed;
    std::random_device device;
    RobotOnBus robot(*model, SimulatedRobot(*model, ground->profile, simulation),
                     {.firstEpoch = static_cast<std::uint8_t>(1 + device() % 255),
                      .speed = options.speed,
                      .fault = fault->kind,
                      .faultAt = fault->at});
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    const double end = options.seconds > 0.0 ? steadyNow() + options.seconds : HUGE_VAL;
    fmt::print("simulated robot on {}; Ctrl+C ends it\n", options.can);
    const double began = steadyNow();
    return serveRobot(
        **bus, robot, [&] { return !interrupted && steadyNow() < end; },
        [&](const std::string& what) {
            fmt::print("{:8.2f} s  {}\n", steadyNow() - began, what);
            std::fflush(stdout);
        });
}

}  // namespace terratact
