#pragma once

#include <optional>
#include <string>
#include <vector>

namespace terratact {

/// Facts about a Linux interface without opening it.
struct CanInterfaceFacts {
    std::string name;
    bool present = false;
    bool isCan = false;
    bool isVirtual = false;  ///< vcan, vxcan: no bit rate, no controller
    bool up = false;
    std::optional<long> sendQueue;     ///< frames (txqueuelen)
    std::optional<long> receiveLimit;  ///< [B] net.core.rmem_max
    bool mayForce = false;             ///< this process may exceed it (CAP_NET_ADMIN)
    std::vector<std::string> others;   ///< existing CAN interfaces, sorted
    bool operator==(const CanInterfaceFacts&) const = default;
};

/// Reads /sys/class/net and /proc below `root`. Facts that cannot be read are absent, false or
/// empty. The name may be any text: one that cannot be an interface is not present.
CanInterfaceFacts inspectInterface(const std::string& name, const std::string& root = "");

/// Returns 0, or the errno that prevents this process from opening a CAN socket.
int canSocketError();

/// Returns the output of `ip -details link show` for an interface: its controller's bit rate and
/// state. Empty if the command is missing or fails, or if the name is invalid.
std::string linkDetails(const std::string& name);

}  // namespace terratact
