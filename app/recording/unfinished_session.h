#pragma once

#include <string>

namespace terratact {

/// Removes a session that this program began to write and could not finish, with its journal.
void removeUnfinishedSession(const std::string& path);

}  // namespace terratact
