#include "app/runtime/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <initializer_list>

namespace terratact {

void holdStandardStreams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) != -1) continue;
        const int way = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
        const int opened = ::open("/dev/null", way);  // gets the lowest free descriptor
        if (opened > stream) ::close(opened);
    }
}

}  // namespace terratact
