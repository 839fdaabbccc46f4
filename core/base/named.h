#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace terratact {

/// Returns the value whose name() is the text; empty if there is none.
template <class Value, std::size_t n>
std::optional<Value> named(std::string_view text, const std::array<Value, n>& values)
{
    for (const Value value : values)
        if (name(value) == text) return value;
    return std::nullopt;
}

/// The name of an enumerator, from the table of all names in the order of the values.  Throws std::invalid_argument for
/// a value without a name.
template <class Enum, std::size_t n>
std::string_view nameIn(const std::array<std::string_view, n>& names, Enum value)
{
    const auto i = static_cast<std::size_t>(value);
    if (i >= n) throw std::invalid_argument("name: no such value");
    return names[i];
}

/// The enumerator of that name; empty: none.
template <class Enum, std::size_t n>
std::optional<Enum> valueIn(const std::array<std::string_view, n>& names, std::string_view text)
{
    for (std::size_t i = 0; i < n; ++i)
        if (names[i] == text) return static_cast<Enum>(i);
    return std::nullopt;
}

}  // namespace terratact
