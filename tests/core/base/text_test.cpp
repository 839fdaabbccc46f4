#include "core/base/text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace terratact {
namespace {

TEST(NumberText, readsBackAsTheSameBits)
{
    std::mt19937_64 rng(1);
    for (int i = 0; i < 100000; ++i) {
        const double value = std::bit_cast<double>(rng());
        if (!std::isfinite(value)) continue;
        const auto read = numberFrom(numberText(value));
        ASSERT_TRUE(read) << numberText(value);
        ASSERT_EQ(std::bit_cast<std::uint64_t>(*read), std::bit_cast<std::uint64_t>(value));
    }
}

TEST(RandomErrorText, isNeverZero)
{
    EXPECT_EQ(randomErrorText(0.016, 2), "0.02");
    EXPECT_EQ(randomErrorText(0.005, 2), "0.01");
    EXPECT_EQ(randomErrorText(0.0049, 2), "< 0.01");
    EXPECT_EQ(randomErrorText(0.0, 1), "< 0.1");
}

TEST(RhatText, isOver100ForStuckChains)
{
    EXPECT_EQ(rhatText(1.0), "1.000");
    EXPECT_EQ(rhatText(1.0612), "1.061");
    EXPECT_EQ(rhatText(100.0), "100.000");
    EXPECT_EQ(rhatText(100.5), "> 100");
    EXPECT_EQ(rhatText(1e6), "> 100") << "kRhatNever";
}

TEST(NumberText, isTheShortestThatReadsBack)
{
    EXPECT_EQ(numberText(0.1), "0.1");
    EXPECT_EQ(numberText(-0.3), "-0.3");
    EXPECT_EQ(numberText(5.0), "5");
    EXPECT_EQ(numberText(1e-9), "1e-09");
}

TEST(NumberFrom, takesTheWholeTextOrNothing)
{
    EXPECT_EQ(numberFrom("-1.5e-3"), -1.5e-3);
    for (const char* text :
         {"", " 1", "1 ", "1,5", "0x10", "1.5m", "--1", "+1", "1e999", "e5", "."})
        EXPECT_FALSE(numberFrom(text)) << text;
}

TEST(IntegerFrom, takesTheWholeTextOrNothing)
{
    EXPECT_EQ(integerFrom<int>("-12"), -12);
    EXPECT_EQ(integerFrom<int>("007"), 7);
    EXPECT_EQ(integerFrom<unsigned>("ff", 16), 255U);
    EXPECT_EQ(integerFrom<std::uint8_t>("255"), 255);
    for (const char* text : {"", " 1", "1 ", "1.0", "0x10", "+1", "--1", "2147483648"})
        EXPECT_FALSE(integerFrom<int>(text)) << text;
    for (const char* text : {"256", "-1"}) EXPECT_FALSE(integerFrom<std::uint8_t>(text)) << text;
}

TEST(WrittenIntegerFrom, takesOnlyTextsOfToString)
{
    EXPECT_EQ(writtenIntegerFrom<std::uint64_t>("18446744073709551615"), UINT64_MAX);
    EXPECT_EQ(writtenIntegerFrom<int>("-5"), -5);
    for (const char* text : {"", "007", "-0", "1 ", "1.0"})
        EXPECT_FALSE(writtenIntegerFrom<int>(text)) << text;
}

TEST(IsControl, isTrueForAsciiControlCharacters)
{
    for (const char c : {'\0', '\t', '\n', '\x1b', '\x1f', '\x7f'}) EXPECT_TRUE(isControl(c));
    for (const char c : std::string("\x20~č")) EXPECT_FALSE(isControl(c));
}

TEST(IsUtf8, isTrueForWholeCharactersOnly)
{
    for (const char* const text : {"", "plain", "Wärme: běží", "€", "\U0001F916"})
        EXPECT_TRUE(isUtf8(text)) << text;
    for (const char* const text : {"W\xE4rme", "\xE2\x82", "\xC0\x80", "\xED\xA0\x80", "\x80"})
        EXPECT_FALSE(isUtf8(text)) << shown(text);
}

TEST(Shown, putsUntrustedTextOnOneShortLine)
{
    EXPECT_EQ(shown("pitch"), "'pitch'");
    EXPECT_EQ(shown(std::string_view("a\n\0\x1b[31m", 8)), "'a???[31m'");
    EXPECT_EQ(shown(std::string(41, 'x')), "'" + std::string(40, 'x') + "…'");
}

TEST(Shown, keepsLettersOfUtf8)
{
    EXPECT_EQ(shown("Wärme: běží"), "'Wärme: běží'");
    EXPECT_EQ(shown("W\xE4rme\t"), "'W?rme<tab>'") << "Windows code page 1252";
    EXPECT_EQ(shown("\xE2\x80\xAE"
                    "a\xC4"),
              "'?a?'")
        << "a mark of direction, half a letter";
    std::string forty;
    for (int i = 0; i < 40; ++i) forty += "ř";  // two bytes each
    EXPECT_EQ(shown(forty), "'" + forty + "'");
    EXPECT_EQ(shown(forty + "x"), "'" + forty + "…'");
}

TEST(Text, aNameIsAtMostHundredPlainCharacters)
{
    for (const std::string& good : {std::string("Absolem"), std::string("č"),
                                    std::string("<b> & \"x\""), std::string(100, 'x')})
        EXPECT_TRUE(isReadableName(good)) << good;
    std::string hundred;
    for (int i = 0; i < 100; ++i) hundred += "ř";  // two bytes each
    EXPECT_TRUE(isReadableName(hundred));
    EXPECT_FALSE(isReadableName(hundred + "x"));
    for (const std::string& bad :
         {std::string(), std::string(101, 'x'), std::string("a\nb"), std::string("a\0b", 3),
          std::string("\x1b[2J"), std::string("\x7f"), std::string("\xC2\x9B") + "2J",
          std::string("\xE2\x80\xA8"), std::string("\xE2\x80\xAE") + "RAELC",
          std::string("\xE2\x81\xA6"), std::string("\xEF\xBB\xBF"), std::string("\xFF"),
          std::string("\xC0\x80"), std::string("\xED\xA0\x80"), std::string("\xF4\x90\x80\x80"),
          std::string("\xE2\x80")})
        EXPECT_FALSE(isReadableName(bad)) << shown(bad);
}

TEST(Printable, isOneLineThatMovesNoCursor)
{
    EXPECT_EQ(printable("Absolem \xc2\xb1 5\xc2\xb0 \xe2\x9c\x98 \xf0\x9f\x9a\x9c"),
              "Absolem \xc2\xb1 5\xc2\xb0 \xe2\x9c\x98 \xf0\x9f\x9a\x9c");
    EXPECT_EQ(printable("a\nb\r\x1b[2Kholds yes\x7f\t"), "a?b??[2Kholds yes??");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "?31m")
        << "an escape of one character";
    EXPECT_EQ(printable("a\xe2\x80\xae"
                        "b\xe2\x81\xa6"
                        "c\xe2\x80\xa8"
                        "d"),
              "a?b?c?d")
        << "turned writing, a line separator";
    EXPECT_EQ(printable("\x80 \xc0\xaf \xed\xa0\x80 \xe2\x9c"), "? ?? ??? ??");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "?");
    EXPECT_EQ(printableLines("a\nb\x1b[2K\r\n"), "a\nb?[2K?\n");
}

TEST(BeginningOf, endsWithAWholeCharacter)
{
    EXPECT_EQ(beginningOf("abc", 3), "abc");
    EXPECT_EQ(beginningOf("abcd", 3), "abc");
    EXPECT_EQ(beginningOf("ab\xc3\xa4", 3), "ab");
    EXPECT_EQ(beginningOf("a\xe2\x9c\x98", 3), "a");
    EXPECT_EQ(beginningOf("\x80\x80\x80\x80\x80\x80", 5).size(), 5U) << "no UTF-8 at all";
}

}  // namespace
}  // namespace terratact
