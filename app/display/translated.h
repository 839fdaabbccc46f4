#pragma once

#include <QString>
#include <string>

#include "core/base/message.h"

namespace terratact {

/// Returns a message of the core in the operator's language, on as many lines as it has. What has no translation stays
/// as it is. Control characters become '?'.
QString translated(const Message& message);

/// Returns translated() on one line: line ends become spaces.
QString translatedLine(const Message& message);

/// Returns a message in the operator's language for reports and pictures (app/figures/wording.h). Units are metres and
/// degrees, as in every file. Control characters become '?'. Any thread.
std::string inReadersLanguage(const Message& message);

/// Returns a message of a text that is the same in every language, such as a number of format.h.
Message verbatim(const QString& text);

}  // namespace terratact
