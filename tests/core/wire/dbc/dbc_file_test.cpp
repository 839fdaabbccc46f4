// Tests reading DBC files: their content, warnings and refusals.
#include "core/wire/dbc/dbc_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "core/wire/dbc/dbc.h"
#include "tests/support/bytes/dbc_text.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(DbcMultiplexing, withoutAMultiplexorIsLeftOutWithItsLine)
{
    const Result<DbcFile> file = parsed("BO_ 256 M: 8 A\n"
                                        " SG_ One m1M : 8|8@1+ (1,0) [0|0] \"\" B\n"
                                        " SG_ Two m1M : 16|8@1+ (1,0) [0|0] \"\" B\n"
                                        " SG_ Below m1 : 0|8@1+ (1,0) [0|0] \"\" B\n"
                                        " SG_ Always : 24|8@1+ (1,0) [0|0] \"\" B\n"
                                        "BO_ 257 N: 8 A\n"
                                        " SG_ Lost m1 : 8|8@1+ (1,0) [0|0] \"\" B\n"
                                        "SG_MUL_VAL_ 256 One Two 1-1;\n"
                                        "SG_MUL_VAL_ 256 Two One 1-1;\n"
                                        "SG_MUL_VAL_ 256 Below One 1-1;\n");
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->messages[0].payload.size(), 1U) << "a circle selects nothing";
    EXPECT_EQ(file->messages[0].payload[0].name, "Always");
    EXPECT_TRUE(file->messages[1].payload.empty());
    ASSERT_EQ(file->warnings.size(), 2U);
    EXPECT_TRUE(
        file->warnings[0].english().starts_with("f.dbc: line 2: 3 multiplexed signals of M"));
    EXPECT_TRUE(
        file->warnings[1].english().starts_with("f.dbc: line 7: 1 multiplexed signals of N"));
}

TEST(DbcFiles, giveTheLongNames)
{
    const DbcMessage m =
        onlyMessage("BO_ 256 Short: 8 A\n"
                    " SG_ TemperatureOfTheAirInFrontOfThe_ : 0|8@1+ (1,0) [0|0] \"\" B\n"
                    "BA_DEF_ SG_ \"SystemSignalLongSymbol\" STRING ;\n"
                    "BA_ \"SystemSignalLongSymbol\" SG_ 256 TemperatureOfTheAirInFrontOfThe_ "
                    "\"TemperatureOfTheAirInFrontOfTheGripper\";\n"
                    "BA_ \"SystemMessageLongSymbol\" BO_ 256 \"MuchLongerThanShort\";\n"
                    "VAL_ 256 TemperatureOfTheAirInFrontOfThe_ 1 \"one\" ;\n");
    EXPECT_EQ(m.name, "MuchLongerThanShort");
    EXPECT_EQ(m.payload.at(0).name, "TemperatureOfTheAirInFrontOfTheGripper");
    EXPECT_EQ(m.payload.at(0).words.size(), 1U) << "the file goes on with the short one";
}

TEST(DbcFiles, defineWhichMessagesAreParameterGroups)
{
    const std::string message = "BO_ 2364540158 EEC1: 8 A\nBO_ 256 Standard: 8 A\n";
    const std::string kinds =
        "BA_DEF_ BO_ \"VFrameFormat\" ENUM \"StandardCAN\",\"J1939PG\",\"ExtendedCAN\";\n";
    const auto isGroup = [&](const std::string& text) {
        const Result<DbcFile> file = parsed(message + text);
        EXPECT_TRUE(file && file->warnings.empty());
        EXPECT_FALSE(file->messages.at(1).isParameterGroup) << "11 bits have none";
        return file->messages.at(0).isParameterGroup;
    };
    EXPECT_FALSE(isGroup(""));
    EXPECT_TRUE(isGroup(kinds + "BA_ \"VFrameFormat\" BO_ 2364540158 1;\n"));
    EXPECT_FALSE(isGroup(kinds + "BA_ \"VFrameFormat\" BO_ 2364540158 2;\n"));
    EXPECT_TRUE(isGroup("BA_ \"VFrameFormat\" BO_ 2364540158 3;\n"));
    EXPECT_TRUE(isGroup(kinds + "BA_DEF_DEF_ \"VFrameFormat\" \"J1939PG\";\n"));
    EXPECT_FALSE(isGroup(kinds
                         + "BA_DEF_DEF_ \"VFrameFormat\" \"J1939PG\";\n"
                           "BA_ \"VFrameFormat\" BO_ 2364540158 0;\n"));
    EXPECT_TRUE(isGroup("BA_ \"ProtocolType\" \"J1939\";\n"));
    EXPECT_EQ(parameterGroupOf(0x0CF00400), parameterGroupOf(0x18F004FE));
    EXPECT_NE(parameterGroupOf(0x0CF00400), parameterGroupOf(0x0CF00500));
    EXPECT_EQ(parameterGroupOf(0x18EAFF01), parameterGroupOf(0x18EA0002)) << "a destination";
}

