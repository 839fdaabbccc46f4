#pragma once

#include <string>
#include <string_view>

namespace terratact {

/// A field of a CSV file as RFC 4180 has it: in quotes where it holds a comma, a quote or a line end.
inline std::string csvField(std::string_view text)
{
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
    return quoted + "\"";
}

}  // namespace terratact
