#include "app/link/robot_setup.h"

#include <fmt/format.h>

#include <charconv>
#include <random>
#include <string_view>

#include "core/learn/data/ground_file.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/ground/terrain_shapes.h"

namespace terratact {

Result<RobotGround> robotGround(const std::string& terrain, std::uint64_t seed)
{
    constexpr double kRoomBehind = 0.7;  // [m] room for the rear flippers
    if (terrain.empty()) return RobotGround{GroundLines(demoTerrain()), kDemoStep - 1.1};
    if (terrain == "varied") {
        std::mt19937_64 rng(seed);
        const TerrainProfile varied = randomVariedTerrain(rng);
        return RobotGround{GroundLines(varied), varied.begin() + kRoomBehind};
    }
    auto file = readGrounds(terrain, 0.1, false);
    if (!file) return file.error();
    const GroundLines& first = file->grounds.front();
    return RobotGround{first, first.begin() + kRoomBehind};
}

Result<RobotOnBus::Options> withFault(RobotOnBus::Options robot, const std::string& text)
{
    const std::size_t sign = text.find('@');
    const std::string_view name = std::string_view(text).substr(0, sign);
    const auto kind = robotFaultFromName(name);
    robot.sensorFault = sensorFaultFrom(name);
    bool good = kind || robot.sensorFault;
    if (kind) robot.fault = *kind;
    if (sign != std::string::npos) {
        const char* const begin = text.data() + sign + 1;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(begin, end, robot.faultAt);
        good = good && error == std::errc() && stop == end && robot.faultAt >= 0.0
            && robot.faultAt < 1e9;
    }
    if (good) return robot;
    std::string names;
    for (const RobotFault known : kRobotFaults) names += fmt::format(" {}", terratact::name(known));
    return Error{fmt::format("--fault {}: expected NAME or NAME@SECONDS, NAME one of{}, or {}",
                             text, names, sensorFaultSyntax()),
                 0};
}

}  // namespace terratact