TEST(Dbc, aSignalBelowTheNodesIsNamedAsFault)
{
    const Result<DbcFile> read =
        parsed("BU_: Engine\n SG_ Lost : 0|8@1+ (1,0) [0|0] \"\" A\n"
               "BO_ 256 Clock: 8 A\n SG_ Kept : 0|8@1+ (1,0) [0|0] \"\" A\n");
    ASSERT_TRUE(read);
    ASSERT_EQ(read->messages.size(), 1U);
    ASSERT_EQ(read->warnings.size(), 1U);
    EXPECT_NE(read->warnings[0].english().find("line 2"), std::string::npos)
        << read->warnings[0].english();
}

/// A file as other programs write it.
const char* const kForeign = R"(VERSION "HNPBNYYYYYYYYYNNNNNNN/4/%%%/4/'%**4YYY///"

NS_ :
	NS_DESC_
	CM_
	BO_TX_BU_

BS_: 500000 : 1,2

BU_: Engine Gateway
VAL_TABLE_ Gears 2 "second" 1 "first" ;

BO_ 3221225472 VECTOR__INDEPENDENT_SIG_MSG: 0 Vector__XXX
 SG_ Orphan : 0|8@1+ (1,0) [0|0] "" Vector__XXX

BO_ 2566844926 CCVS : 8 Engine
   SG_ Speed:15|16@0+ (3.90625E-003,0) [0|250.996] "km/h"  Gateway, Vector__XXX
 SG_ Gear : 32|4@1- (+1,-0.) [-1|.5] "" Vector__XXX

BO_ 100 Short: 2 Vector__XXX

EV_ Voltage: 0 [0|20] "V" 0 1 DUMMY_NODE_VECTOR0 Vector__XXX;
CM_ "Of the whole.";
CM_ BU_ Engine "Under the bonnet.";
CM_ BO_ 2566844926 "Says \"hello\";
BO_ 7 NoMessage: 8 A
and goes on.";
CM_ SG_ 2566844926 Speed "Over ground.";
CM_ SG_ 2566844926 Nobody "Of no signal.";
BA_DEF_ BO_  "GenMsgCycleTime" INT 0 65535;
BA_DEF_  "BusType" STRING ;
BA_DEF_DEF_  "GenMsgCycleTime" 250;
BA_DEF_DEF_  "BusType" "CAN";
BA_ "BusType" "CAN";
BA_ "GenMsgCycleTime" BO_ 2566844926 100;
BA_ "GenMsgStartValue" SG_ 2566844926 Speed 0;
BA_ "Kind" BO_ 100 "text";
VAL_ 2566844926 Gear -1 "reverse" 0 "neutral" 1 "first" ;
VAL_ Voltage 0 "off" ;
SIG_GROUP_ 2566844926 Group 1 : Speed;
SIG_VALTYPE_ 2566844926 Gear : 0;
FUTURE_SECTION_ of "another; version"
  without an end
BO_ 101 Last: 8 Engine
)";

