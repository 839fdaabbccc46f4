#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "core/store/canonical_bytes.h"
#include "core/store/sqlite.h"
#include "core/store/sqlite_tables.h"
#include "core/trail/trail_inputs.h"
#include "core/trail/trail_model.h"

namespace terratact::trail_file {

// Tables of a *.ttn file (core/trail/trail_file.h).

/// Version of the files that are written. Files without the table `drive` are read, too.
inline constexpr std::int64_t kVersion = 4, kVersionWithoutDrives = 3;

inline constexpr Eigen::Index kMaxWidth = 499;  ///< a blob of the file has at most 1 000 000 bytes

/// One kind of networks: its name in the file, its inputs, and the sides of an error scene.
struct Kind {
    const char* name;
    Eigen::Index inputs, sides;
};
inline constexpr Kind kPlaneKind{"plane", kPlaneInputs, 1}, kSideKind{"side", kSideInputs, 2};

/// Returns the tables of a version, by name.
std::span<const SqliteTable> tablesOf(std::int64_t version);

/// Adds the numbers of networks to the bytes of the content's hash.
void addContent(CanonicalBytes& bytes, const TrailNetworks& networks);

void writeNetworks(SqliteFile& file, const Kind& kind, const TrailNetworks& networks);

/// Reads the networks of a kind; empty if the file holds none. Throws Refused
/// (core/learn/model/file/model_checks.h) and SqliteError.
TrailNetworks readNetworks(SqliteFile& file, const Kind& kind, std::int64_t version);

/// Refuses rows that no kind of networks reads, in the same way.
void requireKnownRows(SqliteFile& file, const TrailData& data, std::int64_t version);

}  // namespace terratact::trail_file
