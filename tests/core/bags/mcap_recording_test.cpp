// Tests the reader of MCAP files on files written from the specification.
#include "core/bags/mcap_recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/bags/decompress.h"
#include "tests/support/bytes/mcap_bytes.h"
#include "tests/support/refusal.h"
#include "tests/support/sessions/read_recording.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct McapFiles : testing::Test {
    std::string path(const std::string& content) { return directory.write("a.mcap", content); }

    ReadRecording read(const std::string& content,
                       const std::optional<std::set<std::string>>& topics = {})
    {
        return readRecording(path(content), topics);
    }

    static std::string number(double value) { return MessageBytes::cdr().add(value).bytes(); }

    static McapBytes begun()
    {
        McapBytes mcap;
        mcap.schema(1, "std_msgs/msg/Float64", "ros2msg", "float64 data\n");
        mcap.channel(1, 1, "/a", "cdr").channel(2, 1, "/b", "cdr");
        return mcap;
    }

    static McapBytes someMessages()
    {
        McapBytes mcap = begun();
        mcap.message(1, 5, number(1.5)).message(2, 7, number(2.5)).message(1, 6, number(3.5));
        return mcap;
    }

    const std::vector<std::string> all{"/a 5 1.500000", "/b 7 2.500000", "/a 6 3.500000"};
    TemporaryDirectory directory;
};

TEST_F(McapFiles, chunksOfEveryCompressionAreRead)
{
    EXPECT_EQ(read(someMessages().file()).messages, all) << "no chunks";
    for (const char* const method : {"", "lz4", "zstd"})
        EXPECT_EQ(read(someMessages().chunk(method).file()).messages, all) << method;
    EXPECT_EQ(read(someMessages().chunk("lz4").file(), {{"/b"}}).messages,
              std::vector<std::string>{"/b 7 2.500000"});
}

TEST_F(McapFiles, aTornFileIsReadAsFarAsItGoes)
{
    McapBytes mcap = someMessages().chunk("zstd");
    const std::size_t whole = mcap.torn().size();
    mcap.message(1, 9, number(9.0));
    for (std::size_t n = whole; n < mcap.torn().size(); ++n) {
        const ReadRecording found = read(mcap.torn().substr(0, n));
        EXPECT_EQ(found.messages, all) << n;
        EXPECT_EQ(found.remarks.size(), n == whole ? 1U : 2U) << "no index; the cut record";
    }
    EXPECT_EQ(read(mcap.torn()).messages.size(), 4U);
}

TEST_F(McapFiles, joinedFilesAreReadUpToTheFirstEnd)
{
    const std::string one = someMessages().chunk("lz4").file();
    const ReadRecording found = read(one + one);
    EXPECT_EQ(found.messages, all);
    ASSERT_FALSE(found.remarks.empty());
    EXPECT_NE(found.remarks.back().find(std::to_string(one.size()) + " bytes behind it"),
              std::string::npos)
        << found.remarks.back();
}

TEST_F(McapFiles, aDamagedChunkIsLeftOut)
{
    const auto reason = [&](const McapBytes& mcap) {
        McapBytes more = mcap;
        more.message(1, 9, number(9.0));
        const ReadRecording found = read(more.file());
        EXPECT_EQ(found.messages.size(), 0U) << "the channels were in the chunk";
        return found.remarks.size() > 1 ? found.remarks[1] : "";
    };
    EXPECT_NE(reason(someMessages().chunk("", 1)).find("wrong checksum; it is left out"),
              std::string::npos);
    EXPECT_NE(reason(someMessages().chunk("lzma")).find("expected none, lz4, zstd or bz2"),
              std::string::npos);
    std::string bytes = someMessages().chunk("zstd").torn();
    bytes[bytes.size() - 9] = static_cast<char>(bytes[bytes.size() - 9] ^ 0x55);
    EXPECT_EQ(read(bytes).messages.size(), 0U);
}

TEST_F(McapFiles, sizesThatAreDeclaredCostNothing)
{
    auto head = MessageBytes::ros1();
    head.add(std::uint8_t{0x06}).add(std::uint64_t{1} << 60U);
    const ReadRecording huge = read(someMessages().torn() + head.bytes());
    EXPECT_EQ(huge.messages, all);
    EXPECT_NE(huge.remarks.back().find("ends within the record at byte"), std::string::npos);
    // Zeros compress well: 80 MB in a few kilobytes are refused.
    const std::string zeros(std::size_t{80} << 20U, '\0');
    std::string packed(ZSTD_compressBound(zeros.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), zeros.data(), zeros.size(), 1));
    std::string out;
    const Status refused = decompress("zstd", packed, out);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text.find("is larger than 16777216 bytes"), std::string::npos);
    EXPECT_LE(out.size(), kSmallChunkBytes);
}

