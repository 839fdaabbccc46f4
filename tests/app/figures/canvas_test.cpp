// Tests text layout on a canvas.
#include "app/figures/canvas.h"

#include <gtest/gtest.h>

#include "core/store/file_read.h"
#include "tests/support/temporary_directory.h"

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

TEST(Canvas, svgFilesHoldTextsEscaped)
{
    const TemporaryDirectory directory;
    const std::string path = directory.file("picture.svg");
    ASSERT_TRUE(writePicture(path, 10, 10, [](Canvas&) {}, {"a < b", "x & y", "1,2\n3,<4>\n"}));
    const std::string svg = *readFile(path, 1U << 20U);
    EXPECT_NE(svg.find("<title>a &lt; b</title>\n<desc>x &amp; y</desc>\n<metadata>\n1,2\n"
                       "3,&lt;4&gt;\n</metadata>"),
              std::string::npos);
    ASSERT_TRUE(writePicture(path, 10, 10, [](Canvas&) {}));
    EXPECT_EQ(readFile(path, 1U << 20U)->find("<title>"), std::string::npos);
}

}  // namespace
}  // namespace terratact
