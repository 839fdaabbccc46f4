#pragma once

#include <bitset>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/terrain/bins.h"

namespace terratact {

/// Set of bins: bit i is bin i, 0 the rearmost (-0.3 m).
using BinSet = std::bitset<kBins>;

inline constexpr BinSet kAllBins{(1ULL << kBins) - 1};

/// Returns the bins that a text lists: "0-3", "0,4,10", "0-2,9-10". Empty unless it is such a list
/// of bins 0 … 10, each at most once.
std::optional<BinSet> binSetFrom(std::string_view text);

/// Returns the shortest text for binSetFrom(); "none" for no bin.
std::string text(const BinSet& bins);

/// Returns the bins in order.
std::vector<int> binsOf(const BinSet& bins);

}  // namespace terratact
