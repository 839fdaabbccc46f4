#pragma once

#include <string>
#include <vector>

#include "app/modelling/findings.h"
#include "core/base/result.h"

namespace terratact {

/// Prints how one method or baseline fared, a line.
void printRun(const MethodRun& run);

/// Writes tables and figures of an evaluation into the directory and prints its tables.  Errors name the
/// file that could not be written.
/// findings: of all scenes, else std::invalid_argument.
Status reportFindings(const Findings& findings, const std::string& directory);

/// The names of all files that reportFindings() may write.
std::vector<std::string> reportFiles();

}  // namespace terratact