TEST(DbcFiles, areReadAsOtherProgramsWriteThem)
{
    const Result<DbcFile> file = parsed(kForeign);
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_TRUE(file->warnings.empty());
    ASSERT_EQ(file->messages.size(), 3U);
    const DbcMessage& m = file->messages[0];
    EXPECT_EQ(m.name, "CCVS");
    EXPECT_TRUE(m.extended);
    EXPECT_EQ(m.id, 0x18FEF1FEU);
    EXPECT_EQ(m.sender, "Engine");
    EXPECT_EQ(m.comment, "Says \"hello\";\nBO_ 7 NoMessage: 8 A\nand goes on.");
    EXPECT_DOUBLE_EQ(m.period(), 0.1);
    ASSERT_EQ(m.payload.size(), 2U);
    EXPECT_EQ(m.payload[0].name, "Speed");
    EXPECT_TRUE(m.payload[0].isBigEndian);
    EXPECT_EQ(m.payload[0].scale, 1.0 / 256.0);
    EXPECT_EQ(m.payload[0].most, 250.996);
    EXPECT_EQ(m.payload[0].unit, "km/h");
    EXPECT_EQ(m.payload[0].receivers, "Gateway, Vector__XXX");
    EXPECT_EQ(m.payload[0].comment, "Over ground.");
    const DbcSignal& gear = m.signal("Gear");
    EXPECT_EQ(gear.type, DbcSignal::Type::Signed);
    EXPECT_EQ(gear.words.size(), 3U);
    EXPECT_EQ(*wordOf(gear, -1.0), "reverse");
    EXPECT_EQ(wordOf(gear, 2.0), nullptr);
    EXPECT_EQ(wordOf(gear, 1e300), nullptr);
    EXPECT_THROW(static_cast<void>(m.signal("Nobody")), std::out_of_range);
    EXPECT_EQ(file->messages[1].name, "Short");
    EXPECT_DOUBLE_EQ(file->messages[1].period(), 0.25) << "the default";
    EXPECT_EQ(file->messages[2].name, "Last") << "behind a section without its semicolon";
}

TEST(DbcFiles, mayEndTheirLinesAsTheyLike)
{
    std::string text = kForeign;
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
        text.replace(at, 1, "\r\n");
    const Result<DbcFile> file = parsed(text);
    ASSERT_TRUE(file) << file.error().text;
    const Result<DbcFile> plain = parsed(kForeign);
    ASSERT_EQ(file->messages.size(), plain->messages.size());
    for (std::size_t i = 0; i < plain->messages.size(); ++i) {
        EXPECT_EQ(file->messages[i].name, plain->messages[i].name);
        EXPECT_EQ(file->messages[i].comment, plain->messages[i].comment);
        EXPECT_EQ(file->messages[i].payload.size(), plain->messages[i].payload.size());
    }
}

TEST(DbcFiles, areUtf8OrElseOfWindows)
{
    const std::string before = "BO_ 256 M: 8 A\n SG_ S : 0|8@1+ (1,0) [0|0] \"";
    const auto unit = [&](const std::string& bytes) {
        return onlyMessage(before + bytes + "\" B\n").payload[0].unit;
    };
    EXPECT_EQ(unit("\xB0"
                   "C"),
              "°C")
        << "ISO 8859-1 is the same there";
    EXPECT_EQ(unit("\x80\x85\x93\x99\xE4"), "€…“™ä") << "Windows code page 1252";
    EXPECT_EQ(unit("°C"), "°C");
    EXPECT_EQ(unit("\xE2\x82"), "â‚") << "no whole character of UTF-8";
    EXPECT_EQ(unit("\xE2\x81"), "â ") << "no letter, and no control character";
    EXPECT_EQ(onlyMessage("\xEF\xBB\xBF" + before + "Ω\" B\n").payload[0].unit, "Ω");
    EXPECT_EQ(unit("a\x1B[31m\xC2\x9B"
                   "b"),
              "a [31m b")
        << "nothing that a terminal would obey";
    EXPECT_EQ(unit(std::string(64, 'x')), std::string(64, 'x'));
    EXPECT_EQ(unit(std::string(65, 'x')), std::string(64, 'x') + "…");
}

