#pragma once

namespace terratact {

/// Gives each closed standard stream a descriptor of its own, so that no file gets it and what is printed cannot end
/// up in that file. Reading from such a stream and writing to it fail as before. Call it first in main().
void holdStandardStreams();

}  // namespace terratact
