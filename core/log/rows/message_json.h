#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.h"

namespace terratact {

// JSON form of messages in a session, on one line. A text that is not translated is a string. Any
// other message is an array of its context, its source and its arguments:
//   ["core","roll %1°: the ground is not the same left and right","-5.2"]
// An empty message gives an empty text.

std::string jsonOf(const Message& message);

/// Returns the message. Empty for a text that jsonOf() does not write: other JSON, more than nine
/// arguments, arrays deeper than eight.
std::optional<Message> messageFromJson(std::string_view json);

}  // namespace terratact
