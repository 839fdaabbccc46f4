// Tests DBC descriptions of frames outside the robot's protocol.
#include "app/link/dbc_book.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>

#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const char* const kGas = "BO_ 291 Gas: 8 Payload\n SG_ Oxygen : 0|16@1- (0.01,0) [0|25] \"%\" C\n"
                         " SG_ State : 16|2@1+ (1,0) [0|0] \"\" C\n"
                         "VAL_ 291 State 1 \"stand-by\" ;\n";

struct Books : testing::Test {
    std::string write(const std::string& name, const std::string& text) const
    {
        return directory.write(name, text);
    }
    static CanFrame gas(std::uint32_t id = 291, bool extended = false)
    {
        return {.id = id, .extended = extended, .length = 3, .data = {0x17, 0x08, 1}};
    }
    TemporaryDirectory directory;
    DbcBook book;
};

TEST_F(Books, findTheFramesOfTheirFiles)
{
    ASSERT_TRUE(book.add(write("gas.dbc", kGas)));
    const auto found = book.find(gas());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->message.name, "Gas");
    EXPECT_EQ(found->file, "gas.dbc");
    const std::vector<NamedValue> expected{{"Oxygen", "20.71", "%"}, {"State", "stand-by", ""}};
    EXPECT_EQ(valuesOf(found->message, gas()), expected);
    EXPECT_FALSE(book.find(gas(291, true))) << "29 bits are another";
    EXPECT_FALSE(book.find(gas(292)));
    CanFrame remote = gas();
    remote.remote = true;
    EXPECT_FALSE(book.find(remote));
    EXPECT_EQ(book.files().at(0).frames, 1U);
    EXPECT_TRUE(book.remarks().empty());
}

TEST_F(Books, giveNamesWithoutDecodingValues)
{
    ASSERT_TRUE(book.add(write("gas.dbc", kGas)));
    const auto reader = frameReader(CanProtocol::Terratact, std::make_shared<const DbcBook>(book),
                                    FrameDepth::Name);
    const FrameWords words = reader->read(gas(), 0.0);
    EXPECT_EQ(words.name, "Gas");
    EXPECT_EQ(words.trouble, FrameTrouble::None);
    EXPECT_TRUE(words.values.empty());
}

TEST_F(Books, neverOverrideTheProtocol)
{
    const std::string path =
        write("clash.dbc", "BO_ 34 A: 8 X\nBO_ 2147483682 B: 8 X\nBO_ 519 C: 8 X\n");
    ASSERT_TRUE(book.add(path));
    EXPECT_FALSE(book.find(gas(0x22)));
    EXPECT_TRUE(book.find(gas(0x22, true))) << "ours have 11 bits";
    EXPECT_TRUE(book.find(gas(519)));
    ASSERT_EQ(book.remarks().size(), 1U);
    EXPECT_EQ(book.remarks()[0].english(),
              path + ": frame 022: ignored; the robot's protocol already uses this identifier");

    DbcBook absolem(CanProtocol::Absolem);
    ASSERT_TRUE(absolem.add(write("elmo.dbc", "BO_ 34 A: 8 X\nBO_ 647 C: 8 X\n")));
    EXPECT_TRUE(absolem.find(gas(0x22)));
    EXPECT_FALSE(absolem.find(gas(0x287))) << "the front left flipper's reply";
}

TEST_F(Books, doNotDescribeFramesOfTheProtocol)
{
    const std::string path = TERRATACT_SOURCE_DIR "/resources/dbc/terratact.dbc";
    ASSERT_TRUE(book.add(path));
    EXPECT_EQ(book.frames(), 0U);
    ASSERT_EQ(book.remarks().size(), 1U);
    EXPECT_EQ(book.remarks()[0].english(),
              path
                  + ": 30 frames (010, 011, 012, 013 …): ignored; the robot's protocol "
                    "already uses this identifier");
}

TEST_F(Books, letTheFirstOfTwoFilesCount)
{
    ASSERT_TRUE(book.add(write("one.dbc", kGas)));
    const std::string two = write("two.dbc", "BO_ 291 Other: 8 X\nBO_ 292 More: 8 X\n");
    ASSERT_TRUE(book.add(two));
    EXPECT_EQ(book.find(gas())->message.name, "Gas");
    EXPECT_EQ(book.find(gas(292))->file, "two.dbc");
    ASSERT_EQ(book.remarks().size(), 1U);
    EXPECT_EQ(book.remarks()[0].english(),
              two + ": frame 123: ignored; one.dbc already describes it");
}

TEST_F(Books, stayAsTheyWereWhenAFileCannotBeUsed)
{
    ASSERT_TRUE(book.add(write("gas.dbc", kGas)));
    const std::string bad = write("bad.dbc", "VERSION \"\"\n SG_ S : 4|8@1+ (1,0) [0|0] \"\" C\n");
    EXPECT_TRUE(refused(book.add(bad), bad, {"line 2", "expected a message"}));
    const std::string pipe = directory.file("pipe.dbc");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_TRUE(refused(book.add(pipe), pipe, {"no regular file"})) << "nobody waits for a pipe";
    EXPECT_TRUE(refused(book.add(directory.file("")), directory.file(""), {"cannot be read"}));
    EXPECT_EQ(book.frames(), 1U);
    EXPECT_EQ(book.files().size(), 1U);
    EXPECT_FALSE(readDbcBook(CanProtocol::Terratact, {bad}));
    EXPECT_FALSE(*readDbcBook(CanProtocol::Terratact, {})) << "none";
}

