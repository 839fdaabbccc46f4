#include "drivers/can_bus.h"

#include <stdexcept>
#include <utility>

namespace terratact {
namespace {

SourceText faultOf(BusState state)
{
    switch (state) {
    case BusState::Up: return TR_NOOP("BusWords", "%1: working");
    case BusState::Stalled:
        return TR_NOOP("BusWords",
                       "%1 does not take frames: no node acknowledges them, or the bus is full. "
                       "Check the robot's power, the wires and the bit rate");
    case BusState::ErrorWarning:
        return TR_NOOP("BusWords", "%1 has errors: check wires, terminators and bit rate");
    case BusState::ErrorPassive:
        return TR_NOOP("BusWords", "%1 has many errors: check wires, terminators and bit rate");
    case BusState::BusOff:
        return TR_NOOP("BusWords",
                       "%1 is bus-off after too many errors: check the wires, then restart it");
    case BusState::Down: return TR_NOOP("BusWords", "%1 is down: bring it up");
    case BusState::Absent:
        return TR_NOOP("BusWords", "%1 does not exist: plug the adapter in, or make the interface");
    case BusState::Ended: return TR_NOOP("BusWords", "%1 has ended");
    }
    throw std::invalid_argument("BusState: no such state");
}

}  // namespace

void requireSendable(const CanFrame& frame)
{
    if (frame.fd || frame.error)
        throw std::invalid_argument("CanBus: neither FD nor error frames are sent");
    if (frame.length > kClassicBytes) throw std::invalid_argument("CanBus: more than eight bytes");
    if (frame.id > (frame.extended ? 0x1fffffffu : 0x7ffu))
        throw std::invalid_argument("CanBus: the identifier has too many bits");
}

std::string cureOf(BusState state, const std::string& bus)
{
    const bool isVirtual = bus.starts_with("vcan");
    switch (state) {
    case BusState::Up:
    case BusState::Stalled:
    case BusState::Ended: return {};
    case BusState::ErrorWarning:
    case BusState::ErrorPassive: return "ip -details -statistics link show " + bus;
    case BusState::BusOff: return "sudo ip link set " + bus + " type can restart";
    case BusState::Down:
        if (isVirtual) return "sudo ip link set " + bus + " up";
        return "sudo ip link set " + bus + " up type can bitrate 500000";
    case BusState::Absent:
        if (isVirtual) return "sudo ip link add dev " + bus + " type vcan";
        return "ip -brief link show type can";
    }
    throw std::invalid_argument("BusState: no such state");
}

Message describe(BusState state, const std::string& bus)
{
    Message fault(faultOf(state), bus == kInternalBus ? Message(TR_NOOP("BusWords", "internal bus"))
                                                      : Message::verbatim(bus));
    const std::string command = cureOf(state, bus);
    return command.empty() ? fault : Message::followedBy(std::move(fault), command);
}

}  // namespace terratact
