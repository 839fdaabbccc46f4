#pragma once

#include <cstdint>
#include <span>

#include "core/store/sqlite_tables.h"

namespace terratact {

inline constexpr std::int64_t kFindingsApplicationId = 0x54544531;  // "TTE1"
inline constexpr std::int64_t kFindingsVersion = 3;                 ///< user_version of the file

/// Returns the tables of a findings file (*.tte), sorted by name.
std::span<const SqliteTable> findingsTables();

}  // namespace terratact
