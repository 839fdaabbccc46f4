#pragma once

#include <string>

#include "core/log/session_reader.h"

namespace terratact {

/// Opens a session as SessionReader::open(). The error of a damaged session, such as a truncated
/// one, also says that `session recover` saves what is whole in it.
Result<SessionReader> openSession(const std::string& path);

}  // namespace terratact
