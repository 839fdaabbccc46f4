// Tests exports to candump and ASC logs.
#include <gtest/gtest.h>

#include "tests/support/sessions/session_files.h"

namespace terratact {
namespace {

TEST_F(SessionFiles, logsHaveEveryFrameTheirFormatSupports)
{
    const std::string path = session("kinds.tts", [](SessionWriter& writer) {
        const auto add = [&](CanFrame frame, bool sent) {
            ASSERT_TRUE(writer.add(FrameRow{.time = 1'500'000, .frame = frame, .sent = sent}));
        };
        add({.id = 0x123, .length = 2, .data = {0x01, 0xAB}}, true);
        add({.id = 0x12345678, .extended = true, .length = 0}, false);
        add({.id = 0x123, .remote = true, .length = 4}, false);
        add({.id = 0x4, .error = true, .length = 8}, false);
        add({.id = 0x123, .fd = true, .length = 3, .data = {1, 2, 3}}, false);
        add({.id = 0x123, .fd = true, .length = 12, .data = {1, 2, 3, 4, 5, 6, 7, 8, 9}}, false);
        add({.id = 0x123, .fd = true, .length = 64, .isCut = true}, false);
    });
    EXPECT_EQ(exported(path, "a.log"), "(1793000000.001500) can0 123#01AB\n"
                                       "(1793000000.001500) can0 12345678#\n"
                                       "(1793000000.001500) can0 123#R4\n"
                                       "(1793000000.001500) can0 20000004#0000000000000000\n"
                                       "(1793000000.001500) can0 123##0010203\n"
                                       "(1793000000.001500) can0 "
                                       "123##0010203040506070809000000\n");
    EXPECT_EQ(counts.leftOut, 1U);
    const std::string asc = exported(path, "a.asc");
    EXPECT_EQ(
        asc.substr(asc.find("logged\n") + 7),
        "   0.001500 1  123             Tx   d 2 01 AB\n"
        "   0.001500 1  12345678x       Rx   d 0\n"
        "   0.001500 1  123             Rx   r 4\n"
        "   0.001500 1  ErrorFrame\n"
        "   0.001500 CANFD   1 Rx        123                                   1 0 3  3 01 02 "
        "03        0    0     3000        0        0        0        0        0\n"
        "   0.001500 CANFD   1 Rx        123                                   1 0 9 12 01 02 "
        "03 04 05 06 07 08 09 00 00 00        0    0     3000        0        0        0      "
        "  0        0\n");
    EXPECT_EQ(counts.leftOut, 1U) << "bytes that are not known have no line";
}

TEST_F(SessionFiles, framesBeforeTimeZeroAreInEveryLog)
{
    const std::string path = session("early.tts", [](SessionWriter& writer) {
        for (const SessionTime time : {-200'000'000, 300'000'000})
            ASSERT_TRUE(writer.add(FrameRow{.time = time, .frame = {.id = 1, .length = 0}}));
    });
    EXPECT_EQ(exported(path, "a.log"), "(1792999999.800000) can0 001#\n"
                                       "(1793000000.300000) can0 001#\n");
    const std::string asc = exported(path, "a.asc");
    EXPECT_NE(asc.find(":19 2026\n"), std::string::npos) << asc;
    EXPECT_NE(asc.find("   0.800000 1  1 "), std::string::npos) << asc;
    EXPECT_NE(asc.find("   1.300000 1  1 "), std::string::npos) << asc;
}

}  // namespace
}  // namespace terratact
