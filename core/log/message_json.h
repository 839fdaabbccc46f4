#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.h"

namespace terratact {

// Messages as a session keeps them, in JSON on one line: a text that is not translated is a string, every other one
// is an array of its context, its source and its arguments:
//   ["core","roll %1°: the ground is not the same left and right","-5.2"]
// An empty message is an empty text.

std::string jsonOf(const Message& message);

/// Empty for a text that jsonOf() does not write: other JSON, more than nine arguments, arrays deeper than eight.
std::optional<Message> messageFromJson(std::string_view json);

}  // namespace terratact
