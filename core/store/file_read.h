#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// "`path`: `cause`" as every message about a file begins; control characters of the cause, which may quote the
/// file, as '?'.
Error fileError(const std::string& path, std::string_view cause, int code = 0);

/// The whole content of a file or pipe.  Errors name the file: it cannot be opened or read, is a
/// directory, or has more than `most` bytes (no more than that is ever held in memory).
Result<std::string> readFile(const std::string& path, std::size_t most);

}  // namespace terratact
