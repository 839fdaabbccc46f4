#pragma once

#include <string>
#include <string_view>

namespace terratact {

/// Returns the line of a key in a TOML text, such as "front_flipper.mass_kg"; first line 1. Returns
/// the line of the table if it lacks the key. Returns 0 without such a table, or if the text is not
/// TOML.
std::size_t lineOfKey(const std::string& text, std::string_view key);

}  // namespace terratact
