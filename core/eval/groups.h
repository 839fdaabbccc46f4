#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/eval/evaluation.h"
#include "core/store/csv_reader.h"

namespace terratact {

/// Statistics of the errors of one label in one group of scenes.
struct GroupSummary {
    std::string group;
    std::string label;
    std::size_t scenes = 0;
    ErrorStatistics all{};
};

/// Returns the groups "inside" (novelty ≤ 1) and "outside" the training scenes, for the labels that
/// judge novelty. Groups without errors are left out.
std::vector<GroupSummary> byNovelty(std::span<const BinError> errors);

/// Class of each row of an index file.
using Classes = std::map<std::string, std::string>;
inline constexpr std::size_t kMaxClassRows = 200'000;  ///< rows of an index file

/// Reads the columns `row` and `column` of a CSV index (core/store/csv_reader.h). Errors name the
/// file, the line and the cause. Causes: those of CsvReader, a missing column, a duplicate row,
/// more than kMaxClassRows rows.
Result<Classes> readClasses(const std::string& path, const std::string& column);

/// Reads the same from an open CSV.
Result<Classes> readClasses(CsvReader csv, const std::string& column);

/// Class of a scene whose run is not in the index.
inline constexpr std::string_view kNoClass = "(none)";

/// Returns the groups in alphabetical order, labels by first appearance. The class of a scene is
/// that of the row which its run names. Throws std::invalid_argument if an error's scene is not
/// among the scenes.
std::vector<GroupSummary> byClass(std::span<const BinError> errors, std::span<const Scene> scenes,
                                  const Classes& classes);

}  // namespace terratact
