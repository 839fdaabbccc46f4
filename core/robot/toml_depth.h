#pragma once

#include <string_view>

namespace terratact {

/// An upper bound of how deep a TOML text nests: brackets open at a time, plus the dots of the dotted key
/// or header being read; those inside strings and comments do not count.  One pass, no recursion, any
/// bytes: a recursive parser can then be kept away from a text that would exhaust its stack.
int nestingDepth(std::string_view toml);

}  // namespace terratact
