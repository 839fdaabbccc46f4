#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace terratact {

using Paths = std::vector<std::string>;

/// The files of a command, as its arguments name them, and those that it finds or writes beside them.  "-" is the
/// standard input among those that are read, the standard output among those that are written.
struct CommandFiles {
    Paths inputs;  ///< read
    Paths
        companions;  ///< belong to an input: the card of a model, the notes and the journal of a session
    Paths outputs;  ///< written
    Paths updates;  ///< written, though they are companions of an input
};

/// Done where no file that the command writes is one that it reads, nor another that it writes, nor write-protected,
/// nor a recorded session.  Two names are one file where they have the same device and inode, however they are
/// spelt, through symbolic and hard links; where no file is there yet, where they lead to the same place.  A
/// standard output that is a file counts as written.  Errors name both.
Status checkCommandFiles(const CommandFiles& files);

/// What belongs to a session, or to a model, whether it is there or not.
Paths companionsOf(const std::string& input);

}  // namespace terratact
