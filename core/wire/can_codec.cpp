#include "core/wire/can_codec.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/wire/e2e.h"

namespace terratact {
namespace {

constexpr int kHeaderBits = 8 * static_cast<int>(kE2eHeader);
constexpr std::uint8_t kFrameLength = 8;
constexpr FrameKind kFirstSensor = FrameKind::Attitude;  // first of the frames that every line has
constexpr std::size_t kVoltageFrames = 4;  // of the front flippers, and as many of the rear ones
constexpr std::size_t kFirstMissing = 3;   // place of LeftMissing; Left has place 0

using Values = std::array<double, kMaxSignals>;

// Returns the frame as one little-endian word: bit i of the DBC is bit i of the word.
std::uint64_t wordOf(const CanFrame& frame)
{
    std::uint64_t word = 0;
    for (std::size_t i = kFrameLength; i > 0; --i) word = (word << 8U) | frame.data[i - 1];
    return word;
}

std::uint64_t lowBits(int count)
{
    return (std::uint64_t{1} << static_cast<unsigned>(count)) - 1U;
}

std::uint64_t maskOf(const SignalLayout& signal)
{
    return lowBits(signal.length) << static_cast<unsigned>(signal.start);
}

std::int64_t rawOf(std::uint64_t word, const SignalLayout& signal)
{
    const auto raw =
        static_cast<std::int64_t>((word & maskOf(signal)) >> static_cast<unsigned>(signal.start));
    const std::int64_t half = std::int64_t{1} << static_cast<unsigned>(signal.length - 1);
    return signal.isSigned && raw >= half ? raw - 2 * half : raw;
}

std::uint64_t bitsOf(double value, const SignalLayout& signal)
{
    const double raw = std::round(value / signal.scale);
    const bool fits =
        raw >= static_cast<double>(leastRaw(signal)) && raw <= static_cast<double>(mostRaw(signal));
    if (!fits) {
        std::string text(signal.name);
        text += ": the value does not fit into its signal";
        throw std::invalid_argument(text);
    }
    const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(raw));
    return (bits & lowBits(signal.length)) << static_cast<unsigned>(signal.start);
}

bool isClassicData(const CanFrame& frame)
{
    return !frame.extended && !frame.remote && !frame.error && !frame.fd;
}

CanFrame packed(FrameKind kind, std::uint8_t counter, const Values& values)
{
    return pack({.kind = kind, .counter = counter, .values = values});
}

struct CommandValues {
    FrameKind kind;
    Values values;  ///< in the order of the layout
};

// One function per command: a new command does not compile without its frame.
struct ToValues {
    double epoch, challenge;
    CommandValues operator()(const StopCommand&) const { return {FrameKind::Stop, {}}; }
    CommandValues operator()(const ReleaseStopCommand&) const
    {
        return {FrameKind::ReleaseStop, {epoch, challenge}};
    }
    CommandValues operator()(const HaltCommand&) const { return {FrameKind::Halt, {epoch}}; }
    CommandValues operator()(const DriveCommand& c) const
    {
        return {FrameKind::Drive, {epoch, c.speed, challenge}};
    }
    CommandValues operator()(const PressCommand& c) const
    {
        return {FrameKind::PressFlippers, {epoch, c.torque, challenge}};
    }
    CommandValues operator()(const ProbeCommand& c) const
    {
        return {FrameKind::ProbeBin,
                {epoch, static_cast<double>(c.bin), static_cast<double>(c.side), challenge}};
    }
    CommandValues operator()(const ArmCommand& c) const
    {
        return {FrameKind::Arm, {epoch, c.armed ? 1.0 : 0.0, challenge}};
    }
    CommandValues operator()(const BeginAtemCommand&) const
    {
        return {FrameKind::BeginAtem, {epoch, challenge}};
    }
    CommandValues operator()(const AbortAtemCommand&) const
    {
        return {FrameKind::AbortAtem, {epoch}};
    }
    CommandValues operator()(const HoldFlippersCommand& c) const
    {
        return {FrameKind::HoldFlippers, {c.front, c.rear, challenge}};
    }
    CommandValues operator()(const AdvanceCommand& c) const
    {
        return {FrameKind::Advance, {epoch, c.distance, challenge}};
    }
};

std::optional<Command> commandFrom(FrameKind kind, const Values& v)
{
    switch (kind) {
    case FrameKind::Stop: return StopCommand{};
    case FrameKind::ReleaseStop: return ReleaseStopCommand{};
    case FrameKind::Arm: return ArmCommand{v[1] != 0.0};
    case FrameKind::Halt: return HaltCommand{};
    case FrameKind::Drive: return DriveCommand{v[1]};
    case FrameKind::BeginAtem: return BeginAtemCommand{};
    case FrameKind::AbortAtem: return AbortAtemCommand{};
    case FrameKind::PressFlippers: return PressCommand{v[1]};
    case FrameKind::HoldFlippers: return HoldFlippersCommand{v[0], v[1]};
    case FrameKind::ProbeBin:
        return ProbeCommand{static_cast<int>(v[1]), static_cast<ProbeSide>(v[2])};
    case FrameKind::Advance: return AdvanceCommand{v[1]};
    default: return std::nullopt;
    }
}

std::optional<double> valueOf(const Unpacked& content, std::string_view name)
{
    const auto signals = layoutOf(content.kind).payload;
    const auto at = std::ranges::find(signals, name, &SignalLayout::name);
    if (at == signals.end()) return std::nullopt;
    return content.values[static_cast<std::size_t>(at - signals.begin())];
}

Values valuesOf(const std::optional<Pair>& pair)
{
    return pair ? Values{pair->left, pair->right, 1.0} : Values{};
}

// Both currents of an axle missing are sent as an axle that was not measured.
Values valuesOf(const AxleCurrents& axle)
{
    const auto& [left, right] = axle;
    if (!left && !right) return {};
    return {left.value_or(0.0), right.value_or(0.0), 1.0, left ? 0.0 : 1.0, right ? 0.0 : 1.0};
}

AxleCurrents currentsOf(const Unpacked& content)
{
    const auto measured = measuredSignals(content);
    const auto of = [&](std::size_t side) {
        return measured[side] ? std::optional(content.values[side]) : std::nullopt;
    };
    return {of(0), of(1)};
}

// Returns the two values of a frame with Measured behind them; empty if it is 0.
template <class T>
std::optional<T> twoOf(const Values& v)
{
    return v[2] != 0.0 ? std::optional(T{v[0], v[1]}) : std::nullopt;
}

void readVoltages(SensorLine& line, std::size_t set, const Values& v)
{
    line.voltages[set] =
        v[3] != 0.0 ? std::optional(SensorLine::Three{v[0], v[1], v[2]}) : std::nullopt;
}

// Writes the values of a sensor frame into the line.
void readSensors(SensorLine& line, const Unpacked& content)
{
    const Values& v = content.values;
    switch (content.kind) {
    case FrameKind::Attitude: line.attitude = twoOf<SensorLine::Attitude>(v); return;
    case FrameKind::FrontAngles: line.frontAngles = twoOf<Pair>(v); return;
    case FrameKind::RearAngles: line.rearAngles = twoOf<Pair>(v); return;
    case FrameKind::FrontCurrents: line.frontCurrents = currentsOf(content); return;
    case FrameKind::RearCurrents: line.rearCurrents = currentsOf(content); return;
    case FrameKind::LeftForces1To3: readVoltages(line, 0, v); return;
    case FrameKind::LeftForces4To6: readVoltages(line, 1, v); return;
    case FrameKind::RightForces1To3: readVoltages(line, 2, v); return;
    case FrameKind::RightForces4To6: readVoltages(line, 3, v); return;
    case FrameKind::ArmResult:
        line.arm = v[3] != 0.0 ? std::optional(
                       ArmReading{static_cast<int>(v[0]), v[1], v[2], static_cast<ProbeSide>(v[4])})
                               : std::nullopt;
        return;
    case FrameKind::RearLeftForces1To3: readVoltages(line, 4, v); return;
    case FrameKind::RearLeftForces4To6: readVoltages(line, 5, v); return;
    case FrameKind::RearRightForces1To3: readVoltages(line, 6, v); return;
    case FrameKind::RearRightForces4To6: readVoltages(line, 7, v); return;
    case FrameKind::Differential:
        line.differential = v[1] != 0.0 ? std::optional(v[0]) : std::nullopt;
        return;
    default: return;
    }
}

FrameKind later(FrameKind kind, std::size_t places)
{
    return static_cast<FrameKind>(static_cast<std::size_t>(kind) + places);
}

// Returns the bit of a sensor frame in a SensorLineReader.
std::uint32_t bitOf(FrameKind kind)
{
    return 1U << (static_cast<unsigned>(kind) - static_cast<unsigned>(kFirstSensor));
}

std::uint32_t bitsOfFrames(FrameKind first, FrameKind last)
{
    return 2U * bitOf(last) - bitOf(first);
}

// Returns true for a reading without an sd, which would count as exact.
bool isExactArm(FrameKind kind, const Values& v)
{
    return kind == FrameKind::ArmResult && v[3] != 0.0 && !(v[2] > 0.0);
}

}  // namespace

