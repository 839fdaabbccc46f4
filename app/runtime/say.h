#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <type_traits>

#include "core/base/text.h"

namespace terratact {

/// A text of several lines that the program has laid out itself; texts of files in it cannot end a line (they are
/// printable(), or were read as one line), and what else is not printable is '?' all the same.
struct Lines {
    explicit Lines(std::string_view several) : text(several) {}
    std::string_view text;
};

template <class Value>
auto sayable(const Value& value)
{
    if constexpr (std::is_same_v<Value, Lines>)
        return printableLines(value.text);
    else if constexpr (std::is_convertible_v<const Value&, std::string_view>)
        return printable(value);
    else
        return value;
}

/// All that the programs print goes through here: a text that fills a place of the format may come from anybody's
/// file, so it is one line that moves no cursor and hides nothing (printable()).
template <class... Values>
void say(std::FILE* to,
         fmt::format_string<decltype(sayable(std::declval<const Values&>()))...> format,
         const Values&... values)
{
    fmt::print(to, format, sayable(values)...);
}

template <class... Values>
void say(fmt::format_string<decltype(sayable(std::declval<const Values&>()))...> format,
         const Values&... values)
{
    say(stdout, format, values...);
}

}  // namespace terratact