TEST_F(Books, findParameterGroupsFromAnySource)
{
    ASSERT_TRUE(book.add(write("j.dbc", "BO_ 2364540158 EEC1: 8 X\n"
                                        " SG_ Speed : 24|16@1+ (0.125,0) [0|0] \"rpm\" X\n"
                                        "BO_ 2364540159 Own: 8 X\n"
                                        "BA_ \"VFrameFormat\" BO_ 2364540158 3;\n")));
    const auto reader = frameReader(CanProtocol::Terratact, std::make_shared<const DbcBook>(book));
    CanFrame frame{.id = 0x18F00403, .extended = true, .length = 8, .data = {0, 0, 0, 0x68, 0x13}};
    FrameWords words = reader->read(frame, 0.0);
    EXPECT_EQ(words.name, "EEC1");
    EXPECT_EQ(words.verdict, "by j.dbc, source address 0x03");
    EXPECT_EQ(wordsOf(words.values), "Speed 621.000 rpm");
    frame.id = 0x0CF004FF;
    EXPECT_EQ(reader->read(frame, 0.0).name, "Own") << "the very identifier comes first";
    frame.id = 0x0CF00500;
    EXPECT_EQ(reader->read(frame, 0.0).verdict, "extended frame");
    frame.remote = true;
    EXPECT_EQ(reader->read(frame, 0.0).verdict, "extended remote frame");
    frame = {.id = 0x700, .fd = true, .length = 12};
    EXPECT_EQ(reader->read(frame, 0.0).verdict, "CAN FD frame");
}

TEST_F(Books, preferTheParameterGroupOfTheFramesSource)
{
    const std::string any = "BO_ 2364540158 EEC1: 8 X\n", gearbox = "BO_ 2364539907 Gearbox: 8 X\n",
                      last = "BO_ 2364539908 Last: 8 X\nBA_ \"ProtocolType\" \"J1939\";\n";
    for (const std::string& text : {any + gearbox + last, gearbox + any + last}) {
        DbcBook groups;
        ASSERT_TRUE(groups.add(write("j.dbc", text)));
        const auto nameOf = [&](std::uint32_t id) {
            return groups.find(gas(id, true))->message.name;
        };
        EXPECT_EQ(nameOf(0x0CF00403), "Gearbox");
        EXPECT_EQ(nameOf(0x04F00403), "Gearbox") << "another priority";
        EXPECT_EQ(nameOf(0x18F00404), "Last");
        EXPECT_EQ(nameOf(0x04F00405), "EEC1") << "of no described source";
    }
    ASSERT_TRUE(book.add(write("k.dbc", gearbox + last)));
    EXPECT_EQ(book.find(gas(0x04F00405, true))->message.name, "Gearbox") << "the first";
}

TEST_F(Books, showTheNumberForABlankWord)
{
    ASSERT_TRUE(book.add(write("gas.dbc", std::string(kGas) + "VAL_ 291 Oxygen 2071 \"\" ;\n")));
    const std::vector<NamedValue> expected{{"Oxygen", "20.71", "%"}, {"State", "stand-by", ""}};
    EXPECT_EQ(valuesOf(book.find(gas())->message, gas()), expected);
}

TEST_F(Books, nameTheSignalsThatAShortFrameLacks)
{
    ASSERT_TRUE(book.add(write("fd.dbc", "BO_ 1291 Fd: 64 X\n"
                                         " SG_ First : 0|16@1+ (1,0) [0|0] \"\" X\n"
                                         " SG_ Last : 496|16@1+ (1,0) [0|0] \"\" X\n")));
    const auto reader = frameReader(CanProtocol::Terratact, std::make_shared<const DbcBook>(book));
    CanFrame frame{.id = 1291, .fd = true, .length = 64, .data = {1, 1}};
    EXPECT_EQ(wordsOf(reader->read(frame, 0.0).values), "First 257, Last 0");
    frame.isCut = true;
    EXPECT_EQ(reader->read(frame, 0.0).verdict,
              "by fd.dbc, cut before it was stored, too short for Last");
    frame.isCut = false;
    frame.length = 8;
    EXPECT_EQ(reader->read(frame, 0.0).verdict, "by fd.dbc, too short for Last");
}

TEST(DbcNumbers, haveTheDigitsOfTheirScale)
{
    const auto text = [](double scale, double offset, double value,
                         DbcSignal::Type type = DbcSignal::Type::Unsigned) {
        DbcSignal s;
        s.scale = scale;
        s.offset = offset;
        s.type = type;
        return wordOrNumber(s, value);
    };
    EXPECT_EQ(text(1.0, 0.0, 7.0), "7");
    EXPECT_EQ(text(10.0, 0.0, 70.0), "70");
    EXPECT_EQ(text(0.25, 0.0, 0.75), "0.75");
    EXPECT_EQ(text(-0.1, 0.0, -0.0), "0.0");
    EXPECT_EQ(text(1.0, -273.15, 20.0 - 273.15), "-253.15");
    EXPECT_EQ(text(1.0 / 256.0, 0.0, 3.0 / 256.0), "0.0117");
    EXPECT_EQ(text(1e-12, 0.0, 3e-12), "3e-12");
    EXPECT_EQ(text(1.0, 0.0, 1.8446744073709552e19), "18446744073709551616");
    EXPECT_EQ(text(1e9, 0.0, 1.8446744073709552e28), "1.844674e+28");
    EXPECT_EQ(text(1.0, 0.0, std::nan(""), DbcSignal::Type::Double), "nan");
    EXPECT_EQ(text(1.0, 0.0, 1.5, DbcSignal::Type::Float), "1.5");
    EXPECT_EQ(text(1.0, 0.0, 1.0 / 3.0, DbcSignal::Type::Double), "0.3333333");
}

}  // namespace
}  // namespace terratact