std::string describe(FrameFault fault)
{
    switch (fault) {
    case FrameFault::UnknownId: return "unknown identifier";
    case FrameFault::NotClassicData: return "no standard data frame";
    case FrameFault::WrongLength: return "not eight bytes";
    case FrameFault::WrongCrc: return "wrong checksum";
    case FrameFault::ReservedBits: return "a bit without meaning is set";
    case FrameFault::OutOfRange: return "a value is beyond its range";
    }
    throw std::invalid_argument("describe: no such FrameFault");
}

CanFrame pack(const Unpacked& content)
{
    const FrameLayout& layout = layoutOf(content.kind);
    for (std::size_t i = layout.payload.size(); i < content.values.size(); ++i)
        if (content.values[i] != 0.0)
            throw std::invalid_argument("pack: a value that the frame has no signal for");
    if (isExactArm(content.kind, content.values))
        throw std::invalid_argument("pack: the sd of an arm's reading must be positive");
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < layout.payload.size(); ++i)
        word |= bitsOf(content.values[i], layout.payload[i]);
    CanFrame frame{.id = layout.id, .length = kFrameLength};
    for (std::size_t i = 0; i < kFrameLength; ++i)
        frame.data[i] = static_cast<std::uint8_t>(word >> (8U * static_cast<unsigned>(i)));
    protect(std::span(frame.data).first(kFrameLength), content.counter, layout.dataId);
    return frame;
}

