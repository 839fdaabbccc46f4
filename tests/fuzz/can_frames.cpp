// Fuzzes frames from a bus. Input: records of 12 bytes. The first byte selects the kind of frame (bit 0 extended, 1
// remote, 2 error, 3 FD). Its bit 4 selects an identifier of ours, bit 5 one of an Absolem, bit 6 a corrected checksum.
// Then follow two bytes of identifier, two of length and time, eight of data. All receivers get the frames.
#include <cmath>
#include <cstdint>
#include <variant>

#include "core/terrain/bins.h"
#include "core/wire/absolem.h"
#include "core/wire/can_codec.h"
#include "core/wire/can_error.h"
#include "core/wire/command_receiver.h"
#include "core/wire/e2e.h"
#include "core/wire/telemetry_listener.h"
#include "tests/fuzz/promise.h"
#include "tests/support/absolem.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

constexpr std::size_t kRecord = 12;

struct ReceivedFrame {
    CanFrame frame;
    double after = 0.0;  // [s] since the previous frame
};

ReceivedFrame frameIn(const std::uint8_t* record)
{
    const unsigned kind = record[0];
    const auto flag = [kind](unsigned bit) { return (kind >> bit & 1U) != 0; };
    const unsigned number = record[1] + 256U * record[2];
    ReceivedFrame received;
    CanFrame& frame = received.frame;
    frame = {.id = number & 0x7FFU,
             .extended = flag(0),
             .remote = flag(1),
             .error = flag(2),
             .fd = flag(3),
             .length = static_cast<std::uint8_t>(record[3] % 16U % 9U)};
    for (std::size_t i = 0; i < kClassicBytes; ++i) frame.data[i] = record[4 + i];
    received.after = static_cast<double>(record[3] / 16U) * 0.02;
    if (frame.extended || frame.error) frame.id = number << 13U | number;
    if (flag(5)) frame.id = 0x180U + 0x80U * (number % 4U) + record[2] % 8U;
    if (flag(4)) frame.id = frameLayouts()[number % kFrameKinds].id;
    const std::optional<FrameKind> ours = kindOfId(frame.id);
    if (flag(6) && ours)
        protect(std::span(frame.data).first(8), frame.data[2], layoutOf(*ours).dataId);
    return received;
}

bool isFinite(const std::optional<Pair>& pair)
{
    return !pair || (std::isfinite(pair->left) && std::isfinite(pair->right));
}

void promiseMeasurement(const Measurement& m)
{
    for (const double value :
         {m.time, m.pitch, m.roll, m.frontLeft, m.frontRight, m.rearLeft, m.rearRight,
          m.frontLeftCurrent, m.frontRightCurrent, m.rearLeftCurrent, m.rearRightCurrent})
        promise(std::isfinite(value), "a measurement is finite");
    for (const double force : m.force)
        promise(std::isfinite(force) && force >= 0.0, "a force is finite and not negative");
    if (m.arm)
        promise(std::isfinite(m.arm->height) && m.arm->sd > 0.0 && m.arm->bin >= 0
                    && m.arm->bin < kBins,
                "an arm's reading is of a bin and has an sd");
}

void promiseCommand(const Command& command)
{
    const CanFrame frame = frameOf(command, 7, 9);  // throws for values that do not fit
    if (std::holds_alternative<StopCommand>(command)) return;
    const auto unpacked = unpack(frame);
    promise(std::holds_alternative<Unpacked>(unpacked), "an accepted command can be sent again");
}

void promiseCodec(const CanFrame& frame)
{
    const std::variant<Unpacked, FrameFault> got = unpack(frame);
    if (const auto* fault = std::get_if<FrameFault>(&got))
        return promise(!describe(*fault).empty(), "a fault has a name");
    const auto& content = std::get<Unpacked>(got);
    for (const double value : content.values) promise(std::isfinite(value), "a signal is finite");
    promise(pack(content) == frame, "a sound frame is packed into the same bytes");
}

struct Receivers {
    TelemetryListener telemetry{absolem()};
    CommandReceiver commands{1};
    AbsolemListener robot;
    std::uint64_t frames = 0;
    double now = 0.0;

    void add(const ReceivedFrame& received)
    {
        now += received.after;
        ++frames;
        const CanFrame& frame = received.frame;
        promiseCodec(frame);
        if (frame.error) {
            promise(!describeError(frame).empty(), "an error has a name");
            controllerState(frame);
        }
        if (const auto measurement = telemetry.receive(frame, now))
            promiseMeasurement(*measurement);
        if (const auto command = commands.receive(frame, now).command) promiseCommand(*command);
        commands.tick(now);
        promise(commands.epoch() != 0, "no epoch is 0");
        const AbsolemListener::Received said = robot.receive(frame, now);
        promise(!describe(said.verdict).empty(), "a verdict has a name");
        if (said.frame) promise(said.frame->name().size() < 12, "a name is short");
    }

    void promiseBooks() const
    {
        const TelemetryCounters c = telemetry.counters();
        std::uint64_t sum = c.used + c.fromConsole + c.repeated + c.wrongSequence;
        for (const std::uint64_t n : c.faults) sum += n;
        promise(sum == frames, "every frame is counted once");
        sum = 0;
        for (const std::uint64_t n : robot.counters()) sum += n;
        promise(sum == frames, "every frame has one verdict");
        const SensorLine line = sensorLineOf(robot.state(), now, 0.25);
        for (const auto& pair : {line.frontAngles, line.rearAngles})
            promise(isFinite(pair), "an Absolem's line is finite");
        for (const auto& [left, right] : {line.frontCurrents, line.rearCurrents})
            promise(std::isfinite(left.value_or(0.0)) && std::isfinite(right.value_or(0.0)),
                    "an Absolem's currents are finite");
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const Receivers fresh;
    Receivers receivers = fresh;
    for (; size >= kRecord; data += kRecord, size -= kRecord) receivers.add(frameIn(data));
    receivers.promiseBooks();
    return 0;
}
