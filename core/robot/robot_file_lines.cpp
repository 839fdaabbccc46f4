#include "core/robot/robot_file_lines.h"

#include <toml++/toml.h>

namespace terratact {

std::size_t lineOfKey(const std::string& text, std::string_view key)
{
    try {
        const toml::table file = toml::parse(text);
        if (const auto found = file.at_path(key)) return found.node()->source().begin.line;
        const auto table = file.at_path(key.substr(0, key.find('.')));
        return table ? table.node()->source().begin.line : 0;
    } catch (const toml::parse_error&) {
        return 0;
    }
}

}  // namespace terratact
