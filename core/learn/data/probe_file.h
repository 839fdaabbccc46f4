#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/store/csv_reader.h"

namespace terratact {

/// Largest number of readings in one file.
inline constexpr std::size_t kMaxProbeReadings = 100'000;

/// One reading of the arm for measuring its accuracy.
struct ProbeReading {
    std::string place;            ///< place that was touched; readings of one place are repetitions
    double height = 0.0;          ///< as the arm reports it [m]
    std::optional<double> truth;  ///< true height of the place [m], if known
    bool operator==(const ProbeReading&) const = default;
};

/// Reads a CSV file (core/store/csv_reader.h) with the header place,height_m,truth_m. truth_m may
/// be missing in a line, or NaN. Errors name file, line and cause. Causes: another header; wrong
/// numbers or units; heights beyond ±5 m; a place without a name; two truths of a place that differ
/// by more than 0.1 mm; no reading; more than kMaxProbeReadings.
Result<std::vector<ProbeReading>> readProbeReadings(const std::string& path);

/// Reads the same from an open CSV.
Result<std::vector<ProbeReading>> readProbeReadings(CsvReader csv);

}  // namespace terratact