TEST_F(McapFiles, wrongDefinitionsNameFileTopicAndPlace)
{
    McapBytes mcap;
    mcap.schema(1, "p/msg/T", "ros2msg", "float64[] data\n").channel(1, 1, "/a", "cdr");
    mcap.message(1, 5, number(2.3));
    auto recording = openRecording(path(mcap.file()));
    ASSERT_TRUE(recording);
    RecordedMessage message;
    ASSERT_TRUE(*(*recording)->next(message));
    const auto value = (*recording)->decode(message);
    ASSERT_FALSE(value);
    EXPECT_EQ(
        value.error().text.find(directory.file("a.mcap") + ": topic /a: the message at byte "), 0U);
    EXPECT_NE(value.error().text.find("member 'data'"), std::string::npos) << value.error().text;
}

TEST_F(McapFiles, longNamesOfTopicsAreCut)
{
    McapBytes mcap;
    mcap.schema(1, std::string(1000, 't'), "jsonschema", "{}");
    mcap.channel(1, 1, "/" + std::string(1000, 'n'), "json").message(1, 5, "1");
    const auto recording = openRecording(path(mcap.file()));
    ASSERT_TRUE(recording);
    RecordedMessage message;
    ASSERT_TRUE(*(*recording)->next(message));
    EXPECT_EQ((*recording)->topics().at(0).name, "/" + std::string(kMaxTopicName - 1, 'n') + "…");
    EXPECT_EQ((*recording)->topics().at(0).type, std::string(kMaxTopicName, 't') + "…");
}

TEST_F(McapFiles, aDefinitionThatIsTooLargeCostsItsTopic)
{
    McapBytes mcap = begun();
    mcap.schema(2, "p/msg/T", "ros2msg", std::string(MessageSchema::kMaxText + 1, ' '));
    mcap.schema(3, "p/msg/T", "jsonschema", std::string(MessageSchema::kMaxText + 1, ' '));
    mcap.channel(3, 2, "/c", "cdr").channel(4, 3, "/d", "json");
    mcap.message(1, 5, number(1.5)).message(3, 6, number(2.5)).message(4, 7, R"({"data":3.5})");
    const ReadRecording found = read(mcap.chunk("zstd").file());
    ASSERT_EQ(found.messages.size(), 3U);
    EXPECT_EQ(found.messages[0], "/a 5 1.500000");
    EXPECT_NE(found.messages[1].find("topic /c: the definition of p/msg/T has 1048577 bytes"),
              std::string::npos)
        << found.messages[1];
    EXPECT_EQ(found.messages[2], "/d 7 3.500000") << "it needs none";
    ASSERT_EQ(found.remarks.size(), 2U) << "no index; the definition that would be decoded";
    EXPECT_NE(found.remarks[1].find("the definition of p/msg/T has 1048577 bytes"),
              std::string::npos)
        << found.remarks[1];
}

TEST_F(McapFiles, aCommonTypeIsNotDecodedByAnotherDefinition)
{
    const std::string tooLong(MessageSchema::kMaxText + 1, ' '), longer = tooLong + ' ';
    McapBytes mcap = begun();
    mcap.schema(2, "std_msgs/msg/Float64", "ros2msg", tooLong).channel(3, 2, "/c", "cdr");
    mcap.schema(3, "std_msgs/msg/Float64", "ros2msg", longer).channel(4, 3, "/d", "cdr");
    mcap.schema(4, "std_msgs/msg/Float64", "", "").channel(5, 4, "/e", "cdr");
    for (std::uint16_t channel = 3; channel <= 5; ++channel) mcap.message(channel, 6, number(2.5));
    const ReadRecording found = read(mcap.chunk("zstd").file());
    ASSERT_EQ(found.messages.size(), 3U);
    EXPECT_NE(found.messages[0].find("topic /c: the definition of std_msgs/msg/Float64 has 1048577 "
                                     "bytes, more than 1048576; it is left out. Record fewer"),
              std::string::npos)
        << found.messages[0];
    EXPECT_NE(found.messages[1].find("/d: the definition of std_msgs/msg/Float64 has 1048578"),
              std::string::npos)
        << found.messages[1];
    EXPECT_EQ(found.messages[2], "/e 6 2.500000") << "the file has no definition of it";
}

TEST_F(McapFiles, anUnreadDefinitionOfACommonTypeIsRemarked)
{
    McapBytes mcap = begun();
    mcap.schema(2, "std_msgs/msg/Float64", "ros2idl", "module std_msgs").channel(3, 2, "/c", "cdr");
    mcap.schema(3, "std_msgs/msg/Float64", "ros2msg", "").channel(4, 3, "/d", "cdr");
    mcap.message(1, 5, number(1.5)).message(3, 6, number(2.5)).message(4, 7, number(3.5));
    const ReadRecording found = read(mcap.file());
    EXPECT_EQ(found.messages,
              (std::vector<std::string>{"/a 5 1.500000", "/c 6 2.500000", "/d 7 3.500000"}));
    const std::string remark = "the definition of std_msgs/msg/Float64 has the encoding 'ros2idl', "
                               "which is not read; the shipped definition of this type was used";
    EXPECT_EQ(std::ranges::count(found.remarks, remark), 1);
    for (const std::string& other : found.remarks)
        EXPECT_TRUE(other == remark || other.find("shipped") == std::string::npos) << other;
}

