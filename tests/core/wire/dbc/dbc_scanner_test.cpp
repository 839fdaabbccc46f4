// Tests where texts of DBC files end.
#include "core/wire/dbc/dbc_scanner.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/wire/dbc/dbc.h"
#include "core/wire/dbc/dbc_file.h"
#include "tests/support/bytes/dbc_text.h"

namespace terratact {
namespace {

TEST(DbcTexts, anOpenQuoteTakesNoOtherLineAway)
{
    const std::string signals = "BO_ 256 M: 8 A\n SG_ Speed : 0|8@1+ (1,0) [0|0] \"\" B\n"
                                " SG_ Gear : 8|8@1+ (1,0) [0|0] \"\" B\n"
                                " SG_ Rpm : 16|8@1+ (1,0) [0|0] \"\" B\n";
    for (const char* const open : {"CM_ SG_ 256 Speed \"open;\n", "CM_ \"open;\n",
                                   "BA_ \"Kind\" \"open;\n", "FUTURE_ of \"open;\n"}) {
        const Result<DbcFile> file = parsed(signals + open
                                            + "VAL_ 256 Gear 0 \"neutral\" 1 \"first\" ;\n"
                                              "CM_ SG_ 256 Rpm \"engine; filtered\";\n");
        ASSERT_TRUE(file) << file.error().text;
        const DbcMessage& m = file->messages.at(0);
        EXPECT_EQ(m.signal("Gear").words.size(), 2U) << open;
        EXPECT_EQ(m.signal("Rpm").comment, "engine; filtered") << open;
        EXPECT_EQ(m.signal("Speed").comment, "");
        ASSERT_EQ(file->warnings.size(), 1U) << open;
        EXPECT_TRUE(
            file->warnings[0].english().starts_with("f.dbc: line 5: expected a quotation mark"))
            << file->warnings[0].english();
    }
    const Result<DbcFile> file = parsed("VERSION \"1\n" + signals);
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->messages.at(0).payload.size(), 3U);
    ASSERT_EQ(file->warnings.size(), 1U);
    EXPECT_TRUE(
        file->warnings[0].english().starts_with("f.dbc: line 1: expected a quotation mark"));
}

TEST(DbcScanner, readsRawValuesWithAllTheirDigits)
{
    const auto raw = [](std::string_view text) {
        DbcScanner scan(text);
        const std::optional<DbcRaw> read = scan.raw(TR_NOOP("core", "a raw value"));
        EXPECT_TRUE(scan.failure().empty() && scan.atEnd()) << text;
        return read;
    };
    const DbcRaw highest = ~std::uint64_t{0};
    EXPECT_TRUE(raw("18446744073709551615") == highest && raw("+18446744073709551615") == highest);
    EXPECT_TRUE(raw("-9223372036854775808") == -(highest / 2) - 1);
    EXPECT_TRUE(raw("2.0") == DbcRaw{2} && raw("1E3") == DbcRaw{1000});
    for (const char* const lost : {"18446744073709551616", "1.8446744073709552E+19", "-1e16"})
        EXPECT_FALSE(raw(lost)) << lost;
    DbcScanner none("zero");
    EXPECT_TRUE(none.raw(TR_NOOP("core", "a raw value")));
    EXPECT_FALSE(none.failure().empty());
}

TEST(DbcTexts, commentsMayHaveSeveralLines)
{
    const DbcMessage m = onlyMessage("BO_ 256 M: 8 A\n"
                                     "CM_ BO_ 256 \"First;\nBO_ 7 is another one,\n"
                                     "as VAL_ says\" ;\n");
    EXPECT_EQ(m.comment, "First;\nBO_ 7 is another one,\nas VAL_ says");
}

TEST(DbcTexts, anEscapedQuoteOutsideATextBeginsNone)
{
    const Result<DbcFile> file =
        parsed("BO_ 256 M: 8 A\nFUTURE_ \\\"\nBO_ 257 N: 8 A\nCM_ BO_ 257 \"n\";\n");
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_TRUE(file->warnings.empty());
    ASSERT_EQ(file->messages.size(), 2U);
    EXPECT_EQ(file->messages[1].comment, "n");
}

}  // namespace
}  // namespace terratact
