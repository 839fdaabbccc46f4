#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace terratact {

/// A note made while reviewing.
struct ReviewNote {
    double time = 0.0;  ///< [s] of the session
    std::string text{};
    bool operator==(const ReviewNote&) const = default;
};

/// Notes stand in a file beside the session, SESSION.notes.csv with the columns t_s,note: the session itself is
/// never changed.  RFC 4180: a note with a comma, a quotation mark or a line end stands in quotes.
std::string notesPath(const std::string& session);
/// None where there is no such file.  Errors name file, line and cause.
Result<std::vector<ReviewNote>> readNotes(const std::string& session);
Status writeNotes(const std::string& session, const std::vector<ReviewNote>& notes);

}  // namespace terratact
