// Logs of CAN traffic in every readable format: their clocks, packing, truncated ends and refusals.
#include "core/wire/logs/log_reader.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "core/wire/logs/candump_log.h"
#include "tests/core/wire/logs.h"
#include "tests/support/refusal.h"

namespace terratact {
namespace {

std::string packed(const std::string& text)
{
    z_stream stream{};
    EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
    std::string out(deflateBound(&stream, text.size()), '\0');
    std::string in = text;
    stream.next_in = reinterpret_cast<Bytef*>(in.data());
    stream.avail_in = static_cast<uInt>(in.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

TEST(Logs, ofCandumpMayHaveCommentsAMarkAndDates)
{
    const std::vector<std::string> logs{kTwo, "# boat, second day\n\n  # more\n" + kTwo,
                                        "\xEF\xBB\xBF" + kTwo, "\xEF\xBB\xBF# mark\r\n" + kTwo};
    for (const std::string& text : logs) {
        const Log log = read(text);
        EXPECT_EQ(log.error, "");
        EXPECT_TRUE(log.remarks.empty());
        ASSERT_EQ(log.frames.size(), 2U) << text;
        EXPECT_EQ(log.frames[1].frame, data(0x500, {0xDD, 0xFF, 2}));
        EXPECT_EQ(log.format, "candump");
    }
    const Log dated = read(" (2025-01-10 12:34:56.250000)  can0  500   [1]  DD\n"
                           " (2025-01-10 12:34:57.500000)  can0  500   [1]  DE\n");
    ASSERT_EQ(dated.frames.size(), 2U) << dated.error;
    EXPECT_NEAR(dated.elapsed[1], 1.25, 1e-6);
    EXPECT_NEAR(*dated.frames[0].time, 1736512496.25, 86400.0) << "in whichever time zone";
}

TEST(Logs, mayBeUtf16)
{
    for (const bool lowFirst : {true, false}) {
        std::string wide = lowFirst ? "\xFF\xFE" : "\xFE\xFF";
        for (const char c : "# caf" + kTwo.substr(0, 0) + "e\n" + kTwo) {
            if (!lowFirst) wide += '\0';
            wide += c;
            if (lowFirst) wide += '\0';
        }
        EXPECT_EQ(read(wide).frames.size(), 2U) << read(wide).error;
    }
}

TEST(Logs, ofUtf32AreRefused)
{
    std::string wide("\xFF\xFE\0\0", 4);
    for (const char c : kTwo) wide += {c, '\0', '\0', '\0'};
    EXPECT_NE(read(wide).error.find("is text in UTF-32: save it in UTF-8"), std::string::npos)
        << read(wide).error;
}

TEST(Logs, ofEndlessZerosAreRefused)
{
    const auto zeros = [](std::span<char> room) -> Result<std::size_t> {
        std::fill(room.begin(), room.end(), '\0');
        return room.size();
    };
    LogReader log("zero", LogBytes::Source(zeros));
    const auto next = log.next();
    ASSERT_FALSE(next);
    EXPECT_NE(next.error().message.english().find("this is no log of CAN frames"),
              std::string::npos);
}

TEST(Logs, zeroBytesWithinLoseOnlyWhatTheyCut)
{
    for (const std::size_t count : {1U, 500U, 4096U, 200'000U}) {
        const std::string zeros(count, '\0'), third = "(1000.300000) can0 501#AA\n";
        Log log = read(kTwo + "(1000.200000) can0 50" + zeros + third);
        EXPECT_EQ(log.error, "");
        ASSERT_EQ(log.frames.size(), 3U) << count;
        EXPECT_EQ(log.frames[2].frame, data(0x501, {0xAA}));
        ASSERT_EQ(log.remarks.size(), 1U);
        EXPECT_EQ(log.remarks[0], "a.log: line 3: zero bytes, as after a power loss, are left out, "
                                  "and the text that they cut");
        log = read(kTwo + zeros + third + third);
        EXPECT_EQ(log.frames.size(), 4U) << log.error;
        ASSERT_EQ(log.remarks.size(), 1U);
        EXPECT_TRUE(log.remarks[0].ends_with("are left out")) << log.remarks[0];
        log = read(kTwo + "(1000.2000" + zeros);
        EXPECT_EQ(log.frames.size(), 2U) << log.error;
        EXPECT_TRUE(log.isTorn);
    }
    std::string many = kTwo;
    for (int i = 0; i < 5000; ++i) many += std::string("a\0", 2);
    const Log log = read(many + "\n" + kTwo);
    EXPECT_EQ(log.frames.size(), 4U) << log.error;
    EXPECT_LE(log.remarks.size(), 101U) << "100 of them, and the clock set back";
}

TEST(Logs, aWrongLineIsRefusedWithWhatToDo)
{
    const Log log = read(kTwo + "(1000.200000) can0 5Ä0#00\n" + kTwo);
    EXPECT_EQ(log.frames.size(), 2U);
    EXPECT_EQ(log.error,
              "a.log: line 3: expected an identifier of 3 or 8 hexadecimal digits, found "
              "'5Ä0': correct or delete the line");
    EXPECT_EQ(read(";$FILEVERSION=3.0\n").error,
              "a.log: line 1: is of version '3.0' of the format: export it as version 1.0 to 2.1");
}

TEST(Logs, mayHaveDecimalCommasOfADesktop)
{
    std::string asc = kAsc;
    for (const std::string_view time : {"0.1000", "0.2000", "0.3000"})
        asc[asc.find(time) + 1] = ',';
    EXPECT_EQ(read(asc).elapsed, read(kAsc).elapsed) << read(asc).error;
    const Log gvret = read("Time Stamp;ID;Extended;Dir;Bus;LEN;D1\n"
                           "166,5;500;false;Rx;0;1;DD\n167,25;500;false;Rx;0;1;DE\n");
    ASSERT_EQ(gvret.frames.size(), 2U) << gvret.error;
    EXPECT_NEAR(gvret.elapsed[1], 0.75, 1e-9);
    EXPECT_NE(read("Time Stamp;ID;Extended;Dir;Bus;LEN;D1\n1.166,5;500;false;Rx;0;1;DD\n")
                  .error.find("expected a time"),
              std::string::npos)
        << "a mark between thousands";
}

TEST(Logs, mayBePackedByGzip)
{
    std::string many;
    for (int i = 0; i < 20'000; ++i)
        many += candumpLine(1000.0 + 1e-3 * i, "can0",
                            data(static_cast<std::uint32_t>(i) % 2000, {1, 2}))
              + "\n";
    Log log = read(packed(many));
    EXPECT_EQ(log.frames.size(), 20'000U) << log.error;
    EXPECT_EQ(log.format, "candump, packed by gzip");
    EXPECT_TRUE(log.remarks.empty());
    EXPECT_EQ(read(packed(kTwo) + packed(many)).frames.size(), 20'002U) << "two pieces";
    const std::string whole = packed(many);
    log = read(whole.substr(0, whole.size() / 2));
    EXPECT_EQ(log.error, "");
    EXPECT_TRUE(log.isTorn);
    EXPECT_GT(log.frames.size(), 5'000U);
    ASSERT_EQ(log.remarks.size(), 1U);
    EXPECT_NE(log.remarks[0].find("torn"), std::string::npos) << log.remarks[0];
    std::string damaged = whole;
    for (std::size_t i = whole.size() / 2; i < whole.size() / 2 + 40; ++i) damaged[i] ^= 0x55;
    EXPECT_NE(read(damaged).error.find("a.log: "), std::string::npos);
}

TEST(Logs, withATornEndGiveTheWholeLines)
{
    for (const std::string& end :
         {std::string("(1000.2) can0 5"), std::string("(1000.2) can0 500#D"), std::string("(10"),
          std::string("(1000.2) can0 500#D") + std::string(100, '\0'),
          std::string("(1000.2) can0 500#D") + std::string(100'000, '\0'),
          std::string(5'000, '\0')}) {
        const Log log = read(kTwo + end);
        EXPECT_EQ(log.error, "");
        EXPECT_EQ(log.frames.size(), 2U);
        EXPECT_TRUE(log.isTorn);
        ASSERT_EQ(log.remarks.size(), 1U) << end.size();
        EXPECT_TRUE(log.remarks[0].starts_with("a.log: line 3: is torn")) << log.remarks[0];
    }
    const Log whole = read(kTwo.substr(0, kTwo.size() - 1));
    EXPECT_EQ(whole.frames.size(), 2U) << "a line is whole without its end";
    EXPECT_FALSE(whole.isTorn);
    ASSERT_EQ(whole.remarks.size(), 1U);
    EXPECT_NE(whole.remarks[0].find("line 2: has no line end"), std::string::npos);
    EXPECT_NE(read(kTwo + "(1000.2) can0 5\n" + kTwo).error.find("line 3"), std::string::npos)
        << "not at the end";
}

TEST(Logs, asCsvTornWithinAByteGiveTheWholeLines)
{
    const std::string whole =
        "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2\n1000000,500,false,Rx,0,2,A,0F\n";
    const Log log = read(whole + "1000100,500,false,Rx,0,2,DD,F");
    EXPECT_EQ(log.frames.size(), 1U) << log.error;
    EXPECT_TRUE(log.isTorn);
    EXPECT_FALSE(read(whole.substr(0, whole.size() - 1)).isTorn);
    EXPECT_FALSE(read(whole + "1000100,500,false,Rx,0,0").isTorn) << "no byte is missing";
}

TEST(Logs, withAClockStepBackContinueEvenly)
{
    const Log log = read("(100000.00) can0 500#00\n(100000.05) can0 500#01\n"
                         "(96400.20) can0 500#02\n(96400.25) can0 500#03\n"
                         "(96400.30) can1 500#04\n(96400.29) can0 500#05\n(96400.35) can0 500#06\n"
                         "(96400.3495) can0 500#07\n");
    const std::vector<double> expected{0.0, 0.05, 0.05, 0.10, 0.15, 0.15, 0.20, 0.20};
    ASSERT_EQ(log.elapsed.size(), expected.size()) << log.error;
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(log.elapsed[i], expected[i], 1e-9) << i;
    ASSERT_EQ(log.remarks.size(), 1U) << "frames may be slightly out of order";
    EXPECT_EQ(log.remarks[0],
              "a.log: line 3: 3599.85 s earlier than the line before: was the clock "
              "set, or is this a log of candump -td?");
}

TEST(Logs, keepMicrosecondsOfTimesSince1970)
{
    std::string text;
    std::vector<int> expected;  // [us]
    for (int i = 0; i < 200; ++i) {
        expected.push_back(i * 1'234'567 + (i < 100 ? 0 : -1'234'567));
        const int micro = 223'456 + i * 1'234'567;
        text += fmt::format("({}.{:06}) can0 500#\n",
                            (i < 100 ? 1'700'000'000 : 1'690'000'000) + micro / 1'000'000,
                            micro % 1'000'000);
    }
    const Log log = read(text);
    ASSERT_EQ(log.elapsed.size(), expected.size()) << log.error;
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(std::llround(log.elapsed[i] * 1e9), expected[i] * 1'000LL) << i;
}

TEST(Logs, writeStepsOfTheClockAlike)
{
    for (const auto& [first, second, said] :
         {std::tuple{"1700000000.0", "1068848000.0", "631152000 s earlier"},
          {"1068848000.0", "1700000000.0", "631152000 s later"},
          {"1700000000.0", "1699999999.57", "0.43 s earlier"}}) {
        const Log log = read(fmt::format("({}) can0 500#\n({}) can0 500#\n", first, second));
        ASSERT_EQ(log.remarks.size(), 1U) << log.error;
        EXPECT_NE(log.remarks[0].find(std::string("line 2: ") + said), std::string::npos)
            << log.remarks[0];
    }
}

TEST(Logs, reportFrequentClockStepsBriefly)
{
    std::string text;
    for (int i = 0; i < 50; ++i) text += i % 2 == 0 ? "(5.0) can0 500#\n" : "(4.0) can0 500#\n";
    const Log log = read(text);
    EXPECT_EQ(log.frames.size(), 50U);
    ASSERT_EQ(log.remarks.size(), LogReader::kMaxSteps + 1);
    EXPECT_EQ(log.remarks.back(), "a.log: the clock is set 20 more times");
    for (const double elapsed : log.elapsed) EXPECT_GE(elapsed, 0.0);
}

TEST(Logs, ofTimeDifferencesAreGuessed)
{
    std::string text = " (000.000000)  can0  500   [1]  00\n";
    for (int i = 0; i < 12; ++i) text += " (000.050000)  can0  500   [1]  00\n";
    const Log log = read(text);
    ASSERT_EQ(log.remarks.size(), 1U);
    EXPECT_NE(log.remarks[0].find("candump -td"), std::string::npos) << log.remarks[0];
    std::string zero;
    for (int i = 0; i < 12; ++i)
        zero += " (000.0" + std::to_string(10 + i) + "000)  can0  500   [1]  00\n";
    EXPECT_TRUE(read(zero).remarks.empty()) << "candump -tz";
}

TEST(Logs, nameTheLineAtFaultInEveryFormat)
{
    const auto says = [](const std::string& text, const std::vector<std::string>& parts) {
        const std::string error = read(text).error;
        for (const std::string& part : parts)
            EXPECT_NE(error.find(part), std::string::npos) << part << " not in " << error;
    };
    says("base hex\n0.1 1 500 Rx d 3 DD FF 1\n", {"a.log: line 2", "two hexadecimal", "'1'"});
    says("base hex\n0.1 1 500 Rx d 3 DD FF\n", {"line 2", "the end of the line"});
    says("base hex\n0.1 1 800 Rx d 0\n", {"line 2", "up to 7FF"});
    says("base hex\n0.1 1 Name Rx d 0\n", {"line 2", "up to 7FF", "'Name'"});
    says("base hex\n0.1 CANFD 1 Rx 500 1 0 9 11 00\n", {"line 2", "CAN FD can have"});
    says(";$FILEVERSION=3.0\n", {"line 1", "version 1.0 to 2.1", "'3.0'"});
    says("1) 100 0500 9 00\n", {"line 1", "at most 8 bytes"});
    says("1) x 0500 1 00\n", {"line 1", "a time"});
    says(";$COLUMNS=N,O,T,I,d,L,D\n1 1.0 DT 0500 Ax 1 00\n", {"line 2", "Rx or Tx", "'Ax'"});
    says("Time Stamp,ID,Extended,Bus,LEN,D1\n1,500,maybe,0,1,00\n", {"line 2", "true or false"});
    says("Time Stamp,ID,Extended,Bus,LEN,D1\n1,500,false,0,2,00\n", {"line 2", "a byte of two"});
    says("Time Stamp,ID,Extended,Bus,LEN,D1\n-1,500,false,0,1,00\n", {"line 2", "a time"});
    says("Time Stamp,ID,Extended,Bus,LEN,D1\n1,500,false,0,1,00\n"
         "Time Stamp,ID,Extended,Bus,LEN,D1\n1,500,false,0,1,00\n",
         {"line 3: repeats the header: a second table begins here"});
}

TEST(Logs, ofOtherKindsAreNamedWithTheirConverter)
{
    using namespace std::string_literals;
    const std::vector<std::pair<std::string, std::string>> kinds{
        {"LOGG\x90\0\0\0"s, "(.blf)"},
        {"MDF     4.10"s, "(.mf4"},
        {"\x89MCAP0\r\n"s, "MCAP"},
        {"SQLite format 3\0"s, "session export"},
        {"\x0A\x0D\x0D\x0A"s, ".pcapng"},
        {"PK\x03\x04"s, "ZIP"},
        {"%PDF-1.4\n%\xE2\xE3\n"s, "a PDF"},
        {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"s, "a workbook"},
        {"\x89PNG\r\n\x1A\n"s, "no text"},
        {"\x7F"
         "ELF\x02\0\0"s,
         "no text"},
        {"t12380011223344556677\n"s, "slcan"},
        {"T1FFFFFFF1AA12CD\n"s, "candump -l"},
        {"r1230\n"s, "slcan"},
        {"\xFD"
         "7zXZ\0"s,
         "xz -d"},
        {"#ROSBAG V2.0\n"s, "ROS"},
        {"a.log"s + std::string(252, '\0') + "ustar"s, "tar -xf"},
        {"***BUSMASTER Ver 3.2.2***\n"s, "BusMaster"},
        {"1542473901.020305 1R11 213 01 02\n"s, "CRTD"},
        {"2016-04-09T16:41:09.078Z,3,127257,17,255,8,00,ff\n"s, "canboat"},
        {"//---\nMicrochip Technology Inc.\n"s, "Microchip"},
        {"VERSION \"\"\n"s, "--dbc"}};
    for (const auto& [begin, part] : kinds) {
        const Log log = read(begin + "more and more\n");
        EXPECT_TRUE(log.error.starts_with("a.log: is ")) << log.error;
        EXPECT_NE(log.error.find(part), std::string::npos) << log.error;
    }
}

TEST(Logs, surviveAnyBytesInEveryFormat)
{
    std::mt19937 random(5);
    const std::vector<std::string> seeds{
        kTwo,
        kAsc,
        packed(kTwo),
        ";$FILEVERSION=2.1\n;$STARTTIME=44548.6\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n"
        "1 100.000 DT 1 0500 Rx - 3 DD FF 01\n2 200.0 FD 1 18FEF1FE Tx - 9 AA BB\n",
        "     1)     100.0  Rx     0500  3  DD FF 01 \n",
        "Time Stamp,ID,Extended,Dir,Bus,LEN,D1\n1000000,00000500,false,Rx,0,3,DD,FF,01,\n",
        "timestamp,arbitration_id,extended,remote,error,dlc,data\n1.0,0x500,0,0,0,3,3f8B\n"};
    std::size_t accepted = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string text = seeds[random() % seeds.size()];
        for (auto n = 1 + random() % 4; n > 0 && !text.empty(); --n) {
            const std::size_t at = random() % text.size();
            switch (random() % 3) {
            case 0: text.erase(at, 1); break;
            case 1: text.insert(at, 1, "0x9F,;. \n\0-"[random() % 11]); break;
            default: text[at] = static_cast<char>(random());
            }
        }
        for (const LoggedFrame& logged : read(text).frames) {
            ASSERT_TRUE(!logged.time || (*logged.time >= 0.0 && *logged.time < 1e10)) << text;
            const double time = logged.time.value_or(0.0);
            const std::string line = candumpLine(time, logged.interface, logged.frame);
            ASSERT_EQ(frameFromCandump(line)->frame, logged.frame) << line;
            ++accepted;
        }
    }
    EXPECT_GT(accepted, 5'000U);
}

TEST(Logs, areTornIfTheLastLineHasNoFrame)
{
    const Log log = read("base hex\n0.1 1 500 Rx d 1 DD\n0.2 1  12");
    EXPECT_EQ(log.frames.size(), 1U);
    EXPECT_TRUE(log.isTorn);
    EXPECT_FALSE(read("base hex\n0.1 1 500 Rx d 1 DD\nEnd TriggerBlock").isTorn);
}

TEST(Logs, mayBeUtf16WithoutAMark)
{
    const std::string text = "(1.0) can0 123#00\n(1.1) can0 123#01\n";
    std::string low, high;
    for (const char c : text) {
        low += std::string{c, '\0'};
        high += std::string{'\0', c};
    }
    EXPECT_EQ(read(low).frames.size(), 2U) << read(low).error;
    EXPECT_EQ(read(high).frames.size(), 2U) << read(high).error;
}

TEST(Logs, mayEndTheirLinesWithCrAlone)
{
    const Log log = read("(1.0) can0 123#00\r(1.1) can0 123#01\r(1.2) can0 123#02\r");
    EXPECT_EQ(log.frames.size(), 3U) << log.error;
    EXPECT_TRUE(log.remarks.empty());
    std::string longer;
    for (int i = 0; i < 200; ++i) longer += "(1.0) can0 123#00\r";
    EXPECT_EQ(read(longer).frames.size(), 200U) << read(longer).error;
}

TEST(Logs, reportOtherBytesBehindPackedOnes)
{
    const std::string once = packed("(1.0) can0 123#00\n");
    EXPECT_NE(read(packed(once)).error.find("twice"), std::string::npos);
    const Log followed = read(once + "garbage");
    EXPECT_EQ(followed.frames.size(), 1U);
    ASSERT_EQ(followed.remarks.size(), 1U);
    EXPECT_NE(followed.remarks[0].find("left out"), std::string::npos);
    EXPECT_TRUE(read(once + std::string(512, '\0')).remarks.empty());
    const Log torn = read(once.substr(0, 10));
    ASSERT_EQ(torn.remarks.size(), 1U);
    EXPECT_EQ(torn.remarks[0], "a.log: the packed log is torn before its first line");
}

TEST(Logs, ofFewBytesThatUnpackToVeryManyAreRefused)
{
    // Lines of 512 bytes: with sanitizers, each line takes time, and their number is not what is tested.
    std::string spaces(std::size_t{8} << 20, ' ');
    for (std::size_t end = 511; end < spaces.size(); end += 512) spaces[end] = '\n';
    const std::string piece = packed(spaces);
    std::string bomb = packed(kTwo);
    for (int i = 0; i < 9; ++i) bomb += piece;  // 72 MB
    EXPECT_NE(read(bomb).error.find("more than 200 times its size"), std::string::npos)
        << read(bomb).error;
    EXPECT_EQ(read(packed(kTwo) + piece).frames.size(), 2U) << "8 MB are read in no time";
}

TEST(Logs, withAClockStepOfYearsContinueEvenly)
{
    const Log log = read("(0.5) can0 123#00\n(1790000000.5) can0 123#01\n"
                         "(1790000001.0) can0 123#02\n");
    ASSERT_EQ(log.frames.size(), 3U) << log.error;
    EXPECT_EQ(log.elapsed[1], 0.0);
    EXPECT_NEAR(log.elapsed[2], 0.5, 1e-6);
    ASSERT_EQ(log.remarks.size(), 1U);
    EXPECT_NE(log.remarks[0].find("line 2: 1790000000 s later"), std::string::npos)
        << log.remarks[0];
}

}  // namespace
}  // namespace terratact
