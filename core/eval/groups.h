#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/eval/evaluation.h"
#include "core/store/csv_reader.h"

namespace terratact {

/// The errors of one label in scenes of one kind.
struct GroupSummary {
    std::string group;
    std::string label;
    std::size_t scenes = 0;
    ErrorStatistics all{};
};

/// "inside" (novelty ≤ 1) and "outside" the scenes a model was trained on, for the labels that judge
/// novelty; a group without errors is left out.
std::vector<GroupSummary> byNovelty(std::span<const BinError> errors);

/// Which class each row of an index file belongs to.
using Classes = std::map<std::string, std::string>;
inline constexpr std::size_t kMaxClassRows = 200'000;  ///< of an index file

/// Reads the columns `row` and `column` of a CSV index (core/store/csv_reader.h).
/// Errors name the file, the line and the cause: those of CsvReader; a column is missing, a row appears twice; over
/// kMaxClassRows rows.
Result<Classes> readClasses(const std::string& path, const std::string& column);

/// The same from its first line on.
Result<Classes> readClasses(CsvReader csv, const std::string& column);

/// What a scene's run is called where the index does not know it.
inline constexpr std::string_view kNoClass = "(none)";

/// Groups in alphabetical order, labels by first appearance; a scene belongs to the class of the row that
/// its run names.  Throws std::invalid_argument where an error's scene is not among the scenes.
std::vector<GroupSummary> byClass(std::span<const BinError> errors, std::span<const Scene> scenes,
                                  const Classes& classes);

}  // namespace terratact
