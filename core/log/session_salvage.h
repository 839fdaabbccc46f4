#pragma once

#include <cerrno>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/rows/session_rows.h"

namespace terratact {

/// Contents of the pages of a damaged session.
struct SalvagedPages {
    SessionStart start;         ///< start of the session, as far as it was found
    bool startIsWhole = false;  ///< the whole start was found
    bool isCut = false;         ///< the file ends before its last page
    /// True if the hashes of at least one batch were found. Otherwise nothing proves that the
    /// frames are what was recorded.
    bool isProven = true;
    std::int64_t batches = 0, frames = 0;
    std::int64_t lastBatch = 0;  ///< largest batch number
};

/// Error::code if the file holds nothing of a session.
inline constexpr int kNothingWhole = ENODATA;

/// Copies the rows in the pages of a damaged session to a new file, unchecked.
/// SessionReader::openFragments() then returns the rows whose recorded hash is valid. The damaged
/// file and its journal are only read, page by page. A cut or a hole therefore costs only the rows
/// in it.
///
/// scratch: must not exist. Errors name the damaged file if it holds nothing of a session
/// (kNothingWhole), or `scratch`.
Result<SalvagedPages> salvagePages(const std::string& path, const std::string& scratch);

}  // namespace terratact
