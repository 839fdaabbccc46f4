#pragma once

#include <optional>
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

/// The other way: takes a field off the front of `rest`, which then begins with what ends it: a comma, a line end or
/// nothing.  Empty: its quote does not end, or something else stands behind that.
inline std::optional<std::string> takeCsvField(std::string_view& rest)
{
    if (!rest.starts_with('"')) {
        const std::string_view field = rest.substr(0, rest.find_first_of(",\r\n"));
        rest.remove_prefix(field.size());
        return std::string(field);
    }
    std::string text;
    for (rest.remove_prefix(1); !rest.empty(); rest.remove_prefix(1)) {
        if (rest.starts_with("\"\""))
            rest.remove_prefix(1);  // stands for one
        else if (rest.front() == '"') {
            rest.remove_prefix(1);
            const bool isEnd = rest.empty() || rest.find_first_of(",\r\n") == 0;
            return isEnd ? std::optional(text) : std::nullopt;
        }
        text += rest.front();
    }
    return std::nullopt;
}

}  // namespace terratact
