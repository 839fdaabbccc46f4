// DBC files: their content, their refusal, and their signals compared with a bit-by-bit decoder.
#include "core/wire/dbc/dbc.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/wire/can_codec.h"
#include "core/wire/dbc/dbc_file.h"
#include "core/wire/dbc/dbc_number.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

Result<DbcFile> parsed(const std::string& text)
{
    return dbcFrom("f.dbc", text);
}

DbcMessage onlyMessage(const std::string& text)
{
    const Result<DbcFile> file = parsed(text);
    EXPECT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->messages.size(), 1U);
    return file->messages.at(0);
}

/// A signal of an eight-byte message.
DbcSignal onlySignal(const std::string& place, const std::string& more = {})
{
    return onlyMessage("BO_ 256 M: 8 A\n SG_ S : " + place + " [0|0] \"\" B\n" + more)
        .payload.at(0);
}

CanFrame frameOfBytes(const std::vector<std::uint8_t>& bytes)
{
    CanFrame frame{.id = 256, .length = static_cast<std::uint8_t>(bytes.size())};
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    return frame;
}

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

TEST(DbcMultiplexing, withoutAMultiplexorIsLeftOutWithItsLine)
{
    const Result<DbcFile> file = parsed("BO_ 256 M: 8 A\n"
                                        " SG_ One m1M : 8|8@1+ (1,0) [0|0] \"\" B\n"
                                        " SG_ Two m1M : 16|8@1+ (1,0) [0|0] \"\" B\n"
                                        " SG_ Below m1 : 0|8@1+ (1,0) [0|0] \"\" B\n"
                                        " SG_ Always : 24|8@1+ (1,0) [0|0] \"\" B\n"
                                        "BO_ 257 N: 8 A\n"
                                        " SG_ Lost m1 : 8|8@1+ (1,0) [0|0] \"\" B\n"
                                        "SG_MUL_VAL_ 256 One Two 1-1;\n"
                                        "SG_MUL_VAL_ 256 Two One 1-1;\n"
                                        "SG_MUL_VAL_ 256 Below One 1-1;\n");
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->messages[0].payload.size(), 1U) << "a circle selects nothing";
    EXPECT_EQ(file->messages[0].payload[0].name, "Always");
    EXPECT_TRUE(file->messages[1].payload.empty());
    ASSERT_EQ(file->warnings.size(), 2U);
    EXPECT_TRUE(
        file->warnings[0].english().starts_with("f.dbc: line 2: 3 multiplexed signals of M"));
    EXPECT_TRUE(
        file->warnings[1].english().starts_with("f.dbc: line 7: 1 multiplexed signals of N"));
}

TEST(DbcFiles, giveTheLongNames)
{
    const DbcMessage m =
        onlyMessage("BO_ 256 Short: 8 A\n"
                    " SG_ TemperatureOfTheAirInFrontOfThe_ : 0|8@1+ (1,0) [0|0] \"\" B\n"
                    "BA_DEF_ SG_ \"SystemSignalLongSymbol\" STRING ;\n"
                    "BA_ \"SystemSignalLongSymbol\" SG_ 256 TemperatureOfTheAirInFrontOfThe_ "
                    "\"TemperatureOfTheAirInFrontOfTheGripper\";\n"
                    "BA_ \"SystemMessageLongSymbol\" BO_ 256 \"MuchLongerThanShort\";\n"
                    "VAL_ 256 TemperatureOfTheAirInFrontOfThe_ 1 \"one\" ;\n");
    EXPECT_EQ(m.name, "MuchLongerThanShort");
    EXPECT_EQ(m.payload.at(0).name, "TemperatureOfTheAirInFrontOfTheGripper");
    EXPECT_EQ(m.payload.at(0).words.size(), 1U) << "the file goes on with the short one";
}

