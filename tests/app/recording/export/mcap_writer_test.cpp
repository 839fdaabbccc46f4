// Tests JSON texts and check sums of MCAP files.
#include "app/recording/export/mcap_writer.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

TEST(Json, keepsUtf8AndReplacesInvalidBytes)
{
    EXPECT_EQ(jsonText("±0.5 m → \xF0\x9F\xA4\x96"), "\"±0.5 m → \xF0\x9F\xA4\x96\"");
    for (const char* wrong : {"\x80", "\xC0\xAF", "\xE2\x82", "\xED\xA0\x80", "\xF5\x80\x80\x80"})
        EXPECT_EQ(jsonText(wrong).find_first_not_of("\"\xEF\xBF\xBD"), std::string::npos) << wrong;
    EXPECT_EQ(crc32("123456789"), 0xCBF43926U) << "the check value of CRC-32";
}

}  // namespace
}  // namespace terratact
