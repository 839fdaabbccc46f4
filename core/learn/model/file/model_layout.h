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

/// Table of the heights' sd, which a model of exact heights lacks. Of two tracks it has the prefix side_.
inline constexpr const char* kSdTable = "height_sd_row";
inline constexpr const char* kSideSdTable = "side_height_sd_row";

/// Table of the bins whose height is unknown in a row, which a model without such rows does not have.
inline constexpr const char* kUnknownTable = "unknown_bins_row";
inline constexpr const char* kSideUnknownTable = "side_unknown_bins_row";

/// Optional content of a model.
struct ModelContent {
    bool sides = false;        ///< of two tracks
    bool heightSd = false;     ///< the heights of training rows have an sd
    bool sideSd = false;       ///< those of sides have one
    bool unknown = false;      ///< rows have unknown heights
    bool sideUnknown = false;  ///< rows of sides have some
};
ModelContent contentOf(const ModelData& model);

/// Returns every table of a model, sorted by name.
std::vector<SqliteTable> schema(const ModelContent& content);

/// Returns the rows of the table meta that every file has: explanations for people who open it with
/// other tools.
std::map<std::string, std::string> explanations(const ModelContent& content);

}  // namespace terratact::model_file