std::variant<Unpacked, FrameFault> unpack(const CanFrame& frame)
{
    if (!isClassicData(frame)) return FrameFault::NotClassicData;
    const std::optional<FrameKind> kind = kindOfId(frame.id);
    if (!kind) return FrameFault::UnknownId;
    if (frame.length != kFrameLength) return FrameFault::WrongLength;
    const FrameLayout& layout = layoutOf(*kind);
    if (!isIntact(bytesOf(frame), layout.dataId)) return FrameFault::WrongCrc;

    Unpacked content{.kind = *kind, .counter = frame.data[2]};
    const std::uint64_t word = wordOf(frame);
    std::uint64_t named = lowBits(kHeaderBits);
    for (std::size_t i = 0; i < layout.payload.size(); ++i) {
        const SignalLayout& signal = layout.payload[i];
        const std::int64_t raw = rawOf(word, signal);
        if (raw < leastRaw(signal) || raw > mostRaw(signal)) return FrameFault::OutOfRange;
        content.values[i] = static_cast<double>(raw) * signal.scale;
        named |= maskOf(signal);
    }
    if ((word & ~named) != 0) return FrameFault::ReservedBits;
    if (isExactArm(*kind, content.values)) return FrameFault::OutOfRange;
    return content;
}

std::bitset<kMaxSignals> measuredSignals(const Unpacked& content)
{
    std::bitset<kMaxSignals> measured;
    const auto signals = layoutOf(content.kind).payload;
    const bool isWhole = valueOf(content, "Measured").value_or(1.0) != 0.0;
    for (std::size_t i = 0; i < signals.size(); ++i)
        measured[i] = isWhole || signals[i].name == "Measured";
    if (content.kind == FrameKind::FrontCurrents || content.kind == FrameKind::RearCurrents)
        for (std::size_t side = 0; side < 2; ++side)
            if (content.values[kFirstMissing + side] != 0.0) measured.reset(side);
    return measured;
}

