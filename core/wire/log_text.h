#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/wire/can_frame.h"

namespace terratact {

// What the formats of logs have in common: words between blanks, identifiers, lengths and bytes.

inline constexpr std::string_view kLogBlanks = " \t\r";
inline constexpr std::uint32_t kMaxStandardId = 0x7FF;
inline constexpr std::uint32_t kMaxExtendedId = 0x1FFF'FFFF;
inline constexpr double kMaxLogSeconds = 9'999'999'999.0;  ///< a later time is not believed

/// "expected WHAT, found 'FOUND'"
Error expectedInLog(std::string_view what, std::string_view found);

/// Takes a line apart at its blanks.
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

/// [s] from a text such as "12.345", of seconds that `perSecond` units make; refused: negative, not finite, beyond
/// kMaxLogSeconds.
Result<double> logSeconds(std::string_view text, double perSecond = 1.0);

/// A length that a frame of its kind (`fd`) can have.
bool isFrameLength(std::size_t length, bool fd);
Status setFrameLength(CanFrame& frame, std::size_t length, std::string_view found);

/// The number of bytes that a length code of CAN FD stands for; code: 0 … 15.
std::size_t bytesOfCode(unsigned code);

/// Byte i of the frame from one or two digits; without a place for it, it is only checked.
Status setFrameByte(CanFrame& frame, std::size_t i, std::string_view digits, int base = 16);

/// Sets the identifier, which must have 11 or 29 bits, as `frame.extended` says.
Status setFrameId(CanFrame& frame, std::string_view digits, int base = 16);

/// "can0" for bus 1 of a program that counts from 1.
std::string interfaceOfBus(unsigned busFromOne);

}  // namespace terratact
