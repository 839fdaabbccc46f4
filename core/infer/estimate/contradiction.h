#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace terratact {

/// Prefix of the warning that a posterior check failed (core/sim/posterior_check.h). A session
/// stores it among the estimate's warnings.
inline constexpr std::string_view kContradictsReadings = "the estimate contradicts the readings";

/// Returns true if one of the warnings begins with kContradictsReadings.
inline bool sayContradiction(const std::vector<std::string>& warnings)
{
    return std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
        return warning.starts_with(kContradictsReadings);
    });
}

}  // namespace terratact
