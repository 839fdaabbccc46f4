// Logs of Vector's tools, PEAK and CSV: their frames.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/wire/logs/log_reader.h"
#include "tests/core/wire/logs.h"
#include "tests/support/refusal.h"

namespace terratact {
namespace {

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

TEST(Logs, countFramesWithMoreBytesThanTheirLength)
{
    const std::string trc = ";$FILEVERSION=2.1\n;$STARTTIME=43008.9\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n";
    const std::string csv = "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3\n";
    for (const std::string& text :
         {std::string("0.1 1 500 Rx d 1 DD FF\n0.2 1 500 Rx d 1 DD  Length = 0\n"),
          std::string(" 1) 1059.9 Rx 0500 1 DD FF\n 2) 1060.9 Rx 0500 1 DD\n"),
          trc + " 1 9.9 DT 1 0500 Rx - 1 DD FF\n 2 10.9 DT 1 0500 Rx - 1 DD\n",
          csv + "5,500,0,Rx,0,1,DD,FF,\n6,500,0,Rx,0,1,DD,00,\n"}) {
        const Log log = read(text);
        ASSERT_EQ(log.frames.size(), 2U) << text << log.error;
        EXPECT_EQ(log.frames[0].frame, data(0x500, {0xDD}));
        ASSERT_FALSE(log.remarks.empty()) << text;
        EXPECT_NE(log.remarks.back().find("1 frames have more bytes than their length says, which "
                                          "are left out; the first is in line "),
                  std::string::npos)
            << log.remarks.back();
    }
}

TEST(Logs, ofVectorWithNegativeTimesAreRefused)
{
    EXPECT_NE(
        read("0.1 1 500 Rx d 1 DD\n-0.2 1 500 Rx d 1 DD\n").error.find("line 2: expected a time"),
        std::string::npos);
}

TEST(Logs, asCsvMayBeSavedByASpreadsheet)
{
    for (const char* const text :
         {"Time Stamp;ID;Extended;Dir;Bus;LEN;D1;D2\n1000000;500;FALSE;Rx;0;2;DD;FF\n",
          "\"Time Stamp\",\"ID\",\"Extended\",\"Dir\",\"Bus\",\"LEN\",\"D1\",\"D2\"\n"
          "\"1000000\",\"500\",\"false\",\"Rx\",\"0\",\"2\",\"DD\",\"FF\"\n",
          "sep=;\nTime Stamp;ID;Extended;Dir;Bus;LEN;D1;D2\n1000000;500;FALSE;Rx;0;2;DD;FF\n",
          "time stamp, id, extended, dir, bus, len, d1, d2\n1000000, 500, false, Rx, 0, 2, DD, "
          "FF\n",
          "Time "
          "Stamp\tID\tExtended\tDir\tBus\tLEN\tD1\tD2\n1000000\t500\t0\tRx\t0\t2\t0xDD\t0xFF\n"}) {
        const Log log = read(text);
        ASSERT_EQ(log.frames.size(), 1U) << text << log.error;
        EXPECT_EQ(log.frames[0].frame, data(0x500, {0xDD, 0xFF})) << text;
    }
    const Log shortened =
        read("Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2\n1000000,500,FALSE,Rx,0,2,A,0\n");
    ASSERT_EQ(shortened.frames.size(), 1U) << "without leading zeros" << shortened.error;
    EXPECT_EQ(shortened.frames[0].frame, data(0x500, {0x0A, 0}));
    for (const char* const text : {"ID,DLC,Data,Time\n", "1,2,3,4,5\n", "a;b;c;d\n"})
        EXPECT_NE(read(text).error.find("is a table"), std::string::npos) << read(text).error;
    EXPECT_EQ(read(" can0  123   [2]  2C 2C   ',,'\n").error, "");
}

TEST(Logs, asCsvThatASpreadsheetHasRoundedAreRefused)
{
    const std::string heading = "Time Stamp,ID,Extended,Dir,Bus,LEN,D1\n";
    const auto refusalOf = [](const std::string& text) { return read(text).error; };
    EXPECT_EQ(refusalOf(heading + "1.67E+08,500,false,Rx,0,1,DD\n"),
              "a.log: line 2: '1.67E+08' has lost its digits in a spreadsheet: export the log "
              "again, and keep this column as text");
    for (const std::string& text : {heading + "1000000,1.00E+05,false,Rx,0,1,DD\n",
                                    std::string("1.67E+08,00000500,false,Rx,0,1,DD\n")})
        EXPECT_NE(refusalOf(text).find("has lost its digits"), std::string::npos)
            << refusalOf(text);
}

}  // namespace
}  // namespace terratact
