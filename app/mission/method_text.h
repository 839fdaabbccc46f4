#pragma once

#include <QString>

#include "core/infer/estimate/variant.h"

namespace terratact {

/// Returns one line: what the method uses, and whether it samples or has a closed form.
QString methodUses(Method method);

}  // namespace terratact
