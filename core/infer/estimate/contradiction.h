#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace terratact {

/// Prefix of the warning that a posterior check failed (core/sim/posterior_check.h). Sessions of
/// versions 1 and 2 store it among the estimate's warnings alone.
inline constexpr std::string_view kContradictsReadings = "the estimate contradicts the readings";

/// Returns true if one of the warnings begins with kContradictsReadings.
inline bool haveContradiction(const std::vector<Message>& warnings)
{
    return std::any_of(warnings.begin(), warnings.end(), [](const Message& warning) {
        return warning.source.starts_with(kContradictsReadings);
    });
}

}  // namespace terratact