TEST(DbcFiles, sayWhichMessagesAreParameterGroups)
{
    const std::string message = "BO_ 2364540158 EEC1: 8 A\nBO_ 256 Standard: 8 A\n";
    const std::string kinds =
        "BA_DEF_ BO_ \"VFrameFormat\" ENUM \"StandardCAN\",\"J1939PG\",\"ExtendedCAN\";\n";
    const auto isGroup = [&](const std::string& text) {
        const Result<DbcFile> file = parsed(message + text);
        EXPECT_TRUE(file && file->warnings.empty());
        EXPECT_FALSE(file->messages.at(1).isParameterGroup) << "11 bits have none";
        return file->messages.at(0).isParameterGroup;
    };
    EXPECT_FALSE(isGroup(""));
    EXPECT_TRUE(isGroup(kinds + "BA_ \"VFrameFormat\" BO_ 2364540158 1;\n"));
    EXPECT_FALSE(isGroup(kinds + "BA_ \"VFrameFormat\" BO_ 2364540158 2;\n"));
    EXPECT_TRUE(isGroup("BA_ \"VFrameFormat\" BO_ 2364540158 3;\n"));
    EXPECT_TRUE(isGroup(kinds + "BA_DEF_DEF_ \"VFrameFormat\" \"J1939PG\";\n"));
    EXPECT_FALSE(isGroup(kinds
                         + "BA_DEF_DEF_ \"VFrameFormat\" \"J1939PG\";\n"
                           "BA_ \"VFrameFormat\" BO_ 2364540158 0;\n"));
    EXPECT_TRUE(isGroup("BA_ \"ProtocolType\" \"J1939\";\n"));
    EXPECT_EQ(parameterGroupOf(0x0CF00400), parameterGroupOf(0x18F004FE));
    EXPECT_NE(parameterGroupOf(0x0CF00400), parameterGroupOf(0x0CF00500));
    EXPECT_EQ(parameterGroupOf(0x18EAFF01), parameterGroupOf(0x18EA0002)) << "a destination";
}

DbcSignal scaled(double scale, double offset, DbcSignal::Type type = DbcSignal::Type::Unsigned)
{
    DbcSignal signal;
    signal.length = 64;
    signal.scale = scale;
    signal.offset = offset;
    signal.type = type;
    return signal;
}

