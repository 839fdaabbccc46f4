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

// What a *.ttm looks like: its marks, its limits and its tables.

inline constexpr std::int64_t kApplicationId = 0x54544D31;      // "TTM1"
inline constexpr std::int64_t kPartApplicationId = 0x54545031;  // "TTP1"
inline constexpr std::int64_t kUserVersion = 3;
inline constexpr std::uintmax_t kMaxBytes = std::uintmax_t{16} * 1024 * 1024;
inline constexpr Eigen::Index kMaxRows = 20'000;
inline constexpr std::array kSets{FeatureSet::Pa,
                                  FeatureSet::Paf};  ///< in the order of their names

/// A column of the inputs: the eleven heights, then the features.
const Column& inputColumn(std::size_t position);

/// How many inputs a set has, the heights included.
std::size_t inputs(FeatureSet set);

/// Every table of a model, sorted by name.
std::vector<SqliteTable> schema();

/// Rows of the table meta in every file: what the file says of itself, for people who open it with other tools.
const std::map<std::string, std::string>& explanations();

}  // namespace terratact::model_file
