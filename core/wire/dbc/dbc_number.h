#pragma once

#include <cstdint>
#include <string>

#include "core/wire/dbc/dbc.h"

namespace terratact {

// The value of a signal as text.  Of whole raw values with a decimal scale and offset, all digits are computed exactly:
// 64 bits have more of them than a double.

/// For files: every digit, or of other values the shortest text that reads back as the same double; "nan", "inf" and
/// "-inf" where a float is so.
std::string exactText(const DbcSignal& signal, std::uint64_t bits);

/// For people: as many digits behind the point as the scale resolves; of floats, and of scales that no few digits tell,
/// seven digits.
std::string shownText(const DbcSignal& signal, std::uint64_t bits);

/// The same where only the value is known: whole numbers beyond 2⁵³ then have the digits of a double.
std::string shownText(const DbcSignal& signal, double value);

}  // namespace terratact
