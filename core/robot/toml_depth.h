#pragma once

#include <string_view>

namespace terratact {

/// Returns an upper bound of the nesting depth of a TOML text. It counts open brackets, plus the
/// dots of the dotted key or header being read. Brackets and dots in strings and comments do not
/// count. One pass, no recursion, any bytes. It protects the recursive parser from a text that
/// would exhaust its stack.
int nestingDepth(std::string_view toml);

}  // namespace terratact
