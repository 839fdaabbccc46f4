#pragma once

#include <QStringList>
#include <span>

#include "core/eval/tradeoff.h"

namespace terratact {

// What each preset, in the order of kQualities, costs with a method and what it gives, as `costs` has it; of those that
// were not measured they say so.

QStringList presetLines(Method method, std::span<const PresetCost> costs);    ///< a sentence each
QStringList presetEntries(Method method, std::span<const PresetCost> costs);  ///< likewise, short

}  // namespace terratact
