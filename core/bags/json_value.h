#pragma once

#include <string_view>

#include "core/bags/field_value.h"
#include "core/base/result.h"

namespace terratact {

/// Reads one JSON text (RFC 8259). true and false become 1 and 0. An array of numbers and nulls becomes
/// numbers with NaN for null, an array of texts becomes texts. Of long arrays only
/// FieldValue::kMaxElements elements are kept. Errors name the byte and what was expected: no JSON,
/// nested too deep, or more than FieldValue::kMaxValues values.
Result<FieldValue> jsonValue(std::string_view text);

}  // namespace terratact
