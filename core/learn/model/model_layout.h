#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/learn/data/columns.h"
#include "core/learn/model/model.h"
#include "core/store/sqlite_tables.h"

namespace terratact::model_file {

// Layout of a *.ttm file: its identifiers, its limits and its tables.

inline constexpr std::int64_t kApplicationId = 0x54544D31;      // "TTM1"
inline constexpr std::int64_t kPartApplicationId = 0x54545031;  // "TTP1"
inline constexpr std::int64_t kUserVersion = 3;                 ///< one plane only
inline constexpr std::int64_t kSidesVersion = 4;                ///< one plane and two tracks
inline constexpr std::uintmax_t kMaxBytes = std::uintmax_t{16} * 1024 * 1024;
inline constexpr Eigen::Index kMaxRows = 20'000;
inline constexpr std::array kSets{FeatureSet::Pa,
                                  FeatureSet::Paf};  ///< in the order of their names

/// Returns a column of the inputs: the eleven heights, then the features.
const Column& inputColumn(std::size_t position);

/// Returns the number of inputs of a set, with the heights.
std::size_t inputs(FeatureSet set);

/// Returns every table of a model, sorted by name. sides: of two tracks.
std::vector<SqliteTable> schema(bool sides);

/// Returns the rows of the table meta that every file has: explanations for people who open it with
/// other tools.
std::map<std::string, std::string> explanations(bool sides);

}  // namespace terratact::model_file
