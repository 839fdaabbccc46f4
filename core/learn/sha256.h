#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace terratact {

/// SHA-256 of the bytes as 64 lower-case hexadecimal digits (FIPS 180-4).
std::string sha256Hex(std::string_view bytes);

/// The same of a file's bytes, at most 1 GiB.  Errors as readFile.
Result<std::string> sha256OfFile(const std::string& path);

}  // namespace terratact
