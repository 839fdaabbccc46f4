// The codec against resources/dbc/terratact.dbc: frames are taken apart and put together here by what the
// file says, so that neither can change without the other.
#include "core/wire/can_codec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include "core/terrain/bins.h"
#include "core/wire/dbc_file.h"
#include "core/wire/e2e.h"

namespace terratact {
namespace {

const std::vector<DbcMessage>& dbc()
{
    static const auto file = readDbc(TERRATACT_SOURCE_DIR "/resources/dbc/terratact.dbc");
    return file->messages;
}

const DbcMessage& message(FrameKind kind)
{
    return dbc().at(static_cast<std::size_t>(kind));
}

const DbcMessage& message(const std::string& name)
{
    for (const DbcMessage& m : dbc())
        if (m.name == name) return m;
    throw std::out_of_range(name);
}

bool isSigned(const DbcSignal& s)
{
    return s.type == DbcSignal::Type::Signed;
}

bool isHeader(const DbcSignal& s)
{
    return s.name == "Crc" || s.name == "Counter";
}

std::int64_t rawOf(double value, const DbcSignal& s)
{
    return std::llround((value - s.offset) / s.scale);
}

void setBits(CanFrame& frame, const DbcSignal& s, std::int64_t raw)
{
    for (int i = 0; i < s.length; ++i) {
        const int bit = s.start + i;
        const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
        auto& byte = frame.data.at(static_cast<std::size_t>(bit / 8));
        const bool on = ((static_cast<std::uint64_t>(raw) >> i) & 1U) != 0;
        byte = static_cast<std::uint8_t>(on ? byte | mask : byte & ~mask);
    }
}

double physical(const CanFrame& frame, const DbcSignal& s)
{
    std::int64_t raw = 0;
    for (int i = s.length - 1; i >= 0; --i) {
        const int bit = s.start + i;
        raw = 2 * raw + ((frame.data.at(static_cast<std::size_t>(bit / 8)) >> (bit % 8)) & 1);
    }
    if (isSigned(s) && raw >= (std::int64_t{1} << (s.length - 1)))
        raw -= std::int64_t{1} << s.length;
    return static_cast<double>(raw) * s.scale + s.offset;
}

void seal(CanFrame& frame, const DbcMessage& m, std::uint8_t counter)
{
    protect(frame.data, counter, static_cast<std::uint16_t>(m.attributes.at("E2eDataId")));
}

/// A frame of the file with every signal as near to 0 as its range allows; an arm's reading has an sd.
CanFrame blank(const DbcMessage& m, std::uint8_t counter = 0)
{
    CanFrame frame{.id = m.id, .length = static_cast<std::uint8_t>(m.length)};
    for (const DbcSignal& s : m.payload)
        if (s.least > 0.0 || s.name == "Sd")
            setBits(frame, s, std::max(rawOf(s.least, s), std::int64_t{1}));
    seal(frame, m, counter);
    return frame;
}

std::optional<FrameFault> faultOf(const CanFrame& frame)
{
    const auto result = unpack(frame);
    const auto* fault = std::get_if<FrameFault>(&result);
    return fault ? std::optional(*fault) : std::nullopt;
}

Unpacked contentOf(const CanFrame& frame)
{
    return std::get<Unpacked>(unpack(frame));
}

std::size_t signalIndex(FrameKind kind, const std::string& name)
{
    const auto signals = layoutOf(kind).payload;
    for (std::size_t i = 0; i < signals.size(); ++i)
        if (signals[i].name == name) return i;
    throw std::out_of_range(name);
}

template <class Visit>
void forEverySignal(Visit visit)
{
    for (std::size_t k = 0; k < kFrameKinds; ++k) {
        const auto kind = static_cast<FrameKind>(k);
        for (const DbcSignal& s : message(kind).payload)
            if (!isHeader(s)) visit(kind, message(kind), s);
    }
}

TEST(Dbc, namesEveryFrameOfTheCodecAndNoOther)
{
    ASSERT_EQ(dbc().size(), kFrameKinds);
    std::set<unsigned> ids;
    std::set<double> dataIds;
    for (std::size_t k = 0; k < kFrameKinds; ++k) {
        const FrameLayout& layout = layoutOf(static_cast<FrameKind>(k));
        const DbcMessage& m = dbc()[k];
        EXPECT_EQ(m.name, layout.name);
        EXPECT_EQ(m.id, layout.id) << m.name;
        EXPECT_FALSE(m.extended) << m.name;
        EXPECT_EQ(m.length, 8) << m.name;
        EXPECT_EQ(m.sender == "Console", layout.fromConsole) << m.name;
        EXPECT_EQ(m.attributes.at("E2eDataId"), layout.dataId) << m.name;
        EXPECT_DOUBLE_EQ(m.period(), layout.period) << m.name;
        EXPECT_EQ(m.period() > 0.0, m.attributes.contains("GenMsgSendType")) << m.name;
        EXPECT_EQ(m.payload.size(), layout.payload.size() + 2) << m.name;
        EXPECT_FALSE(m.comment.empty()) << m.name << " says nothing about itself";
        ids.insert(m.id);
        dataIds.insert(m.attributes.at("E2eDataId"));
    }
    EXPECT_EQ(ids.size(), kFrameKinds);
    EXPECT_EQ(dataIds.size(), kFrameKinds);
    EXPECT_THROW(static_cast<void>(layoutOf(static_cast<FrameKind>(kFrameKinds))),
                 std::invalid_argument);
}

TEST(Dbc, hasTheHeaderOfProfileFiveInEveryFrame)
{
    for (const DbcMessage& m : dbc()) {
        EXPECT_EQ(m.signal("Crc").start, 0) << m.name;
        EXPECT_EQ(m.signal("Crc").length, 16) << m.name;
        EXPECT_EQ(m.signal("Counter").start, 16) << m.name;
        EXPECT_EQ(m.signal("Counter").length, 8) << m.name;
    }
}

TEST(Dbc, hasEverySignalWhereTheCodecHasIt)
{
    forEverySignal([](FrameKind kind, const DbcMessage& m, const DbcSignal& s) {
        const std::string place = m.name + "." + s.name;
        const SignalLayout& layout = layoutOf(kind).payload[signalIndex(kind, s.name)];
        EXPECT_EQ(s.start, layout.start) << place;
        EXPECT_FALSE(s.isBigEndian) << place;
        EXPECT_EQ(s.length, layout.length) << place;
        EXPECT_EQ(isSigned(s), layout.isSigned) << place;
        EXPECT_DOUBLE_EQ(s.scale, layout.scale) << place;
        EXPECT_EQ(s.offset, 0.0) << place;
        EXPECT_DOUBLE_EQ(s.least, layout.least) << place;
        EXPECT_DOUBLE_EQ(s.most, layout.most) << place;
        EXPECT_EQ(s.unit, layout.unit) << place;
        EXPECT_EQ(s.receivers, m.sender == "Console" ? "Robot" : "Console") << place;
    });
}

TEST(Dbc, keepsEverySignalApartAndItsRangeWithinItsBits)
{
    for (const DbcMessage& m : dbc()) {
        std::uint64_t taken = 0;
        for (const DbcSignal& s : m.payload) {
            ASSERT_LE(s.start + s.length, 64) << m.name << "." << s.name;
            for (int i = 0; i < s.length; ++i) {
                const std::uint64_t bit = std::uint64_t{1} << (s.start + i);
                EXPECT_EQ(taken & bit, 0U) << m.name << "." << s.name;
                taken |= bit;
            }
            const std::int64_t span = std::int64_t{1} << s.length;
            EXPECT_GE(rawOf(s.least, s), isSigned(s) ? -span / 2 : 0) << m.name << "." << s.name;
            EXPECT_LT(rawOf(s.most, s), isSigned(s) ? span / 2 : span) << m.name << "." << s.name;
        }
    }
}

TEST(Dbc, hasTheWordsOfTheCore)
{
    const auto& activity = message("RobotStatus").signal("Activity");
    EXPECT_EQ(activity.words.size(), 6U);
    for (const auto& [raw, word] : activity.words)
        EXPECT_EQ(word, describe(static_cast<RobotActivity>(raw)));
    EXPECT_EQ(activity.most, static_cast<double>(activity.words.rbegin()->first));
    const auto& refusal = message("RobotStatus").signal("Refusal");
    EXPECT_EQ(refusal.words.size(), 9U);
    for (const auto& [raw, word] : refusal.words)
        EXPECT_EQ(word, describe(static_cast<Refusal>(raw)));
    EXPECT_EQ(refusal.most, static_cast<double>(refusal.words.rbegin()->first));
    EXPECT_EQ(message("ProbeBin").signal("Bin").most, kBins - 1);
    EXPECT_EQ(message("ArmResult").signal("Bin").most, kBins - 1);
    EXPECT_EQ(message("RobotStatus").signal("LastCommand").most, message("Advance").id);
}

/// From one raw value to the next: every one of up to 16 bits, some of every class modulo 256 of longer signals.
std::int64_t stride(const DbcSignal& s)
{
    return s.length <= 16 ? 1 : 251;
}

TEST(Codec, readsEveryRawValueOfEverySignalAsTheFileSaysAndWritesItBack)
{
    forEverySignal([](FrameKind kind, const DbcMessage& m, const DbcSignal& s) {
        const std::size_t index = signalIndex(kind, s.name);
        CanFrame frame = blank(m);
        for (std::int64_t raw = rawOf(s.least, s); raw <= rawOf(s.most, s); raw += stride(s)) {
            setBits(frame, s, raw);
            seal(frame, m, static_cast<std::uint8_t>(raw & 0xFF));
            const Unpacked content = contentOf(frame);
            ASSERT_EQ(content.kind, kind) << m.name;
            ASSERT_EQ(content.counter, raw & 0xFF) << m.name;
            ASSERT_NEAR(content.values[index], static_cast<double>(raw) * s.scale, 1e-9 * s.scale)
                << m.name << "." << s.name << " " << raw;
            ASSERT_EQ(pack(content), frame) << m.name << "." << s.name << " " << raw;
        }
    });
}

TEST(Codec, refusesEveryRawValueBeyondTheRange)
{
    forEverySignal([](FrameKind, const DbcMessage& m, const DbcSignal& s) {
        const std::int64_t span = std::int64_t{1} << s.length;
        const std::int64_t begin = isSigned(s) ? -span / 2 : 0;
        CanFrame frame = blank(m);
        for (std::int64_t raw = begin; raw < begin + span; ++raw) {
            if (raw >= rawOf(s.least, s) && raw <= rawOf(s.most, s)) continue;
            setBits(frame, s, raw);
            seal(frame, m, 0);
            ASSERT_EQ(faultOf(frame), FrameFault::OutOfRange)
                << m.name << "." << s.name << " " << raw;
        }
    });
}

TEST(Codec, refusesToWriteWhatDoesNotFit)
{
    forEverySignal([](FrameKind kind, const DbcMessage& m, const DbcSignal& s) {
        const std::size_t index = signalIndex(kind, s.name);
        Unpacked content = contentOf(blank(m));
        for (const double value :
             {s.least - s.scale, s.most + s.scale, 1e300, -1e300,
              std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            content.values[index] = value;
            EXPECT_THROW(static_cast<void>(pack(content)), std::invalid_argument)
                << m.name << "." << s.name << " " << value;
        }
    });
    EXPECT_THROW(static_cast<void>(pack({.kind = FrameKind::Halt, .values = {1.0, 1.0}})),
                 std::invalid_argument)
        << "a value without a signal";
}

TEST(Codec, takesRandomContentThroughTheWire)
{
    std::mt19937_64 rng(7);
    for (int i = 0; i < 20000; ++i) {
        const auto kind = static_cast<FrameKind>(rng() % kFrameKinds);
        const auto signals = layoutOf(kind).payload;
        Unpacked sent{.kind = kind, .counter = static_cast<std::uint8_t>(rng())};
        for (std::size_t s = 0; s < signals.size(); ++s)
            sent.values[s] = std::uniform_real_distribution(signals[s].least, signals[s].most)(rng);
        if (kind == FrameKind::ArmResult) sent.values[2] = std::max(sent.values[2], 0.001);
        const CanFrame frame = pack(sent);
        const Unpacked got = contentOf(frame);
        for (std::size_t s = 0; s < signals.size(); ++s) {
            ASSERT_NEAR(got.values[s], sent.values[s], 0.5001 * signals[s].scale);
            ASSERT_NEAR(physical(frame, message(kind).signal(std::string(signals[s].name))),
                        got.values[s], 1e-9);
        }
        ASSERT_EQ(pack(got), frame);
    }
}

TEST(Codec, refusesEveryOtherLength)
{
    for (const DbcMessage& m : dbc()) {
        CanFrame frame = blank(m);
        ASSERT_FALSE(faultOf(frame)) << m.name;
        for (int length = 0; length <= 64; ++length) {
            frame.length = static_cast<std::uint8_t>(length);
            if (length == 8) continue;
            EXPECT_EQ(faultOf(frame), FrameFault::WrongLength) << m.name << " " << length;
        }
    }
}

TEST(Codec, refusesEveryBitThatNoSignalNames)
{
    for (const DbcMessage& m : dbc()) {
        std::uint64_t named = 0;
        for (const DbcSignal& s : m.payload)
            for (int i = 0; i < s.length; ++i) named |= std::uint64_t{1} << (s.start + i);
        for (int bit = 0; bit < 64; ++bit) {
            if (((named >> bit) & 1U) != 0) continue;
            CanFrame frame = blank(m);
            frame.data[static_cast<std::size_t>(bit / 8)] |=
                static_cast<std::uint8_t>(1 << bit % 8);
            seal(frame, m, 0);
            EXPECT_EQ(faultOf(frame), FrameFault::ReservedBits) << m.name << " bit " << bit;
        }
    }
}

TEST(Codec, catchesEveryFlipOfUpToThreeBitsInEveryFrame)
{
    for (const DbcMessage& m : dbc()) {
        CanFrame frame = blank(m, 77);
        const auto flip = [&](int bit) {
            frame.data[static_cast<std::size_t>(bit / 8)] ^=
                static_cast<std::uint8_t>(1 << bit % 8);
        };
        std::uint64_t caught = 0;
        for (int a = 0; a < 64; ++a)
            for (int b = a; b < 64; ++b)
                for (int c = b; c < 64; ++c) {
                    const std::set<int> bits{a, b, c};
                    for (const int bit : bits) flip(bit);
                    caught += faultOf(frame) == FrameFault::WrongCrc;
                    for (const int bit : bits) flip(bit);
                }
        EXPECT_EQ(caught, 64U * 65U * 66U / 6U) << m.name;
    }
}

TEST(Codec, refusesFramesThatAreNotClassicDataFrames)
{
    for (const DbcMessage& m : dbc()) {
        for (int flag = 0; flag < 4; ++flag) {
            CanFrame frame = blank(m);
            (flag == 0   ? frame.extended
             : flag == 1 ? frame.remote
             : flag == 2 ? frame.error
                         : frame.fd) = true;
            EXPECT_EQ(faultOf(frame), FrameFault::NotClassicData) << m.name << " " << flag;
        }
    }
}

TEST(Codec, refusesAFrameUnderAnyOtherIdentifier)
{
    for (const DbcMessage& m : dbc()) {
        CanFrame frame = blank(m);
        for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
            frame.id = id;
            const bool known =
                std::any_of(dbc().begin(), dbc().end(),
                            [id](const DbcMessage& other) { return other.id == id; });
            if (id == m.id) continue;
            ASSERT_EQ(faultOf(frame), known ? FrameFault::WrongCrc : FrameFault::UnknownId)
                << m.name << " as " << id;
        }
    }
}

TEST(Codec, hasWordsForEveryFault)
{
    for (int i = 0; i < kFrameFaults; ++i)
        EXPECT_FALSE(describe(static_cast<FrameFault>(i)).empty());
    EXPECT_THROW(static_cast<void>(describe(static_cast<FrameFault>(kFrameFaults))),
                 std::invalid_argument);
}

TEST(Codec, stopsOnWhateverCarriesTheIdentifierOfStop)
{
    CanFrame frame = frameOf(StopCommand{}, 9, 1);
    EXPECT_TRUE(meansStop(frame));
    frame.data = {};
    frame.length = 0;
    frame.remote = true;
    EXPECT_TRUE(meansStop(frame)) << "damaged";
    frame.extended = true;
    EXPECT_FALSE(meansStop(frame)) << "another identifier of 29 bits";
    EXPECT_FALSE(meansStop({.id = 0x010, .error = true})) << "an error frame of the controller";
    EXPECT_FALSE(meansStop(frameOf(HaltCommand{}, 9, 1)));
}

struct SentCommand {
    Command command;
    std::string name;
    std::vector<std::pair<std::string, double>> signals;
};

const std::vector<SentCommand>& commands()
{
    static const std::vector<SentCommand> all{
        {StopCommand{}, "Stop", {}},
        {ReleaseStopCommand{}, "ReleaseStop", {}},
        {ArmCommand{true}, "Arm", {{"Armed", 1.0}}},
        {ArmCommand{false}, "Arm", {{"Armed", 0.0}}},
        {HaltCommand{}, "Halt", {}},
        {DriveCommand{-0.25}, "Drive", {{"Speed", -0.25}}},
        {BeginAtemCommand{}, "BeginAtem", {}},
        {AbortAtemCommand{}, "AbortAtem", {}},
        {PressCommand{18.05}, "PressFlippers", {{"Torque", 18.05}}},
        {HoldFlippersCommand{0.7, -0.1}, "HoldFlippers", {{"Front", 0.7}, {"Rear", -0.1}}},
        {ProbeCommand{9}, "ProbeBin", {{"Bin", 9.0}}},
        {AdvanceCommand{0.1}, "Advance", {{"Distance", 0.1}}},
    };
    return all;
}

TEST(Commands, travelInTheirFramesWithTheirEpoch)
{
    std::set<std::size_t> kinds;
    for (const SentCommand& sent : commands()) {
        const CanFrame frame = frameOf(sent.command, 213, 42);
        const DbcMessage& m = message(sent.name);
        EXPECT_EQ(frame.id, m.id) << sent.name;
        EXPECT_EQ(message(kindOf(sent.command)).name, sent.name);
        for (const auto& [name, value] : sent.signals)
            EXPECT_NEAR(physical(frame, m.signal(name)), value, 1e-9) << sent.name << "." << name;
        const Unpacked content = contentOf(frame);
        EXPECT_EQ(content.counter, 42);
        const auto got = commandOf(content);
        ASSERT_TRUE(got) << sent.name;
        EXPECT_EQ(got->command.index(), sent.command.index()) << sent.name;
        EXPECT_EQ(got->epoch, sent.name == "Stop" ? 0 : 213) << sent.name;
        EXPECT_EQ(frameOf(got->command, got->epoch, 42), frame) << sent.name << " changed";
        kinds.insert(sent.command.index());
    }
    EXPECT_EQ(kinds.size(), std::variant_size_v<Command>) << "a command is missing here";
}

TEST(Commands, areRefusedBeyondTheirRange)
{
    for (const Command& command :
         {Command{DriveCommand{0.61}}, Command{DriveCommand{std::nan("")}},
          Command{PressCommand{0.0}}, Command{PressCommand{60.1}}, Command{ProbeCommand{-1}},
          Command{ProbeCommand{11}}, Command{AdvanceCommand{0.0}}, Command{AdvanceCommand{0.101}},
          Command{HoldFlippersCommand{3.2, 0.0}}, Command{HoldFlippersCommand{0.0, -3.2}}})
        EXPECT_THROW(static_cast<void>(frameOf(command, 1, 0)), std::invalid_argument)
            << command.index();
}

TEST(Heartbeats, carryTheirToken)
{
    const CanFrame asked = consoleHeartbeat(0xBEEF, 3);
    const CanFrame answered = robotHeartbeat(0xBEEF, 5);
    EXPECT_EQ(asked.id, message("ConsoleHeartbeat").id);
    EXPECT_EQ(answered.id, message("RobotHeartbeat").id);
    EXPECT_EQ(physical(asked, message("ConsoleHeartbeat").signal("Token")), 0xBEEF);
    EXPECT_EQ(tokenOf(contentOf(asked)), 0xBEEF);
    EXPECT_EQ(tokenOf(contentOf(answered)), 0xBEEF);
    EXPECT_FALSE(tokenOf(contentOf(frameOf(HaltCommand{}, 1, 1))));
    EXPECT_FALSE(commandOf(contentOf(asked)));
}

TEST(Status, travelsInItsFrame)
{
    const RobotStatus sent{.epoch = 250,
                           .activity = RobotActivity::Probing,
                           .refusal = Refusal::OutOfLimits,
                           .armed = true,
                           .exploring = true,
                           .lastCommand = FrameKind::ProbeBin,
                           .lastCounter = 99};
    const CanFrame frame = frameOf(sent, 7);
    const DbcMessage& m = message("RobotStatus");
    EXPECT_EQ(physical(frame, m.signal("Epoch")), 250.0);
    EXPECT_EQ(physical(frame, m.signal("Activity")), 4.0);
    EXPECT_EQ(physical(frame, m.signal("Refusal")), 8.0);
    EXPECT_EQ(physical(frame, m.signal("Armed")), 1.0);
    EXPECT_EQ(physical(frame, m.signal("Exploring")), 1.0);
    EXPECT_EQ(physical(frame, m.signal("LastCommand")), message("ProbeBin").id);
    EXPECT_EQ(physical(frame, m.signal("LastCounter")), 99.0);
    EXPECT_EQ(statusOf(contentOf(frame)), sent);
    for (const bool armed : {false, true})
        for (const bool exploring : {false, true}) {
            const RobotStatus status{.armed = armed, .exploring = exploring};
            EXPECT_EQ(statusOf(contentOf(frameOf(status, 0))), status);
        }
}

TEST(Status, isNoneInOtherFramesWithEpochZeroOrAnUnknownCommand)
{
    EXPECT_FALSE(statusOf(contentOf(frameOf(HaltCommand{}, 1, 1))));
    EXPECT_THROW(static_cast<void>(frameOf(RobotStatus{.epoch = 0}, 0)), std::invalid_argument);
    CanFrame frame = frameOf(RobotStatus{}, 0);
    setBits(frame, message("RobotStatus").signal("LastCommand"), 5);
    seal(frame, message("RobotStatus"), 0);
    EXPECT_FALSE(statusOf(contentOf(frame)));
}

SensorLine fullLine()
{
    SensorLine line;
    line.odometry = SensorLine::Odometry{-12.345, 0.5};
    line.attitude = SensorLine::Attitude{0.2, -0.1};
    line.frontAngles = Pair{0.3, 0.31};
    line.rearAngles = Pair{-0.4, -0.41};
    line.frontCurrents = Pair{1.5, 1.501};
    line.rearCurrents = Pair{-2.5, 2.501};
    for (std::size_t set = 0; set < 4; ++set) {
        const double v = 0.625 * static_cast<double>(set + 1);
        line.voltages[set] = SensorLine::Three{v, v + 0.0625, v + 0.125};
    }
    line.arm = ArmReading{8, -0.1234, 0.0305};
    return line;
}

std::optional<SensorLine> read(SensorLineReader& reader, const SensorLine& line,
                               std::uint8_t counter)
{
    std::optional<SensorLine> got;
    for (const CanFrame& frame : framesOf(line, counter)) {
        EXPECT_FALSE(got) << "before the last frame";
        got = reader.take(contentOf(frame));
    }
    return got;
}

TEST(SensorLine, putsEveryNumberIntoItsSignal)
{
    const auto frames = framesOf(fullLine(), 9);
    const auto at = [&](const std::string& name, const std::string& signal) {
        for (const CanFrame& frame : frames)
            if (frame.id == message(name).id) return physical(frame, message(name).signal(signal));
        ADD_FAILURE() << "no " << name;
        return 0.0;
    };
    EXPECT_NEAR(at("Odometry", "Travelled"), -12.345, 1e-9);
    EXPECT_NEAR(at("Odometry", "Turned"), 0.5, 1e-9);
    EXPECT_NEAR(at("Attitude", "Pitch"), 0.2, 1e-9);
    EXPECT_NEAR(at("Attitude", "Roll"), -0.1, 1e-9);
    EXPECT_NEAR(at("FrontAngles", "Left"), 0.3, 1e-9);
    EXPECT_NEAR(at("FrontAngles", "Right"), 0.31, 1e-9);
    EXPECT_NEAR(at("RearAngles", "Left"), -0.4, 1e-9);
    EXPECT_NEAR(at("RearAngles", "Right"), -0.41, 1e-9);
    EXPECT_NEAR(at("FrontCurrents", "Left"), 1.5, 1e-9);
    EXPECT_NEAR(at("FrontCurrents", "Right"), 1.501, 1e-9);
    EXPECT_NEAR(at("RearCurrents", "Left"), -2.5, 1e-9);
    EXPECT_NEAR(at("RearCurrents", "Right"), 2.501, 1e-9);
    EXPECT_NEAR(at("LeftForces1To3", "Element1"), 0.625, 1e-9);
    EXPECT_NEAR(at("LeftForces1To3", "Element3"), 0.75, 1e-9);
    EXPECT_NEAR(at("LeftForces4To6", "Element5"), 1.3125, 1e-9);
    EXPECT_NEAR(at("RightForces1To3", "Element2"), 1.9375, 1e-9);
    EXPECT_NEAR(at("RightForces4To6", "Element6"), 2.625, 1e-9);
    EXPECT_NEAR(at("ArmResult", "Bin"), 8.0, 1e-9);
    EXPECT_NEAR(at("ArmResult", "Height"), -0.1234, 1e-9);
    EXPECT_NEAR(at("ArmResult", "Sd"), 0.0305, 1e-9);
    for (const CanFrame& frame : frames) EXPECT_EQ(frame.data[2], 9) << "one counter for all";
}

TEST(SensorLine, comesBackWholeOverEveryTurnOfTheCounter)
{
    SensorLineReader reader;
    for (int counter = 0; counter < 600; ++counter) {
        const auto got = read(reader, fullLine(), static_cast<std::uint8_t>(counter));
        ASSERT_TRUE(got);
        ASSERT_NEAR(got->frontAngles->right, 0.31, 1e-9);
        ASSERT_NEAR((*got->voltages[3])[2], 2.625, 1e-9);
        ASSERT_EQ(got->arm->bin, 8);
        ASSERT_NEAR(got->odometry->travelled, -12.345, 1e-9);
    }
    EXPECT_EQ(reader.unfinished(), 0U);
}

TEST(SensorLine, saysWhatWasNotMeasured)
{
    SensorLineReader reader;
    ASSERT_TRUE(read(reader, fullLine(), 1));
    EXPECT_EQ(read(reader, SensorLine{}, 2), SensorLine{}) << "nothing of the line before";
}

TEST(SensorLine, isNeverMadeOfTwoLines)
{
    SensorLineReader reader;
    const auto first = framesOf(fullLine(), 1), second = framesOf(SensorLine{}, 2);
    for (std::size_t i = 0; i + 1 < first.size(); ++i)
        EXPECT_FALSE(reader.take(contentOf(first[i])));
    EXPECT_FALSE(reader.take(contentOf(second.back()))) << "the one missing, of another line";
    EXPECT_EQ(reader.unfinished(), 1U);
    for (std::size_t i = 0; i + 2 < second.size(); ++i)
        EXPECT_FALSE(reader.take(contentOf(second[i])));
    EXPECT_FALSE(reader.take(contentOf(frameOf(RobotStatus{}, 2)))) << "no sensor frame";
    EXPECT_TRUE(reader.take(contentOf(second[second.size() - 2])));
}

TEST(SensorLine, needsNoOdometryAndTakesNoOtherLines)
{
    SensorLineReader reader;
    const auto first = framesOf(fullLine(), 1), second = framesOf(fullLine(), 2);
    std::optional<SensorLine> got;
    for (std::size_t i = 1; i < first.size(); ++i) got = reader.take(contentOf(first[i]));
    ASSERT_TRUE(got) << "a robot without odometry";
    EXPECT_FALSE(got->odometry);
    EXPECT_FALSE(reader.take(contentOf(first.front()))) << "too late for its line";
    for (std::size_t i = 1; i < second.size(); ++i) got = reader.take(contentOf(second[i]));
    ASSERT_TRUE(got);
    EXPECT_FALSE(got->odometry) << "of the line before";
    EXPECT_EQ(reader.unfinished(), 0U);
}

TEST(ArmResult, isNeverWithoutAnSd)
{
    SensorLine line;
    line.arm = ArmReading{3, 0.1, 0.0};
    EXPECT_THROW(static_cast<void>(framesOf(line, 0)), std::invalid_argument);
    CanFrame frame = blank(message("ArmResult"));
    setBits(frame, message("ArmResult").signal("Sd"), 0);
    setBits(frame, message("ArmResult").signal("Measured"), 1);
    seal(frame, message("ArmResult"), 0);
    EXPECT_EQ(faultOf(frame), FrameFault::OutOfRange);
}

}  // namespace
}  // namespace terratact
