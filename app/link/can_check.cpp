#include "app/link/can_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <system_error>

#include "core/base/text.h"

namespace terratact {
namespace {

using Level = CanFinding::Level;

constexpr long kReceiveBuffer = 4L << 20;  // [B] one second of a full bus
constexpr long kLongQueue = 100;           // frames

// Returns the word after `key`; empty if `key` is absent.
std::string_view wordAfter(std::string_view text, std::string_view key)
{
    const std::size_t at = text.find(key);
    if (at == std::string_view::npos) return {};
    text.remove_prefix(at + key.size());
    return text.substr(0, text.find_first_of(" \t\n"));
}

CanFinding absentFinding(const CanInterfaceFacts& facts)
{
    if (!facts.others.empty())
        return {Level::Problem,
                fmt::format("there is no interface {}, but {}", facts.name,
                            fmt::join(facts.others, ", ")),
                fmt::format("terratact can check {}", facts.others.front())};
    return {Level::Problem,
            fmt::format("there is no interface {}, nor any CAN interface", facts.name),
            "plug the adapter in and load its driver; for a virtual one: sudo ip link add dev "
            "vcan0 type "
            "vcan"};
}

void addController(std::vector<CanFinding>& findings, const CanInterfaceFacts& facts,
                   const CanController& controller)
{
    if (facts.isVirtual) {
        findings.push_back({Level::Fine, "it is virtual: no bit rate, no controller"});
        return;
    }
    const std::string set = fmt::format("sudo ip link set {} ", facts.name);
    if (controller.state.empty()) {
        findings.push_back({Level::Warning, "its bit rate and its controller's state are not known",
                            "sudo apt-get install iproute2"});
        return;
    }
    if (!controller.bitrate)
        findings.push_back({Level::Problem, "it has no bit rate",
                            set + "type can bitrate 500000   (as on the robot's bus)"});
    else
        findings.push_back({Level::Fine, fmt::format("bit rate {} bit/s", *controller.bitrate)});
    if (controller.state == "BUS-OFF")
        findings.push_back(
            {Level::Problem,
             "its controller has given up (bus-off): wrong bit rate, no terminators or "
             "crossed wires",
             set + "down; " + set + "up"});
    else if (controller.state == "ERROR-PASSIVE" || controller.state == "ERROR-WARNING")
        findings.push_back({Level::Warning,
                            fmt::format("its controller sees many errors ({}): wrong bit rate, no "
                                        "terminators or loose wires",
                                        controller.state),
                            "ip -details -statistics link show " + facts.name});
}

void addState(std::vector<CanFinding>& findings, const CanInterfaceFacts& facts)
{
    if (facts.up)
        findings.push_back({Level::Fine, "it is up"});
    else
        findings.push_back(
            {Level::Problem, "it is down", fmt::format("sudo ip link set {} up", facts.name)});
    if (facts.sendQueue && *facts.sendQueue > kLongQueue && !facts.isVirtual)
        findings.push_back(
            {Level::Warning,
             fmt::format("its send queue holds {} frames: with nobody to acknowledge "
                         "them, other programs' frames grow old in it",
                         *facts.sendQueue),
             fmt::format("sudo ip link set {} txqueuelen 10", facts.name)});
}

void addBuffer(std::vector<CanFinding>& findings, const CanInterfaceFacts& facts)
{
    const bool isEnough = facts.mayForce || facts.receiveLimit.value_or(0) >= kReceiveBuffer;
    if (isEnough)
        findings.push_back({Level::Fine, "the receive buffer may be as large as it has to"});
    else
        findings.push_back(
            {Level::Warning,
             fmt::format("the receive buffer is limited to {} of {} bytes: frames are lost "
                         "when this computer is busy",
                         facts.receiveLimit.value_or(0), kReceiveBuffer),
             fmt::format("sudo sysctl -w net.core.rmem_max={}", kReceiveBuffer)});
}

}  // namespace

CanController controllerFrom(std::string_view linkDetails)
{
    CanController controller;
    controller.state = wordAfter(linkDetails, " can state ");
    if (controller.state.empty()) controller.state = wordAfter(linkDetails, " can <FD> state ");
    const std::string_view digits = wordAfter(linkDetails, " bitrate ");
    const auto bitrate = integerFrom<long>(digits);
    if (bitrate && *bitrate > 0) controller.bitrate = *bitrate;
    return controller;
}

CanFinding socketFinding(int socketError)
{
    const std::string reason = std::generic_category().message(socketError);
    switch (socketError) {
    case 0: return {Level::Fine, "the kernel has CAN and this user may use it"};
    case EAFNOSUPPORT:
    case EPROTONOSUPPORT:
        return {Level::Problem, fmt::format("the kernel has no CAN sockets ({})", reason),
                "sudo modprobe can_raw   (where that fails: a kernel with CONFIG_CAN_RAW)"};
    case EPERM:
    case EACCES:
        return {Level::Problem, fmt::format("this user may not open CAN sockets ({})", reason),
                "run it outside of the sandbox or container that forbids it, or as another user"};
    default: return {Level::Problem, fmt::format("a CAN socket cannot be opened ({})", reason), ""};
    }
}

std::vector<CanFinding> findingsOf(const CanInterfaceFacts& facts, int socketError,
                                   const CanController& controller)
{
    std::vector<CanFinding> findings{socketFinding(socketError)};
    if (!facts.present) {
        findings.push_back(absentFinding(facts));
        return findings;
    }
    if (!facts.isCan) {
        findings.push_back({Level::Problem, fmt::format("{} is no CAN interface", facts.name),
                            facts.others.empty()
                                ? "ip -brief link   (lists all there are)"
                                : fmt::format("terratact can check {}", facts.others.front())});
        return findings;
    }
    findings.push_back({Level::Fine, "it is a CAN interface"});
    addController(findings, facts, controller);
    addState(findings, facts);
    addBuffer(findings, facts);
    return findings;
}

}  // namespace terratact
