// Logs of CAN traffic in every readable format: their frames, clocks and truncated ends.
#include "core/wire/log_reader.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/wire/candump_log.h"
#include "tests/support/refusal.h"

namespace terratact {
namespace {

using Bytes = std::vector<std::uint8_t>;

CanFrame data(std::uint32_t id, const Bytes& bytes, bool extended = false)
{
    CanFrame frame{.id = id,
                   .extended = extended,
                   .fd = bytes.size() > 8,
                   .length = static_cast<std::uint8_t>(bytes.size())};
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    return frame;
}

struct Log {
    std::vector<LoggedFrame> frames;
    std::vector<double> elapsed;
    std::vector<std::string> remarks;
    std::string format, error;
    bool isTorn = false;
};

Log read(const std::string& content)
{
    LogReader reader("a.log", std::make_unique<std::istringstream>(content));
    Log log;
    for (;;) {
        const auto next = reader.next();
        for (const Message& remark : reader.consumeRemarks())
            log.remarks.push_back(remark.english());
        if (!next) log.error = next.error().text;
        if (!next || !*next) break;
        log.frames.push_back(**next);
        log.elapsed.push_back(reader.elapsed());
    }
    log.format = reader.format();
    log.isTorn = reader.isTorn();
    return log;
}

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

const std::string kTwo = "(1000.000000) can0 500#DDFF01\n(1000.100000) can0 500#DDFF02\n";

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

TEST(Logs, whoseClockGoesBackGoOnEvenly)
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

const std::string kAsc =
    "date Thu Jan 01 00:16:40 1970\n"
    "base hex  timestamps absolute\n"
    "no internal events logged\n"
    "// version 9.0.0\n"
    "Begin Triggerblock Thu Jan 01 00:16:40 1970\n"
    "   0.000000 Start of measurement\n"
    "   0.015991 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.00%\n"
    "   0.100000 1  500             Rx   d 3 DD FF 01  Length = 0 BitCount = 0\n"
    "   0.200000 2  18FEF1FEx       Tx   d 8 01 02 03 04 05 06 07 08\n"
    "   0.300000 1  123             Rx   r Length = 1704000 BitCount = 145\n"
    "   0.310000 1  123             Rx   r 4 Length = 1704000 BitCount = 145\n"
    "   0.320000 1  123             TxRq d 1 00\n"
    "   0.400000 2  ErrorFrame\n"
    "   0.500000 CANFD   1 Rx        50B                                   1 0 a "
    "16 00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F   130000  130     3000 0\n"
    "   0.600000 CANFD   2 Tx   18FEF1FEx  Name_of_it   0 0 2  2 AA BB  0 0 3000 0\n"
    "   0.700000 CANFD   2 Tx        7FF  0 0 2  2 AA BB  0 0 0 0\n"
    "End TriggerBlock\n";

TEST(Logs, ofVectorAreRead)
{
    const Log log = read(kAsc);
    EXPECT_EQ(log.error, "");
    EXPECT_EQ(log.format, "Vector .asc");
    ASSERT_EQ(log.frames.size(), 8U);
    const auto& f = log.frames;
    EXPECT_EQ(f[0].frame, data(0x500, {0xDD, 0xFF, 1}));
    EXPECT_EQ(f[0].interface, "can0");
    EXPECT_EQ(f[0].direction, LogDirection::Received);
    EXPECT_NEAR(std::fmod(*f[0].time, 1.0), 0.1, 1e-6);
    EXPECT_EQ(f[1].frame, data(0x18FEF1FE, {1, 2, 3, 4, 5, 6, 7, 8}, true));
    EXPECT_EQ(f[1].interface, "can1");
    EXPECT_EQ(f[1].direction, LogDirection::Sent);
    EXPECT_EQ(f[2].frame, (CanFrame{.id = 0x123, .remote = true}));
    EXPECT_EQ(f[3].frame, (CanFrame{.id = 0x123, .remote = true, .length = 4}));
    EXPECT_TRUE(f[4].frame.error);
    EXPECT_EQ(f[5].frame, data(0x50B, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}));
    CanFrame named = data(0x18FEF1FE, {0xAA, 0xBB}, true);
    named.fd = true;
    EXPECT_EQ(f[6].frame, named);
    EXPECT_EQ(f[7].frame, data(0x7FF, {0xAA, 0xBB})) << "a classic frame, as its flags say";
    EXPECT_NEAR(log.elapsed.back(), 0.6, 1e-6);
    ASSERT_EQ(log.remarks.size(), 1U);
    EXPECT_EQ(log.remarks[0],
              "a.log: 2 lines hold no frame and are passed over, the first is line 7");
}

TEST(Logs, ofVectorMayCountOtherwise)
{
    const Log log = read("date Mit Okt 5 03:06:13.500 pm 2022\n"
                         "base dec  timestamps relative\n"
                         "0.1 1 1280 Rx d 2 221 255\n"
                         "0.2 1 218x Rx d 1 9\n"
                         "0.3 CAN 1 Status:chip status error active\n"
                         "0.1 1 1 Rx d 0\n");
    ASSERT_EQ(log.frames.size(), 3U) << log.error;
    EXPECT_EQ(log.frames[0].frame, data(1280, {221, 255}));
    EXPECT_EQ(log.frames[1].frame, data(218, {9}, true));
    EXPECT_NEAR(*log.frames[0].time - 0.1, 1664982373.5, 86400.0);
    EXPECT_NEAR(log.elapsed[2], 0.6, 1e-6) << "an event's time counts, too";
    const Log trigger = read("date Mit Okt 5 03:06:13.500 pm 2022\nbase hex  timestamps absolute\n"
                             "Begin TriggerBlock Wed Oct 5 04:06:13.500 pm 2022\n"
                             "30.5 CANFD 3 Tx 50005x 0 1 5 0 140000 73 200050 7a60 46500250\n");
    ASSERT_EQ(trigger.frames.size(), 1U) << trigger.error;
    EXPECT_EQ(trigger.frames[0].frame,
              (CanFrame{.id = 0x50005, .extended = true, .remote = true, .length = 5}));
    EXPECT_NEAR(*trigger.frames[0].time - *log.frames[0].time, 3600.0 + 30.4, 1e-6);
    const Log bare = read("0.1 1 500 Rx d 1 09\n");
    ASSERT_EQ(bare.frames.size(), 1U) << bare.error;
    EXPECT_EQ(bare.frames[0].time, 0.1) << "without a heading";
    EXPECT_NE(read("date soon\n0.1 1 500 Rx d 1 09\n").remarks.at(0).find("line 1: the date"),
              std::string::npos);
}

TEST(Logs, ofPeakAreRead)
{
    const std::vector<std::string> logs{
        ";   Start time: 18.12.2021 14:28:07.062\n;---+--   ----+----  --+--  ----+---\n"
        "     1)     100  0500  3  DD FF 01 \n"
        "     2)     200  18FEF1FE  2  AA BB \n"
        "     3)     300  0123  4  RTR\n"
        "     4)     400  FFFFFFFF  4  00 00 00 08  BUSHEAVY\n",
        ";$FILEVERSION=1.1\n;$STARTTIME=44548.6028595139\n"
        "     1)     100.0  Rx     0500  3  DD FF 01 \n"
        "     2)     200.0  Tx     18FEF1FE  2  AA BB \n"
        "     3)     300.0  Rx     0123  4  RTR\n"
        "     4)     400.0  Warng  FFFFFFFF  4  00 00 00 08  BUSHEAVY\n",
        ";$FILEVERSION=1.3\n;$STARTTIME=44548.6028595139\n"
        "     1)     100.000 1  Rx     0500 -  3    DD FF 01 \n"
        "     2)     200.000 1  Tx     18FEF1FE -  2    AA BB \n"
        "     3)     300.000 1  Rx     0123 -  4    RTR\n"
        "     4)     400.000 1  Error  0008 -  4    00 00 00 08 \n",
        ";$FILEVERSION=2.0\n;$STARTTIME=44548.6028595139\n;$COLUMNS=N,O,T,I,d,l,D\n"
        "      1     100.000 DT     0500 Rx 3  DD FF 01 \n"
        "      2     200.000 DT 18FEF1FE Tx 2  AA BB \n"
        "      3     300.000 RR     0123 Rx 4  \n"
        "      4     400.000 ST          Rx    00 00 00 08 \n",
        ";$FILEVERSION=2.1\r\n;$STARTTIME=44548.6028595139\r\n;$COLUMNS=N,O,T,B,I,d,R,L,D\r\n"
        "      1     100.000 DT 1      0500 Rx -  3    DD FF 01 \r\n"
        "      2     200.000 DT 1  18FEF1FE Tx -  2    AA BB \r\n"
        "      3     300.000 RR 1      0123 Rx -  4    \r\n"
        "      4     400.000 ST 1       -   Rx -  4    00 00 00 08 \r\n"};
    for (const std::string& text : logs) {
        const Log log = read(text);
        EXPECT_EQ(log.error, "") << text;
        EXPECT_EQ(log.format, "PEAK .trc");
        ASSERT_EQ(log.frames.size(), 3U) << text;
        EXPECT_EQ(log.frames[0].frame, data(0x500, {0xDD, 0xFF, 1}));
        EXPECT_EQ(log.frames[0].interface, "can0");
        EXPECT_EQ(log.frames[1].frame, data(0x18FEF1FE, {0xAA, 0xBB}, true));
        EXPECT_EQ(log.frames[2].frame, (CanFrame{.id = 0x123, .remote = true, .length = 4}));
        EXPECT_NEAR(log.elapsed[2], 0.2, 1e-6);
        EXPECT_NEAR(*log.frames[0].time, 1639837687.162, 1e-3);
        ASSERT_EQ(log.remarks.size(), 1U);
        EXPECT_NE(log.remarks[0].find("holds no frame and is passed over"), std::string::npos);
    }
}

TEST(Logs, ofPeakVersion10StartAtTheirComment)
{
    const auto startOf = [](const std::string& start) {
        return read(";##\n;   Start time: " + start + "\n;##\n     1)  100  0500  3  DD FF 01 \n");
    };
    Log log = startOf("24.09.2008 16:00:35.472.0");
    ASSERT_EQ(log.frames.size(), 1U) << log.error;
    EXPECT_NEAR(*log.frames[0].time, 1222272035.572, 1e-3);
    EXPECT_TRUE(log.remarks.empty());
    log = startOf("9/24/2008 4:00:35 PM");  // the order of day and month is ambiguous
    ASSERT_EQ(log.frames.size(), 1U) << log.error;
    EXPECT_NEAR(*log.frames[0].time, 0.1, 1e-6);
    ASSERT_EQ(log.remarks.size(), 1U);
    EXPECT_NE(log.remarks[0].find("the start time is not understood"), std::string::npos);
}

TEST(Logs, ofPeakHaveFramesOfCanFd)
{
    const Log log = read(";$FILEVERSION=2.1\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n"
                         "1 1.0 FD 2 0500 Rx - 9 00 01 02 03 04 05 06 07 08 09 0A 0B\n"
                         "2 2.0 BI 2 0500 Rx - 2 00 01\n");
    ASSERT_EQ(log.frames.size(), 2U) << log.error;
    EXPECT_EQ(log.frames[0].frame, data(0x500, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
    EXPECT_EQ(log.frames[0].interface, "can1");
    EXPECT_TRUE(log.frames[1].frame.fd);
}

TEST(Logs, asCsvAreRead)
{
    const std::vector<std::string> logs{
        "Time Stamp,ID,Extended,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n"
        "1000000,00000500,false,0,3,DD,FF,01,\n1100000,18FEF1FE,true,0,2,AA,BB,\n",
        "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\r\n"
        "1000000,00000500,false,Rx,0,3,DD,FF,01,,,,,\r\n1100000,18FEF1FE,true,Tx,0,2,AA,BB\r\n",
        "1000000,00000500,false,0,3,DD,FF,01,\n1100000,18FEF1FE,true,0,2,AA,BB,\n",
        "timestamp,arbitration_id,extended,remote,error,dlc,data\n"
        "1.0,0x500,0,0,0,3,3f8B\n1.1,0x18fef1fe,1,0,0,2,qrs=\n",
        "__time,id,extended,remote,error,fd,sent,local,length,data\n"
        "1.000000000,1280,0,0,0,0,0,0,3,DDFF01\n1.100000000,419361278,1,0,0,0,1,0,2,AABB\n"};
    for (const std::string& text : logs) {
        const Log log = read(text);
        EXPECT_EQ(log.error, "") << text;
        ASSERT_EQ(log.frames.size(), 2U) << text;
        EXPECT_EQ(log.frames[0].frame, data(0x500, {0xDD, 0xFF, 1})) << text;
        EXPECT_EQ(log.frames[1].frame, data(0x18FEF1FE, {0xAA, 0xBB}, true)) << text;
        EXPECT_EQ(log.frames[0].time, 1.0);
        EXPECT_EQ(log.frames[0].interface, "can0");
        EXPECT_NEAR(log.elapsed[1], 0.1, 1e-9);
    }
    std::string wide = "Time Stamp,ID,Extended,Dir,Bus,LEN,D1\n5,00000500,0,Rx,1,12";
    for (int i = 0; i < 12; ++i) wide += ",0" + std::to_string(i % 10);
    const Log fd = read(wide + ",\n");
    ASSERT_EQ(fd.frames.size(), 1U) << fd.error;
    EXPECT_EQ(fd.frames[0].frame, data(0x500, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 1}));
    EXPECT_EQ(fd.frames[0].interface, "can1");
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

TEST(Logs, whoseClockJumpsOverYearsGoOnEvenly)
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

TEST(Logs, asCsvMayBeSavedByASpreadsheet)
{
    for (const char* const text :
         {"Time Stamp;ID;Extended;Dir;Bus;LEN;D1;D2\n1000000;500;FALSE;Rx;0;2;DD;FF\n",
          "\"Time Stamp\",\"ID\",\"Extended\",\"Dir\",\"Bus\",\"LEN\",\"D1\",\"D2\"\n"
          "\"1000000\",\"500\",\"false\",\"Rx\",\"0\",\"2\",\"DD\",\"FF\"\n",
          "time stamp, id, extended, dir, bus, len, d1, d2\n1000000, 500, false, Rx, 0, 2, DD, "
          "FF\n",
          "Time "
          "Stamp\tID\tExtended\tDir\tBus\tLEN\tD1\tD2\n1000000\t500\t0\tRx\t0\t2\t0xDD\t0xFF\n"}) {
        const Log log = read(text);
        ASSERT_EQ(log.frames.size(), 1U) << text << log.error;
        EXPECT_EQ(log.frames[0].frame, data(0x500, {0xDD, 0xFF})) << text;
    }
    for (const char* const text : {"ID,DLC,Data,Time\n", "1,2,3,4,5\n", "a;b;c;d\n"})
        EXPECT_NE(read(text).error.find("is a table"), std::string::npos) << read(text).error;
    EXPECT_EQ(read(" can0  123   [2]  2C 2C   ',,'\n").error, "");
}

}  // namespace
}  // namespace terratact
