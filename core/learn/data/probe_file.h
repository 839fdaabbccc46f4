#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/store/csv_reader.h"

namespace terratact {

/// No file holds more.
inline constexpr std::size_t kMaxProbeReadings = 100'000;

/// One reading of the arm, taken to learn how well it measures.
struct ProbeReading {
    std::string place;            ///< what was touched; readings of one place repeat each other
    double height = 0.0;          ///< [m] as the arm reports it
    std::optional<double> truth;  ///< [m] of the place, where it is known
    bool operator==(const ProbeReading&) const = default;
};

/// Reads a CSV (core/store/csv_reader.h) with the header place,height_m,truth_m; truth_m may be missing in a line, or NaN.
/// Errors name file, line and cause: another header, wrong numbers or units, heights beyond ±5 m, a place without a
/// name, no reading at all, more than kMaxProbeReadings.
Result<std::vector<ProbeReading>> readProbeReadings(const std::string& path);

/// The same from its first line on.
Result<std::vector<ProbeReading>> readProbeReadings(CsvReader csv);

}  // namespace terratact
