// Tests paths into decoded messages, and JSON.
#include "core/bags/field_value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/bags/json_value.h"

namespace terratact {
namespace {

FieldValue json(std::string_view text)
{
    auto value = jsonValue(text);
    EXPECT_TRUE(value) << text;
    return value ? *value : FieldValue{};
}

TEST(FieldPath, namesMembersElementsAndJoints)
{
    const FieldValue joints = json(
        R"({"header":{"stamp":{"sec":5,"nanosec":7}},"name":["rear","fl"],"position":[1,2.5],"a.b":3})");
    EXPECT_EQ(numberAt(joints, "position[1]"), 2.5);
    EXPECT_EQ(numberAt(joints, "position[fl]"), 2.5);
    EXPECT_EQ(numberAt(joints, "header.stamp.nanosec"), 7.0);
    EXPECT_EQ(numberAt(joints, "a.b"), 3.0) << "a name with a dot";
    EXPECT_EQ(textAt(joints, "name[0]"), "rear");
    EXPECT_EQ(stampOf(joints), 5'000'000'007);
    for (const char* const none : {"position[2]", "position[xx]", "position", "header", "x",
                                   "position[1", "position[fl].x", "", "[0]", ".", "name[fl]"})
        EXPECT_FALSE(numberAt(joints, none)) << none;
    EXPECT_TRUE(hasField(joints, "name[fl]"));
    EXPECT_FALSE(hasField(joints, "name[front]"));
}

TEST(FieldPath, namesTransformsByTheirFrame)
{
    const FieldValue tf = json(
        R"({"transforms":[{"child_frame_id":"odom","x":1},{"child_frame_id":"imu","x":2},{"header":{"frame_id":"m"},"x":3}]})");
    EXPECT_EQ(numberAt(tf, "transforms[imu].x"), 2.0);
    EXPECT_EQ(numberAt(tf, "transforms[m].x"), 3.0);
    EXPECT_FALSE(numberAt(tf, "transforms[base].x"));
}

TEST(FieldPath, nullIsANumberThatIsNone)
{
    const FieldValue value = json(R"({"a":null,"b":[1,null]})");
    EXPECT_TRUE(std::isnan(*numberAt(value, "a")));
    EXPECT_TRUE(std::isnan(*numberAt(value, "b[1]")));
}

TEST(FieldPath, visitsEveryNumberByItsPath)
{
    std::map<std::string, double> found;
    const FieldValue value =
        json(R"({"name":["l","r"],"position":[1,2],"long":[1,2,3,4],"t":"x","in":{"ok":true}})");
    eachNumber(value, 3, [&](const std::string& path, double number) { found[path] = number; });
    const std::map<std::string, double> expected{{"position[l]", 1}, {"position[r]", 2},
                                                 {"long[0]", 1},     {"long[1]", 2},
                                                 {"long[2]", 3},     {"in.ok", 1}};
    EXPECT_EQ(found, expected);
    for (const auto& [path, number] : found) EXPECT_EQ(numberAt(value, path), number) << path;
}

TEST(Json, readsTextsWithEscapes)
{
    EXPECT_EQ(json(R"("a\"\\\/\b\f\n\r\t\u00e9\ud83d\ude00")").text,
              "a\"\\/\b\f\n\r\t\u00e9\U0001F600");
    EXPECT_EQ(json(" -1.5e3 ").number, -1500.0);
}

TEST(Json, refusesWhatIsNone)
{
    for (const std::string_view bad :
         {"", "{", "[1", "[1,]", "{\"a\"}", "{\"a\":1,}", "nul", "\"a", "1 2", "\"\\x\"",
          "\"\\ud800\"", "\"\\u12", "--1", "{a:1}", "\x01"})
        EXPECT_FALSE(jsonValue(bad)) << bad;
    EXPECT_EQ(jsonValue("[1,]").error().text, "is no JSON at byte 3: expected a value");
}

TEST(Json, boundsDepthAndValues)
{
    EXPECT_FALSE(jsonValue(std::string(100'000, '[')));
    std::string many = "[[]";
    for (int i = 0; i < 200'000; ++i) many += ",[]";
    const auto refused = jsonValue(many + "]");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text.find("too many values"), std::string::npos);
}

}  // namespace
}  // namespace terratact
