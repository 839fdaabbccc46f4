#pragma once

#include <span>
#include <string>

#include "core/eval/evaluation.h"

namespace terratact {

/// Returns the part of the truth's own sd in the errors of each method. Empty if every true height is exact.
std::string truthShareText(std::span<const BinError> errors);

}  // namespace terratact
