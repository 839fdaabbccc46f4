#pragma once

#include <optional>
#include <string>
#include <vector>

namespace terratact {

/// What Linux says of an interface without its being opened.
struct CanInterfaceFacts {
    std::string name;
    bool present = false;
    bool isCan = false;
    bool isVirtual = false;  ///< vcan, vxcan: no bit rate, no controller
    bool up = false;
    std::optional<long> sendQueue;     ///< frames (txqueuelen)
    std::optional<long> receiveLimit;  ///< [B] net.core.rmem_max
    bool mayForce = false;             ///< this process may exceed it (CAP_NET_ADMIN)
    std::vector<std::string> others;   ///< CAN interfaces that are there, sorted
    bool operator==(const CanInterfaceFacts&) const = default;
};

/// Reads /sys/class/net and /proc below `root`; what cannot be read is absent, false or empty.  The name may be
/// any text: what cannot be an interface is not present.
CanInterfaceFacts lookAtInterface(const std::string& name, const std::string& root = "");

/// 0, or why this process cannot have a CAN socket (errno).
int canSocketError();

/// What `ip -details link show` prints of an interface: its controller's bit rate and state.  Empty where the
/// command is not there, fails, or the name is none.
std::string linkDetails(const std::string& name);

}  // namespace terratact
