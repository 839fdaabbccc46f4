#pragma once

namespace terratact {

/// What the commands say of the logs they read.
inline constexpr const char* kLogHelp = "Log of candump, Vector (.asc), PEAK (.trc), or CSV of "
                                        "GVRET or python-can, also packed by gzip; "
                                        "- is standard input";

}  // namespace terratact
