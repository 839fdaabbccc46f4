#pragma once

#include <string>

#include "core/log/session_reader.h"

namespace terratact {

/// Opens a session as SessionReader::open(). The error of a damaged session, such as a truncated
/// one, names `session recover`, which saves what is whole. It does not where the process or the
/// system has too many open files.
Result<SessionReader> openSession(const std::string& path);

}  // namespace terratact
