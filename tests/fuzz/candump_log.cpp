// Fuzzes CAN logs of every format. Accepted frames are possible and have a finite time; their candump line means the
// same frame. The even clock never goes back. Messages about a log are one line.
#include "core/wire/logs/candump_log.h"

#include <cmath>
#include <cstdint>
#include <sstream>

#include "core/wire/logs/log_reader.h"
#include "tests/fuzz/promise.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

void promiseFrame(const LoggedFrame& logged)
{
    const CanFrame& frame = logged.frame;
    promise(!logged.time || (std::isfinite(*logged.time) && *logged.time >= 0.0),
            "a time is finite");
    promise(frame.length <= (frame.fd ? 64 : 8), "a frame is no longer than CAN allows");
    promise(frame.id <= (frame.extended || frame.error ? 0x1FFF'FFFFU : 0x7FFU),
            "an identifier has its bits");
    promise(!logged.interface.empty() && logged.interface.size() <= 15, "an interface has a name");
    for (std::size_t i = frame.length; i < frame.data.size(); ++i)
        promise(frame.data[i] == 0, "bytes beyond the length are 0");
    if (frame.isCut) return;

    const std::string line = candumpLine(logged.time.value_or(0.0), logged.interface, frame);
    const Result<LoggedFrame> again = frameFromCandump(line);
    promise(again && again->frame == frame && again->interface == logged.interface,
            "a frame survives being written and read");
    promise(candumpLine(*again->time, again->interface, again->frame) == line,
            "a line that was read is written again");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    LogReader log("f", std::make_unique<std::istringstream>(textOf(data, size)));
    double elapsed = 0.0;
    for (;;) {
        const Result<std::optional<LoggedFrame>> next = log.next();
        for (const Message& remark : log.consumeRemarks()) promiseRefusal({remark}, "f");
        if (!next) return promiseRefusal(next.error(), "f"), 0;
        if (!*next) return 0;
        promiseFrame(**next);
        promise(log.elapsed() >= elapsed, "the even clock does not go back");
        promise(!log.stepBack() || *log.stepBack() != 0.0, "a step of the clock has a length");
        elapsed = log.elapsed();
    }
}
