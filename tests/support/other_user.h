#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace terratact {

/// Runs `work` in a child process of another user, without environment variables. Returns its result from 0 to 254, or
/// -1 without the right to do so.
inline int asOtherUser(uid_t user, int (*work)())
{
    constexpr int kMayNot = 255;
    const pid_t child = ::fork();
    if (child == 0) {
        if (::clearenv() != 0 || ::setuid(user) != 0) ::_exit(kMayNot);
        ::_exit(work());
    }
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status) == kMayNot ? -1 : WEXITSTATUS(status);
}

}  // namespace terratact
