#include "drivers/can_interface.h"

#include <linux/if.h>
#include <linux/if_arp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <system_error>

#include "drivers/socketcan.h"

namespace terratact {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kNetAdmin = 12;  // CAP_NET_ADMIN

bool isName(std::string_view name)
{
    return static_cast<bool>(checkInterfaceName(name));
}

// Reads hexadecimal and decimal numbers: "0x10" and "280".
std::optional<unsigned long> numberIn(const fs::path& file)
{
    std::ifstream in(file);
    std::string word;
    if (!(in >> word)) return std::nullopt;
    const bool isHex = word.starts_with("0x");
    unsigned long value = 0;
    const char* const end = word.data() + word.size();
    const auto [rest, error] =
        std::from_chars(word.data() + (isHex ? 2 : 0), end, value, isHex ? 16 : 10);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return value;
}

std::optional<long> countIn(const fs::path& file)
{
    const std::optional<unsigned long> value = numberIn(file);
    return value ? std::optional(static_cast<long>(*value)) : std::nullopt;
}

bool isCanInterface(const fs::path& interface)
{
    return numberIn(interface / "type") == ARPHRD_CAN;
}

std::vector<std::string> canInterfaces(const fs::path& net)
{
    std::vector<std::string> names;
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(net, failure))
        if (isCanInterface(entry.path())) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

bool mayForceBuffers(const fs::path& status)
{
    std::ifstream in(status);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("CapEff:")) continue;
        const std::size_t first = line.find_first_not_of(" \t", 7);
        if (first == std::string::npos) return false;
        unsigned long long bits = 0;
        std::from_chars(line.data() + first, line.data() + line.size(), bits, 16);
        return ((bits >> kNetAdmin) & 1U) != 0;
    }
    return false;
}

}  // namespace

CanInterfaceFacts inspectInterface(const std::string& name, const std::string& root)
{
    const fs::path net = root + "/sys/class/net";
    CanInterfaceFacts facts{.name = name, .sendQueue = {}, .receiveLimit = {}, .others = {}};
    facts.others = canInterfaces(net);
    facts.receiveLimit = countIn(root + "/proc/sys/net/core/rmem_max");
    facts.mayForce = mayForceBuffers(root + "/proc/self/status");
    std::error_code failure;
    if (!isName(name) || !fs::exists(net / name, failure)) return facts;
    facts.present = true;
    facts.isCan = isCanInterface(net / name);
    facts.up =
        (numberIn(net / name / "flags").value_or(0) & static_cast<unsigned long>(IFF_UP)) != 0;
    facts.sendQueue = countIn(net / name / "tx_queue_len");
    facts.isVirtual = !fs::exists(net / name / "device", failure);
    return facts;
}

int canSocketError()
{
    constexpr int kRaw = 1;  // CAN_RAW
    const int fd = ::socket(AF_CAN, SOCK_RAW | SOCK_CLOEXEC, kRaw);
    if (fd < 0) return errno;
    ::close(fd);
    return 0;
}

std::string linkDetails(const std::string& name)
{
    if (!isName(name)) return {};
    const std::string command = "ip -details link show dev " + name + " 2>/dev/null";
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"),
                                                               ::pclose);
    if (!pipe) return {};
    std::string text;
    std::array<char, 1024> block{};
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe.get()))
        text.append(block.data(), count);
    return text;
}

}  // namespace terratact
