#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/base/message.h"

namespace terratact {

/// Formats a message in the language of who reads a report or a picture: inEnglish() for the command line, the
/// operator's language in the console. It may be called from any thread.
using Wording = std::function<std::string(const Message&)>;

/// Returns message.english().
std::string inEnglish(const Message& message);

/// Returns a name of an event, such as "approve", for translators (app/display/event_names.cpp).
Message eventName(std::string name);

/// Returns the source of a session's frames, such as "SIMULATED ROBOT" or "REPLAY drive.log".
Message sourceMessage(std::string_view name);

/// Returns a word of a table of bins: the name of a Provenance, of a Touch, of an Ending, or of a side.
Message tableWord(std::string_view name);

}  // namespace terratact
