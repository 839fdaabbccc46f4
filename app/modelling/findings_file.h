#pragma once

#include <string>

#include "app/modelling/findings.h"
#include "core/base/result.h"

namespace terratact {

/// Writes findings as a *.tte: one SQLite file (application_id 0x54544531, user_version 1) with every
/// error, forecast and probe, and the content's hash; under a temporary name, then renamed.  What is read back is
/// equal to the bit, but for -0, which becomes 0.
Status writeFindings(const std::string& path, const Findings& findings);

/// Whether a file has the mark of a *.tte; false where it cannot be read.
bool isFindingsFile(const std::string& path);

/// Opens read-only and validates: application_id, user_version, integrity, schema, finite numbers in
/// their ranges, the scenes of its part, and the content's hash.  Errors are one sentence naming the file
/// and the cause.
Result<Findings> readFindings(const std::string& path);

}  // namespace terratact
