#pragma once

#include <string>

#include "core/log/session_reader.h"

namespace terratact {

/// Opens a session as SessionReader::open(). The error of a damaged session names `session recover`,
/// which saves its undamaged rows. An error for too many open files does not.
Result<SessionReader> openSession(const std::string& path);

}  // namespace terratact
