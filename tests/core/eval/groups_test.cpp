#include "core/eval/groups.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

BinError errorOf(std::size_t scene, double error, double novelty, const std::string& label = "pa")
{
    BinError e;
    e.scene = scene;
    e.label = label;
    e.error = error;
    e.novelty = novelty;
    return e;
}

TEST(ByNovelty, splitsScenesByNovelty)
{
    const std::vector<BinError> errors{errorOf(0, 0.01, 0.5), errorOf(0, 0.03, 0.5),
                                       errorOf(1, 0.02, 1.0), errorOf(2, 0.5, 1.01),
                                       errorOf(2, 9.0, 0.0, "flat")};
    const auto groups = byNovelty(errors);
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0].group, "inside");
    EXPECT_EQ(groups[0].scenes, 2U);
    EXPECT_EQ(groups[0].all.n, 3U);
    EXPECT_DOUBLE_EQ(groups[0].all.median, 0.02);
    EXPECT_EQ(groups[1].group, "outside");
    EXPECT_DOUBLE_EQ(groups[1].all.mean, 0.5);
}

class ClassIndex : public testing::Test {
protected:
    std::string write(const std::string& text) const
    {
        std::ofstream(path_, std::ios::binary) << text;
        return path_;
    }
    std::string complaint(const std::string& text, const std::string& column = "class") const
    {
        const auto classes = readClasses(write(text), column);
        return classes ? "" : classes.error().text;
    }

private:
    TemporaryDirectory directory_;
    std::string path_ = directory_.file("index.csv");
};

TEST_F(ClassIndex, isReadWithQuotesAndEitherLineEnd)
{
    const auto classes = readClasses(write("row,source,class,kind\r\n1,eth,flat,\"map, indoor\"\r\n"
                                           "2,nist,\"a \"\"b\"\", c\",x"),
                                     "class");
    ASSERT_TRUE(classes);
    EXPECT_EQ(*classes, (Classes{{"1", "flat"}, {"2", "a \"b\", c"}}));
    EXPECT_EQ(readClasses(write("class,row\nflat,7\n"), "class")->at("7"), "flat");
}

TEST_F(ClassIndex, isRefusedWithItsLineIfWrong)
{
    EXPECT_NE(complaint("row,source\n1,eth\n").find("line 1: has no column class"),
              std::string::npos);
    EXPECT_NE(complaint("source,class\n1,eth\n").find("no column row"), std::string::npos);
    EXPECT_NE(complaint("row,class\n1,a\n2\n").find("line 3: has 1 fields where the header has 2"),
              std::string::npos);
    EXPECT_NE(complaint("row,class\n1,\"a\n").find("line 2: a quote does not end"),
              std::string::npos);
    EXPECT_NE(complaint("row,class\n1,a\n1,b\n").find("row '1' appears twice"), std::string::npos);
    EXPECT_FALSE(readClasses("/nowhere/index.csv", "class"));
}

TEST_F(ClassIndex, isBoundedAndQuotedInPlainCharacters)
{
    EXPECT_EQ(complaint("row,class\n\x1b[1m,a\n\x1b[1m,b\n").find('\x1b'), std::string::npos);
    std::string rows = "row,class\n";
    for (std::size_t i = 0; i < kMaxClassRows; ++i) rows += std::to_string(i) + ",a\n";
    EXPECT_TRUE(readClasses(*CsvReader::over("text", rows), "class"));
    EXPECT_NE(complaint(rows + "x,a\n").find("one row more than the 200000"), std::string::npos);
}

TEST(ByClass, groupsScenesByTheRowTheirRunNames)
{
    std::vector<Scene> scenes(3);
    scenes[0].run = "1";
    scenes[1].run = "2";
    scenes[2].run = "77";
    const std::vector<BinError> errors{errorOf(0, 0.01, 0.0), errorOf(1, 0.02, 0.0),
                                       errorOf(2, 0.03, 0.0), errorOf(1, 0.04, 0.0, "flat")};
    const auto groups = byClass(errors, scenes, {{"1", "stairs"}, {"2", "flat ground"}});
    ASSERT_EQ(groups.size(), 4U);
    EXPECT_EQ(groups[0].group, kNoClass);
    EXPECT_EQ(groups[1].group, "flat ground");
    EXPECT_EQ(groups[1].label, "pa");
    EXPECT_EQ(groups[2].label, "flat");
    EXPECT_EQ(groups[3].group, "stairs");
    EXPECT_DOUBLE_EQ(groups[3].all.median, 0.01);
    EXPECT_THROW(byClass(errors, std::span(scenes).first(2), {}), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
