#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// Returns the Error "`path`: `cause`" with which every message about a file begins. Control
/// characters of the cause, which may quote the file, become '?'.
Error fileError(const std::string& path, Message cause, int code = 0);
/// The same in English alone.
Error fileError(const std::string& path, std::string_view cause, int code = 0);

/// Returns the whole content of a file or pipe. Errors name the file: it cannot be opened or read,
/// is a directory, or has more than `most` bytes. No more than `most` bytes are held in memory.
Result<std::string> readFile(const std::string& path, std::size_t most);

}  // namespace terratact
