#include "app/runtime/revised.h"

#include <gtest/gtest.h>

#include <string>

namespace terratact {
namespace {

TEST(Revised, everyAssignmentIsANewRevision)
{
    Revised<std::string> text;
    EXPECT_FALSE(text);
    const auto empty = text.revision();
    text = std::string("a");
    const auto first = text.revision();
    EXPECT_NE(first, empty);
    EXPECT_EQ(*text, "a");
    text = std::string("a");
    EXPECT_NE(text.revision(), first) << "it may have been shown with other context";
}

TEST(Revised, readingKeepsTheRevision)
{
    Revised<int> number;
    number = 7;
    const auto revision = number.revision();
    EXPECT_EQ(number.value(), 7);
    EXPECT_TRUE(number);
    EXPECT_EQ(number.revision(), revision);
}

TEST(Revised, onlyAValueCanBeReset)
{
    Revised<int> number;
    const auto empty = number.revision();
    number.reset();
    EXPECT_EQ(number.revision(), empty);
    number = 7;
    const auto seven = number.revision();
    number.reset();
    EXPECT_FALSE(number);
    EXPECT_NE(number.revision(), seven);
    EXPECT_NE(number.revision(), empty) << "a value was there in between";
}

TEST(Revised, takesAnOptionalValue)
{
    Revised<int> number;
    number = std::optional(3);
    EXPECT_EQ(*number, 3);
    const auto three = number.revision();
    number = std::optional<int>();
    EXPECT_FALSE(number);
    EXPECT_NE(number.revision(), three);
}

}  // namespace
}  // namespace terratact
