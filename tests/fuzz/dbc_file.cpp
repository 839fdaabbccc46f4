// Fuzzes DBC files. Accepted messages fit their frames and decode any frame; values that are not floats are finite, and
// texts read back.
#include "core/wire/dbc/dbc_file.h"

#include <cmath>
#include <cstdint>

#include "core/base/text.h"
#include "core/wire/dbc/dbc_number.h"
#include "tests/fuzz/promise.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

void promiseValue(const DbcSignal& signal, std::uint64_t bits)
{
    const std::optional<double> read = numberFrom(exactText(signal, bits));
    promise(read.has_value(), "a value is a number as text");
    const double value = physicalOf(signal, bits);
    const bool isFloat =
        signal.type == DbcSignal::Type::Float || signal.type == DbcSignal::Type::Double;
    const double most = 1e-9 * std::abs(value) + 1e-9 * std::abs(signal.offset);
    promise(!std::isfinite(value) || std::abs(*read - value) <= most, "its text means the value");
    promise(isFloat || !std::isnan(value), "a whole number is one");
    promise(!shownText(signal, bits).empty(), "a value is shown");
}

void promiseMessage(const DbcMessage& message)
{
    promise(message.length <= 64 && message.id <= (message.extended ? 0x1FFF'FFFFU : 0x7FFU),
            "a message is a frame");
    for (const DbcSignal& s : message.payload)
        promise(s.length >= 1 && s.length <= 64 && s.end() <= 8 * message.length && s.scale != 0.0,
                "a signal fits its message");
    for (const DbcSignal& s : message.payload)
        promise(s.selectedBy.empty() || (s.selector && *s.selector < message.payload.size()),
                "a multiplexed signal has its multiplexor");
    for (const std::size_t length : {8U, 64U}) {
        CanFrame frame{.fd = length > 8,
                       .length = static_cast<std::uint8_t>(length),
                       .data = {1, 0xFF, 0x80, 0x7F, 0, 3, 0xF0, 2}};
        for (std::size_t i = 8; i < length; ++i) frame.data[i] = static_cast<std::uint8_t>(37 * i);
        std::vector<std::optional<std::uint64_t>> bits(message.payload.size());
        decodeBits(message, frame, bits);
        for (std::size_t i = 0; i < bits.size(); ++i)
            if (bits[i]) promiseValue(message.payload[i], *bits[i]);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const Result<DbcFile> file = dbcFrom("f", textOf(data, size));
    if (!file) return promiseRefusal(file.error(), "f"), 0;
    promise(!file->messages.empty(), "a file describes a message");
    for (const Message& warning : file->warnings) promiseRefusal({warning}, "f");
    for (const DbcMessage& message : file->messages) promiseMessage(message);
    return 0;
}
