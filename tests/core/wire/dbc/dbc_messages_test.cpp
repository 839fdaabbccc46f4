// Tests the bounds of messages and warnings of DBC files.
#include "core/wire/dbc/dbc_messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/wire/dbc/dbc.h"
#include "core/wire/dbc/dbc_file.h"
#include "tests/support/bytes/dbc_text.h"

namespace terratact {
namespace {

TEST(DbcBounds, nameTheLinesOfFurtherFaults)
{
    const std::string good = " SG_ Good : 0|8@1+ (1,0) [0|0] \"\" B\n";
    const std::string bad = " SG_ S : 0|8@1+ (0,0) [0|0] \"\" B\n";
    std::string text = "BO_ 256 M: 8 A\n";
    for (int i = 0; i < 23; ++i) text += bad;  // lines 2 to 24
    text += good + bad + "VAL_ 256 Good 0 zero ;\n" + "BO_ 257 N: 8 A\n" + bad;
    const Result<DbcFile> file = parsed(text);
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->warnings.size(), 21U);
    EXPECT_EQ(file->warnings.back().english(),
              "f.dbc: 6 more things are left out, in lines 22–24, 26–27, 29");
}

TEST(DbcBounds, signalsBeyondTheMostLeaveTheFirst)
{
    const std::string signals = multiplexedSignals(DbcMessage::kMaxSignals + 2);
    const Result<DbcFile> file = parsed("BO_ 256 M: 8 A\n" + signals + "BO_ 257 N: 8 A\n");
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->messages.size(), 2U);
    EXPECT_EQ(file->messages[0].payload.size(), DbcMessage::kMaxSignals);
    ASSERT_EQ(file->warnings.size(), 2U);
    EXPECT_EQ(file->warnings[0].english(), "f.dbc: line 4098: the signal S4096 is left out: its "
                                           "message M has more than 4096 signals");
    EXPECT_TRUE(file->warnings[1].english().starts_with("f.dbc: line 4099: the signal S4097"));
}

TEST(DbcBounds, longTextsOfValuesAreCutWithTheirLine)
{
    const std::string name(129, 'n'), word = std::string(254, 'w') + "ä";
    const Result<DbcFile> file =
        parsed("BO_ 256 M: 8 A\n SG_ S : 0|8@1+ (1,0) [0|0] \"" + std::string(63, 'u')
               + "°C\" B\nVAL_ 256 S 0 \"" + word + "\" 1 \"" + std::string(255, 'w')
               + "\" ;\nBA_ \"SystemSignalLongSymbol\" SG_ 256 S \"" + name + "\";\n");
    ASSERT_TRUE(file) << file.error().text;
    const DbcSignal& s = file->messages.at(0).payload.at(0);
    EXPECT_EQ(s.unit, std::string(63, 'u') + "…") << "cut between two characters";
    EXPECT_EQ(s.words.at(0), std::string(254, 'w') + "…");
    EXPECT_EQ(s.words.at(1), std::string(255, 'w'));
    EXPECT_EQ(s.name, std::string(128, 'n') + "…");
    ASSERT_EQ(file->warnings.size(), 3U);
    EXPECT_EQ(file->warnings[0].english(),
              "f.dbc: line 2: the signal's unit is longer than 64 bytes: the rest is left out");
    EXPECT_EQ(file->warnings[1].english(), "f.dbc: line 3: the word of a raw value is longer than "
                                           "255 bytes: the rest is left out");
    EXPECT_EQ(file->warnings[2].english(),
              "f.dbc: line 4: a long name is longer than 128 bytes: the rest is left out");
}

TEST(DbcBounds, blankWordsAndWordsBeyond64BitsAreLeftOut)
{
    const auto file =
        parsed("BO_ 256 M: 8 A\n SG_ Q : 0|64@1+ (1,0) [0|0] \"\" A\n"
               "VAL_ 256 Q 0 \"\" 1 \" \" 2 \"two\" 1.8446744073709552E19 \"SNA\" ;\n");
    ASSERT_TRUE(file);
    EXPECT_EQ(file->messages.at(0).payload.at(0).words.size(), 1U);
    ASSERT_EQ(file->warnings.size(), 1U);
    EXPECT_EQ(file->warnings[0].english(),
              "f.dbc: line 3: the word 'SNA' is left out: expected its raw value in at most 64 "
              "bits, with all its digits");
}

