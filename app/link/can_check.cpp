#include "app/link/can_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <utility>

#include "core/base/system_message.h"
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

Message command(std::string line)
{
    return Message::verbatim(std::move(line));
}

CanFinding absentFinding(const CanInterfaceFacts& facts)
{
    if (!facts.others.empty())
        return {Level::Problem,
                Message(TR_NOOP("core", "there is no interface %1, but %2"), facts.name,
                        fmt::format("{}", fmt::join(facts.others, ", "))),
                command("terratact can check " + facts.others.front())};
    return {Level::Problem,
            Message(TR_NOOP("core", "there is no interface %1, nor any CAN interface"), facts.name),
            TR_NOOP("core", "plug the adapter in and load its driver; for a virtual one: sudo ip "
                            "link add dev vcan0 type vcan")};
}

void addController(std::vector<CanFinding>& findings, const CanInterfaceFacts& facts,
                   const CanController& controller)
{
    if (facts.isVirtual) {
        findings.push_back(
            {Level::Fine, TR_NOOP("core", "it is virtual: no bit rate, no controller")});
        return;
    }
    const std::string set = fmt::format("sudo ip link set {} ", facts.name);
    if (controller.state.empty()) {
        findings.push_back({Level::Warning,
                            TR_NOOP("core", "its bit rate and its controller's state are not "
                                            "known"),
                            command("sudo apt-get install iproute2")});
        return;
    }
    if (!controller.bitrate)
        findings.push_back({Level::Problem, TR_NOOP("core", "it has no bit rate"),
                            Message(TR_NOOP("core", "%1   (as on the robot's bus)"),
                                    set + "type can bitrate 500000")});
    else
        findings.push_back(
            {Level::Fine, Message(TR_NOOP("core", "bit rate %1 bit/s"), *controller.bitrate)});
    if (controller.state == "BUS-OFF")
        findings.push_back(
            {Level::Problem,
             TR_NOOP("core", "its controller has given up (bus-off): wrong bit rate, no "
                             "terminators or crossed wires"),
             command(set + "down; " + set + "up")});
    else if (controller.state == "ERROR-PASSIVE" || controller.state == "ERROR-WARNING")
        findings.push_back({Level::Warning,
                            Message(TR_NOOP("core", "its controller sees many errors (%1): wrong "
                                                    "bit rate, no terminators or loose wires"),
                                    controller.state),
                            command("ip -details -statistics link show " + facts.name)});
}

void addState(std::vector<CanFinding>& findings, const CanInterfaceFacts& facts)
{
    if (facts.up)
        findings.push_back({Level::Fine, TR_NOOP("core", "it is up")});
    else
        findings.push_back({Level::Problem, TR_NOOP("core", "it is down"),
                            command(fmt::format("sudo ip link set {} up", facts.name))});
    if (facts.sendQueue && *facts.sendQueue > kLongQueue && !facts.isVirtual)
        findings.push_back(
            {Level::Warning,
             Message(TR_NOOP("core", "its send queue holds %1 frames: without acknowledgement, "
                                     "other programs' frames wait in it too long"),
                     *facts.sendQueue),
             command(fmt::format("sudo ip link set {} txqueuelen 10", facts.name))});
}

void addBuffer(std::vector<CanFinding>& findings, const CanInterfaceFacts& facts)
{
    const bool isEnough = facts.mayForce || facts.receiveLimit.value_or(0) >= kReceiveBuffer;
    if (isEnough)
        findings.push_back(
            {Level::Fine, TR_NOOP("core", "the receive buffer may be as large as it has to")});
    else
        findings.push_back(
            {Level::Warning,
             Message(TR_NOOP("core", "the receive buffer is limited to %1 of %2 bytes: frames are "
                                     "lost when this computer is busy"),
                     facts.receiveLimit.value_or(0), kReceiveBuffer),
             command(fmt::format("sudo sysctl -w net.core.rmem_max={}", kReceiveBuffer))});
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
    const Message reason = systemMessage(socketError);
    switch (socketError) {
    case 0: return {Level::Fine, TR_NOOP("core", "the kernel has CAN and this user may use it")};
    case EAFNOSUPPORT:
    case EPROTONOSUPPORT:
        return {Level::Problem,
                Message(TR_NOOP("core", "the kernel has no CAN sockets (%1)"), reason),
                TR_NOOP("core", "sudo modprobe can_raw   (where that fails: a kernel with "
                                "CONFIG_CAN_RAW)")};
    case EPERM:
    case EACCES:
        return {Level::Problem,
                Message(TR_NOOP("core", "this user may not open CAN sockets (%1)"), reason),
                TR_NOOP("core", "run it outside of the sandbox or container that forbids it, or as "
                                "another user")};
    default:
        return {Level::Problem,
                Message(TR_NOOP("core", "a CAN socket cannot be opened (%1)"), reason)};
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
        findings.push_back(
            {Level::Problem, Message(TR_NOOP("core", "%1 is no CAN interface"), facts.name),
             facts.others.empty() ? TR_NOOP("core", "ip -brief link   (lists all there are)")
                                  : command("terratact can check " + facts.others.front())});
        return findings;
    }
    findings.push_back({Level::Fine, TR_NOOP("core", "it is a CAN interface")});
    addController(findings, facts, controller);
    addState(findings, facts);
    addBuffer(findings, facts);
    return findings;
}

}  // namespace terratact
