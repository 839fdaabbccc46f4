#pragma once

#include <string>
#include <vector>

#include "app/modelling/findings.h"
#include "core/base/result.h"

namespace terratact {

/// Prints one line with the results of a method or baseline.
void printRun(const MethodRun& run);

/// Writes an evaluation's tables and figures into the directory and prints the tables. Errors name the file that could
/// not be written. Throws std::invalid_argument unless the findings cover all scenes.
Status reportFindings(const Findings& findings, const std::string& directory);

/// Returns the names of all files that reportFindings() may write.
std::vector<std::string> reportFiles();

}  // namespace terratact
