#pragma once

#include <optional>
#include <string>

#include "core/mapping/mapping.h"

namespace terratact {

/// Returns the position of an activity or a refusal among its enumerators, by the English text that
/// describes it; empty for an unknown text.
std::optional<double> enumeratorOf(Quantity quantity, const std::string& text);

}  // namespace terratact
