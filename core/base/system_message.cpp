#include "core/base/system_message.h"

#include <array>
#include <cerrno>
#include <system_error>

namespace terratact {
namespace {

struct Known {
    int code;
    SourceText text;
};

const std::array kKnown{
    Known{ENOENT, TR_NOOP("core", "No such file or directory")},
    Known{EACCES, TR_NOOP("core", "Permission denied")},
    Known{EPERM, TR_NOOP("core", "Operation not permitted")},
    Known{EISDIR, TR_NOOP("core", "Is a directory")},
    Known{ENOTDIR, TR_NOOP("core", "Not a directory")},
    Known{EROFS, TR_NOOP("core", "Read-only file system")},
    Known{ENOSPC, TR_NOOP("core", "No space left on device")},
    Known{EIO, TR_NOOP("core", "Input/output error")},
    Known{ENETDOWN, TR_NOOP("core", "Network is down")},
    Known{ENODEV, TR_NOOP("core", "No such device")},
    Known{ENXIO, TR_NOOP("core", "No such device or address")},
    Known{EBUSY, TR_NOOP("core", "Device or resource busy")},
    Known{ENOBUFS, TR_NOOP("core", "No buffer space available")},
    Known{EADDRINUSE, TR_NOOP("core", "Address already in use")},
    Known{EAFNOSUPPORT, TR_NOOP("core", "Address family not supported by protocol")},
    Known{EPROTONOSUPPORT, TR_NOOP("core", "Protocol not supported")},
};

}  // namespace

Message systemMessage(int code)
{
    for (const Known& known : kKnown)
        if (known.code == code) return known.text;
    return Message::verbatim(std::generic_category().message(code));
}

}  // namespace terratact