bool meansStop(const CanFrame& frame)
{
    return !frame.extended && !frame.error && frame.id == layoutOf(FrameKind::Stop).id;
}

FrameKind kindOf(const Command& command)
{
    return std::visit(ToValues{0.0, 0.0}, command).kind;
}

CanFrame frameOf(const Command& command, std::uint8_t epoch, std::uint8_t counter,
                 std::uint16_t challenge)
{
    const ToValues toValues{static_cast<double>(epoch), static_cast<double>(challenge)};
    const CommandValues content = std::visit(toValues, command);
    return packed(content.kind, counter, content.values);
}

std::optional<ReceivedCommand> commandOf(const Unpacked& content)
{
    const std::optional<Command> command = commandFrom(content.kind, content.values);
    if (!command) return std::nullopt;
    ReceivedCommand received{.command = *command, .challenge = challengeOf(content)};
    if (const auto epoch = valueOf(content, "Epoch"))
        received.epoch = static_cast<std::uint8_t>(*epoch);
    return received;
}

CanFrame consoleHeartbeat(std::uint16_t token, std::uint8_t counter)
{
    return packed(FrameKind::ConsoleHeartbeat, counter, {static_cast<double>(token)});
}

CanFrame robotHeartbeat(std::uint16_t token, std::uint8_t counter, std::uint16_t challenge)
{
    return packed(FrameKind::RobotHeartbeat, counter,
                  {static_cast<double>(token), static_cast<double>(challenge)});
}

std::optional<std::uint16_t> tokenOf(const Unpacked& content)
{
    if (content.kind != FrameKind::ConsoleHeartbeat && content.kind != FrameKind::RobotHeartbeat)
        return std::nullopt;
    return static_cast<std::uint16_t>(content.values[0]);
}

std::optional<std::uint16_t> challengeOf(const Unpacked& content)
{
    const std::optional<double> value = valueOf(content, "Challenge");
    return value ? std::optional(static_cast<std::uint16_t>(*value)) : std::nullopt;
}

CanFrame frameOf(const RobotStatus& s, std::uint8_t counter)
{
    const std::uint32_t last = s.lastCommand ? layoutOf(*s.lastCommand).id : 0U;
    return packed(FrameKind::RobotStatus, counter,
                  {static_cast<double>(s.epoch), static_cast<double>(s.activity),
                   static_cast<double>(s.refusal), s.armed ? 1.0 : 0.0, s.exploring ? 1.0 : 0.0,
                   static_cast<double>(last), static_cast<double>(s.lastCounter)});
}

