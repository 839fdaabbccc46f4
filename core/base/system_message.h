#pragma once

#include "core/base/message.h"

namespace terratact {

/// What the operating system says of an error number, for translation where it is a usual one.
Message systemMessage(int code);

}  // namespace terratact