TEST(DbcNumberTexts, haveAllTheirDigits)
{
    DbcSignal whole = scaled(1.0, 0.0);
    EXPECT_EQ(exactText(whole, 9223372036854788153U), "9223372036854788153");
    EXPECT_EQ(shownText(whole, 9223372036854788153U), "9223372036854788153");
    whole.type = DbcSignal::Type::Signed;
    EXPECT_EQ(exactText(whole, ~std::uint64_t{0}), "-1");
    EXPECT_EQ(exactText(whole, std::uint64_t{1} << 63U), "-9223372036854775808");
    const DbcSignal tenths = scaled(0.1, -40.0);
    EXPECT_EQ(exactText(tenths, 3), "-39.7");
    EXPECT_EQ(exactText(tenths, 9223372036854788153U), "922337203685478775.3");
    EXPECT_EQ(exactText(tenths, 400), "0.0");
    DbcSignal fine = scaled(1.0 / 256.0, 0.0);
    EXPECT_EQ(exactText(fine, 3), "0.01171875");
    EXPECT_EQ(shownText(fine, std::uint64_t{3}), "0.0117");
    fine.scale = 1.0 / 3.0;
    EXPECT_EQ(exactText(fine, 1), "0.3333333333333333");
    const DbcSignal real = scaled(1.0, 0.0, DbcSignal::Type::Double);
    EXPECT_EQ(exactText(real, std::bit_cast<std::uint64_t>(1234.56789012345)), "1234.56789012345");
    EXPECT_EQ(exactText(real, 0x7FF8'0000'0000'0000), "nan");
    EXPECT_EQ(exactText(real, 0x7FF0'0000'0000'0000), "inf");
    EXPECT_EQ(shownText(real, std::uint64_t{0xFFF0'0000'0000'0000}), "-inf");
}

TEST(Dbc, aSignalBelowTheNodesIsNamedAsFault)
{
    const Result<DbcFile> read =
        parsed("BU_: Engine\n SG_ Lost : 0|8@1+ (1,0) [0|0] \"\" A\n"
               "BO_ 256 Clock: 8 A\n SG_ Kept : 0|8@1+ (1,0) [0|0] \"\" A\n");
    ASSERT_TRUE(read);
    ASSERT_EQ(read->messages.size(), 1U);
    ASSERT_EQ(read->warnings.size(), 1U);
    EXPECT_NE(read->warnings[0].english().find("line 2"), std::string::npos)
        << read->warnings[0].english();
}

/// A file as other programs write it.
const char* const kForeign = R"(VERSION "HNPBNYYYYYYYYYNNNNNNN/4/%%%/4/'%**4YYY///"

NS_ :
	NS_DESC_
	CM_
	BO_TX_BU_

BS_: 500000 : 1,2

BU_: Engine Gateway
VAL_TABLE_ Gears 2 "second" 1 "first" ;

BO_ 3221225472 VECTOR__INDEPENDENT_SIG_MSG: 0 Vector__XXX
 SG_ Orphan : 0|8@1+ (1,0) [0|0] "" Vector__XXX

BO_ 2566844926 CCVS : 8 Engine
   SG_ Speed:15|16@0+ (3.90625E-003,0) [0|250.996] "km/h"  Gateway, Vector__XXX
 SG_ Gear : 32|4@1- (+1,-0.) [-1|.5] "" Vector__XXX

BO_ 100 Short: 2 Vector__XXX

EV_ Voltage: 0 [0|20] "V" 0 1 DUMMY_NODE_VECTOR0 Vector__XXX;
CM_ "Of the whole.";
CM_ BU_ Engine "Under the bonnet.";
CM_ BO_ 2566844926 "Says \"hello\";
BO_ 7 NoMessage: 8 A
and goes on.";
CM_ SG_ 2566844926 Speed "Over ground.";
CM_ SG_ 2566844926 Nobody "Of no signal.";
BA_DEF_ BO_  "GenMsgCycleTime" INT 0 65535;
BA_DEF_  "BusType" STRING ;
BA_DEF_DEF_  "GenMsgCycleTime" 250;
BA_DEF_DEF_  "BusType" "CAN";
BA_ "BusType" "CAN";
BA_ "GenMsgCycleTime" BO_ 2566844926 100;
BA_ "GenMsgStartValue" SG_ 2566844926 Speed 0;
BA_ "Kind" BO_ 100 "text";
VAL_ 2566844926 Gear -1 "reverse" 0 "neutral" 1 "first" ;
VAL_ Voltage 0 "off" ;
SIG_GROUP_ 2566844926 Group 1 : Speed;
SIG_VALTYPE_ 2566844926 Gear : 0;
FUTURE_SECTION_ of "another; version"
  without an end
BO_ 101 Last: 8 Engine
)";

TEST(DbcFiles, areReadAsOtherProgramsWriteThem)
{
    const Result<DbcFile> file = parsed(kForeign);
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_TRUE(file->warnings.empty());
    ASSERT_EQ(file->messages.size(), 3U);
    const DbcMessage& m = file->messages[0];
    EXPECT_EQ(m.name, "CCVS");
    EXPECT_TRUE(m.extended);
    EXPECT_EQ(m.id, 0x18FEF1FEU);
    EXPECT_EQ(m.sender, "Engine");
    EXPECT_EQ(m.comment, "Says \"hello\";\nBO_ 7 NoMessage: 8 A\nand goes on.");
    EXPECT_DOUBLE_EQ(m.period(), 0.1);
    ASSERT_EQ(m.payload.size(), 2U);
    EXPECT_EQ(m.payload[0].name, "Speed");
    EXPECT_TRUE(m.payload[0].isBigEndian);
    EXPECT_EQ(m.payload[0].scale, 1.0 / 256.0);
    EXPECT_EQ(m.payload[0].most, 250.996);
    EXPECT_EQ(m.payload[0].unit, "km/h");
    EXPECT_EQ(m.payload[0].receivers, "Gateway, Vector__XXX");
    EXPECT_EQ(m.payload[0].comment, "Over ground.");
    const DbcSignal& gear = m.signal("Gear");
    EXPECT_EQ(gear.type, DbcSignal::Type::Signed);
    EXPECT_EQ(gear.words.size(), 3U);
    EXPECT_EQ(*wordOf(gear, -1.0), "reverse");
    EXPECT_EQ(wordOf(gear, 2.0), nullptr);
    EXPECT_EQ(wordOf(gear, 1e300), nullptr);
    EXPECT_THROW(static_cast<void>(m.signal("Nobody")), std::out_of_range);
    EXPECT_EQ(file->messages[1].name, "Short");
    EXPECT_DOUBLE_EQ(file->messages[1].period(), 0.25) << "the default";
    EXPECT_EQ(file->messages[2].name, "Last") << "behind a section without its semicolon";
}

TEST(DbcFiles, mayEndTheirLinesAsTheyLike)
{
    std::string text = kForeign;
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
        text.replace(at, 1, "\r\n");
    const Result<DbcFile> file = parsed(text);
    ASSERT_TRUE(file) << file.error().text;
    const Result<DbcFile> plain = parsed(kForeign);
    ASSERT_EQ(file->messages.size(), plain->messages.size());
    for (std::size_t i = 0; i < plain->messages.size(); ++i) {
        EXPECT_EQ(file->messages[i].name, plain->messages[i].name);
        EXPECT_EQ(file->messages[i].comment, plain->messages[i].comment);
        EXPECT_EQ(file->messages[i].payload.size(), plain->messages[i].payload.size());
    }
}

TEST(DbcFiles, areUtf8OrElseOfWindows)
{
    const std::string before = "BO_ 256 M: 8 A\n SG_ S : 0|8@1+ (1,0) [0|0] \"";
    const auto unit = [&](const std::string& bytes) {
        return onlyMessage(before + bytes + "\" B\n").payload[0].unit;
    };
    EXPECT_EQ(unit("\xB0"
                   "C"),
              "°C")
        << "ISO 8859-1 is the same there";
    EXPECT_EQ(unit("\x80\x85\x93\x99\xE4"), "€…“™ä") << "Windows code page 1252";
    EXPECT_EQ(unit("°C"), "°C");
    EXPECT_EQ(unit("\xE2\x82"), "â‚") << "no whole character of UTF-8";
    EXPECT_EQ(unit("\xE2\x81"), "â ") << "no letter, and no control character";
    EXPECT_EQ(onlyMessage("\xEF\xBB\xBF" + before + "Ω\" B\n").payload[0].unit, "Ω");
    EXPECT_EQ(unit("a\x1B[31m\xC2\x9B"
                   "b"),
              "a [31m b")
        << "nothing that a terminal would obey";
    EXPECT_EQ(unit(std::string(500, 'x')), std::string(500, 'x'));
    EXPECT_EQ(unit(std::string(2500, 'x')), std::string(2000, 'x') + "…");
}

TEST(DbcFiles, duplicatesKeepTheFirstWithAWarning)
{
    const Result<DbcFile> file = parsed("BO_ 256 M: 8 A\n"
                                        " SG_ S : 0|8@1+ (2,0) [0|0] \"\" B\n"
                                        " SG_ S : 8|8@1+ (3,0) [0|0] \"\" B\n"
                                        " SG_ Z : 8|8@1+ (0,0) [0|0] \"\" B\n"
                                        "BO_ 256 N: 8 A\n"
                                        " SG_ T : 0|8@1+ (1,0) [0|0] \"\" B\n"
                                        "BO_ 2147483904 Extended: 8 A\n"
                                        "BO_ 300 Long: 1785 A\n"
                                        " SG_ T : 9000|8@1+ (1,0) [0|0] \"\" B\n");
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->messages.size(), 2U);
    ASSERT_EQ(file->messages[0].payload.size(), 1U);
    EXPECT_EQ(file->messages[0].payload[0].scale, 2.0);
    EXPECT_EQ(file->messages[1].name, "Extended") << "256 with 29 bits is another";
    const std::vector<std::string> lines{"line 3", "line 4", "line 5", "line 8"};
    ASSERT_EQ(file->warnings.size(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
        EXPECT_TRUE(file->warnings[i].english().starts_with("f.dbc: " + lines[i] + ": "))
            << file->warnings[i].english();
}

TEST(DbcFiles, loseOnlyTheFaultyLine)
{
    const std::string head = "VERSION \"\"\n\nBO_ 256 M: 8 A\n";
    const std::string kept = " SG_ Kept : 0|8@1+ (1,0) [0|0] \"\" B\n";
    const std::string more = "BO_ 300 More: 8 A\n SG_ Kept : 0|8@1+ (1,0) [0|0] \"\" B\n";
    const std::string s = " SG_ S : ";
    struct Case {
        std::string line;
        std::vector<std::string_view> parts;
    };
    const std::vector<Case> cases{
        {s + "60|8@1+ (1,0) [0|0] \"\" B\n", {"S is left out", "message M", "bit 68 of 64"}},
        {s + "0|0@1+ (1,0) [0|0] \"\" B\n", {"0 bits", "1 to 64"}},
        {s + "0|65@1+ (1,0) [0|0] \"\" B\n", {"65 bits", "1 to 64"}},
        {s + "0|8@2+ (1,0) [0|0] \"\" B\n", {"byte order", "'2+'"}},
        {s + "0|8@1 (1,0) [0|0] \"\" B\n", {"expected '+'", "'-'"}},
        {s + "0|8@1+ (nan,0) [0|0] \"\" B\n", {"scale, a number", "'nan,0)'"}},
        {s + "0|8@1+ (1e999,0) [0|0] \"\" B\n", {"scale, a number"}},
        {s + "0|8@1+ (1;0) [0|0] \"\" B\n", {"between scale and offset"}},
        {s + "0|8@1+ (1,0) [0|0] V B\n", {"unit", "quotation marks", "'V'"}},
        {s + "0|8@1+ (1,0) 0|0 \"\" B\n", {"range"}},
        {" SG_ S m : 0|8@1+ (1,0) [0|0] \"\" B\n", {"multiplexor", "'m'"}},
        {" SG_ : 0|8@1+ (1,0) [0|0] \"\" B\n", {"the signal's name"}},
        {"VAL_ 256 Kept 0 zero ;\n", {"word of a raw value", "'zero'"}},
        {"SIG_VALTYPE_ 256 Kept : 1;\n", {"no float", "8 bits, expected 32"}},
        {"time,id,data\n", {"keyword of a section", "'time'"}},
        {"BO_ x N: 8 A\n", {"identifier", "'x'"}},
        {"BO_ 4096 N: 8 A\n", {"4096", "at most 2047"}},
        {"BO_ 3221225473 N: 8 A\n", {"3221225473", "29 bits"}},
        {"BO_ 4294967296 N: 8 A\n", {"at most 4294967295"}},
        {"BO_ 257 N 8 A\n", {"':' behind the message's name"}},
        {"BO_ 257 " + std::string(129, 'x') + ": 8 A\n", {"at most 128"}},
    };
    for (const Case& c : cases) {
        const Result<DbcFile> file = parsed(head + kept + c.line + more);
        ASSERT_TRUE(file) << c.line << file.error().text;
        ASSERT_EQ(file->warnings.size(), 1U) << c.line;
        EXPECT_TRUE(file->warnings[0].english().starts_with("f.dbc: line 5: "))
            << file->warnings[0].english();
        for (const std::string_view part : c.parts)
            EXPECT_NE(file->warnings[0].english().find(part), std::string::npos)
                << "no " << part << " in " << file->warnings[0].english();
        ASSERT_EQ(file->messages.size(), 2U) << c.line;
        const bool isLost = c.line.starts_with("SIG_VALTYPE_");
        EXPECT_EQ(file->messages[0].payload.size(), isLost ? 0U : 1U) << c.line;
        EXPECT_EQ(file->messages[1].payload.size(), 1U) << c.line;
    }
}

TEST(DbcFiles, withAQuoteThatDoesNotEndKeepTheRest)
{
    const Result<DbcFile> file = parsed("BO_ 256 M: 8 A\nCM_ BO_ 256 \"no end;\nBO_ 257 N: 8 A\n");
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->messages.size(), 2U);
    ASSERT_EQ(file->warnings.size(), 1U);
    EXPECT_TRUE(file->warnings[0].english().starts_with("f.dbc: line 2: expected a quotation mark"))
        << file->warnings[0].english();
}

TEST(DbcFiles, skipOtherSectionsSilently)
{
    const std::string text = "// made by hand\nVERSION \"\"\nBO_ 256 M: 8 A // its message\n"
                             "// BO_ 257 Not: 8 A\n"
                             " SG_ S : 0|8@1+ (1,0) [-1e400|1e400] \"\" B\n"
                             " SG_ T : 8|8@1+ (1,0) [] \"\" B\n"
                             "BO_ 1073741824 VECTOR__INDEPENDENT_SIG_MSG: 0 Vector__XXX\n"
                             " SG_ Orphan : 0|8@1+ (1,0) [0|0] \"\" B\n"
                             "BO_ 258 N: 8\n\x1A";
    const Result<DbcFile> file = parsed(text);
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_TRUE(file->warnings.empty()) << file->warnings.front().english();
    ASSERT_EQ(file->messages.size(), 2U);
    EXPECT_EQ(file->messages[0].payload.size(), 2U);
    EXPECT_EQ(file->messages[0].payload[0].most, 0.0) << "no range";
    EXPECT_EQ(file->messages[1].name, "N") << "without a sender";
}

TEST(DbcFiles, withoutAMessageAreRefusedWithTheFirstCause)
{
    struct Case {
        std::string text;
        std::vector<std::string_view> parts;
    };
    const std::vector<Case> cases{
        {"time,id,data\n0.1,22,AA\n", {"no message", "line 1", "keyword of a section", "'time'"}},
        {"VERSION \"\"\n SG_ S : 0|8@1+ (1,0) [0|0] \"\" B\n",
         {"no message", "line 2", "a message (BO_) before"}},
        {"VERSION \"\"\n", {"no message", "is it a DBC file?"}},
        {"", {"no message"}},
        {std::string("BO_\0", 4), {"no text", "save it anew"}},
    };
    for (const Case& c : cases) {
        const Result<DbcFile> file = parsed(c.text);
        EXPECT_TRUE(refused(file, "f.dbc", {})) << c.text;
        if (file) continue;
        for (const std::string_view part : c.parts)
            EXPECT_NE(file.error().text.find(part), std::string::npos)
                << "no " << part << " in " << file.error().text;
    }
}

TEST(DbcFiles, thatCannotBeReadNameTheFile)
{
    const TemporaryDirectory directory;
    EXPECT_TRUE(refused(readDbc(directory.file("none.dbc")), directory.file("none.dbc"),
                        {"cannot be opened"}));
    EXPECT_TRUE(refused(readDbc(directory.file("")), directory.file(""), {"cannot be read"}));
    const std::string big = directory.write("big.dbc", std::string(kMaxDbcBytes + 1, ' '));
    EXPECT_TRUE(refused(readDbc(big), big, {"larger"}));
}

TEST(DbcFiles, largeFilesAreReadWithFewWarnings)
{
    std::string text;
    for (int i = 0; i < 20'000; ++i)
        text += "BO_ " + std::to_string(2147483648U + static_cast<unsigned>(i)) + " M: 8 A\n"
              + " SG_ S : 0|8@1+ (0,0) [0|0] \"\" B\n";
    text += "BO_ 1 Wide: 8 A\n";
    for (int i = 0; i < 20'000; ++i)
        text += " SG_ S" + std::to_string(i) + " : 0|8@1+ (1,0) [0|0] \"\" B\n";
    for (int i = 0; i < 20'000; ++i) text += "VAL_ 1 S" + std::to_string(i) + " 1 \"one\" ;\n";
    const Result<DbcFile> file = parsed(text);
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->messages.size(), 20'001U);
    EXPECT_EQ(file->messages.back().payload.back().words.at(1), "one");
    EXPECT_EQ(file->warnings.size(), 21U);
    EXPECT_EQ(file->warnings.back().english(), "f.dbc: 19980 more things are left out");
}

TEST(DbcFiles, damagedFilesOnlyGiveErrors)
{
    const std::string whole = kForeign;
    std::mt19937_64 rng(3);
    for (std::size_t i = 0; i < 4000; ++i) {
        std::string text = whole;
        if (i < whole.size())
            text.resize(i);
        else
            for (int k = 0; k < 4; ++k) text[rng() % text.size()] = "\"; \n:|@M0_9\x80"[rng() % 12];
        const Result<DbcFile> file = parsed(text);
        if (!file) {
            ASSERT_TRUE(refused(file, "f.dbc", {}));
            continue;
        }
        for (const DbcMessage& m : file->messages)
            for (const DbcSignal& s : m.payload) {
                ASSERT_GE(s.length, 1);
                ASSERT_LE(s.length, 64);
                ASSERT_LE(s.end(), 8 * m.length);
            }
    }
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

TEST(DbcFile, aUnitThatDoesNotEndTakesNoOtherSignalAway)
{
    const auto file = parsed("BO_ 256 M: 8 A\n SG_ Q : 0|8@1+ (1,0) [0|0] \"km/h A\n"
                             " SG_ R : 0|8@1+ (1,0) [0|0] \"\" A\n");
    ASSERT_TRUE(file);
    ASSERT_EQ(file->messages.at(0).payload.size(), 1U);
    EXPECT_EQ(file->messages[0].payload[0].name, "R");
    ASSERT_EQ(file->warnings.size(), 1U);
    EXPECT_TRUE(
        file->warnings[0].english().starts_with("f.dbc: line 2: expected a quotation mark"));
}

TEST(DbcFile, linesMayEndWithCrAlone)
{
    const auto file = parsed("BO_ 256 M: 8 A\r SG_ Q : 0|8@1+ (1,0) [0|0] \"\" A\r");
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->messages.at(0).payload.size(), 1U);
}

TEST(DbcFile, saysWhereTheCodePageIsAGuess)
{
    const auto warnings = [](const std::string& unit) {
        const auto file =
            parsed("BO_ 256 M: 8 A\n SG_ Q : 0|8@1+ (1,0) [0|0] \"" + unit + "\" A\n");
        EXPECT_TRUE(file);
        return file->warnings.size();
    };
    EXPECT_EQ(warnings("\xB0"
                       "C m/s\xB2 gr\xF6\xDF"
                       "er"),
              0U);
    EXPECT_EQ(warnings("p\xF8\xEDli\x9A"), 1U) << "Windows code page 1250";
}

}  // namespace
}  // namespace terratact
