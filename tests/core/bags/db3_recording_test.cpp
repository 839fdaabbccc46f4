// Tests the reader of ROS 2 bags in SQLite.
#include "core/bags/db3_recording.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/bytes/message_bytes.h"
#include "tests/support/sessions/read_recording.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

std::string hexadecimal(std::string_view bytes)
{
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const char c : bytes) {
        text += kDigits[static_cast<unsigned char>(c) / 16];
        text += kDigits[static_cast<unsigned char>(c) % 16];
    }
    return text;
}

struct Db3Files : testing::Test {
    std::string written(const std::string& sql)
    {
        const std::string path = directory.file("a.db3");
        sqlite3* file = nullptr;
        EXPECT_EQ(sqlite3_open(path.c_str(), &file), SQLITE_OK);
        EXPECT_EQ(sqlite3_exec(file, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
            << sqlite3_errmsg(file);
        sqlite3_close(file);
        return path;
    }
    static std::string tables()
    {
        return "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT "
               "NULL, serialization_format "
               "TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
               "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp "
               "INTEGER NOT NULL, data BLOB "
               "NOT NULL);"
               "INSERT INTO topics VALUES(1, '/a', 'std_msgs/msg/Float64', 'cdr', ''), (2, '/b', "
               "'p/msg/T', 'cdr', '');";
    }
    static std::string definitionsTable()
    {
        return "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT, encoding "
               "TEXT, encoded_message_definition TEXT, type_description_hash TEXT);";
    }
    static std::string message(int topic, std::int64_t time, const std::string& data)
    {
        return "INSERT INTO messages(topic_id, timestamp, data) VALUES(" + std::to_string(topic)
             + ", " + std::to_string(time) + ", x'" + hexadecimal(data) + "');";
    }
    static std::string number(double value) { return MessageBytes::cdr().add(value).bytes(); }

    std::vector<std::string> read(const std::string& path,
                                  const std::optional<std::set<std::string>>& topics = {})
    {
        ReadRecording read = readRecording(path, topics);
        remarks = std::move(read.remarks);
        return std::move(read.messages);
    }

    TemporaryDirectory directory;
    std::vector<std::string> remarks;
};

TEST_F(Db3Files, commonTypesNeedNoDefinition)
{
    const std::string path = written(tables() + message(1, 5, number(1.5))
                                     + message(2, 6, number(2.5)) + message(9, 7, ""));
    const auto found = read(path);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0], "/a 5 1.500000");
    EXPECT_NE(
        found[1].find("a.db3: topic /b: the file lacks the definition of p/msg/T; record it again"),
        std::string::npos)
        << found[1];
    EXPECT_EQ(remarks,
              std::vector<std::string>{"row 3 of messages is of no topic; it is left out"});
    EXPECT_EQ(read(path, {{"/a"}}).size(), 1U);
}

TEST_F(Db3Files, definitionsInTheFileAreUsed)
{
    const std::string path = written(
        tables() + definitionsTable()
        + "INSERT INTO message_definitions VALUES(1, 'p/msg/T', 'ros2msg', 'float64 data', '');"
        + message(2, 6, number(2.5)));
    EXPECT_EQ(read(path), std::vector<std::string>{"/b 6 2.500000"});
}

TEST_F(Db3Files, anUnreadDefinitionIsThatOfACommonType)
{
    const std::string path = written(
        tables() + definitionsTable()
        + "INSERT INTO message_definitions VALUES(1, 'std_msgs/msg/Float64', 'ros2idl', 'module "
          "std_msgs', ''), (2, 'p/msg/T', 'ros2idl', 'module p', '');"
        + message(1, 5, number(1.5)) + message(2, 6, number(2.5)));
    const auto found = read(path);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0], "/a 5 1.500000");
    EXPECT_NE(found[1].find("topic /b: its definition has the encoding 'ros2idl', expected "
                            "ros2msg; record it again where the .msg files of its package are "
                            "installed"),
              std::string::npos)
        << found[1];
    EXPECT_EQ(remarks, std::vector<std::string>{
                           "the definition of std_msgs/msg/Float64 has the encoding 'ros2idl', "
                           "which is not read; the shipped definition of this type was used"});
}

TEST_F(Db3Files, aDefinitionThatIsTooLargeCostsItsTopic)
{
    const std::string path =
        written(tables() + definitionsTable()
                + "INSERT INTO message_definitions VALUES(1, 'p/msg/T', 'ros2msg', "
                  "replace(hex(zeroblob(524289)), '0', ' '), '');"
                  "UPDATE topics SET name = replace(hex(zeroblob(500)), '0', 'n') WHERE id = 1;"
                + message(1, 5, number(1.5)) + message(2, 6, number(2.5)));
    const auto found = read(path);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0], std::string(kMaxTopicName, 'n') + "… 5 1.500000");
    EXPECT_NE(found[1].find("topic /b: the definition of p/msg/T has 1048578 bytes"),
              std::string::npos)
        << found[1];
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_EQ(remarks[0],
              "the definition of p/msg/T has 1048578 bytes, more than 1048576; it is left out");
}

