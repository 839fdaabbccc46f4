#pragma once

#include "core/base/message.h"

namespace terratact {

/// The operating system's text of an error number; usual ones can be translated.
Message systemMessage(int code);

}  // namespace terratact
