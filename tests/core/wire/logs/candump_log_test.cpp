#include "core/wire/logs/candump_log.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/wire/logs/log_reader.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

constexpr double kTime = 1436509052.249713;

LoggedFrame parsed(std::string_view line)
{
    const auto got = frameFromCandump(line);
    if (!got) throw std::runtime_error(got.error().text);
    return *got;
}

std::string complaint(std::string_view line)
{
    const auto got = frameFromCandump(line);
    return got ? "" : got.error().text;
}

CanFrame classicFrame(std::uint32_t id, std::initializer_list<std::uint8_t> bytes)
{
    CanFrame frame{.id = id, .length = static_cast<std::uint8_t>(bytes.size())};
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    return frame;
}

/// Returns one frame of every kind.
std::vector<CanFrame> everyKind()
{
    std::vector<CanFrame> frames;
    for (const bool extended : {false, true})
        for (const std::uint32_t id : {0U, 0x44U, extended ? 0x1FFF'FFFFU : 0x7FFU})
            for (std::uint8_t length = 0; length <= 8; ++length)
                for (const int kind : {0, 1, 2}) {
                    CanFrame frame{.id = id, .extended = extended, .length = length};
                    frame.remote = kind == 1;
                    frame.fd = kind == 2;
                    for (std::uint8_t i = 0; !frame.remote && i < length; ++i)
                        frame.data[i] = static_cast<std::uint8_t>(0xF1 * (i + 1));
                    frames.push_back(frame);
                }
    frames.push_back({.id = 0x04, .error = true, .length = 8, .data = {0, 1, 0, 0, 0, 0, 9, 9}});
    frames.push_back({.id = 0x1FFF'FFFF, .error = true, .length = 8});
    frames.push_back({.id = 0x50B, .fd = true, .length = 64});
    for (std::size_t i = 0; i < 64; ++i) frames.back().data[i] = static_cast<std::uint8_t>(i);
    return frames;
}

TEST(Candump, readsTheCompactDialect)
{
    const LoggedFrame frame = parsed("(1436509052.249713) vcan0 044#2A366C2BBA");
    EXPECT_EQ(frame.time, kTime);
    EXPECT_EQ(frame.interface, "vcan0");
    EXPECT_EQ(frame.frame, classicFrame(0x44, {0x2A, 0x36, 0x6C, 0x2B, 0xBA}));
    EXPECT_EQ(frame.direction, LogDirection::Unknown);
    EXPECT_EQ(parsed("(1.5) can0 7FF# R").direction, LogDirection::Received);
    EXPECT_EQ(parsed("(1.5) can0 7ff#ab T\r").direction, LogDirection::Sent);
    EXPECT_EQ(parsed("(1.5) can0 7ff#ab T\r").frame, classicFrame(0x7FF, {0xAB}));
    EXPECT_EQ(parsed("(0000000001.500000)     can0 001#").time, 1.5);
    EXPECT_EQ(parsed("(1.5) fifteen-byte-na 001#").interface, "fifteen-byte-na");
}

TEST(Candump, readsEveryKindOfFrame)
{
    EXPECT_EQ(parsed("(1.5) can0 00000044#01").frame,
              (CanFrame{.id = 0x44, .extended = true, .length = 1, .data = {1}}));
    EXPECT_EQ(parsed("(1.5) can0 044#R").frame, (CanFrame{.id = 0x44, .remote = true}));
    EXPECT_EQ(parsed("(1.5) can0 044#R4").frame,
              (CanFrame{.id = 0x44, .remote = true, .length = 4}));
    EXPECT_EQ(parsed("(1.5) can0 044#1122334455667788_F").frame,
              parsed("(1.5) can0 044#1122334455667788").frame)
        << "candump -8 writes length codes above 8";
    EXPECT_EQ(parsed("(1.5) can0 044##1AB").frame,
              (CanFrame{.id = 0x44, .fd = true, .length = 1, .data = {0xAB}}));
    EXPECT_EQ(
        parsed("(1.5) can0 20000088#00000000000000FF").frame,
        (CanFrame{.id = 0x88, .error = true, .length = 8, .data = {0, 0, 0, 0, 0, 0, 0, 0xFF}}));
    const LoggedFrame longFd = parsed("(1.5) can0 12345678##0" + std::string(128, '5') + " R");
    EXPECT_EQ(longFd.frame.length, 64);
    EXPECT_EQ(longFd.frame.data[63], 0x55) << "none of its bytes is lost";
    EXPECT_TRUE(longFd.frame.fd && longFd.frame.extended);
}

TEST(Candump, readsTheLongDialectWithTimeAndWithout)
{
    const LoggedFrame compact = parsed("(1436509052.249713) vcan0 044#2A366C2BBA");
    EXPECT_EQ(parsed("(1436509052.249713)  vcan0  044   [5]  2A 36 6C 2B BA"), compact);
    EXPECT_EQ(parsed(" (1436509052.249713)  vcan0       044   [5]  2A 36 6C 2B BA         '*6l+.'"),
              compact);
    const LoggedFrame untimed = parsed("  vcan0  044   [5]  2A 36 6C 2B BA");
    EXPECT_EQ(untimed.frame, compact.frame);
    EXPECT_FALSE(untimed.time);
    EXPECT_EQ(parsed("  vcan0  RX - -  044   [1]  2A").direction, LogDirection::Received);
    EXPECT_EQ(parsed("  vcan0  TX B E  044  [01]  2A").direction, LogDirection::Sent);
    EXPECT_EQ(parsed(" can0  044   [4]  remote request").frame,
              (CanFrame{.id = 0x44, .remote = true, .length = 4}));
    EXPECT_EQ(parsed(" can0  044   [0] ").frame, classicFrame(0x44, {}));
    EXPECT_EQ(parsed("<0x18eeff01> [2] 05 a0").frame,
              (CanFrame{.id = 0x18EEFF01, .extended = true, .length = 2, .data = {5, 0xA0}}));
    EXPECT_EQ(parsed(" can0  00000044  [02]  01 02").frame,
              (CanFrame{.id = 0x44, .extended = true, .fd = true, .length = 2, .data = {1, 2}}));
    EXPECT_EQ(parsed(" can0  20000004   [8]  00 01 00 00 00 00 00 00   ERRORFRAME").frame,
              (CanFrame{.id = 4, .error = true, .length = 8, .data = {0, 1}}));
}

TEST(Candump, errorsNameWhatWasExpected)
{
    const auto says = [](std::string_view line, std::string_view part) {
        const std::string text = complaint(line);
        EXPECT_NE(text.find(part), std::string::npos) << line << "\n" << text;
    };
    says("(1.5)", "name of an interface, found the end");
    says("(1.5) can0", "3 or 8 hexadecimal digits, found the end");
    says("(15) can0 044#", "expected a time");
    says("(1.5", "expected a time");
    says("(nan.5) can0 044#", "expected a time");
    says("(-1.5) can0 044#", "expected a time");
    says("(1.0000000000) can0 044#", "expected a time");
    says("(99999999999.5) can0 044#", "expected a time");
    says("(2015-07-10 06:77:32.249713)  vcan0  044   [0]", "expected a time like (2025");
    says("(2015-07-10 06:17:32.249713  vcan0  044   [0]", "expected a time like (2025");
    says("(2015-13-10 06:17:32.249713)  vcan0  044   [0]", "expected a time like (2025");
    says("(2015-07-10", "expected a time like (2025");
    says("(2025-02-30 06:17:32.249713)  vcan0  044   [0]", "expected a time like (2025");
    says("(1.5) can0 044#1122334455667788_8", "at most 8 bytes");
    says("(1.5) can0 044#11_F", "two hexadecimal digits");
    says("(1.5) can0 044#2A#00:11223344#11", "a CAN XL frame is not read");
    says("vcan0 044#", "expected a time");
    says("(1.5) sixteen-byte-nam 044#", "name of an interface");
    says("(1.5) can0 44#", "3 or 8 hexadecimal");
    says("(1.5) can0 -44#", "3 or 8 hexadecimal");
    says("(1.5) can0 0x4#", "3 or 8 hexadecimal");
    says("(1.5) can0 800#", "standard identifier up to 7FF");
    says("(1.5) can0 40000000#", "an identifier up to");
    says("(1.5) can0 80000044#", "an identifier up to");
    says("(1.5) can0 044#1", "even number");
    says("(1.5) can0 044#1G", "two hexadecimal digits");
    says("(1.5) can0 044#01.02", "even number");
    says("(1.5) can0 044#112233445566778899", "at most 8 bytes");
    says("(1.5) can0 044#R9", "length from 0 to 8");
    says("(1.5) can0 044#R44", "length from 0 to 8");
    says("(1.5) can0 044##", "digit of flags");
    says("(1.5) can0 044##G", "digit of flags");
    says("(1.5) can0 044##0112233445566778899", "CAN FD can have");
    says("(1.5) can0 20000004##0", "error frame");
    says("(1.5) can0 20000004#R", "error frame");
    says("(1.5) can0 044#01 X", "a direction");
    says("(1.5) can0 044#01 R R", "end of the line");
    says("(1.5) can0 044 5 01", "a length like [5]");
    says("(1.5) can0 044 [9] 01", "at most 8");
    says("(1.5) can0 044 [2] 01", "two hexadecimal digits, found the end");
    says("(1.5) can0 044 [1] 01 02", "no more than the bytes");
    says("(1.5) can0 044 [1] 00000001", "two hexadecimal digits");
    says("(1.5) can0 044 [2] 02`01`", "two hexadecimal digits");
    says("(1.5) can0 044 [1] remote", "remote request");
    says("(1.5) can0 20000004 [1] remote request", "only a classic");
    says("(1.5) can0 044 [01] remote request", "only a classic");
    says("(1.5) can0 20000004 [1] 00", "ERRORFRAME");
    says("(1.5) can0 RX - X 044 [1] 00", "3 or 8 hexadecimal digits, found 'X'");
    says("", "name of an interface");
}

TEST(Candump, writesWhatItReadsForEveryKindOfFrame)
{
    for (const CanFrame& frame : everyKind()) {
        const std::string line = candumpLine(kTime, "vcan0", frame);
        EXPECT_EQ(parsed(line), (LoggedFrame{.time = kTime, .interface = "vcan0", .frame = frame}))
            << line;
    }
    EXPECT_EQ(candumpLine(kTime, "vcan0", classicFrame(0x44, {0x2A, 0x36, 0x6C, 0x2B, 0xBA})),
              "(1436509052.249713) vcan0 044#2A366C2BBA");
    EXPECT_EQ(candumpLine(0.0, "can0", classicFrame(0x7FF, {})), "(0000000000.000000) can0 7FF#");
}

TEST(Candump, keepsTheMicrosecondsOfEveryTime)
{
    std::mt19937_64 random(3);
    for (int i = 0; i < 10'000; ++i) {
        const double time = static_cast<double>(random() % 2'000'000'000'000'000ULL) * 1e-6;
        const auto line = candumpLine(time, "can0", CanFrame{});
        EXPECT_NEAR(*parsed(line).time, time, 1.1e-6);
        EXPECT_EQ(candumpLine(*parsed(line).time, "can0", CanFrame{}), line);
    }
}

TEST(Candump, writesNothingThatHasNoLine)
{
    const CanFrame sound = classicFrame(0x44, {1});
    EXPECT_THROW(candumpLine(-1e-9, "can0", sound), std::invalid_argument);
    EXPECT_THROW(candumpLine(1e10, "can0", sound), std::invalid_argument);
    EXPECT_THROW(candumpLine(std::nan(""), "can0", sound), std::invalid_argument);
    EXPECT_THROW(candumpLine(std::numeric_limits<double>::infinity(), "can0", sound),
                 std::invalid_argument);
    for (const char* name : {"", "sixteen-byte-nam", "can 0", "can0\n", "a/b"})
        EXPECT_THROW(candumpLine(1.5, name, sound), std::invalid_argument) << name;
    for (const CanFrame& frame :
         {CanFrame{.id = 0x800}, CanFrame{.id = 0x2000'0000, .extended = true},
          CanFrame{.length = 9}, CanFrame{.fd = true, .length = 9},
          CanFrame{.fd = true, .length = 12, .isCut = true}, CanFrame{.remote = true, .fd = true},
          CanFrame{.remote = true, .error = true}, CanFrame{.extended = true, .error = true},
          CanFrame{.error = true, .fd = true}})
        EXPECT_THROW(candumpLine(1.5, "can0", frame), std::invalid_argument);
}

struct CandumpFile : testing::Test {
    TemporaryDirectory folder;

    Result<std::vector<LoggedFrame>> read(std::string_view content)
    {
        auto reader = LogReader::open(folder.write("a.log", content));
        if (!reader) return reader.error();
        std::vector<LoggedFrame> frames;
        for (;;) {
            auto next = reader->next();
            if (!next) return next.error();
            dropped = reader->dropped();
            for (const Message& remark : reader->consumeRemarks())
                remarks.push_back(remark.english());
            if (!*next) return frames;
            frames.push_back(**std::move(next));
        }
    }
    std::string path() const { return folder.file("a.log"); }

    std::uint64_t dropped = 0;
    std::vector<std::string> remarks;
};

TEST_F(CandumpFile, isReadLineByLineInBothDialects)
{
    const auto frames = read("(1.5) can0 044#01\n\n(1.6)  can1  045   [1]  02\r\n");
    ASSERT_TRUE(frames) << frames.error().text;
    ASSERT_EQ(frames->size(), 2U);
    EXPECT_EQ((*frames)[1], (LoggedFrame{1.6, "can1", classicFrame(0x45, {2})}));
    EXPECT_TRUE(read("")->empty());
}

TEST_F(CandumpFile, namesTheLineAtFault)
{
    EXPECT_TRUE(refused(read("(1.5) can0 044#01\n\n(1.6) can0 44#01\n"), path(),
                        {"line 3", "3 or 8 hexadecimal digits, found '44'"}));
    EXPECT_TRUE(
        refused(read(std::string(1001, ' ') + "\n"), path(), {"line 1", "longer than 1000"}));
    EXPECT_TRUE(read(std::string(1000, ' ') + "\n"));
    EXPECT_TRUE(refused(read(std::string("(1.5) can0 044#0\0", 17) + "\n"), path(), {"line 1"}));
    const auto none = LogReader::open(folder.file("none.log"));
    EXPECT_TRUE(refused(none, folder.file("none.log"), {"No such file"}));
    auto directory = LogReader::open(folder.file(""));
    EXPECT_FALSE(directory && directory->next());
}

TEST_F(CandumpFile, skipsCommentsAndCountsDrops)
{
    const auto frames = read(" (1.5)  can0  20000004   [8]  00 04 00 00 00 00 60 00   ERRORFRAME\n"
                             "\tcontroller-problem{rx-error-warning}\n"
                             "\terror-counter-tx-rx{{96}{0}}\n"
                             "DROPCOUNT: dropped 3 CAN frames on 'can0' socket (total drops 3)\n"
                             "DROPCOUNT: dropped 1 CAN frame on 'can0' socket (total drops 4)\n"
                             " (1.6)  can0  044   [0] \n");
    ASSERT_TRUE(frames) << frames.error().text;
    EXPECT_EQ(frames->size(), 2U);
    EXPECT_EQ(dropped, 4U);
    EXPECT_TRUE(
        refused(read(" (1.6)  can0  044   [0] \n\tcontroller-problem\n"), path(), {"line 2"}));
    EXPECT_TRUE(refused(read("DROPCOUNT: dropped many\n"), path(), {"line 1"}));
}

TEST_F(CandumpFile, survivesAnyBytesAndKeepsWhatItAccepts)
{
    std::mt19937 random(11);
    const std::vector<std::string> seeds{"(1436509052.249713) vcan0 044#2A366C2BBA",
                                         "(1.5) can0 044#R4",
                                         "(1.5) can0 12345678##0AB R",
                                         " (1.5)  can0  RX - -  044   [2]  01 02   '..'",
                                         " (1.5)  can0  20000004   [2]  01 02   ERRORFRAME",
                                         " can0  044   [2]  remote request"};
    constexpr std::string_view kAlphabet = "(). #R[]'0159AFacnt-\t\r\0\xFF";
    int accepted = 0;
    for (int i = 0; i < 60'000; ++i) {
        std::string line = seeds[random() % seeds.size()];
        for (auto n = random() % 4; n > 0 && !line.empty(); --n) {
            const std::size_t at = random() % line.size();
            switch (random() % 3) {
            case 0: line.erase(at, 1); break;
            case 1: line.insert(at, 1, kAlphabet[random() % kAlphabet.size()]); break;
            default: line[at] = kAlphabet[random() % kAlphabet.size()];
            }
        }
        const auto got = frameFromCandump(line);
        if (!got || !got->time) continue;
        ++accepted;
        const std::string written = candumpLine(*got->time, got->interface, got->frame);
        EXPECT_EQ(parsed(written).frame, got->frame) << line;
    }
    EXPECT_GT(accepted, 5'000);
}

/// Returns the output of a command; empty if it fails.
std::string output(const std::string& command)
{
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(
        ::popen((command + " 2>/dev/null").c_str(), "r"), ::pclose);
    std::string text;
    std::array<char, 4096> block{};
    while (pipe && !std::feof(pipe.get()))
        text.append(block.data(), std::fread(block.data(), 1, block.size(), pipe.get()));
    return text;
}

std::size_t lines(const std::string& text)
{
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

struct CandumpPeers : CandumpFile {
    /// Returns a log with every kind of frame, 1 ms apart.
    std::string ours()
    {
        std::string text;
        double time = kTime;
        for (const CanFrame& frame : everyKind())
            text += candumpLine(time += 0.001, "vcan0", frame) + "\n";
        return folder.write("ours.log", text);
    }
};

// The parser of log2asc and the writer of asc2log are independent of ours.
TEST_F(CandumpPeers, canUtilsReadWhatIsWrittenAndWriteWhatIsRead)
{
    if (output("which log2asc asc2log").empty()) GTEST_SKIP() << "can-utils are not installed";
    const std::string asc = folder.file("a.asc");
    output("log2asc -I " + ours() + " -O " + asc + " vcan0");
    const std::string text = contentOf(asc);
    EXPECT_EQ(lines(text), everyKind().size() + 3) << "three lines of heading";
    EXPECT_NE(text.find("44              Rx   d 3 F1 E2 D3"), std::string::npos) << text;
    EXPECT_NE(text.find("1FFFFFFFx       Rx   r"), std::string::npos) << text;

    const auto back = read(output("asc2log -I " + asc));
    ASSERT_TRUE(back) << back.error().text;
    std::vector<CanFrame> classic;
    for (const LoggedFrame& logged : *back)
        if (!logged.frame.fd && !logged.frame.error) classic.push_back(logged.frame);
    std::vector<CanFrame> expected;
    for (CanFrame frame : everyKind())
        if (!frame.fd && !frame.error) expected.push_back(frame);
    EXPECT_EQ(classic, expected);
}

TEST_F(CandumpPeers, pythonCanReadsWhatIsWrittenAndWritesWhatIsRead)
{
    if (output("/usr/bin/python3 -c 'import can; print(can.__version__)'").empty())
        GTEST_SKIP() << "python-can is not installed";
    const std::string theirs = folder.file("theirs.log");
    const std::string script = folder.write(
        "through.py",
        "import sys\n"
        "from can.io import CanutilsLogReader, CanutilsLogWriter\n"
        "with CanutilsLogReader(sys.argv[1]) as log, CanutilsLogWriter(sys.argv[2]) as out:\n"
        "    for message in log:\n"
        "        out.on_message_received(message)\n"
        "        print(message.dlc)\n");
    const std::string lengths = output("/usr/bin/python3 " + script + " " + ours() + " " + theirs);
    EXPECT_EQ(lines(lengths), everyKind().size());
    const auto back = read(contentOf(theirs));
    ASSERT_TRUE(back) << back.error().text;
    ASSERT_EQ(back->size(), everyKind().size());
    for (std::size_t i = 0; i < back->size(); ++i) {
        CanFrame frame = everyKind()[i];
        if (frame.error) continue;           // it only keeps that there was an error frame
        if (frame.remote) frame.length = 0;  // it does not keep the requested length
        EXPECT_EQ((*back)[i].frame, frame) << i;
        EXPECT_EQ((*back)[i].direction, LogDirection::Received);
    }
}

}  // namespace
}  // namespace terratact