TEST(DbcNames, giveNoLongNameToTwoSignals)
{
    const auto file = parsed("BO_ 256 M: 8 A\n SG_ A : 0|8@1+ (1,0) [0|0] \"\" B\n"
                             " SG_ B : 8|8@1+ (1,0) [0|0] \"\" B\n"
                             " SG_ C : 16|8@1+ (1,0) [0|0] \"\" B\n"
                             "BO_ 257 N: 8 A\n SG_ A : 0|8@1+ (1,0) [0|0] \"\" B\n"
                             "BA_ \"SystemSignalLongSymbol\" SG_ 256 A \"Same\";\n"
                             "BA_ \"SystemSignalLongSymbol\" SG_ 256 A \"Same\";\n"
                             "BA_ \"SystemSignalLongSymbol\" SG_ 256 B \"Same\";\n"
                             "BA_ \"SystemSignalLongSymbol\" SG_ 256 C \"B\";\n"
                             "BA_ \"SystemSignalLongSymbol\" SG_ 257 A \"Same\";\n");
    ASSERT_TRUE(file) << file.error().text;
    const auto& payload = file->messages.at(0).payload;
    ASSERT_EQ(payload.size(), 3U);
    EXPECT_EQ(payload[0].name, "Same");
    EXPECT_EQ(payload[1].name, "B") << "the short name";
    EXPECT_EQ(payload[2].name, "C");
    EXPECT_EQ(file->messages.at(1).payload.at(0).name, "Same") << "of another message";
    ASSERT_EQ(file->warnings.size(), 2U);
    EXPECT_EQ(file->warnings[0].english(),
              "f.dbc: line 9: the long name 'Same' of the signal B is left out: M has another "
              "signal of that name");
    EXPECT_EQ(file->warnings[1].english(),
              "f.dbc: line 10: the long name 'B' of the signal C is left out: M has another signal "
              "of that name");
}

/// Returns signals S0, S1 … of the first bit. multiplexing: of each, with a blank before it.
std::string firstBits(std::size_t count, const std::string& multiplexing = "")
{
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
        text += " SG_ S" + std::to_string(i) + multiplexing + " : 0|1@1+ (1,0) [0|0] \"\" B\n";
    return text;
}

TEST(DbcBounds, moreSignalsThanAFrameHasBitsAreNamed)
{
    const std::string selector = " SG_ X M : 0|8@1+ (1,0) [0|0] \"\" B\n";
    const std::string middle = " SG_ Y m1M : 8|8@1+ (1,0) [0|0] \"\" B\n";
    std::string nested = "BO_ 256 M: 1 A\n" + selector + firstBits(15, " m1");
    EXPECT_TRUE(parsed(nested)->warnings.empty()) << "with X there are 16";
    nested = "BO_ 256 M: 2 A\n" + selector + middle + firstBits(23, " m0");
    for (int i = 0; i < 23; ++i)
        nested += "SG_MUL_VAL_ 256 S" + std::to_string(i) + " Y 2-2, 4-18446744073709551615;\n";
    nested += "SG_MUL_VAL_ 256 Y X 1-1;\n";
    const std::string plain = "\nBO_ 257 N: 1 A\n" + firstBits(17);
    const Result<DbcFile> file = parsed(nested + plain);
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->warnings.size(), 2U);
    EXPECT_EQ(file->warnings[0].english(),
              "f.dbc: line 1: the message M describes up to 25 signals in a frame of 2 bytes: only "
              "the first 24 of a frame are read");
    EXPECT_EQ(
        file->warnings[1].english(),
        "f.dbc: line 52: the message N describes up to 17 signals in a frame of 1 bytes: only "
        "the first 16 of a frame are read");
}

TEST(DbcBounds, signalsOfDifferentPagesDoNotCountTogether)
{
    const DbcMessage m = onlyMessage("BO_ 256 M: 8 A\n" + multiplexedSignals(4096));
    EXPECT_EQ(m.payload.size(), 4096U);
    EXPECT_TRUE(parsed("BO_ 256 M: 8 A\n" + multiplexedSignals(4096))->warnings.empty());
    std::vector<std::optional<std::uint64_t>> bits(m.payload.size());
    decodeBits(m, frameOfBytes({127, 1, 2, 3, 4, 5, 6, 7}), bits);
    EXPECT_EQ(std::ranges::count_if(bits, [](const auto& b) { return b.has_value(); }), 33)
        << "S0, and each 128th";
    EXPECT_TRUE(bits[4095].has_value());
}

}  // namespace
}  // namespace terratact
