// Tests the reader of ROS 1 bags on files written from the description of the format.
#include "core/bags/bag_recording.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/bytes/bag_bytes.h"
#include "tests/support/sessions/read_recording.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct BagFiles : testing::Test {
    ReadRecording read(const std::string& content,
                       const std::optional<std::set<std::string>>& topics = {})
    {
        return readRecording(directory.write("a.bag", content), topics);
    }

    static std::string number(double value) { return MessageBytes::ros1().add(value).bytes(); }

    static BagBytes someMessages()
    {
        BagBytes bag;
        bag.connection(0, "/a", "std_msgs/Float64", "float64 data\n")
            .connection(1, "/b", "std_msgs/Float64", "float64 data\n");
        bag.message(0, 5, 1, number(1.5)).message(1, 7, 0, number(2.5));
        return bag;
    }

    const std::vector<std::string> all{"/a 5000000001 1.500000", "/b 7000000000 2.500000"};
    TemporaryDirectory directory;
};

TEST_F(BagFiles, chunksOfEveryCompressionAreRead)
{
    for (const char* const method : {"none", "bz2", "lz4"}) {
        const ReadRecording found = read(someMessages().chunk(method).index({0, 1}).bytes());
        EXPECT_EQ(found.messages, all) << method;
        EXPECT_TRUE(found.remarks.empty()) << method;
    }
    EXPECT_EQ(read(someMessages().bytes()).messages, all) << "no chunk, no index";
}

TEST_F(BagFiles, theIndexSkipsChunks)
{
    // The index claims that the chunk has only /a: a reader of /b trusts it.
    const std::string bag = someMessages().chunk("bz2").index({0}).bytes();
    EXPECT_TRUE(read(bag, {{"/b"}}).messages.empty());
    EXPECT_EQ(read(bag, {{"/a"}}).messages, std::vector<std::string>{all[0]});
    const auto recording = openRecording(directory.write("b.bag", bag));
    EXPECT_EQ((*recording)->topics().at(0).messages, 1U);
}

TEST_F(BagFiles, aTornFileIsReadAsFarAsItGoes)
{
    const std::string one = someMessages().chunk("lz4").bytes();
    const std::string two = someMessages().chunk("lz4").message(0, 9, 0, number(9.0)).bytes();
    for (std::size_t n = one.size(); n < two.size(); ++n) {
        const ReadRecording found = read(two.substr(0, n));
        EXPECT_EQ(found.messages, all) << n;
        EXPECT_EQ(found.remarks.size(), n == one.size() ? 1U : 2U) << "no index; the cut record";
    }
    EXPECT_EQ(read(two).messages.size(), 3U);
    const std::string indexed = someMessages().chunk("bz2").index({0, 1}).bytes();
    for (std::size_t n = one.size(); n < indexed.size(); n += 7) read(indexed.substr(0, n));
}

TEST_F(BagFiles, damagedChunksAndMessagesAreLeftOut)
{
    const ReadRecording unknown = read(someMessages().chunk("zip").bytes());
    EXPECT_TRUE(unknown.messages.empty());
    EXPECT_NE(unknown.remarks.back().find(
                  "has the compression 'zip', expected none, lz4, zstd or bz2; it is left out"),
              std::string::npos);
    BagBytes stray = someMessages();
    EXPECT_EQ(read(stray.message(77, 1, 0, "x").bytes()).messages, all);
    auto huge = MessageBytes::ros1();
    huge.add(0xFFFFFFFFU);
    EXPECT_EQ(read(someMessages().bytes() + huge.bytes()).messages, all);
}

TEST_F(BagFiles, aDefinitionThatIsTooLargeCostsItsTopic)
{
    BagBytes bag = someMessages();
    bag.connection(2, "/" + std::string(1000, 'n'), "p/T",
                   std::string(MessageSchema::kMaxText + 1, ' '));
    bag.message(2, 8, 0, number(3.5));
    bag.connection(3, "/c", "std_msgs/Float64", std::string(MessageSchema::kMaxText + 1, ' '));
    bag.message(3, 9, 0, number(4.5));
    const ReadRecording found = read(bag.chunk("bz2").bytes());
    ASSERT_EQ(found.messages.size(), 4U);
    EXPECT_EQ(found.messages[0], all[0]);
    EXPECT_EQ(found.messages[1], all[1]);
    EXPECT_EQ(found.messages[2].find("/" + std::string(kMaxTopicName - 1, 'n') + "… 8"), 0U)
        << found.messages[2];
    EXPECT_NE(found.messages[2].find("the definition of p/T has 1048577 bytes"), std::string::npos)
        << found.messages[2];
    EXPECT_NE(found.messages[3].find("the definition of std_msgs/Float64 has 1048577 bytes"),
              std::string::npos)
        << "a common type is not decoded by another definition: " << found.messages[3];
    ASSERT_EQ(found.remarks.size(), 3U) << "no index; the definitions";
    EXPECT_NE(found.remarks[1].find("the definition of p/T has 1048577 bytes"), std::string::npos)
        << found.remarks[1];
}

TEST_F(BagFiles, anEmptyDefinitionIsNone)
{
    BagBytes bag = someMessages();
    bag.connection(2, "/c", "std_msgs/Float64", "");
    bag.message(2, 9, 0, number(4.5));
    const ReadRecording found = read(bag.chunk("bz2").bytes());
    ASSERT_EQ(found.messages.size(), 3U);
    EXPECT_EQ(found.messages[2], "/c 9000000000 4.500000");
    for (const std::string& remark : found.remarks)
        EXPECT_EQ(remark.find("shipped"), std::string::npos) << remark;
}

TEST_F(BagFiles, otherVersionsAreNamed)
{
    const auto opened = openRecording(directory.write("a.bag", "#ROSBAG V1.2\nfoo"));
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error().text.find("is a ROS bag of another version, expected 2.0"),
              std::string::npos);
}

}  // namespace
}  // namespace terratact
