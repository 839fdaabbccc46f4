// DBC files: what is accepted fits its frames and decodes any of them to finite values.
#include "core/wire/dbc_file.h"

#include <cmath>
#include <cstdint>

#include "tests/fuzz/promise.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

void promiseMessage(const DbcMessage& message)
{
    promise(message.length <= 64 && message.id <= (message.extended ? 0x1FFF'FFFFU : 0x7FFU),
            "a message is a frame");
    for (const DbcSignal& s : message.payload)
        promise(s.length >= 1 && s.length <= 64 && s.end() <= 8 * message.length && s.scale != 0.0,
                "a signal fits its message");
    const CanFrame frame{.length = 8, .data = {1, 0xFF, 0x80, 0x7F, 0, 3, 0xF0, 2}};
    std::vector<std::optional<double>> values(message.payload.size());
    decode(message, frame, values);
    for (const std::optional<double>& value : values)
        promise(!value || std::isfinite(*value), "a value is finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const Result<DbcFile> file = dbcFrom("f", textOf(data, size));
    if (!file) return promiseRefusal(file.error(), "f"), 0;
    promise(!file->messages.empty(), "a file describes a message");
    for (const std::string& warning : file->warnings) promiseRefusal({warning}, "f");
    for (const DbcMessage& message : file->messages) promiseMessage(message);
    return 0;
}
