// Tests the signals of other devices in a recording.
#include "app/recording/export/payload_signals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/bags/field_value.h"
#include "core/bags/json_value.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

std::shared_ptr<const DbcBook> bookOf(const std::string& text)
{
    const TemporaryDirectory directory;
    auto book = std::make_shared<DbcBook>();
    const Status added = book->add(directory.write("some.dbc", text));
    EXPECT_TRUE(added) << added.error().text;
    return book;
}

constexpr const char* kTwo = "BO_ 1280 Gas: 4 P\n SG_ Oxygen : 0|16@1+ (0.01,0) [0|0] \"%\" C\n"
                             " SG_ State : 16|8@1+ (1,0) [0|0] \"\" C\n"
                             "BO_ 1281 Wind: 1 P\n SG_ Speed : 0|8@1+ (1,0) [0|0] \"m/s\" C\n";

TEST(PayloadSignalsOfARecording, areThoseOfMessagesThatOccur)
{
    PayloadSignals payload(bookOf(kTwo));
    const CanFrame wind{.id = 1281, .length = 1, .data = {7}};
    payload.note(wind);
    payload.note(wind);
    payload.note({.id = 1282, .length = 1});
    payload.name();
    ASSERT_EQ(payload.messages().size(), 1U);
    EXPECT_EQ(payload.messages()[0].name, "Wind");
    EXPECT_EQ(payload.signals(), 1U);
    EXPECT_EQ(payload.find(wind), 0U);
    EXPECT_FALSE(payload.find({.id = 1280, .length = 4})) << "it did not occur";
    EXPECT_FALSE(payload.find({.id = 1281, .remote = true, .length = 1}));
    EXPECT_EQ(headingOf(payload.messages()[0], payload.messages()[0].described->message.payload[0]),
              "Wind.Speed [m/s]");
}

TEST(PayloadSignalsOfARecording, equalNamesAreDistinguished)
{
    PayloadSignals payload(bookOf("BO_ 1280 Attitude: 1 P\n SG_ A : 0|8@1+ (1,0) [0|0] \"\" C\n"
                                  "BO_ 1281 Same: 1 P\n SG_ A : 0|8@1+ (1,0) [0|0] \"\" C\n"
                                  "BO_ 1282 Same: 1 P\n SG_ A : 0|8@1+ (1,0) [0|0] \"\" C\n"));
    for (const std::uint32_t id : {1280U, 1281U, 1282U}) payload.note({.id = id, .length = 1});
    payload.name();
    ASSERT_EQ(payload.messages().size(), 3U);
    EXPECT_EQ(payload.messages()[0].name, "Attitude 500") << "the robot has an Attitude";
    EXPECT_EQ(payload.messages()[1].name, "Same");
    EXPECT_EQ(payload.messages()[2].name, "Same 502");
}

TEST(PayloadSignalsOfARecording, messagesBeyondTheBoundAreCounted)
{
    std::string text;
    for (int m = 0; m < 9; ++m) {
        text += "BO_ " + std::to_string(1280 + m) + " M" + std::to_string(m) + ": 64 P\n";
        for (int s = 0; s < 250; ++s)
            text += " SG_ S" + std::to_string(s) + " : " + std::to_string(2 * s)
                  + "|2@1+ (1,0) [0|0] \"\" C\n";
    }
    PayloadSignals payload(bookOf(text));
    for (int turn = 0; turn < 2; ++turn)
        for (std::uint32_t id = 1280; id < 1289; ++id)
            payload.note({.id = id, .fd = true, .length = 64});
    EXPECT_EQ(payload.signals(), PayloadSignals::kMaxSignals);
    EXPECT_EQ(payload.leftOut(), 1U);
}

TEST(PayloadSignalsOfARecording, valuesHaveAllDigitsAndAbsentOnesNone)
{
    const auto book = bookOf(kTwo);
    const CanFrame whole{.id = 1280, .length = 4, .data = {0x17, 0x08, 2}};
    const CanFrame cut{.id = 1280, .length = 2, .data = {0x17, 0x08}};
    const DbcMessage& gas = book->find(whole)->message;
    EXPECT_EQ(numbersOf(gas, whole), (std::vector<std::string>{"20.71", "2"}));
    EXPECT_EQ(numbersOf(gas, cut), (std::vector<std::string>{"20.71", ""}));
    EXPECT_EQ(jsonValuesOf(gas, whole), R"({"Oxygen":20.71,"State":2})");
    EXPECT_EQ(jsonValuesOf(gas, cut), R"({"Oxygen":20.71})");
}

TEST(PayloadSignalsOfARecording, numbersThatAreNotFiniteAreNullInJson)
{
    const auto book = bookOf("BO_ 1280 Arm: 8 P\n SG_ Torque : 0|32@1- (1,0) [0|0] \"N m\" C\n"
                             " SG_ Speed : 32|32@1- (1,0) [0|0] \"\" C\n"
                             "SIG_VALTYPE_ 1280 Torque : 1;\nSIG_VALTYPE_ 1280 Speed : 1;\n");
    const CanFrame frame{.id = 1280, .length = 8, .data = {0, 0, 0xC0, 0x7F, 0, 0, 0x80, 0x7F}};
    const std::string json = jsonValuesOf(book->find(frame)->message, frame);
    EXPECT_EQ(json, R"({"Torque":null,"Speed":null})") << "NaN and infinity";
    const auto read = jsonValue(json);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_TRUE(std::isnan(numberAt(*read, "Torque").value_or(0.0))) << "our reader knows the key";
}

}  // namespace
}  // namespace terratact