TEST(DbcFiles, duplicatesKeepTheFirstWithAWarning)
{
    const Result<DbcFile> file = parsed("BO_ 256 M: 8 A\n"
                                        " SG_ S : 0|8@1+ (2,0) [0|0] \"\" B\n"
                                        " SG_ S : 8|8@1+ (3,0) [0|0] \"\" B\n"
                                        " SG_ Z : 8|8@1+ (0,0) [0|0] \"\" B\n"
                                        "BO_ 256 N: 8 A\n"
                                        " SG_ T : 0|8@1+ (1,0) [0|0] \"\" B\n"
                                        "BO_ 2147483904 Extended: 8 A\n"
                                        "BO_ 300 Long: 1785 A\n"
                                        " SG_ T : 9000|8@1+ (1,0) [0|0] \"\" B\n");
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->messages.size(), 2U);
    ASSERT_EQ(file->messages[0].payload.size(), 1U);
    EXPECT_EQ(file->messages[0].payload[0].scale, 2.0);
    EXPECT_EQ(file->messages[1].name, "Extended") << "256 with 29 bits is another";
    const std::vector<std::string> lines{"line 3", "line 4", "line 5", "line 8"};
    ASSERT_EQ(file->warnings.size(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
        EXPECT_TRUE(file->warnings[i].english().starts_with("f.dbc: " + lines[i] + ": "))
            << file->warnings[i].english();
}

TEST(DbcFiles, loseOnlyTheFaultyLine)
{
    const std::string head = "VERSION \"\"\n\nBO_ 256 M: 8 A\n";
    const std::string kept = " SG_ Kept : 0|8@1+ (1,0) [0|0] \"\" B\n";
    const std::string more = "BO_ 300 More: 8 A\n SG_ Kept : 0|8@1+ (1,0) [0|0] \"\" B\n";
    const std::string s = " SG_ S : ";
    struct Case {
        std::string line;
        std::vector<std::string_view> parts;
    };
    const std::vector<Case> cases{
        {s + "60|8@1+ (1,0) [0|0] \"\" B\n", {"S is left out", "message M", "bit 68 of 64"}},
        {s + "0x8|8@1+ (1,0) [0|0] \"\" B\n", {"a whole number", "'0x8|8@1+"}},
        {s + "0|0@1+ (1,0) [0|0] \"\" B\n", {"0 bits", "1 to 64"}},
        {s + "0|65@1+ (1,0) [0|0] \"\" B\n", {"65 bits", "1 to 64"}},
        {s + "0|8@2+ (1,0) [0|0] \"\" B\n", {"byte order", "'2+'"}},
        {s + "0|8@1 (1,0) [0|0] \"\" B\n", {"expected '+'", "'-'"}},
        {s + "0|8@1+ (nan,0) [0|0] \"\" B\n", {"scale, a number", "'nan,0)'"}},
        {s + "0|8@1+ (1e999,0) [0|0] \"\" B\n", {"scale, a number"}},
        {s + "0|8@1+ (1;0) [0|0] \"\" B\n", {"between scale and offset"}},
        {s + "0|8@1+ (1,0) [0|0] V B\n", {"unit", "quotation marks", "'V'"}},
        {s + "0|8@1+ (1,0) 0|0 \"\" B\n", {"range"}},
        {" SG_ S m : 0|8@1+ (1,0) [0|0] \"\" B\n", {"multiplexor", "'m'"}},
        {" SG_ : 0|8@1+ (1,0) [0|0] \"\" B\n", {"the signal's name"}},
        {"VAL_ 256 Kept 0 zero ;\n", {"word of a raw value", "'zero'"}},
        {"SIG_VALTYPE_ 256 Kept : 1;\n", {"no float", "8 bits, expected 32"}},
        {"time,id,data\n", {"keyword of a section", "'time'"}},
        {"BO_ x N: 8 A\n", {"identifier", "'x'"}},
        {"BO_ 4096 N: 8 A\n", {"4096", "at most 2047"}},
        {"BO_ 3221225473 N: 8 A\n", {"3221225473", "29 bits"}},
        {"BO_ 4294967296 N: 8 A\n", {"at most 4294967295"}},
        {"BO_ 257 N 8 A\n", {"':' behind the message's name"}},
        {"BO_ 257 " + std::string(129, 'x') + ": 8 A\n", {"at most 128"}},
    };
    for (const Case& c : cases) {
        const Result<DbcFile> file = parsed(head + kept + c.line + more);
        ASSERT_TRUE(file) << c.line << file.error().text;
        ASSERT_EQ(file->warnings.size(), 1U) << c.line;
        EXPECT_TRUE(file->warnings[0].english().starts_with("f.dbc: line 5: "))
            << file->warnings[0].english();
        for (const std::string_view part : c.parts)
            EXPECT_NE(file->warnings[0].english().find(part), std::string::npos)
                << "no " << part << " in " << file->warnings[0].english();
        ASSERT_EQ(file->messages.size(), 2U) << c.line;
        const bool isLost = c.line.starts_with("SIG_VALTYPE_");
        EXPECT_EQ(file->messages[0].payload.size(), isLost ? 0U : 1U) << c.line;
        EXPECT_EQ(file->messages[1].payload.size(), 1U) << c.line;
    }
}

TEST(DbcFiles, withAQuoteThatDoesNotEndKeepTheRest)
{
    const Result<DbcFile> file = parsed("BO_ 256 M: 8 A\nCM_ BO_ 256 \"no end;\nBO_ 257 N: 8 A\n");
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->messages.size(), 2U);
    ASSERT_EQ(file->warnings.size(), 1U);
    EXPECT_TRUE(file->warnings[0].english().starts_with("f.dbc: line 2: expected a quotation mark"))
        << file->warnings[0].english();
}

