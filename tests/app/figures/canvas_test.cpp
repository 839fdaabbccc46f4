// Tests text layout on a canvas.
#include "app/figures/canvas.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

TEST(Canvas, wrapsWordsAndBreaksThoseThatAreTooLong)
{
    std::vector<std::string> lines, broken;
    (void)svgText(100, 100, [&](Canvas& canvas) {
        const TextStyle style{.colour = {}, .size = 10.0};
        lines = canvas.wrapped("one two three four", canvas.textWidth("one two ", style), style);
        broken = canvas.wrapped(std::string("a ").append(64, 'f'), 100.0, style);
        for (const std::string& line : broken) EXPECT_LE(canvas.textWidth(line, style), 100.0);
        EXPECT_TRUE(canvas.wrapped("", 100.0, style).empty());
        EXPECT_EQ(canvas.wrapped("wide", 0.0, style).size(), 1U);
    });
    EXPECT_EQ(lines, (std::vector<std::string>{"one two", "three", "four"}));
    std::string joined;
    for (const std::string& line : broken) joined += line;
    EXPECT_EQ(joined, std::string("a").append(64, 'f'));
}

}  // namespace
}  // namespace terratact
