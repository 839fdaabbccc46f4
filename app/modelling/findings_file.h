#pragma once

#include <string>

#include "app/modelling/findings.h"
#include "core/base/result.h"

namespace terratact {

/// Writes findings as *.tte: one SQLite file (application_id 0x54544531, user_version 3). It holds every error,
/// forecast and probe, and the content's hash. The file is written under a temporary name and renamed. Reading returns
/// bit-identical values, except that -0 becomes 0.
Status writeFindings(const std::string& path, const Findings& findings);

/// Returns the file name for the findings of one part.
std::string shardFile(const Shard& shard);

/// Returns true if a file has the application_id of *.tte; false also if it cannot be read.
bool isFindingsFile(const std::string& path);

/// Opens read-only and validates application_id, user_version, integrity, schema and hash. Numbers must be finite and
/// in their ranges, and scenes belong to the part. Errors are one sentence with file and cause.
Result<Findings> readFindings(const std::string& path);

}  // namespace terratact
