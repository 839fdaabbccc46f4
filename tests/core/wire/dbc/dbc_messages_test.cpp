// Tests the bounds of messages and warnings of DBC files.
#include "core/wire/dbc/dbc_messages.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

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
    std::string text = "BO_ 256 M: 8 A\n";
    for (std::size_t i = 0; i < DbcMessage::kMaxSignals + 2; ++i)
        text += " SG_ S" + std::to_string(i) + " : 0|8@1+ (1,0) [0|0] \"\" B\n";
    const Result<DbcFile> file = parsed(text + "BO_ 257 N: 8 A\n");
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->messages.size(), 2U);
    EXPECT_EQ(file->messages[0].payload.size(), DbcMessage::kMaxSignals);
    ASSERT_EQ(file->warnings.size(), 2U);
    EXPECT_EQ(file->warnings[0].english(), "f.dbc: line 4098: the signal S4096 is left out: its "
                                           "message M has more than 4096 signals");
    EXPECT_TRUE(file->warnings[1].english().starts_with("f.dbc: line 4099: the signal S4097"));
}

}  // namespace
}  // namespace terratact
