#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/wire/dbc/dbc.h"

namespace terratact {

/// Reads the DBC file of the robot's protocol (resources/dbc/terratact.dbc): one message for each FrameKind, in that
/// order. Returns an Error if it cannot be read or differs from the protocol in this program.
Result<std::vector<DbcMessage>> readProtocolDbc(const std::string& path);

}  // namespace terratact
