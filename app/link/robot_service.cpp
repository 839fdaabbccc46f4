#include "app/link/robot_service.h"

#include <fmt/core.h>

#include <array>
#include <chrono>

#include "app/link/can_source.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

struct Shown {
    bool armed = false;
    RobotActivity activity = RobotActivity::Halted;
    BusState bus = BusState::Up;
    bool operator==(const Shown&) const = default;
};

std::string words(const Shown& shown, const RobotOnBus& robot, const CanBus& bus)
{
    std::string state = describe(shown.bus, bus.name()).english();
    const bool works = shown.bus == BusState::Up || shown.bus == BusState::ErrorWarning;
    if (!works) return state;
    return fmt::format("{}, {} (epoch {}){}", describe(shown.activity).english,
                       shown.armed ? "armed" : "disarmed", robot.epoch(),
                       shown.bus == BusState::Up ? "" : "; " + state);
}

void sendAll(CanBus& bus, const std::vector<CanFrame>& frames)
{
    for (const CanFrame& frame : frames)
        if (!bus.send(frame)) return;  // an incomplete line has no value
}

}  // namespace

Status serveRobot(CanBus& bus, RobotOnBus& robot, const std::function<bool()>& goOn,
                  const std::function<void(const std::string&)>& print,
                  const std::function<void()>& measured, const std::function<double()>& clock)
{
    std::array<BusFrame, 64> frames;
    std::optional<Shown> before;
    while (goOn()) {
        const auto count = bus.receive(frames, 5ms);
        if (!count) return count.error();
        for (std::size_t i = 0; i < *count; ++i)
            if (!frames[i].echo) sendAll(bus, robot.receive(frames[i].frame, clock()));
        const std::vector<CanFrame> line = robot.tick(clock());
        if (!line.empty()) measured();
        sendAll(bus, line);
        const Shown shown{robot.armed(), robot.robot().activity(), bus.state()};
        if (before != shown) print(words(shown, robot, bus));
        before = shown;
    }
    return Done{};
}

}  // namespace terratact
