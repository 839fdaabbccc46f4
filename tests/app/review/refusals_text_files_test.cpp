// Tests that refused text files are explained in the operator's language. The errors are not listed here: the readers
// produce them for files broken in many ways. No English word may remain in the translations.
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "app/link/dbc_book.h"
#include "core/atem/panel_file.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/model/model_card.h"
#include "core/robot/robot_model.h"
#include "core/store/file_read.h"
#include "core/wire/dbc/dbc_file.h"
#include "core/wire/logs/log_reader.h"
#include "drivers/log_replay.h"
#include "tests/app/review/refusals.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

/// Breaks the text: omits, repeats and cuts each line, and gives it invalid values.
void breakToml(const std::string& text, const std::function<void(const std::string& broken)>& read)
{
    const std::vector<std::string> lines = linesOf(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto with = [&](std::vector<std::string> instead) {
            std::vector<std::string> broken(lines.begin(),
                                            lines.begin() + static_cast<std::ptrdiff_t>(i));
            broken.insert(broken.end(), instead.begin(), instead.end());
            broken.insert(broken.end(), lines.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                          lines.end());
            read(joined(broken));
        };
        with({});
        with({lines[i], "colour = 1"});
        const std::size_t sign = lines[i].find(" = ");
        if (sign == std::string::npos || lines[i].starts_with('#')) continue;
        const std::string key = lines[i].substr(0, sign + 3);
        with({lines[i], lines[i]});
        for (const char* const value : {"",
                                        "\"x\"",
                                        "\"\"",
                                        "-1e9",
                                        "0",
                                        "0.5",
                                        "1e9",
                                        "true",
                                        "[]",
                                        "{}",
                                        "{ line = \"a\" }",
                                        "[1, 1, 1, 1, 1, 1]",
                                        "[0.1, 0.2]",
                                        "[[1, 2], [2, 3]]",
                                        "[[[0, 0], [1, 0], [0.5, 0.1], [0.5, 1]]]",
                                        "{ line = \"a\", offset = 1 }",
                                        "{ offset = 0.5 }",
                                        R"({ line = "a", closes_to = "up", resistor = "x" })",
                                        R"({ line = "GPIO5", lit_when = "up" })",
                                        R"({ offset = -3, closes_to = "ground", resistor = "x" })"})
            with({key + value});
    }
    read("");
    read("x = " + std::string(20, '[') + std::string(20, ']'));
    read(std::string(70'000, '#'));
}

TEST(Refusals, ofRobots)
{
    const std::string text = contentOf(kSource + "/resources/robots/absolem.toml");
    Refusals refusals({"name", "base", "imu", "track", "body", "arm", "odometry"});
    const auto read = [&](const std::string& robot) {
        refusals.add(robotModelFrom("/tmp/my robot.toml", robot));
    };
    breakToml(text, read);
    const std::string array = "[[force_array]]\nname = \"a\"\nside = \"left\"\nelements = [1, 2]\n";
    for (const char* const more :
         {"[[force_array]]\n", "[force_array]\n", "force_array = 1\n", "force_array = [1]\n",
          "force_array = []\n",
          "[[force_array]]\nname = \"an array whose name is far longer than any screen has room "
          "for\"\nside = \"left\"\nelements = [1]\n",
          "[[force_array]]\nname = \"a\"\nside = \"up\"\nelements = [1]\n",
          "[[force_array]]\nname = \"a\"\nside = \"left\"\nelements = [1.5]\n",
          "[[force_array]]\nname = \"a\"\nside = \"left\"\nelements = [1, 1]\n",
          "[[force_array]]\nname = \"a\"\nside = \"left\"\nelements = [9]\n"}) {
        read(more + text);
        read(text + more);
    }
    read(text + array);
    read(text + array + array);
    std::string many;
    for (int i = 0; i < 40; ++i) many += array;
    read(text + many);
    EXPECT_GE(refusals.size(), 20U);
    refusals.expectTranslated();
}

TEST(Refusals, ofPanelsAndCards)
{
    Refusals refusals({"name", "chip", "chip.name", "inputs", "outputs", "data", "date", "scenes",
                       "method", "terrain", "trained", "evaluation", "label"});
    breakToml(contentOf(kSource + "/resources/panels/example.toml"),
              [&](const std::string& broken) { refusals.add(panelFrom("panel.toml", broken)); });
    const std::size_t panels = refusals.size();
    EXPECT_GE(panels, 12U);
    const std::string card = contentOf(kSource + "/resources/models/default.card.toml");
    breakToml(card, [&](const std::string& broken) {
        refusals.add(modelCardFrom("m.card.toml", broken));
    });
    breakToml(
        "evaluation = [1]\n" + card.substr(0, card.find("[[")),
        [&](const std::string& broken) { refusals.add(modelCardFrom("m.card.toml", broken)); });
    const TemporaryDirectory dir;
    dir.write("mine.card.toml", card);
    refusals.add(readModelCard(dir.file("mine.ttm"), std::string(64, '7')));
    EXPECT_GE(refusals.size(), panels + 5U);
    refusals.expectTranslated();
}

std::string semicolons(std::string text)
{
    std::replace(text.begin(), text.end(), ',', ';');
    return text;
}

TEST(Refusals, ofScenes)
{
    const TemporaryDirectory dir;
    Refusals refusals({"run"});
    const auto read = [&](const std::string& content) {
        const std::string path = dir.write("scenes.csv", content);
        const auto file = readScenes(path);
        refusals.add(file);
        for (const Message& notice : file ? file->notices : std::vector<Message>{})
            refusals.add(notice);
        refusals.add(readScenesWithTruth(path));
    };
    Scene scene;
    scene.run = "a";
    const std::string good = scenesText({scene});
    const std::string header = good.substr(0, good.find('\n') + 1),
                      row = good.substr(header.size());
    for (const std::string& content :
         {std::string(),
          good,
          header,
          good + good.substr(0, 9),
          "\n" + good,
          header + "\n",
          header + "\"a\"\n",
          header + "a\n",
          header + "\"a\n",
          header + "\"a\"b\n",
          header + "\"a,b\"" + row.substr(1),
          header + "a",
          good.substr(0, good.size() - 1),
          header + row.substr(0, row.size() - 1) + ",1\n",
          std::string("\xFF\xFE\0a", 4),
          std::string("PK\x03\x04"),
          std::string("\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"),
          std::string("\x1F\x8B"),
          std::string("%PDF-"),
          std::string("SQLite format 3\0", 16),
          std::string("a\0,b\n", 5),
          std::string("a b\n"),
          std::string("a|b\n"),
          std::string("a,b;c\n"),
          std::string("sep=|\n"),
          header + ",s,deg,rad,rad,A,A" + std::string(17, ',') + "\n",
          semicolons(header) + "a;0,5;0.5" + std::string(21, ';') + "\n",
          semicolons(header) + "a;0.5;0,5" + std::string(21, ';') + "\n",
          semicolons(header) + "a;1.000,5;0" + std::string(21, ';') + "\n",
          header + row.substr(0, row.size() - 1) + ",\n",
          "run,run\n" + row,
          "run,h_0.0_m\n" + row,
          "run,colour\n" + row,
          "colour," + header + "1," + row,
          "run,t_s\n" + row,
          header + std::string(70'000, 'x') + "\n",
          header + std::string(2'000, ',') + "\n",
          std::string(300, ',') + "\n"})
        read(content);
    const auto commas = static_cast<std::size_t>(std::count(header.begin(), header.end(), ','));
    for (std::size_t column = 0; column <= commas; ++column)
        for (const char* const value : {"", "x", "nan", "inf", "1e9", "-1e9", "a\tb"}) {
            std::string broken;
            std::size_t at = 0;
            for (const char c : row) {
                if (at != column || c == ',' || c == '\n') broken += c;
                at += c == ',';
                if (at == column && (c == ',' || broken.empty())) broken += value;
            }
            read(header + broken);
        }
    refusals.add(readScenes(dir.file("none.csv")));
    EXPECT_GE(refusals.size(), 20U);
    refusals.expectTranslated();
}

TEST(Refusals, ofDbcFiles)
{
    const TemporaryDirectory dir;
    const std::string text = "VERSION \"1\"\n\nNS_ :\n\tCM_\n\nBS_:\n\nBU_: G1 D1\n\n"
                             "BO_ 256 Engine_1: 8 G1\n"
                             " SG_ Speed_1 m1 : 8|16@1+ (0.1,-40) [0|250] \"km/h\" D1\n"
                             " SG_ Mode_1 M : 0|8@1+ (1,0) [0|3] \"\" D1\n"
                             " SG_ Torque_1 : 24|32@1- (1,0) [0|0] \"Nm\" D1\n\n"
                             "CM_ SG_ 256 Speed_1 \"Over ground.\";\n"
                             "BA_DEF_DEF_ \"GenMsgCycleTime\" 100;\n"
                             "BA_ \"GenMsgCycleTime\" BO_ 256 100;\n"
                             "VAL_ 256 Mode_1 0 \"neutral\" 1 \"first\" ;\n"
                             "SIG_VALTYPE_ 256 Torque_1 : 1;\n"
                             "SG_MUL_VAL_ 256 Speed_1 Mode_1 1-1, 4-7;\n";
    ASSERT_TRUE(dbcFrom("good.dbc", text)) << dbcFrom("good.dbc", text).error().text;
    Refusals refusals({"Windows"});
    const auto read = [&](const std::string& content) {
        const auto file = dbcFrom("my.dbc", content);
        refusals.add(file);
        for (const Message& warning : file ? file->warnings : std::vector<Message>{})
            refusals.add(warning);
    };
    for (std::size_t at = 0; at < text.size(); ++at) {
        read(text.substr(0, at));
        for (const char* const instead : {"", "!", "\"", "9", "x", ";", " 99999999999 "})
            read(text.substr(0, at) + instead + text.substr(at + 1));
    }
    const std::string message = "BO_ 256 Engine_1: 8 G1\n";
    for (const char* const broken :
         {" SG_ A_1 M : 0|8@1+ (1,0) [0|0] \"\" D1\n SG_ B_1 M : 8|8@1+ (1,0) [0|0] \"\" D1\n SG_ "
          "C_1 m1 : 16|8@1+ (1,0) [0|0] \"\" D1\n",
          " SG_ A_1 m1M : 0|8@1+ (1,0) [0|0] \"\" D1\n",
          "BA_ \"SystemSignalLongSymbol\" SG_ 256 A_1 9;\n", "BA_ \"VFrameFormat\" BO_ 256 x;\n",
          "BA_ \"ProtocolType\" 9;\n", "BA_DEF_ BO_ \"VFrameFormat\" ENUM x;\n",
          " SG_ A_1 m1 : 0|8@1+ (1,0) [0|0] \"\" D1\nSG_MUL_VAL_ 256 A_1 None 1-1;\n",
          " SG_ A_1 : 0|8@1+ (0,0) [0|0] \"\" D1\n", " SG_ A_1 : 0|0@1+ (1,0) [0|0] \"\" D1\n",
          " SG_ A_1 : 0|8@1+ (1,0) [0|0] \"\" D1\n SG_ A_1 : 0|8@1+ (1,0) [0|0] \"\" D1\n",
          " SG_ A_1 : 0|8@1+ (1,0) [0|0] \"\" D1\nSIG_VALTYPE_ 256 A_1 : 2;\n"})
        read(message + broken);
    read(message + "BO_ 256 Other_1: 8 G1\n");
    read(message + "BO_ 4096 Other_1: 8 G1\n");
    read(message + "BO_ 512 Other_1: 999 G1\n");
    std::string many = message;
    for (int i = 0; i < 30; ++i) many += message;
    read(many);
    read(std::string("\0", 1));
    read(text + std::string("\0", 1));
    read(text + "VAL_ 256 Mode_1 1e30 \"far\" ;\n");
    read(text + "BA_ \"SystemSignalLongSymbol\" SG_ 256 Speed_1 \"Mode_1\";\n");
    DbcBook book;
    refusals.add(book.add("/dev/null"));
    refusals.add(book.add(dir.file("none.dbc")));
    refusals.add(book.add(dir.write("one.dbc", text)));
    refusals.add(book.add(dir.write("two.dbc", text + "BO_ 257 Another_1: 8 G1\n")));
    refusals.add(book.add(dir.write("three.dbc", text + "BO_ 257 Another_1: 8 G1\n")));
    refusals.add(book.add(kSource + "/resources/dbc/terratact.dbc"));
    refusals.add(book.add(dir.write("ours.dbc", "BO_ 34 Ours_1: 8 G1\n")));
    for (const Message& remark : book.remarks()) refusals.add(remark);
    EXPECT_GE(refusals.size(), 60U);
    refusals.expectTranslated();
}

TEST(Refusals, ofLogs)
{
    Refusals refusals(
        {"remote",     "request", "candump", "-L",        "--interface",    "CSV",   "GVRET",
         "python-can", "MCAP",    "Vector",  "BusMaster", "Microchip",      "CRTD",  "canboat",
         "NMEA",       "JSON",    "XML",     "Wireshark", "tcpdump",        "ZIP",   "session",
         "export",     "BRS",     "ESI",     "true",      "false",          "xz",    "zstd",
         "Rx",         "Tx",      "dlc",     "base",      "can_logconvert", "--dbc", "-d",
         "slcan",      "-l"});
    const auto read = [&](const std::string& log) {
        LogReader reader("broken.log", std::make_unique<std::istringstream>(log));
        for (;;) {
            const auto frame = reader.next();
            if (!frame) refusals.add(frame.error().message);
            if (!frame || !*frame) return;
        }
    };
    for (const std::string line :
         {"(1436509052.249713) vcan0 044#2A366C2BBA R", "(1436509052.249713) vcan0 044#R3",
          "(1436509052.249713) vcan0 12345678##1112233", "(1.5) vcan0 20000004#0000000000000000",
          "  vcan0  RX - -  044   [5]  2A 36 6C 2B BA", "  vcan0  044   [0]  remote request",
          "  vcan0  20000004   [8]  00 00 00 00 00 00 00 00   ERRORFRAME",
          " (2025-01-10 12:34:56.249713)  vcan0  044   [1]  2A", "0.1 1 500x Rx d 3 DD FF 01",
          "0.1 1 500 Rx r 4",
          "0.1 CANFD 1 Rx 500 1 0 9 12 00 01 02 03 04 05 06 07 08 09 0A 0B 0 0 3000",
          ";$FILEVERSION=1.1", "     1)     100.0 1 Rx     0500  3  DD FF 01"}) {
        read(line);
        read(line + "\n" + std::string(9'000, 'x') + "\n");
        for (std::size_t at = 0; at < line.size(); ++at) {
            read(line.substr(0, at) + "\n");
            for (const char* const instead : {"", "!", "9", "x", "F", " ", "#", "R", "[99]"})
                read(line.substr(0, at) + instead + line.substr(at + 1) + "\n");
        }
    }
    const std::vector<std::pair<std::string, std::string>> tables{
        {";$COLUMNS=N,O,T,B,I,d,R,L,D\n", "1 100.000 DT 1 0500 Rx - 3 DD FF 01"},
        {"Time Stamp,ID,Extended,Dir,Bus,LEN,D1\n", "1000000,00000500,false,Rx,0,3,DD,FF,01,"},
        {"timestamp,arbitration_id,extended,remote,error,dlc,data\n", "1.0,0x500,0,1,1,3,3f8B"},
        {"__time,id,extended,remote,error,fd,sent,local,length,data\n",
         "1.0,1280,0,1,0,1,0,0,3,DDFF01"},
        {"base dec\n", "0.1 1 500x Rx d 3 221 255 1"}};
    for (const auto& [heading, row] : tables)
        for (std::size_t at = 0; at < row.size(); ++at)
            for (const char* const instead : {"", "!", "9", "0", "x", ",", " ", "300"})
                read(heading + row.substr(0, at) + instead + row.substr(at + 1) + "\n");
    using namespace std::string_literals;
    for (const std::string& kind :
         {"LOGG"s, "MDF     "s, "\x89MCAP0"s, "SQLite format 3\0"s, "\x0A\x0D\x0D\x0A"s,
          "\xD4\xC3\xB2\xA1"s, "PK\x03\x04"s,
          "\xFD"
          "7zXZ"s,
          "\x28\xB5\x2F\xFD"s, "BZh"s, "***BUSMASTER"s, "Microchip Tech"s, "1.5 1R11 213 01"s,
          "VERSION \"\""s, "2016-04-09T16:41:09.078Z,3,127257,17,255,8,00"s, "{}"s, "Time,a"s,
          "\x1F\x8B\x08\x08 and nothing that is packed"s})
        read(kind + "\n");
    for (const char* const kind : {"%PDF-1.4\n", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", "\x89PNG\n",
                                   "t1230\n", "1.67E+08,00000500,false,0,1,DD\n"})
        read(kind);
    const TemporaryDirectory dir;
    for (const auto& path : {dir.write("empty.log", ""), dir.file("."), dir.file("none.log"),
                             dir.write("two.log", "(1.5) can0 044#2A\n(1.6) can1 044#2A\n"),
                             dir.write("untimed.log", "  vcan0  044   [1]  2A\n")})
        refusals.add(LogReplay::open(path, {}));
    refusals.add(LogReplay::open(dir.file("two.log"), {.interface = "can7"}));
    refusals.add(fileError("my.csv", TR_NOOP("core", "has no scenes")).message);
    EXPECT_GE(refusals.size(), 24U);
    refusals.expectTranslated();
}

}  // namespace
}  // namespace terratact
