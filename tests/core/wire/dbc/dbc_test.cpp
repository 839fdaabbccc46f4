// Tests the signals of DBC files against a bit-by-bit decoder, the handbooks and the codec.
#include "core/wire/dbc/dbc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/wire/can_codec.h"
#include "core/wire/dbc/dbc_file.h"
#include "tests/support/bytes/dbc_text.h"

namespace terratact {
namespace {

/// Returns the positions of a signal's bits, highest first.
std::vector<int> bitsFromTheTop(const DbcSignal& s)
{
    std::vector<int> bits;
    if (!s.isBigEndian)
        for (int i = s.length - 1; i >= 0; --i) bits.push_back(s.start + i);
    for (int bit = s.start; s.isBigEndian && static_cast<int>(bits.size()) < s.length;
         bit = bit % 8 == 0 ? bit + 15 : bit - 1)
        bits.push_back(bit);
    return bits;
}

/// Returns the same as valueOf(), bit by bit; empty if a bit lies beyond the frame.
std::optional<double> valueBitByBit(const DbcSignal& s, const CanFrame& frame)
{
    std::uint64_t raw = 0;
    for (const int bit : bitsFromTheTop(s)) {
        if (bit >= 8 * frame.length) return std::nullopt;
        raw = 2 * raw + ((frame.data.at(static_cast<std::size_t>(bit / 8)) >> (bit % 8)) & 1U);
    }
    double number = static_cast<double>(raw);
    if (s.type == DbcSignal::Type::Signed) {
        const bool isNegative = ((raw >> (s.length - 1)) & 1U) != 0;
        const std::uint64_t magnitude =
            isNegative ? (~raw & (~std::uint64_t{0} >> (64 - s.length))) + 1U : raw;
        number = (isNegative ? -1.0 : 1.0) * static_cast<double>(magnitude);
    }
    if (s.type == DbcSignal::Type::Float)
        number = static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
    if (s.type == DbcSignal::Type::Double) number = std::bit_cast<double>(raw);
    return number * s.scale + s.offset;
}

DbcSignal randomSignal(std::mt19937_64& rng)
{
    using Type = DbcSignal::Type;
    DbcSignal s;
    s.type = static_cast<Type>(rng() % 4);
    s.isBigEndian = rng() % 2 == 0;
    s.scale = std::uniform_real_distribution(-3.0, 3.0)(rng);
    s.offset = std::uniform_real_distribution(-100.0, 100.0)(rng);
    do {
        s.length = s.type == Type::Float  ? 32
                 : s.type == Type::Double ? 64
                                          : static_cast<int>(1 + rng() % 64);
        s.start = static_cast<int>(rng() % 512);
    } while (s.end() > 512);
    return s;
}

TEST(DbcSignals, agreeWithABitByBitDecoder)
{
    std::mt19937_64 rng(64);
    std::size_t negative = 0, missing = 0;
    for (int i = 0; i < 200'000; ++i) {
        const DbcSignal s = randomSignal(rng);
        CanFrame frame{.fd = true, .length = static_cast<std::uint8_t>(rng() % 65)};
        if (rng() % 2 == 0) frame.length = 64;
        for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(rng());
        const auto expected = valueBitByBit(s, frame);
        const auto found = valueOf(s, frame);
        ASSERT_EQ(found.has_value(), expected.has_value()) << s.start << "|" << s.length;
        if (expected && std::isnan(*expected))
            ASSERT_TRUE(std::isnan(*found)) << s.start << "|" << s.length;
        else
            ASSERT_EQ(found.value_or(0.0), expected.value_or(0.0)) << s.start << "|" << s.length;
        missing += !found;
        negative += found && (*found - s.offset) * s.scale < 0.0;
    }
    EXPECT_GT(missing, 10'000U);
    EXPECT_GT(negative, 10'000U);
}

TEST(DbcSignals, areWhereHandbooksHaveThem)
{
    const CanFrame frame = frameOfBytes({0x12, 0x34, 0x56, 0x78, 0x9A, 0xBC, 0xDE, 0xF0});
    EXPECT_EQ(valueOf(onlySignal("0|16@1+ (1,0)"), frame), 0x3412);
    EXPECT_EQ(valueOf(onlySignal("7|16@0+ (1,0)"), frame), 0x1234);
    EXPECT_EQ(valueOf(onlySignal("3|12@0+ (1,0)"), frame), 0x234);
    EXPECT_EQ(valueOf(onlySignal("4|12@1+ (1,0)"), frame), 0x341);
    EXPECT_EQ(valueOf(onlySignal("55|16@0- (1,0)"), frame), 0xDEF0 - 0x10000);
    EXPECT_EQ(valueOf(onlySignal("56|8@1+ (0.5,-20)"), frame), 100.0);
    EXPECT_EQ(valueOf(onlySignal("63|1@1- (1,0)"), frame), -1.0);
}

TEST(DbcSignals, mayBeFloatsOfIeee754)
{
    const std::string file = "BO_ 256 M: 8 A\n SG_ S : 0|32@1- (2,1) [0|0] \"\" B\n"
                             " SG_ T : 39|32@0- (1,0) [0|0] \"\" B\n"
                             "SIG_VALTYPE_ 256 S : 1;\nSIG_VALTYPE_ 256 T 1;\n";
    const DbcMessage m = onlyMessage(file);
    const CanFrame frame = frameOfBytes({0, 0, 0xC0, 0x3F, 0xC0, 0x20, 0, 0});
    EXPECT_EQ(valueOf(m.signal("S"), frame), 2.0 * 1.5 + 1.0);
    EXPECT_EQ(valueOf(m.signal("T"), frame), -2.5);
    EXPECT_TRUE(std::isnan(*valueOf(m.signal("S"), frameOfBytes({0, 0, 0xC0, 0x7F, 0, 0, 0, 0}))));
    EXPECT_TRUE(std::isinf(*valueOf(m.signal("T"), frameOfBytes({0, 0, 0, 0, 0x7F, 0x80, 0, 0}))));
    const DbcSignal whole = onlySignal("0|64@1- (1,0)", "SIG_VALTYPE_ 256 S : 2;\n");
    EXPECT_EQ(valueOf(whole, frameOfBytes({0, 0, 0, 0, 0, 0, 0x04, 0xC0})), -2.5);
}

TEST(DbcWords, nameRawValuesOf64Bits)
{
    const DbcSignal s = onlySignal("0|64@1+ (1,0)", "VAL_ 256 S 18446744073709551615 \"SNA\" "
                                                    "9223372036854775808 \"half\" -1 \"no\" "
                                                    "9007199254740993 \"odd\" ;\n");
    const auto word = [&](std::uint64_t bits) {
        const std::string* const found = wordOfBits(s, bits);
        return found ? *found : "none";
    };
    EXPECT_EQ(word(~std::uint64_t{0}), "SNA");
    EXPECT_EQ(word(std::uint64_t{1} << 63U), "half");
    EXPECT_EQ(word((std::uint64_t{1} << 53U) + 1U), "odd");
    EXPECT_EQ(word(std::uint64_t{1} << 53U), "none");
    const DbcSignal t = onlySignal("0|64@1- (1,0)", "VAL_ 256 S -1 \"minus\" ;\n");
    ASSERT_TRUE(wordOfBits(t, ~std::uint64_t{0}));
    EXPECT_EQ(*wordOfBits(t, ~std::uint64_t{0}), "minus");
}

TEST(DbcSignals, haveNoValueInAFrameThatHasNotTheirBits)
{
    const DbcSignal s = onlySignal("8|8@1+ (1,0)");
    EXPECT_FALSE(valueOf(s, frameOfBytes({1})));
    EXPECT_EQ(valueOf(s, frameOfBytes({1, 2})), 2.0);
    CanFrame remote = frameOfBytes({1, 2});
    remote.remote = true;
    EXPECT_FALSE(valueOf(s, remote));
    CanFrame error = frameOfBytes({1, 2});
    error.error = true;
    EXPECT_FALSE(valueOf(s, error));
    const DbcSignal far =
        onlyMessage("BO_ 256 M: 64 A\n SG_ S : 500|8@1+ (1,0) [0|0] \"\" B\n").payload[0];
    CanFrame fd = frameOfBytes({1, 2, 3, 4, 5, 6, 7, 8});
    fd.fd = true;
    fd.length = 64;
    fd.data[62] = 0xF0;
    fd.data[63] = 0x0A;
    EXPECT_EQ(valueOf(far, fd), 0xAF);
    fd.isCut = true;
    EXPECT_FALSE(valueOf(far, fd)) << "only eight bytes of it are known";
}

TEST(DbcMultiplexing, showsWhatTheMultiplexorSelects)
{
    const DbcMessage m = onlyMessage("BO_ 256 M: 8 A\n"
                                     " SG_ One m1 : 8|8@1+ (1,0) [0|0] \"\" B\n"
                                     " SG_ Which M : 0|8@1+ (1,0) [0|0] \"\" B\n"
                                     " SG_ Two m2 : 8|8@1+ (1,0) [0|0] \"\" B\n"
                                     " SG_ Some m7 : 16|8@1+ (1,0) [0|0] \"\" B\n"
                                     " SG_ Always : 24|8@1+ (1,0) [0|0] \"\" B\n"
                                     "SG_MUL_VAL_ 256 Some Which 7-7, 1-1;\n");
    const auto values = [&](std::uint8_t which) {
        std::vector<std::optional<double>> all(m.payload.size());
        decode(m, frameOfBytes({which, 50, 60, 70}), all);
        return all;
    };
    using All = std::vector<std::optional<double>>;
    EXPECT_EQ(values(1), (All{50.0, 1.0, std::nullopt, 60.0, 70.0}));
    EXPECT_EQ(values(2), (All{std::nullopt, 2.0, 50.0, std::nullopt, 70.0}));
    EXPECT_EQ(values(7), (All{std::nullopt, 7.0, std::nullopt, 60.0, 70.0}));
    All without(m.payload.size());
    decode(m, frameOfBytes({}), without);
    EXPECT_EQ(without, All(m.payload.size())) << "no multiplexor, nothing selected";
    EXPECT_THROW(decode(m, frameOfBytes({}), std::span(without).first(2)), std::invalid_argument);
}

TEST(DbcMultiplexing, mayBeNested)
{
    const DbcMessage m = onlyMessage("BO_ 256 M: 8 A\n"
                                     " SG_ Page M : 0|4@1+ (1,0) [0|15] \"\" B\n"
                                     " SG_ Sub m2M : 4|4@1+ (1,0) [0|15] \"\" B\n"
                                     " SG_ Flat m1 : 8|16@1+ (0.1,0) [0|0] \"V\" B\n"
                                     " SG_ Deep m0 : 8|16@1+ (1,0) [0|0] \"A\" B\n"
                                     "SG_MUL_VAL_ 256 Deep Sub 0-0;\n"
                                     "SG_MUL_VAL_ 256 Sub Page 2-2;\n"
                                     "SG_MUL_VAL_ 256 Flat Page 1-1;\n");
    const auto values = [&](std::uint8_t pages) {
        std::vector<std::optional<double>> all(m.payload.size());
        decode(m, frameOfBytes({pages, 5, 0}), all);
        return all;
    };
    using All = std::vector<std::optional<double>>;
    EXPECT_EQ(values(0x01), (All{1.0, std::nullopt, 0.5, std::nullopt}));
    EXPECT_EQ(values(0x02), (All{2.0, 0.0, std::nullopt, 5.0}));
    EXPECT_EQ(values(0x12), (All{2.0, 1.0, std::nullopt, std::nullopt}));
    EXPECT_EQ(values(0x00), (All{0.0, std::nullopt, std::nullopt, std::nullopt}));
}

TEST(DbcMultiplexing, rangesAreInOrderAndDoNotOverlap)
{
    const DbcMessage m = onlyMessage("BO_ 256 M: 8 A\n"
                                     " SG_ Which M : 0|8@1+ (1,0) [0|0] \"\" B\n"
                                     " SG_ Some m0 : 8|8@1+ (1,0) [0|0] \"\" B\n"
                                     "SG_MUL_VAL_ 256 Some Which 7-9, 1-2, 8-8, 2-3, 9-11;\n");
    EXPECT_EQ(m.signal("Some").selectedBy, (std::vector<DbcSignal::Selection>{
                                               {.first = 1, .last = 3}, {.first = 7, .last = 11}}));
}

TEST(DbcMultiplexing, anyRangesSelectTheirValues)
{
    std::mt19937_64 rng(5);
    for (int i = 0; i < 200; ++i) {
        std::vector<std::pair<std::size_t, std::size_t>> ranges(1 + rng() % 8);
        std::string text;
        for (auto& [first, last] : ranges) {
            first = rng() % 40;
            last = rng() % 40;  // a range whose last value is below the first selects nothing
            text += (text.empty() ? "" : ",") + std::to_string(first) + "-" + std::to_string(last);
        }
        const DbcMessage m = onlyMessage("BO_ 256 M: 8 A\n"
                                         " SG_ Which M : 0|8@1+ (1,0) [0|0] \"\" B\n"
                                         " SG_ Some m0 : 8|8@1+ (1,0) [0|0] \"\" B\n"
                                         "SG_MUL_VAL_ 256 Some Which "
                                         + text + ";\n");
        for (std::uint8_t which = 0; which < 42; ++which) {
            std::vector<std::optional<double>> all(m.payload.size());
            decode(m, frameOfBytes({which, 1}), all);
            const bool isSelected = std::any_of(ranges.begin(), ranges.end(), [&](const auto& r) {
                return r.first <= which && which <= r.second;
            });
            ASSERT_EQ(all[1].has_value(), isSelected) << int{which} << " of " << text;
        }
    }
}

TEST(DbcSignals, ofAFrameAreAtMostItsBitsAndEightMore)
{
    std::string text = "BO_ 256 M: 8 A\n";
    for (int i = 0; i < 100; ++i)
        text += " SG_ S" + std::to_string(i) + " : 0|8@1+ (1,0) [0|0] \"\" B\n";
    const DbcMessage m = onlyMessage(text);
    const auto decoded = [&](const std::vector<std::uint8_t>& bytes) {
        std::vector<std::optional<double>> values(m.payload.size());
        decode(m, frameOfBytes(bytes), values);
        const auto end = std::ranges::find(values, std::optional<double>());
        EXPECT_TRUE(std::all_of(end, values.end(), [](const auto& v) { return !v; }));
        return end - values.begin();
    };
    EXPECT_EQ(decoded({1}), 16) << "all bits, the byte and more";
    EXPECT_EQ(decoded({1, 2, 3, 4, 5, 6, 7, 8}), 72) << "all bits and bytes";
    EXPECT_EQ(decoded({}), 0);
}

TEST(ShippedDbc, decodesEveryFrameExactlyAsTheCodec)
{
    const auto file = readDbc(TERRATACT_SOURCE_DIR "/resources/dbc/terratact.dbc");
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_TRUE(file->warnings.empty());
    ASSERT_EQ(file->messages.size(), kFrameKinds);
    std::mt19937_64 rng(25);
    for (int i = 0; i < 20'000; ++i) {
        const auto kind = static_cast<FrameKind>(rng() % kFrameKinds);
        const auto layout = layoutOf(kind).payload;
        Unpacked sent{.kind = kind, .counter = static_cast<std::uint8_t>(rng())};
        for (std::size_t s = 0; s < layout.size(); ++s)
            sent.values[s] = std::uniform_real_distribution(layout[s].least, layout[s].most)(rng);
        if (kind == FrameKind::ArmResult) sent.values[2] = std::max(sent.values[2], 0.001);
        const CanFrame frame = pack(sent);
        const Unpacked coded = std::get<Unpacked>(unpack(frame));
        const DbcMessage& m = file->messages[static_cast<std::size_t>(kind)];
        std::vector<std::optional<double>> values(m.payload.size());
        decode(m, frame, values);
        ASSERT_EQ(m.payload.size(), layout.size() + 2);
        EXPECT_EQ(values[1], coded.counter) << m.name;
        for (std::size_t s = 0; s < layout.size(); ++s) {
            ASSERT_EQ(m.payload[s + 2].name, layout[s].name);
            ASSERT_EQ(values[s + 2], coded.values[s]) << m.name << "." << layout[s].name;
        }
    }
}

}  // namespace
}  // namespace terratact
