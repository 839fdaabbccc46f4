#pragma once

#include <QStringList>
#include <span>

#include "core/eval/tradeoff.h"

namespace terratact {

// Texts with time and error of each preset, in the order of kQualityPresets, for a method. The texts say if a preset
// was not measured.

QStringList presetLines(Method method, std::span<const PresetCost> costs);    ///< one sentence each
QStringList presetEntries(Method method, std::span<const PresetCost> costs);  ///< short texts

}  // namespace terratact
