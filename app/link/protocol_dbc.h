#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/wire/dbc/dbc.h"

namespace terratact {

/// The robot's own frames in the words of their DBC file (resources/dbc/terratact.dbc): one for each FrameKind, in that
/// order.  An Error where it cannot be read, or where it is not of the protocol that this program speaks.
Result<std::vector<DbcMessage>> readProtocolDbc(const std::string& path);

}  // namespace terratact
