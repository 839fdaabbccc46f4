#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/wire/can_frame.h"

namespace terratact {

// Common parts of log formats: words between blanks, identifiers, lengths and bytes.

inline constexpr std::string_view kLogBlanks = " \t\r";
inline constexpr std::uint32_t kMaxStandardId = 0x7FF;
inline constexpr std::uint32_t kMaxExtendedId = 0x1FFF'FFFF;
inline constexpr double kMaxLogSeconds = 9'999'999'999.0;  ///< later times are refused

/// Returns "expected WHAT, found 'FOUND'".
Error expectedInLog(SourceText what, std::string_view found);

/// Splits a line at its blanks.
class LogWords {
public:
    explicit LogWords(std::string_view line) : rest_(line) {}

    std::string_view next();  ///< empty after the last one
    std::string_view rest();

private:
    void skipBlanks();
    std::string_view rest_;
};

bool isDigits(std::string_view text);

/// Returns seconds from a text such as "12.345" in units of 1 / perSecond. Refuses a number that is
/// negative, not finite, or beyond kMaxLogSeconds.
Result<double> logSeconds(std::string_view text, double perSecond = 1.0);

/// Returns true for a length that a frame of its kind (`fd`) can have.
bool isFrameLength(std::size_t length, bool fd);
Status setFrameLength(CanFrame& frame, std::size_t length, std::string_view found);

/// Returns the number of bytes of a CAN FD length code; code: 0 … 15.
std::size_t bytesOfCode(unsigned code);

/// Sets byte i of the frame from one to three decimal digits, or from `least` to two hexadecimal
/// digits. A byte beyond the frame's space is only checked.
Status setFrameByte(CanFrame& frame, std::size_t i, std::string_view digits, int base = 16,
                    std::size_t least = 2);

/// Sets the identifier, which must have 29 bits if `frame.extended`, else 11.
Status setFrameId(CanFrame& frame, std::string_view digits, int base = 16);

/// Returns "can0" for bus 1 of a program that counts from 1.
std::string interfaceOfBus(unsigned busFromOne);

}  // namespace terratact