std::optional<RobotStatus> statusOf(const Unpacked& content)
{
    if (content.kind != FrameKind::RobotStatus) return std::nullopt;
    const Values& v = content.values;
    const auto last = static_cast<std::uint32_t>(v[5]);
    const std::optional<FrameKind> command = kindOfId(last);
    if (last != 0 && !command) return std::nullopt;
    return RobotStatus{.epoch = static_cast<std::uint8_t>(v[0]),
                       .activity = static_cast<RobotActivity>(v[1]),
                       .refusal = static_cast<Refusal>(v[2]),
                       .armed = v[3] != 0.0,
                       .exploring = v[4] != 0.0,
                       .lastCommand = command,
                       .lastCounter = static_cast<std::uint8_t>(v[6])};
}

std::vector<CanFrame> framesOf(const SensorLine& line, std::uint8_t counter,
                               const LineExtent& extent)
{
    const auto voltages = [&](std::size_t set) {
        const auto& three = line.voltages[set];
        return three ? Values{(*three)[0], (*three)[1], (*three)[2], 1.0} : Values{};
    };
    const Values attitude =
        line.attitude ? Values{line.attitude->pitch, line.attitude->roll, 1.0} : Values{};
    const Values odometry =
        line.odometry ? Values{line.odometry->travelled, line.odometry->turned, 1.0} : Values{};
    const Values arm = line.arm ? Values{static_cast<double>(line.arm->bin), line.arm->height,
                                         line.arm->sd, 1.0, static_cast<double>(line.arm->side)}
                                : Values{};
    std::vector<CanFrame> frames{
        packed(FrameKind::Odometry, counter, odometry),
        packed(FrameKind::Attitude, counter, attitude),
        packed(FrameKind::FrontAngles, counter, valuesOf(line.frontAngles)),
        packed(FrameKind::RearAngles, counter, valuesOf(line.rearAngles)),
        packed(FrameKind::FrontCurrents, counter, valuesOf(line.frontCurrents)),
        packed(FrameKind::RearCurrents, counter, valuesOf(line.rearCurrents)),
        packed(FrameKind::LeftForces1To3, counter, voltages(0)),
        packed(FrameKind::LeftForces4To6, counter, voltages(1)),
        packed(FrameKind::RightForces1To3, counter, voltages(2)),
        packed(FrameKind::RightForces4To6, counter, voltages(3)),
        packed(FrameKind::ArmResult, counter, arm)};
    for (std::size_t i = 0; extent.rearForces && i < kVoltageFrames; ++i)
        frames.push_back(
            packed(later(FrameKind::RearLeftForces1To3, i), counter, voltages(kVoltageFrames + i)));
    if (extent.differential)
        frames.push_back(packed(FrameKind::Differential, counter,
                                line.differential ? Values{*line.differential, 1.0} : Values{}));
    return frames;
}

SensorLineReader::SensorLineReader(const LineExtent& extent)
    : needed_(bitsOfFrames(kFirstSensor, FrameKind::ArmResult))
{
    if (extent.rearForces)
        needed_ |= bitsOfFrames(FrameKind::RearLeftForces1To3, FrameKind::RearRightForces4To6);
    if (extent.differential) needed_ |= bitOf(FrameKind::Differential);
}

std::optional<SensorLine> SensorLineReader::add(const Unpacked& content)
{
    if (content.kind == FrameKind::Odometry)
        odometry_ = CountedOdometry{content.counter, twoOf<SensorLine::Odometry>(content.values)};
    if (content.kind < kFirstSensor || (bitOf(content.kind) & needed_) == 0) return std::nullopt;
    if (have_ != 0 && content.counter != counter_) {
        ++unfinished_;
        have_ = 0;
    }
    counter_ = content.counter;
    readSensors(line_, content);
    have_ |= bitOf(content.kind);
    if (have_ != needed_) return std::nullopt;
    have_ = 0;
    const std::optional<CountedOdometry> odometry = std::exchange(odometry_, std::nullopt);
    line_.odometry.reset();
    if (odometry && odometry->counter == counter_) line_.odometry = odometry->odometry;
    return line_;
}

}  // namespace terratact