TEST_F(Db3Files, aCommonTypeIsNotDecodedByAnotherDefinition)
{
    const std::string definitions = tables() + definitionsTable();
    const auto tooLong =
        read(written(definitions
                     + "INSERT INTO message_definitions VALUES(1, 'std_msgs/msg/Float64', "
                       "'ros2msg', replace(hex(zeroblob(524289)), '0', ' '), '');"
                     + message(1, 5, number(1.5))));
    ASSERT_EQ(tooLong.size(), 1U);
    EXPECT_NE(tooLong[0].find("topic /a: the definition of std_msgs/msg/Float64 has 1048578 bytes"),
              std::string::npos)
        << tooLong[0];
    std::filesystem::remove(directory.file("a.db3"));
    const auto behindTheBound = read(written(
        definitions
        + "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 1000) INSERT "
          "INTO message_definitions SELECT i, 'p/msg/N' || i, 'ros2msg', 'bool a', '' FROM n;"
          "INSERT INTO message_definitions VALUES(1001, 'std_msgs/msg/Float64', 'ros2msg', "
          "'uint64 data', '');"
        + message(1, 5, number(1.5))));
    ASSERT_EQ(behindTheBound.size(), 1U);
    EXPECT_NE(behindTheBound[0].find("topic /a: the definition of std_msgs/msg/Float64 is not "
                                     "among the first 1000 of the file, which alone are read. "
                                     "Record fewer types"),
              std::string::npos)
        << behindTheBound[0];
}

TEST_F(Db3Files, anEmptyDefinitionIsNone)
{
    const std::string path = written(
        tables() + definitionsTable()
        + "INSERT INTO message_definitions VALUES(1, 'std_msgs/msg/Float64', 'unknown', '', '');"
        + message(1, 5, number(1.5)));
    EXPECT_EQ(read(path), std::vector<std::string>{"/a 5 1.500000"});
    EXPECT_EQ(remarks, std::vector<std::string>{});
}

TEST_F(Db3Files, otherDatabasesAreRefused)
{
    const auto opened = openRecording(written("CREATE TABLE messages(id INTEGER);"));
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error().text.find("has no table topics, expected a bag of rosbag2"),
              std::string::npos);
    const auto session = openRecording(TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts");
    ASSERT_FALSE(session);
    EXPECT_NE(session.error().text.find("is a recorded session already"), std::string::npos);
}

TEST_F(Db3Files, aCutFileIsNamed)
{
    std::string sql = tables();
    for (int i = 0; i < 3000; ++i) sql += message(1, i, number(i));
    const std::string bytes = contentOf(written("BEGIN;" + sql + "COMMIT;"));
    ASSERT_GT(bytes.size(), 60'000U);
    for (const std::size_t n :
         {std::size_t{50}, std::size_t{5000}, bytes.size() / 2, bytes.size() - 10}) {
        const auto opened = openRecording(directory.write("cut.db3", bytes.substr(0, n)));
        if (opened) continue;
        EXPECT_EQ(opened.error().text.find(directory.file("cut.db3") + ": "), 0U);
    }
    std::string damaged = bytes;
    for (std::size_t i = bytes.size() / 2; i < bytes.size() / 2 + 20'000; ++i) damaged[i] = '\x55';
    const auto found = read(directory.write("damaged.db3", damaged));
    EXPECT_LT(found.size(), 3000U);
    ASSERT_FALSE(remarks.empty());
    EXPECT_NE(remarks.back().find("it was read up to there"), std::string::npos) << remarks.back();
}

TEST_F(Db3Files, aRowOfWrongTypesIsLeftOut)
{
    const std::string path =
        written(tables() + message(1, 5, number(1.5))
                + "INSERT INTO messages(topic_id, timestamp, data) VALUES(1, 6, 'text'), (1, "
                  "'noon', x'00'), ('one', 7, x'00');"
                + message(1, 8, number(2.5)));
    EXPECT_EQ(read(path), (std::vector<std::string>{"/a 5 1.500000", "/a 8 2.500000"}));
    ASSERT_EQ(remarks.size(), 3U);
    EXPECT_EQ(remarks[0], "row 2 of messages holds values of a wrong type; it is left out");
}

}  // namespace
}  // namespace terratact
