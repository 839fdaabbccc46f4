#pragma once

namespace terratact {

/// Help text about log formats for all commands.
inline constexpr const char* kLogHelp = "Log of candump, Vector (.asc), PEAK (.trc), or CSV of "
                                        "GVRET or python-can, also packed by gzip; "
                                        "- is standard input";

}  // namespace terratact
