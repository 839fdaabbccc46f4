#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/message.h"
#include "core/infer/estimate/settings.h"

namespace terratact {

/// Quality preset: how much time an estimate may take. `terratact tradeoff` measures the cost and
/// the error of each preset (docs/tradeoff.md). Accurate predicts through all inducing rows of the
/// model, and its few long chains end once they have converged. Fast and Balanced mostly reach
/// their sweep limit and report that they did not converge.
enum class QualityPreset : std::uint8_t { Fast, Balanced, Accurate };

inline constexpr std::array kQualityPresets{QualityPreset::Fast, QualityPreset::Balanced,
                                            QualityPreset::Accurate};

/// Returns "fast", "balanced" or "accurate".
std::string_view name(QualityPreset preset);

/// Returns the name for the operator.
SourceText describe(QualityPreset preset);
std::optional<QualityPreset> qualityPresetFromName(std::string_view text);

/// Returns the settings with the preset's draws, chains, burn-in, precision and inducing rows.
Settings withPreset(Settings settings, QualityPreset preset);

}  // namespace terratact
