#pragma once

#include <string>

namespace terratact {

// Names of the files that this process has begun and not finished. A program's signal handler removes
// them before the signal ends the program. The list belongs to the whole process, like signals.

/// Notes a file until forgetUnfinished(). Names beyond 16, or of more than 4095 bytes, are not noted.
void noteUnfinished(const std::string& path);
void forgetUnfinished(const std::string& path);

/// Removes the noted files. A signal handler may call it.
void removeUnfinished() noexcept;

}  // namespace terratact