TEST(DbcFiles, skipOtherSectionsSilently)
{
    const std::string text = "// made by hand\nVERSION \"\"\nBO_ 256 M: 8 A // its message\n"
                             "// BO_ 257 Not: 8 A\n"
                             " SG_ S : 0|8@1+ (1,0) [-1e400|1e400] \"\" B\n"
                             " SG_ T : 8|8@1+ (1,0) [] \"\" B\n"
                             "BO_ 1073741824 VECTOR__INDEPENDENT_SIG_MSG: 0 Vector__XXX\n"
                             " SG_ Orphan : 0|8@1+ (1,0) [0|0] \"\" B\n"
                             "BO_ 258 N: 8\n\x1A";
    const Result<DbcFile> file = parsed(text);
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_TRUE(file->warnings.empty()) << file->warnings.front().english();
    ASSERT_EQ(file->messages.size(), 2U);
    EXPECT_EQ(file->messages[0].payload.size(), 2U);
    EXPECT_EQ(file->messages[0].payload[0].most, 0.0) << "no range";
    EXPECT_EQ(file->messages[1].name, "N") << "without a sender";
}

TEST(DbcFiles, withoutAMessageAreRefusedWithTheFirstCause)
{
    struct Case {
        std::string text;
        std::vector<std::string_view> parts;
    };
    const std::vector<Case> cases{
        {"time,id,data\n0.1,22,AA\n", {"no message", "line 1", "keyword of a section", "'time'"}},
        {"VERSION \"\"\n SG_ S : 0|8@1+ (1,0) [0|0] \"\" B\n",
         {"no message", "line 2", "a message (BO_) before"}},
        {"VERSION \"\"\n", {"no message", "is it a DBC file?"}},
        {"", {"no message"}},
        {std::string("BO_\0", 4), {"no text", "save it again as one"}},
        {std::string("\xFF\xFE"
                     "B\0O\0_\0 \0",
                     10),
         {"is text in UTF-16: save it as UTF-8"}},
    };
    for (const Case& c : cases) {
        const Result<DbcFile> file = parsed(c.text);
        EXPECT_TRUE(refused(file, "f.dbc", {})) << c.text;
        if (file) continue;
        for (const std::string_view part : c.parts)
            EXPECT_NE(file.error().text.find(part), std::string::npos)
                << "no " << part << " in " << file.error().text;
    }
}

TEST(DbcFiles, thatCannotBeReadNameTheFile)
{
    const TemporaryDirectory directory;
    EXPECT_TRUE(refused(readDbc(directory.file("none.dbc")), directory.file("none.dbc"),
                        {"cannot be opened"}));
    EXPECT_TRUE(refused(readDbc(directory.file("")), directory.file(""), {"cannot be read"}));
    const std::string big = directory.write("big.dbc", std::string(kMaxDbcBytes + 1, ' '));
    EXPECT_TRUE(refused(readDbc(big), big, {"larger"}));
}

