#include "core/robot/toml_depth.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace terratact {
namespace {

TEST(NestingDepth, countsBracketsAndDotsOutsideStringsAndComments)
{
    EXPECT_EQ(nestingDepth(""), 0);
    EXPECT_EQ(nestingDepth("a = [[1], [[2]]]"), 3);
    EXPECT_EQ(nestingDepth("a = {b = {c = 1}}"), 2);
    EXPECT_EQ(nestingDepth("a.b.c = 1"), 2);
    EXPECT_EQ(nestingDepth("[a.b.c]\nd.e = 1"), 3);
    EXPECT_EQ(nestingDepth("a = [1.0, 2.0, 3.0]"), 2);
    EXPECT_EQ(nestingDepth("# [[[[\na = '[[[[' # {{{{"), 0);
    EXPECT_EQ(nestingDepth("a = \"\\\"[[[[\"\nb = [1]"), 1);
    EXPECT_EQ(nestingDepth("a = \"\"\"\n[[[\\\"\"\"\" [["), 2);
    EXPECT_EQ(nestingDepth("a = [\"\"\"x\"\"\"\", [[["), 4)
        << "a quote of the text touches the closing three";
    EXPECT_EQ(nestingDepth("a = ['''x''''', [[["), 4);
    EXPECT_EQ(nestingDepth("]]]]a = [["), 2);
    EXPECT_EQ(nestingDepth("a = \"[[[\nb = [["), 2) << "a string torn at the line's end";
}

TEST(NestingDepth, neverReadsBeyondTheText)
{
    const std::string alphabet = "\"'[]{}.=,#\n\\a";
    std::mt19937_64 rng(4);
    for (int i = 0; i < 20000; ++i) {
        std::string text(rng() % 20, ' ');
        for (char& c : text) c = alphabet[rng() % alphabet.size()];
        const int depth = nestingDepth(text);
        EXPECT_GE(depth, 0);
        EXPECT_LE(depth, static_cast<int>(text.size()));
    }
}

}  // namespace
}  // namespace terratact
