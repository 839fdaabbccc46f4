#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace terratact {

struct MergedSession {
    std::size_t sessions = 0;
    std::int64_t frames = 0;
    std::string chain{};  ///< last link of the new session's chain
};

/// Merges sessions of one robot, source and bus into a new, sealed one. The files may be given in any order; the times
/// of their frames decide. An event for each session holds its file name, its number of frames and its last link.
///
/// Errors name the file: it is unreadable, of another robot, source or bus, or overlaps another
/// one. Others: two files are more than a month apart; `out` exists or cannot be written. An error
/// leaves no new file. files: at least one.
Result<MergedSession> mergeSessionFiles(const std::vector<std::string>& files,
                                        const std::string& out);

}  // namespace terratact
