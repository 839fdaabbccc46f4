#pragma once

#include <array>
#include <cstddef>
#include <optional>
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

}  // namespace terratact
