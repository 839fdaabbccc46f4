#pragma once

#include <QString>
#include <vector>

#include "core/infer/estimate/variant.h"

namespace terratact {

/// Returns one line: what the method uses, and whether it samples or has a closed form.
QString methodUses(Method method);
/// Returns methodUses() of these methods, each in a line with its name.
QString methodLines(const std::vector<Method>& methods);

}  // namespace terratact