TEST_F(McapFiles, decodersHaveABoundedNumberOfFields)
{
    constexpr std::uint16_t kDefinitions = 11;
    std::string fields;
    for (int i = 0; i < 9990; ++i) fields += "bool a\n";
    McapBytes mcap;
    for (std::uint16_t i = 1; i <= kDefinitions; ++i) {
        mcap.schema(i, "p/msg/T" + std::to_string(i), "ros2msg", fields);
        mcap.channel(i, i, "/" + std::to_string(i), "cdr").message(i, 5, "");
    }
    const ReadRecording found = read(mcap.file());
    ASSERT_EQ(found.messages.size(), std::size_t{kDefinitions});
    for (std::size_t i = 0; i < kDefinitions; ++i)
        EXPECT_EQ(found.messages[i].find("more than 100000 structs and fields")
                      != std::string::npos,
                  i + 1 == kDefinitions)
            << found.messages[i];
}

TEST_F(McapFiles, messagesOfUnknownChannelsAreLeftOut)
{
    McapBytes mcap = begun();
    mcap.message(77, 5, number(1.5))
        .message(1, ~std::uint64_t{0}, number(1.0))
        .message(1, 6, number(2.0));
    const ReadRecording found = read(mcap.file());
    EXPECT_EQ(found.messages, std::vector<std::string>{"/a 6 2.000000"});
    EXPECT_EQ(found.remarks.size(), 3U);
}

TEST_F(McapFiles, filesThatAreNoRecordingAreNamed)
{
    const auto refuses = [&](const std::string& name, const std::string& content,
                             std::initializer_list<std::string_view> parts) {
        const std::string file = directory.write(name, content);
        return refused(openRecording(file), file, parts);
    };
    EXPECT_TRUE(refuses("a.mcap", "", {"is empty", "expected MCAP", "copy"}));
    EXPECT_TRUE(refuses("a.mcap", "<!DOCTYPE html>", {"begins with '<!DOCTYPE", "expected MCAP"}));
    EXPECT_TRUE(refuses("a.mcap", "\x89MCAP1\r\n and more", {"another version, '1'"}));
    EXPECT_TRUE(refuses("a.mcap.zst", "\x28\xb5\x2f\xfd more", {"unpack", "zstd -d"}));
    EXPECT_TRUE(refuses("a.bag.bz2", "BZh91AY", {"unpack", "bzip2 -d"}));
    EXPECT_TRUE(
        refused(openRecording(directory.file("")), directory.file(""), {"is a folder", "a.mcap"}));
    EXPECT_TRUE(openRecording(directory.write("csv.bag", "t,x\n1,2\n"))) << "the content counts";
}

TEST(Decompress, everyCutIsRefused)
{
    const std::string plain(1000, 'x');
    std::string lz4(LZ4F_compressFrameBound(plain.size(), nullptr), '\0');
    lz4.resize(LZ4F_compressFrame(lz4.data(), lz4.size(), plain.data(), plain.size(), nullptr));
    std::string out;
    ASSERT_TRUE(decompress("lz4", lz4, out));
    EXPECT_EQ(out, plain);
    for (std::size_t n = 0; n < lz4.size(); ++n)
        EXPECT_FALSE(decompress("lz4", std::string_view(lz4).substr(0, n), out)) << n;
}

TEST(Decompress, aSmallRecordingUnpacksToABoundedSize)
{
    const std::string chunk = packed("zstd", std::string(8U << 20U, 'x'));
    ChunkUnpacker unpacker(10'000);
    std::string into;
    for (std::uint64_t bytes = 0; bytes < ChunkUnpacker::kSmallRecordingBytes; bytes += into.size())
        ASSERT_TRUE(unpacker.unpack("zstd", chunk, into));
    for (int i = 0; i < 2; ++i) {
        const Status done = unpacker.unpack("zstd", chunk, into);
        ASSERT_FALSE(done);
        EXPECT_EQ(done.error().text,
                  "is beyond the 67108864 bytes that this recording may expand to");
        EXPECT_TRUE(into.empty());
    }
    ChunkUnpacker large(1'000'000'000);
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(large.unpack("zstd", chunk, into));
}

TEST(Decompress, fullPiecesOfEveryMethodAreWhole)
{
    for (const char* const method : {"lz4", "zstd", "bz2"})
        for (const std::size_t pieces : {1U, 2U, 16U}) {
            const std::string plain(pieces * 65'536, 'x');  // as the buffer
            std::string out;
            EXPECT_TRUE(decompress(method, packed(method, plain), out)) << method << pieces;
            EXPECT_EQ(out, plain) << method << pieces;
        }
}

}  // namespace
}  // namespace terratact
