#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace terratact {

/// How a warning begins that says a posterior check failed (core/sim/posterior_check.h). A session keeps it among the
/// estimate's warnings.
inline constexpr std::string_view kContradictsReadings = "the estimate contradicts the readings";

/// Whether one of an estimate's warnings says so.
inline bool sayContradiction(const std::vector<std::string>& warnings)
{
    return std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
        return warning.starts_with(kContradictsReadings);
    });
}

}  // namespace terratact
