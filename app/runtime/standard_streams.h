#pragma once

namespace terratact {

/// Opens a placeholder for each closed standard stream. Otherwise a file could get that descriptor, and printed text
/// would go to the file. Reading from such a stream and writing to it fail as before. Call it first in main().
void holdStandardStreams();

}  // namespace terratact
