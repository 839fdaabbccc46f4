#pragma once

namespace terratact {

/// Runs `terratact` with the arguments of main(), and prints its failure to standard error. Returns the exit code: 0, 1
/// for a failure, 2 for wrong arguments. Limits OpenBLAS to one thread and handles signals of this process.
int runCommandLine(int argc, char** argv);

}  // namespace terratact
