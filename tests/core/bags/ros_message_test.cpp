// Tests message definitions of ROS, and messages decoded by them.
#include "core/bags/ros_message.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/bags/known_messages.h"
#include "core/bags/message_decoder.h"
#include "tests/support/bytes/message_bytes.h"

namespace terratact {
namespace {

using Dialect = MessageSchema::Dialect;

constexpr const char* kJointState =
    "# comment\nHeader header\n\nstring[] name\nfloat64[] position # rad\nuint8 A=1\nstring B = x "
    "y\n"
    "float32[2] pair\nbool on\n"
    "================================================================================\n"
    "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";

MessageSchema schema(std::string_view type, std::string_view text, Dialect dialect)
{
    auto parsed = MessageSchema::parse(type, text, dialect);
    EXPECT_TRUE(parsed) << parsed.error().text;
    return parsed ? std::move(*parsed) : MessageSchema{};
}

std::string whyNot(std::string_view text, Dialect dialect = Dialect::Ros2)
{
    const auto parsed = MessageSchema::parse("p/T", text, dialect);
    return parsed ? "" : parsed.error().text;
}

std::string someJoints()
{
    return MessageBytes::ros1()
        .add(std::uint32_t{9})
        .add(std::uint32_t{100})
        .add(std::uint32_t{250})
        .text("base")
        .add(std::uint32_t{2})
        .text("fl")
        .text("fr")
        .counted(std::vector{0.5, -0.25})
        .add(1.5F)
        .add(2.5F)
        .add(std::uint8_t{1})
        .bytes();
}

TEST(Ros1Message, isDecodedByItsDefinition)
{
    const auto joints = schema("sensor_msgs/JointState", kJointState, Dialect::Ros1);
    const auto value = decodeRos1(joints, someJoints());
    ASSERT_TRUE(value) << value.error().text;
    EXPECT_EQ(numberAt(*value, "position[fr]"), -0.25);
    EXPECT_EQ(numberAt(*value, "pair[1]"), 2.5);
    EXPECT_EQ(numberAt(*value, "on"), 1.0);
    EXPECT_EQ(textAt(*value, "header.frame_id"), "base");
    EXPECT_EQ(stampOf(*value), 100'000'000'250);
    EXPECT_FALSE(hasField(*value, "A")) << "a constant is no member";
}

TEST(Ros1Message, everyCutIsRefused)
{
    const auto joints = schema("sensor_msgs/JointState", kJointState, Dialect::Ros1);
    const std::string whole = someJoints();
    for (std::size_t n = 0; n < whole.size(); ++n)
        EXPECT_FALSE(decodeRos1(joints, whole.substr(0, n))) << n;
    const auto longer = decodeRos1(joints, whole + "x");
    ASSERT_FALSE(longer);
    EXPECT_NE(longer.error().text.find("1 bytes behind its last member"), std::string::npos);
}

TEST(RosMessage, hugeCountsCostNothing)
{
    const auto numbers = schema("p/T", "float64[] a\n", Dialect::Ros1);
    EXPECT_FALSE(decodeRos1(numbers, MessageBytes::ros1().add(0xFFFFFFFFU).bytes()));
    const auto empties = schema("p/T", "Empty[] a\n===\nMSG: p/Empty\n", Dialect::Ros1);
    const auto refused = decodeRos1(empties, MessageBytes::ros1().add(0xFFFFFFFFU).bytes());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text.find("more elements than it has bytes"), std::string::npos);
    // Each level multiplies by 1000.
    const auto nested = schema(
        "p/A", "B[1000] b\n===\nMSG: p/B\nC[1000] c\n===\nMSG: p/C\nD[1000] d\n===\nMSG: p/D\n",
        Dialect::Ros1);
    EXPECT_FALSE(decodeRos1(nested, ""));
}

TEST(RosMessage, aDefinitionInItselfIsRefused)
{
    const auto loop = schema("p/T", "p/T inner\n", Dialect::Ros1);
    const auto refused = decodeRos1(loop, std::string(100, '\0'));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text.find("nests too deep"), std::string::npos);
}

TEST(CdrMessage, membersAreAligned)
{
    const auto mixed = schema(
        "p/msg/T",
        "uint8 a\nfloat64 b\nstring c\nint16 d\nstring<=5[<=3] e\nbuiltin_interfaces/Time t\n",
        Dialect::Ros2);
    const std::string bytes = MessageBytes::cdr()
                                  .add(std::uint8_t{7})
                                  .add(2.5)
                                  .text("xy")
                                  .add(std::int16_t{-3})
                                  .add(std::uint32_t{1})
                                  .text("z")
                                  .add(std::int32_t{4})
                                  .add(std::uint32_t{5})
                                  .bytes();
    const auto value = decodeCdr(mixed, bytes);
    ASSERT_TRUE(value) << value.error().text;
    EXPECT_EQ(numberAt(*value, "a"), 7.0);
    EXPECT_EQ(numberAt(*value, "b"), 2.5);
    EXPECT_EQ(textAt(*value, "c"), "xy");
    EXPECT_EQ(numberAt(*value, "d"), -3.0);
    EXPECT_EQ(textAt(*value, "e[0]"), "z");
    EXPECT_EQ(numberAt(*value, "t.nanosec"), 5.0);
}

TEST(CdrMessage, otherByteOrdersAndVersionsAreRead)
{
    const auto one = schema("p/T", "uint8 a\nfloat64 b\n", Dialect::Ros2);
    // Big-endian, version 1: 2.5 is 40 04 00 … .
    const auto big =
        decodeCdr(one, std::string("\0\0\0\0\x07\0\0\0\0\0\0\0\x40\x04\0\0\0\0\0\0", 20));
    ASSERT_TRUE(big) << big.error().text;
    EXPECT_EQ(numberAt(*big, "b"), 2.5);
    // Little-endian, version 2: eight bytes are aligned to four.
    const auto two = decodeCdr(one, std::string("\0\x07\0\0\x07\0\0\0\0\0\0\0\0\0\x04\x40", 16));
    ASSERT_TRUE(two) << two.error().text;
    EXPECT_EQ(numberAt(*two, "b"), 2.5);
    const auto listed = decodeCdr(one, std::string("\0\x03\0\0\x07\0\0\0", 8));
    ASSERT_FALSE(listed);
    EXPECT_NE(listed.error().text.find("representation 3"), std::string::npos);
}

TEST(MessageSchema, refusalsNameTypeAndLine)
{
    EXPECT_EQ(whyNot("float64 a\nWhat b\n"),
              "the definition of p/T, line 2 has a field of an unknown type: 'What'");
    EXPECT_EQ(whyNot("x/Y y\n===\nMSG: x/Y\n\nodd\n"),
              "the definition of p/T, line 5 is not \"TYPE NAME\": 'odd'");
    EXPECT_NE(whyNot("float64[9999999999] a\n"), "");
    EXPECT_NE(whyNot(std::string(MessageSchema::kMaxText + 1, ' ')), "");
    std::string many;
    for (std::size_t i = 0; i <= MessageSchema::kMaxFields; ++i) many += "bool a\n";
    EXPECT_NE(whyNot(many), "");
    EXPECT_EQ(whyNot("time t\nduration d\n", Dialect::Ros1), "");
    const auto headed =
        MessageSchema::parse("p/msg/T", "===\nMSG: p/T\nfloat64 a\n", Dialect::Ros2);
    ASSERT_TRUE(headed);
    EXPECT_EQ(headed->structs.at(0).fields.size(), 1U) << "the message itself has a head";
}

TEST(KnownMessages, allCanBeParsedAndAreOfRos2)
{
    for (const char* const type :
         {"sensor_msgs/msg/JointState", "sensor_msgs/Imu", "nav_msgs/msg/Odometry",
          "geometry_msgs/msg/TwistStamped", "std_msgs/msg/Float64", "std_msgs/msg/Float32",
          "std_msgs/msg/Float64MultiArray", "std_msgs/msg/Float32MultiArray",
          "tf2_msgs/msg/TFMessage"}) {
        ASSERT_FALSE(knownDefinition(type).empty()) << type;
        schema(type, knownDefinition(type), Dialect::Ros2);
    }
    EXPECT_TRUE(knownDefinition("sensor_msgs/msg/Joint").empty());
    EXPECT_TRUE(knownDefinition("").empty());
}

TEST(MessageDecoder, refusalsSayWhatWasExpected)
{
    const auto why = [](RecordedTopic topic) {
        const auto decoder = MessageDecoder::of(topic);
        return decoder ? "" : decoder.error().text;
    };
    EXPECT_EQ(why({.name = "/a", .encoding = "protobuf"}),
              "its messages have the encoding 'protobuf', expected json, ros1 or cdr; record "
              "or convert it with one of these");
    EXPECT_NE(
        why({.name = "/a", .type = "x/Y", .encoding = "cdr"}).find("lacks the definition of x/Y"),
        std::string::npos);
    EXPECT_NE(why({.name = "/a",
                   .type = "x/Y",
                   .encoding = "cdr",
                   .schemaEncoding = "ros2idl",
                   .schema = std::make_shared<const std::string>("x")})
                  .find("expected ros2msg"),
              std::string::npos);
    EXPECT_EQ(why({.name = "/a", .type = "std_msgs/msg/Float64", .encoding = "cdr"}), "");
}

TEST(MessageDecoder, noCommonDefinitionReplacesOneLeftOut)
{
    const auto decoder = MessageDecoder::of({.name = "/a",
                                             .type = "std_msgs/msg/Float64",
                                             .encoding = "cdr",
                                             .schemaEncoding = "ros2msg",
                                             .schema = Error{"its definition is too long"}});
    ASSERT_FALSE(decoder);
    EXPECT_EQ(decoder.error().text, "its definition is too long. Record fewer types in one file, "
                                    "or a type with a shorter definition");
}

}  // namespace
}  // namespace terratact
