#pragma once

#include <cstdint>
#include <string>

#include "core/wire/dbc/dbc.h"

namespace terratact {

// Texts of signal values. For integer raw values with a decimal scale and offset, all digits are
// exact: 64 bits hold more digits than a double.

/// Returns the text for files: every digit of an integer, else the shortest text that reads back as
/// the same double. A float may give "nan", "inf" or "-inf".
std::string exactText(const DbcSignal& signal, std::uint64_t bits);

/// Returns the text for people: as many decimals as the scale resolves. Floats, and scales without
/// a short decimal form, get seven digits.
std::string shownText(const DbcSignal& signal, std::uint64_t bits);

/// Returns the same text for a value alone. Integers beyond 2⁵³ then have the digits of a double.
std::string shownText(const DbcSignal& signal, double value);

}  // namespace terratact
