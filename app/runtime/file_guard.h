#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace terratact {

using Paths = std::vector<std::string>;

/// The files of a command: those its arguments name, and those found or written beside them. "-" is standard input or
/// standard output.
struct CommandFiles {
    Paths inputs;  ///< files read
    /// Files that belong to an input: the card of a model, the notes and the journal of a session.
    Paths companions;
    Paths outputs;     ///< files written
    Paths updates;     ///< files written although they are companions of an input
    Paths sessions{};  ///< those of the outputs that are sessions
};

/// Checks that no written file is an input, another output, write-protected, a recorded session, or a symbolic link.
/// Only a session may have the name of one (*.tts). Two names are the same file if they have the same device and inode,
/// through any symbolic or hard link. Names of missing files are compared by the path they lead to. Standard output
/// that is a file counts as written. Errors name both files.
Status checkCommandFiles(const CommandFiles& files);

/// Returns the companions of a session or model, existing or not.
Paths companionsOf(const std::string& input);

}  // namespace terratact
