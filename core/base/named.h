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

/// Returns true if the enumeration has an enumerator of that value. The compiler writes other values
/// as a cast, such as (Enum)7.
template <class Enum, Enum value>
constexpr bool isEnumerator()
{
    const std::string_view signature(__PRETTY_FUNCTION__);
    return signature[signature.rfind("= ") + 2] != '(';
}

/// Returns the number of enumerators. Their values are 0, 1, 2 and so on.
template <class Enum, std::size_t from = 0>
constexpr std::size_t enumerators()
{
    if constexpr (isEnumerator<Enum, static_cast<Enum>(from)>())
        return enumerators<Enum, from + 1>();
    else
        return from;
}

/// Returns the table of an enumeration's names, in the order of the enumerators. A table of another
/// size does not compile.
template <class Enum, class... Text>
constexpr auto namesOf(Text... names)
{
    static_assert(sizeof...(names) == enumerators<Enum>(), "every enumerator needs one name");
    return std::array<std::string_view, sizeof...(names)>{names...};
}

/// Returns the name of an enumerator from namesOf(). Throws std::invalid_argument for a value without
/// a name.
template <class Enum, std::size_t n>
std::string_view nameIn(const std::array<std::string_view, n>& names, Enum value)
{
    const auto i = static_cast<std::size_t>(value);
    if (i >= n) throw std::invalid_argument("name: no such value");
    return names[i];
}

/// Returns the enumerator of that name; empty if there is none.
template <class Enum, std::size_t n>
constexpr std::optional<Enum> valueIn(const std::array<std::string_view, n>& names,
                                      std::string_view text)
{
    for (std::size_t i = 0; i < n; ++i)
        if (names[i] == text) return static_cast<Enum>(i);
    return std::nullopt;
}

}  // namespace terratact
