#pragma once

#include <cerrno>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/session_rows.h"

namespace terratact {

/// What was found in the pages of a damaged session.
struct SalvagedPages {
    SessionStart start;         ///< as far as it is there
    bool startIsWhole = false;  ///< all of it is there
    bool isCut = false;         ///< the file ends before its last page
    /// The hashes of at least one batch are there.  Otherwise the frames stand as they are in the pages, and nothing
    /// proves that they are what was recorded.
    bool isProven = true;
    std::int64_t batches = 0, frames = 0;
    std::int64_t lastBatch = 0;  ///< the largest number of a batch
};

/// Error::code where nothing of a session is in the file.
inline constexpr int kNothingWhole = ENODATA;

/// Brings what the pages of a damaged session hold into a new file, as it is: to be read by
/// SessionReader::openFragments(), which hands out what has the hash that was recorded with it.  The damaged file and
/// its journal are only read, page by page, so that neither a cut nor a hole takes away more than what stood there.
///
/// scratch: must not exist.  Errors name the damaged file, where nothing of a session is in it (kNothingWhole), or `scratch`.
Result<SalvagedPages> salvagePages(const std::string& path, const std::string& scratch);

}  // namespace terratact
