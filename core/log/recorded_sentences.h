#pragma once

#include <string>

#include "core/base/message.h"

namespace terratact {

/// Returns the message that a sentence of session versions 1 to 3 was made of. Those versions hold
/// the operator's sentences in English. In English the message is that sentence; it can be shown in
/// the reader's language, too. A sentence that is not in the table is returned verbatim. The table
/// is frozen, like that of withNames().
Message recordedSentence(const std::string& english);

}  // namespace terratact
