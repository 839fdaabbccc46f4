#include "core/wire/logs/log_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/text.h"

namespace terratact {
namespace {

constexpr std::array<std::size_t, 7> kLongFdLengths{12, 16, 20, 24, 32, 48, 64};

}  // namespace

Error expectedInLog(SourceText what, std::string_view found)
{
    return Error{Message(TR_NOOP("core", "expected %1, found %2: correct or delete the line"), what,
                         found.empty() ? Message(TR_NOOP("core", "the end of the line"))
                                       : Message::verbatim(shown(found)))};
}

std::string_view LogWords::next()
{
    skipBlanks();
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kLogBlanks));
    rest_.remove_prefix(word.size());
    return word;
}

std::string_view LogWords::rest()
{
    skipBlanks();
    return rest_;
}

void LogWords::skipBlanks()
{
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kLogBlanks), rest_.size()));
}

bool isDigits(std::string_view text)
{
    return !text.empty()
        && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

Result<double> logSeconds(std::string_view text, double perSecond)
{
    std::string pointed(text);  // a desktop may write a decimal comma
    std::replace(pointed.begin(), pointed.end(), ',', '.');
    const bool isPlain = pointed.find_first_not_of("0123456789.") == std::string::npos;
    const std::optional<double> number = isPlain ? numberFrom(pointed) : std::nullopt;
    if (!number || !(*number / perSecond <= kMaxLogSeconds))
        return expectedInLog(TR_NOOP("core", "a time, a number that is not negative"), text);
    return *number / perSecond;
}

bool isFrameLength(std::size_t length, bool fd)
{
    return length <= kClassicBytes
        || (fd
            && std::find(kLongFdLengths.begin(), kLongFdLengths.end(), length)
                   != kLongFdLengths.end());
}

Status setFrameLength(CanFrame& frame, std::size_t length, std::string_view found)
{
    if (!isFrameLength(length, frame.fd))
        return expectedInLog(frame.fd ? TR_NOOP("core", "as many bytes as CAN FD can have")
                                      : TR_NOOP("core", "at most 8 bytes"),
                             found);
    frame.length = static_cast<std::uint8_t>(length);
    return Done{};
}

std::size_t bytesOfCode(unsigned code)
{
    return code <= kClassicBytes ? code : kLongFdLengths.at(std::min(code, 15U) - 9);
}

Status setFrameByte(CanFrame& frame, std::size_t i, std::string_view digits, int base,
                    std::size_t least)
{
    const std::size_t most = base == 10 ? 3 : 2;
    const auto byte =
        digits.size() <= most ? integerFrom<std::uint8_t>(digits, base) : std::nullopt;
    if (!byte || (base == 16 && digits.size() < least))
        return expectedInLog(base == 10 ? TR_NOOP("core", "a byte from 0 to 255")
                                        : TR_NOOP("core", "a byte of two hexadecimal digits"),
                             digits);
    if (i < frame.data.size()) frame.data[i] = *byte;
    return Done{};
}

Status setFrameId(CanFrame& frame, std::string_view digits, int base)
{
    const std::uint32_t most = frame.extended ? kMaxExtendedId : kMaxStandardId;
    const auto id = integerFrom<std::uint32_t>(digits, base);
    if (!id || *id > most)
        return expectedInLog(frame.extended ? TR_NOOP("core", "an identifier up to 1FFFFFFF")
                                            : TR_NOOP("core", "a standard identifier up to 7FF"),
                             digits);
    frame.id = *id;
    return Done{};
}

std::string interfaceOfBus(unsigned busFromOne)
{
    return fmt::format("can{}", busFromOne > 0 ? busFromOne - 1 : 0);
}

}  // namespace terratact
