// Compares the codec with resources/dbc/terratact.dbc. The tests decode and encode frames by the
// file, so that neither can change without the other.
#include "core/wire/can_codec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include "core/terrain/bins.h"
#include "core/wire/dbc/dbc_file.h"
#include "core/wire/e2e.h"
#include "tests/support/bytes/dbc_frames.h"

namespace terratact {
namespace {

bool isHeader(const DbcSignal& s)
{
    return s.name == "Crc" || s.name == "Counter";
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

TEST(Dbc, hasDisjointSignalsWithRangesThatFitTheirBits)
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
        EXPECT_EQ(word, describe(static_cast<RobotActivity>(raw)).english);
    EXPECT_EQ(activity.most, static_cast<double>(activity.words.rbegin()->first));
    const auto& refusal = message("RobotStatus").signal("Refusal");
    EXPECT_EQ(refusal.words.size(), 9U);
    for (const auto& [raw, word] : refusal.words)
        EXPECT_EQ(word, describe(static_cast<Refusal>(raw)).english);
    EXPECT_EQ(refusal.most, static_cast<double>(refusal.words.rbegin()->first));
    EXPECT_EQ(message("ProbeBin").signal("Bin").most, kBins - 1);
    EXPECT_EQ(message("ArmResult").signal("Bin").most, kBins - 1);
    EXPECT_EQ(message("RobotStatus").signal("LastCommand").most, message("Advance").id);
}

/// Returns the distance between raw values to test: all of up to 16 bits, some of every class
/// modulo 256 for longer signals.
std::int64_t stride(const DbcSignal& s)
{
    return s.length <= 16 ? 1 : 251;
}

TEST(Codec, everyRawValueSurvivesARoundTripAsInTheDbc)
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
            ASSERT_NEAR(physical(frame, message(kind).signal(signals[s].name)), got.values[s],
                        1e-9);
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

TEST(Codec, stopsOnEveryFrameWithTheStopIdentifier)
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

}  // namespace
}  // namespace terratact
