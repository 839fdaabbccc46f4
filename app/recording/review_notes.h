#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace terratact {

/// A note made during a review.
struct ReviewNote {
    double time = 0.0;  ///< [s] of the session
    std::string text{};
    bool operator==(const ReviewNote&) const = default;
};

/// Returns the path of the notes: SESSION.notes.csv with the columns t_s,note. The session itself never changes. A note
/// with a comma, a quotation mark or a line end is quoted (RFC 4180).
std::string notesPath(const std::string& session);
/// Reads the notes; none if the file does not exist. Errors name file, line and cause.
Result<std::vector<ReviewNote>> readNotes(const std::string& session);
Status writeNotes(const std::string& session, const std::vector<ReviewNote>& notes);

}  // namespace terratact
