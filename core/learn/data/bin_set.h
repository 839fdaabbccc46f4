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

/// Returns the bins that a text names: "0-3", "0,4,10", "0-2,9-10". Empty if it names none, one
/// beyond 0 … 10 or one twice, or is no such list.
std::optional<BinSet> binSetFrom(std::string_view text);

/// Returns the shortest such text; "none" for no bin.
std::string text(const BinSet& bins);

/// Returns the bins in order.
std::vector<int> binsOf(const BinSet& bins);

}  // namespace terratact
