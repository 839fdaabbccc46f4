// Tests mapping files.
#include "core/mapping/mapping.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/bytes/csv_mapping.h"

namespace terratact {
namespace {

std::string whyNot(const std::string& text)
{
    const auto mapping = mappingFrom("m.toml", text);
    return mapping ? "" : mapping.error().text;
}

TEST(Mapping, readsEveryKeyOfAField)
{
    const Mapping mapping = parsedMapping(csvMapping(
        "[pitch]\ntopic = \"/imu\"\nfield = \"data.x\"\nsign = -1\nscale = 2.0\nunit = \"deg\"\n"
        "offset = 0.5\ndelay_s = 0.02\nunless = \"bad\"\n[front_left_current]\nfield = \"e\"\nunit "
        "= \"N m\"\n"));
    const FieldSource& pitch = *mapping.of(Quantity::Pitch);
    EXPECT_EQ(pitch.topic, "/imu");
    EXPECT_EQ(pitch.field, "data.x");
    EXPECT_DOUBLE_EQ(pitch.factor, -2.0 * std::numbers::pi / 180.0);
    EXPECT_EQ(pitch.offset, 0.5);
    EXPECT_EQ(pitch.delay, 0.02);
    EXPECT_EQ(pitch.unless, "bad");
    EXPECT_TRUE(mapping.of(Quantity::FrontLeftCurrent)->isTorque);
    EXPECT_EQ(mapping.of(Quantity::FrontLeft)->topic, kCsvTopic);
}

TEST(Mapping, readsForcesAsArrayOrAsSixFields)
{
    const Mapping mapping =
        parsedMapping(csvMapping("[front_left_force]\nfield = \"f\"\n[front_right_force]\nfields = "
                                 "[\"a\", \"b\", \"c\", \"d\", \"e\", \"g\"]\nunit = \"kN\"\n"));
    EXPECT_EQ(mapping.elements[0][5], "f[5]");
    EXPECT_EQ(mapping.elements[1][5], "g");
    EXPECT_EQ(mapping.forces[1]->factor, 1000.0);
}

TEST(Mapping, shippedMappingsAreRead)
{
    for (const char* const file : {"terratact", "terratact_signals", "ctu_absolem"}) {
        const auto mapping =
            readMapping(std::string(TERRATACT_SOURCE_DIR "/resources/mappings/") + file + ".toml");
        EXPECT_TRUE(mapping) << mapping.error().text;
    }
}

TEST(Mapping, refusalsNameLineKeyAndWhatToDo)
{
    EXPECT_EQ(whyNot(csvMapping("[roll]\nfield = \"r\"\nunit = \"degrees\"\n")),
              "m.toml: line 4: roll.unit is 'degrees', expected \"rad\" or \"deg\"");
    EXPECT_EQ(whyNot(csvMapping("[roll]\nfield = \"r\"\nsign = 0.5\n")),
              "m.toml: line 4: roll.sign is 0.5, expected 1 or -1");
    EXPECT_EQ(whyNot(csvMapping("[roll]\ntopic = \"/x\"\n")),
              "m.toml: line 2: the key roll.field is missing");
    EXPECT_EQ(whyNot(csvMapping("[roll]\nfield = \"r\"\nfeild = 1\n")),
              "m.toml: line 4: 'roll.feild' is not a known key");
    EXPECT_EQ(whyNot(csvMapping("[front_left_force]\nfields = [\"a\"]\n")),
              "m.toml: line 3: front_left_force.fields is not an array of 6 elements");
    EXPECT_EQ(whyNot("[roll]\nfield = \"r\"\n"), "m.toml: the key name is missing");
    EXPECT_EQ(whyNot("name = \"x\"\n"),
              "m.toml: lacks the pitch: add [attitude] with a quaternion, or [pitch]");
    EXPECT_NE(whyNot("name = \"x\"\n[pitch]\nfield = \"p\"\n").find("lacks [front_left]"),
              std::string::npos);
    EXPECT_NE(whyNot(csvMapping("[attitude]\nquaternion = \"q\"\n"))
                  .find("has both [attitude] and [pitch]"),
              std::string::npos);
    EXPECT_NE(whyNot(csvMapping("[speed]\nfield = \"v\"\n[travelled]\nfield = \"s\"\n"))
                  .find("more than one of"),
              std::string::npos);
}

}  // namespace
}  // namespace terratact