TEST(DbcFiles, largeFilesAreReadWithFewWarnings)
{
    std::string text;
    for (int i = 0; i < 20'000; ++i)
        text += "BO_ " + std::to_string(2147483648U + static_cast<unsigned>(i)) + " M: 8 A\n"
              + " SG_ S : 0|8@1+ (0,0) [0|0] \"\" B\n";
    text += "BO_ 1 Wide: 8 A\n" + multiplexedSignals(DbcMessage::kMaxSignals);
    for (std::size_t i = 0; i < DbcMessage::kMaxSignals; ++i)
        text += "VAL_ 1 S" + std::to_string(i) + " 1 \"one\" ;\n";
    const Result<DbcFile> file = parsed(text);
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->messages.size(), 20'001U);
    EXPECT_EQ(file->messages.back().payload.back().words.at(1), "one");
    EXPECT_EQ(file->warnings.size(), 21U);
    const std::string last = file->warnings.back().english();
    EXPECT_TRUE(last.starts_with("f.dbc: 19980 more things are left out, in lines 42, 44, "))
        << last;
    EXPECT_TRUE(last.ends_with(", 138, 140, …")) << last;
}

TEST(DbcFiles, damagedFilesOnlyGiveErrors)
{
    const std::string whole = kForeign;
    std::mt19937_64 rng(3);
    for (std::size_t i = 0; i < 4000; ++i) {
        std::string text = whole;
        if (i < whole.size())
            text.resize(i);
        else
            for (int k = 0; k < 4; ++k) text[rng() % text.size()] = "\"; \n:|@M0_9\x80"[rng() % 12];
        const Result<DbcFile> file = parsed(text);
        if (!file) {
            ASSERT_TRUE(refused(file, "f.dbc", {}));
            continue;
        }
        for (const DbcMessage& m : file->messages)
            for (const DbcSignal& s : m.payload) {
                ASSERT_GE(s.length, 1);
                ASSERT_LE(s.length, 64);
                ASSERT_LE(s.end(), 8 * m.length);
            }
    }
}

TEST(DbcFile, aUnitThatDoesNotEndTakesNoOtherSignalAway)
{
    const auto file = parsed("BO_ 256 M: 8 A\n SG_ Q : 0|8@1+ (1,0) [0|0] \"km/h A\n"
                             " SG_ R : 0|8@1+ (1,0) [0|0] \"\" A\n");
    ASSERT_TRUE(file);
    ASSERT_EQ(file->messages.at(0).payload.size(), 1U);
    EXPECT_EQ(file->messages[0].payload[0].name, "R");
    ASSERT_EQ(file->warnings.size(), 1U);
    EXPECT_TRUE(
        file->warnings[0].english().starts_with("f.dbc: line 2: expected a quotation mark"));
}

TEST(DbcFile, readsAZeroByteAsABlankWithItsLine)
{
    std::string text = "BO_ 256 M: 8 A\n SG_ Q : 0|8@1+ (1,0) [0|0] \"\" A\n"
                       "CM_ SG_ 256 Q \"of~air\";\nBO_ 257~N: 8 A\n"
                       " SG_ R~R : 0|8@1+ (1,0) [0|0] \"\" A\n";
    std::replace(text.begin(), text.end(), '~', '\0');
    const auto file = parsed(text);
    ASSERT_TRUE(file) << file.error().text;
    ASSERT_EQ(file->messages.size(), 2U);
    EXPECT_EQ(file->messages[0].payload.at(0).comment, "of air");
    EXPECT_TRUE(file->messages[1].payload.empty()) << "its name is damaged";
    ASSERT_EQ(file->warnings.size(), 4U);
    EXPECT_EQ(file->warnings[0].english(),
              "f.dbc: line 3: has zero bytes, which are read as blanks");
    EXPECT_TRUE(refused(parsed(text + std::string(100, '\0')), "f.dbc", {"is no text"}));
}

TEST(DbcFile, linesMayEndWithCrAlone)
{
    const auto file = parsed("BO_ 256 M: 8 A\r SG_ Q : 0|8@1+ (1,0) [0|0] \"\" A\r");
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->messages.at(0).payload.size(), 1U);
}

TEST(DbcFile, remarksWhereTheCodePageIsAGuess)
{
    const auto warnings = [](const std::string& unit) {
        const auto file =
            parsed("BO_ 256 M: 8 A\n SG_ Q : 0|8@1+ (1,0) [0|0] \"" + unit + "\" A\n");
        EXPECT_TRUE(file);
        return file->warnings.size();
    };
    EXPECT_EQ(warnings("\xB0"
                       "C m/s\xB2 gr\xF6\xDF"
                       "er"),
              0U);
    EXPECT_EQ(warnings("p\xF8\xEDli\x9A"), 1U) << "Windows code page 1250";
}

}  // namespace
}  // namespace terratact
