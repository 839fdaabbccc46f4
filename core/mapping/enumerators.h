#pragma once

#include <optional>
#include <string>

#include "core/mapping/mapping.h"

namespace terratact {

/// Returns the position of an activity or a refusal among its enumerators. text: the English text
/// that describes it. Empty: the text is unknown.
std::optional<double> enumeratorOf(Quantity quantity, const std::string& text);

}  // namespace terratact
