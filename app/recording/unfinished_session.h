#pragma once

#include <string>

namespace terratact {

/// Removes a session that this program began to write and could not finish, with its journal.
void removeUnfinishedSession(const std::string& path);

/// Notes a session that is about to be made of other files. A signal then removes it with its
/// journal. Does nothing where a file has that name already.
class SessionInProgress {
public:
    explicit SessionInProgress(std::string path);
    ~SessionInProgress();
    SessionInProgress(const SessionInProgress&) = delete;
    SessionInProgress& operator=(const SessionInProgress&) = delete;

private:
    std::string path_;
};

}  // namespace terratact
