#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/text.h"

namespace terratact {

/// A text of several lines that the program formatted itself. Texts from files inside it are already one line
/// (printable()). Other unprintable characters become '?'.
struct Lines {
    explicit Lines(std::string_view several) : text(several) {}
    std::string_view text;
};

template <class Value>
auto forTerminal(const Value& value)
{
    if constexpr (std::is_same_v<Value, Lines>)
        return printableLines(value.text);
    else if constexpr (std::is_convertible_v<const Value&, std::string_view>)
        return printable(value);
    else
        return value;
}

/// Prints a formatted text; all output of the programs goes through here. Each value may come from an untrusted file,
/// so it becomes one line without control characters (printable()). If nothing can be written, it does nothing more:
/// std::ferror(to) is set.
template <class... Values>
void printText(std::FILE* to,
               fmt::format_string<decltype(forTerminal(std::declval<const Values&>()))...> format,
               const Values&... values)
{
    const std::string text = fmt::format(format, forTerminal(values)...);
    (void)std::fwrite(text.data(), 1, text.size(), to);
}

template <class... Values>
void printText(fmt::format_string<decltype(forTerminal(std::declval<const Values&>()))...> format,
               const Values&... values)
{
    printText(stdout, format, values...);
}

}  // namespace terratact
