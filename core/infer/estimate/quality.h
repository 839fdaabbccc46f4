#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/infer/estimate/settings.h"

namespace terratact {

/// How much time an estimate may take for its accuracy.  What each costs and errs is measured by
/// `terratact tradeoff`, of which they are points: docs/tradeoff.md.  Accurate predicts through as many rows as the model was
/// trained for, has chains few and long enough to converge, and ends when they have; the other two mostly use what they are given, and say so.
enum class Quality : std::uint8_t { Fast, Balanced, Accurate };

inline constexpr std::array kQualities{Quality::Fast, Quality::Balanced, Quality::Accurate};

/// "fast", "balanced", "accurate".
std::string_view name(Quality quality);
std::optional<Quality> qualityFromName(std::string_view text);

/// The settings with draws, chains, burn-in, precision and inducing rows of that quality.
Settings withQuality(Settings settings, Quality quality);

}  // namespace terratact
