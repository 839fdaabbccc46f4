#pragma once

#include <QString>

#include "core/base/message.h"

namespace terratact {

/// Returns a message of the core in the operator's language, on as many lines as it has. What has no translation stays
/// as it is. Control characters become '?'.
QString translated(const Message& message);

}  // namespace terratact
