#include "core/text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace terratact {

std::string numberText(double value)
{
    std::array<char, 32> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end};  // 24 characters suffice for every double
}

std::string randomErrorText(double sd, int decimals)
{
    const double least = std::pow(10.0, -decimals);
    return sd < 0.5 * least ? fmt::format("< {:.{}f}", least, decimals)
                            : fmt::format("{:.{}f}", sd, decimals);
}

std::string rhatText(double rhat)
{
    constexpr double kMost = 100.0;
    return rhat > kMost ? fmt::format("> {:.0f}", kMost) : fmt::format("{:.3f}", rhat);
}

std::optional<double> numberFrom(std::string_view text)
{
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return value;
}

std::string shown(std::string_view text)
{
    constexpr std::size_t kLongest = 40;
    std::string line = "'";
    for (const char c : text.substr(0, kLongest)) line += c >= ' ' && c <= '~' ? c : '?';
    line += text.size() > kLongest ? "…'" : "'";
    return line;
}

}  // namespace terratact
