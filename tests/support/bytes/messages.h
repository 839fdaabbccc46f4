#pragma once

#include <optional>
#include <string_view>

#include "core/base/message.h"

namespace terratact {

/// Returns true if there is a message whose English text has these words.
inline bool mentions(const std::optional<Message>& message, std::string_view words)
{
    return message && message->english().find(words) != std::string::npos;
}

}  // namespace terratact
