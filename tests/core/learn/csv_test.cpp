#include "core/learn/csv.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using Lines = std::vector<std::vector<std::string>>;

/// All fields of a file; empty lines at the first error.
Lines linesOf(CsvReader csv)
{
    Lines lines;
    for (;;) {
        const Result<bool> more = csv.next();
        if (!more) return {};
        if (!*more) return lines;
        lines.emplace_back(csv.fields().begin(), csv.fields().end());
    }
}

TEST(CsvReader, splitsLinesAtCommas)
{
    const TemporaryDirectory dir;
    const std::string path = dir.write("a.csv", "a,b,c\n1,,3\n,\nx\n");
    EXPECT_EQ(linesOf(*CsvReader::open(path)),
              (Lines{{"a", "b", "c"}, {"1", "", "3"}, {"", ""}, {"x"}}));
}

TEST(CsvReader, takesEitherLineEndAndAByteOrderMark)
{
    const TemporaryDirectory dir;
    const std::string path = dir.write("a.csv", "\xEF\xBB\xBF"
                                                "a,b\r\n1,2\n3,4\r\n");
    EXPECT_EQ(linesOf(*CsvReader::open(path)), (Lines{{"a", "b"}, {"1", "2"}, {"3", "4"}}));
}

TEST(CsvReader, refusesATornLastLineOneByteShort)
{
    const TemporaryDirectory dir;
    const std::string whole = "a,b\n1,2\n3,4\n";
    ASSERT_TRUE(CsvReader::open(dir.write("a.csv", whole)));
    const std::string path = dir.write("b.csv", whole.substr(0, whole.size() - 1));
    EXPECT_TRUE(refused(CsvReader::open(path), path, {"line 3", "torn"}));
}

TEST(CsvReader, refusesEmptyFilesAndDirectories)
{
    const TemporaryDirectory dir;
    const std::string empty = dir.write("a.csv", "");
    EXPECT_TRUE(refused(CsvReader::open(empty), empty, {"is empty"}));
    const std::string mark = dir.write("b.csv", "\xEF\xBB\xBF");
    EXPECT_TRUE(refused(CsvReader::open(mark), mark, {"is empty"}));
    EXPECT_TRUE(refused(CsvReader::open(dir.file("")), dir.file(""), {"directory"}));
}

TEST(CsvReader, refusesBlankLinesAndQuotes)
{
    const TemporaryDirectory dir;
    for (const char* blank : {"a\n\nb\n", "a\n \t\nb\n", "a\r\n\r\nb\r\n"}) {
        const std::string path = dir.write("a.csv", blank);
        Result<CsvReader> csv = CsvReader::open(path);
        ASSERT_TRUE(csv && csv->next());
        EXPECT_TRUE(refused(csv->next(), path, {"line 2", "blank"}));
    }
    const std::string path = dir.write("a.csv", "a,\"b,c\"\n");
    Result<CsvReader> csv = CsvReader::open(path);
    ASSERT_TRUE(csv);
    EXPECT_TRUE(refused(csv->next(), path, {"line 1", "quoted field"}));
}

TEST(CsvReader, readsFiniteNumbersOnly)
{
    const TemporaryDirectory dir;
    const std::string path =
        dir.write("a.csv", "x\n 1.5 ,-2e-3,nan,inf,-inf,1e999,1.2.3,,0x1,1m\n");
    Result<CsvReader> csv = CsvReader::open(path);
    ASSERT_TRUE(csv && csv->next() && csv->next());
    EXPECT_EQ(*csv->number(0, "x"), 1.5);
    EXPECT_EQ(*csv->number(1, "x"), -2e-3);
    for (std::size_t i = 2; i < 5; ++i)
        EXPECT_TRUE(refused(csv->number(i, "the x"), path, {"line 2", "the x", "not finite"})) << i;
    for (std::size_t i = 5; i < 10; ++i)
        EXPECT_TRUE(refused(csv->number(i, "the x"), path, {"line 2", "the x", "not a number"}))
            << i;
}

TEST(CsvReader, boundsFieldsAndTheirLength)
{
    const auto first = [](const std::string& line) {
        return CsvReader::over("text", line + "\n")->next();
    };
    EXPECT_TRUE(first(std::string(CsvReader::kMostFields - 1, ',')));
    EXPECT_TRUE(refused(first(std::string(CsvReader::kMostFields, ',')), "text",
                        {"line 1", "more than 100000 fields"}));
    const std::string longest(CsvReader::kLongestField, 'a');
    EXPECT_TRUE(first("b," + longest + "," + longest));
    for (const std::string& line : {"b," + longest + "a", longest + "a,b"})
        EXPECT_TRUE(refused(first(line), "text", {"line 1", "more than 4096 bytes"}));
}

TEST(CsvReader, keepsItsFieldsWhenItMoves)
{
    const TemporaryDirectory dir;
    Result<CsvReader> csv = CsvReader::open(dir.write("a.csv", "a,b\n"));
    ASSERT_TRUE(csv && csv->next());
    const CsvReader moved = *std::move(csv);
    EXPECT_EQ(moved.fields().at(1), "b");
    EXPECT_EQ(moved.line(), 1);
}

}  // namespace
}  // namespace terratact
