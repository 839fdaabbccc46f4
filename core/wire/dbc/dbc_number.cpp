#include "core/wire/dbc/dbc_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"

namespace terratact {
namespace {

__extension__ using Wide = __int128;

constexpr int kMaxDecimals = 12;  // largest number of decimals of a decimal scale
constexpr int kMaxShown = 9;      // most decimals that are displayed
// largest scale in those decimals: exact in a double, and its product with 64 bits fits Wide
constexpr double kMaxUnits = 1e15;
constexpr double kMaxOffset = 1e30;      // largest offset in those decimals
constexpr double kLargestInFull = 1e25;  // larger numbers are easier to read with an exponent

/// Returns the number of decimals that show every step of a scale. For an infinite decimal
/// fraction, it returns enough digits to separate the steps.
int digitsOf(double scale)
{
    constexpr int kMaxDigits = 6;
    const double size = std::abs(scale);
    for (int digits = 0; digits <= kMaxDigits; ++digits) {
        const double steps = size * std::pow(10.0, digits);
        if (std::abs(steps - std::round(steps)) <= 1e-9 * steps) return digits;
    }
    return std::max(0, static_cast<int>(std::ceil(-std::log10(size))) + 1);
}

/// Returns a decimal number in units of its last decimal; `digits`: its number of decimals.
std::optional<Wide> unitsOf(double number, int digits, double most)
{
    const double units = number * std::pow(10.0, digits), whole = std::round(units);
    if (!(std::abs(whole) <= most) || std::abs(units - whole) > 1e-15 * std::abs(units))
        return std::nullopt;
    return static_cast<Wide>(whole);
}

std::string textOf(Wide units, int digits)
{
    const bool isNegative = units < 0;
    std::string text;
    for (int i = 0; units != 0 || i <= digits; ++i) {
        if (i == digits && digits > 0) text += '.';
        const int digit = static_cast<int>(units % 10);
        text += static_cast<char>('0' + (digit < 0 ? -digit : digit));
        units /= 10;
    }
    if (isNegative) text += '-';
    std::reverse(text.begin(), text.end());
    return text;
}

bool isFloating(const DbcSignal& signal)
{
    return signal.type == DbcSignal::Type::Float || signal.type == DbcSignal::Type::Double;
}

/// Returns the number of decimals that are displayed.
int shownDigits(const DbcSignal& signal)
{
    return std::max(digitsOf(signal.scale), digitsOf(signal.offset));
}

/// Returns every digit of a scaled integer raw value. Empty if scale or offset is no decimal number
/// of so few digits.
std::optional<std::string> decimalText(const DbcSignal& signal, std::uint64_t bits, int most)
{
    if (isFloating(signal)) return std::nullopt;
    for (int digits = 0; digits <= most; ++digits) {
        const auto scale = unitsOf(signal.scale, digits, kMaxUnits);
        const auto offset = unitsOf(signal.offset, digits, kMaxOffset);
        if (!scale || !offset) continue;
        return textOf(rawOf(signal, bits) * *scale + *offset, digits);
    }
    return std::nullopt;
}

}  // namespace

std::string exactText(const DbcSignal& signal, std::uint64_t bits)
{
    if (const auto text = decimalText(signal, bits, shownDigits(signal))) return *text;
    if (auto text = decimalText(signal, bits, kMaxDecimals)) {
        text->erase(text->find_last_not_of('0') + 1);
        if (text->ends_with('.')) text->pop_back();
        return *text;
    }
    const double value = physicalOf(signal, bits);
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
    return numberText(value + 0.0);
}

std::string shownText(const DbcSignal& signal, std::uint64_t bits)
{
    constexpr std::size_t kMaxLength = 25;
    const auto text = decimalText(signal, bits, std::min(shownDigits(signal), kMaxShown));
    return text && text->size() <= kMaxLength ? *text : shownText(signal, physicalOf(signal, bits));
}

std::string shownText(const DbcSignal& signal, double value)
{
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
    const int digits = shownDigits(signal);
    if (isFloating(signal) || std::abs(value) >= kLargestInFull || digits > kMaxShown)
        return fmt::format("{:.7g}", value + 0.0);
    return fmt::format("{:.{}f}", value + 0.0, digits);
}

}  // namespace terratact
