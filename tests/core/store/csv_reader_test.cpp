#include "core/store/csv_reader.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/store/csv_text.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/thread_time.h"

namespace terratact {
namespace {

using namespace std::string_literals;
using Lines = std::vector<std::vector<std::string>>;

/// Returns all fields of a file; empty at the first error.
Lines linesOf(Result<CsvReader> csv)
{
    Lines lines;
    while (csv) {
        const Result<bool> more = csv->next();
        if (!more) return {};
        if (!*more) return lines;
        lines.emplace_back(csv->fields().begin(), csv->fields().end());
    }
    return {};
}

Lines linesIn(const std::string& text)
{
    return linesOf(CsvReader::over("text", text));
}

/// Returns a reader at the second line; with `units` the first line is its header.
Result<CsvReader> atSecond(const std::string& text, const std::vector<std::string>& units = {})
{
    Result<CsvReader> csv = CsvReader::over("text", text);
    if (!csv || !csv->next()) return csv;
    if (!units.empty()) csv->useAsHeader(units);
    if (const Result<bool> more = csv->next(); !more) return more.error();
    return csv;
}

TEST(CsvReader, splitsLinesAtCommas)
{
    const TemporaryDirectory dir;
    const std::string path = dir.write("a.csv", "a,b,c\n1,,3\n,\nx\n");
    EXPECT_EQ(linesOf(CsvReader::open(path)),
              (Lines{{"a", "b", "c"}, {"1", "", "3"}, {"", ""}, {"x"}}));
}

TEST(CsvReader, takesEveryLineEndAndAByteOrderMark)
{
    const Lines expected{{"a", "b"}, {"1", "2"}, {"3", "4"}};
    for (const char* text : {"\xEF\xBB\xBF"
                             "a,b\r\n1,2\n3,4\r\n",
                             "a,b\r1,2\r3,4\r", "a,b\n1,2\n3,4", "a,b\r\r\n1,2\r\r\n3,4\r\r\n"})
        EXPECT_EQ(linesIn(text), expected) << text;
}

TEST(CsvReader, readsQuotesAsRfc4180HasThem)
{
    EXPECT_EQ(linesIn("\"a\",\"b,c\"\n\"say \"\"x\"\"\",\"two\r\nlines\"\n \"d\" , e\n"),
              (Lines{{"a", "b,c"}, {"say \"x\"", "two\r\nlines"}, {"d", "e"}}));
    EXPECT_TRUE(refused(atSecond("a\n\"b\n"), "text", {"line 2", "a quote does not end"}));
    EXPECT_TRUE(refused(atSecond("a\n\"b\"c\n"), "text", {"line 2", "behind a closing quote"}));
    const Result<CsvReader> third = atSecond("\"a\nb\"\nc\n");
    ASSERT_TRUE(third);
    EXPECT_EQ(third->line(), 3);
}

TEST(CsvReader, skipsBlankLines)
{
    EXPECT_EQ(linesIn("\n \t\na\n\nb\r\n\r\n  \n"), (Lines{{"a"}, {"b"}}));
}

TEST(CsvReader, findsTheSeparatorInTheFirstLine)
{
    const Lines expected{{"a", "b"}, {"1,5", "2"}};
    EXPECT_EQ(linesIn("a;b\n1,5;2\n"), expected);
    EXPECT_EQ(linesIn("a\tb\n1,5\t2\n"), expected);
    EXPECT_EQ(linesIn("sep=;\na;b\n1,5;2\n"), expected);
    EXPECT_EQ(linesIn("\"sep=;\"\r\na;b\r\n1,5;2\r\n"), expected);
    EXPECT_EQ(linesIn("0,0;0,5;1,0\n"), (Lines{{"0,0", "0,5", "1,0"}}));
    EXPECT_EQ(linesIn("a,\tb\n"), (Lines{{"a", "b"}}));
}

TEST(CsvReader, refusesOtherSeparatorsByName)
{
    EXPECT_TRUE(refused(CsvReader::over("text", "run t_s pitch\n"), "text", {"by blanks"}));
    EXPECT_TRUE(refused(CsvReader::over("text", "run|t_s\n"), "text", {"by |"}));
    EXPECT_TRUE(refused(CsvReader::over("text", "a;b,c\n"), "text", {"more than one way"}));
    EXPECT_TRUE(refused(CsvReader::over("text", "sep=|\na|b\n"), "text", {"names a separator"}));
}

TEST(CsvReader, namesOtherKindsOfFiles)
{
    for (const auto& [bytes, cause] :
         {std::pair("\xFF\xFE"
                    "a\0,\0b\0"s,
                    "UTF-16"),
          std::pair("a\0,\0b\0\n\0"s, "UTF-16"), std::pair("PK\x03\x04 and more"s, "workbook"),
          std::pair("\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"s, "workbook"),
          std::pair("\x1F\x8B\x08 and more"s, "gzip"), std::pair("%PDF-1.7\n"s, "PDF"),
          std::pair("SQLite format 3\0 and more"s, "SQLite"), std::pair("a,b\n1,\0\n"s, "value 0")})
        EXPECT_TRUE(refused(CsvReader::over("text", bytes), "text", {cause})) << cause;
}

TEST(CsvReader, refusesEmptyFilesAndDirectories)
{
    const TemporaryDirectory dir;
    for (const char* text : {"", "\xEF\xBB\xBF", "\n\r\n \n", "# nothing\n"})
        EXPECT_TRUE(refused(CsvReader::over("text", text), "text", {"is empty"})) << text;
    EXPECT_TRUE(refused(CsvReader::open(dir.file("")), dir.file(""), {"directory"}));
}

TEST(CsvReader, findsAHeaderAmongRemarks)
{
    EXPECT_EQ(linesIn("# x,z\n0,1\n"), (Lines{{"x", "z"}, {"0", "1"}}));
    EXPECT_EQ(linesIn("# made by hand, twice\nx,z\n0,1\n"), (Lines{{"x", "z"}, {"0", "1"}}));
}

TEST(CsvReader, readsFiniteNumbersOnly)
{
    Result<CsvReader> csv = atSecond("x,y\n 1.5 ,-2e-3,+3,\xE2\x88\x92"
                                     "4,inf,-inf,1e999,1.2.3,0x1,1m,\"1,5\"\n");
    ASSERT_TRUE(csv);
    EXPECT_EQ(*csv->number(0, "x"), 1.5);
    EXPECT_EQ(*csv->number(1, "x"), -2e-3);
    EXPECT_EQ(*csv->number(2, "x"), 3.0);
    EXPECT_EQ(*csv->number(3, "x"), -4.0);
    for (std::size_t i = 4; i < 6; ++i)
        EXPECT_TRUE(refused(csv->number(i, "the x"), "text", {"line 2", "the x", "not finite"}));
    for (std::size_t i = 6; i < 11; ++i)
        EXPECT_TRUE(refused(csv->number(i, "the x"), "text", {"line 2", "the x", "not a number"}))
            << i;
}

TEST(CsvReader, recognisesFieldsThatMeanNotMeasured)
{
    Result<CsvReader> csv = atSecond("x,y\n,nan,NaN,NA,n/a,#N/A,NULL,None,1.#QNAN,0,-,no\n");
    ASSERT_TRUE(csv);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_TRUE(csv->isMissing(i)) << i;
    for (std::size_t i = 9; i < 12; ++i) EXPECT_FALSE(csv->isMissing(i)) << i;
    EXPECT_TRUE(refused(csv->number(0, "x"), "text", {"line 2", "x is empty"}));
    EXPECT_TRUE(refused(csv->number(1, "x"), "text", {"line 2", "x is not measured"}));
}

TEST(CsvReader, readsDecimalCommasWhereNoCommaSeparates)
{
    Result<CsvReader> csv = atSecond("a;b;c;d\n0,02;-0,5;7;1.234,5\n1.5;2;3;4\n");
    ASSERT_TRUE(csv);
    EXPECT_EQ(*csv->number(0, "a"), 0.02);
    EXPECT_EQ(*csv->number(1, "a"), -0.5);
    EXPECT_EQ(*csv->number(2, "a"), 7.0);
    EXPECT_TRUE(refused(csv->number(3, "d"), "text", {"d is not a number", "between thousands"}));
    ASSERT_TRUE(*csv->next());
    EXPECT_TRUE(
        refused(csv->number(0, "a"), "text", {"line 3: a is '1.5'", "line 2 has a decimal comma"}));
}

TEST(CsvReader, countsFieldsBelowAHeader)
{
    const std::vector<std::string> units{"m", "m"};
    EXPECT_TRUE(refused(atSecond("a,b\n1\n2,3\n", units), "text",
                        {"line 2", "has 1 fields where the header has 2"}));
    EXPECT_TRUE(refused(atSecond("a,b\n0,1,0,2\n", units), "text", {"decimal commas?"}));
    EXPECT_TRUE(refused(atSecond("a,b\n1", units), "text", {"is torn"}));
    const Result<CsvReader> whole = atSecond("a,b\n,\n1,2,,", units);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->line(), 3);
    EXPECT_EQ(whole->fields().size(), 2U);
    EXPECT_TRUE(whole->lacksLineEnd());
}

TEST(CsvReader, namesTheLineOfASecondTable)
{
    const std::vector<std::string> units{"", "s", "rad"};
    const auto before = [&](const std::string& line) {
        return atSecond("run,t_s,pitch\na,1,0.5\n" + line + "\nb,1x,c\n", units);
    };
    EXPECT_TRUE(refused(before("run,t_s,pitch")->next(), "text",
                        {"line 3: repeats the header: a second table begins here: save each"}));
    EXPECT_TRUE(refused(before("source,stamp")->next(), "text",
                        {"line 3: has 2 fields where the header has 3, and no number: does a "
                         "second table begin here?"}));
    EXPECT_TRUE(refused(before("run one,2.5")->next(), "text", {"correct or delete the line"}));
    Result<CsvReader> other = before("source,stamp,roll");
    ASSERT_TRUE(other && other->next());
    EXPECT_TRUE(refused(other->number(1, "t_s"), "text",
                        {"line 3: t_s is not a number: 'stamp', and its line holds none: does a "
                         "second table begin here?"}));
    ASSERT_TRUE(other->next());
    EXPECT_TRUE(refused(other->number(1, "t_s"), "text", {"'1x': write a number there"}));
}

TEST(CsvReader, skipsALineOfUnits)
{
    const std::vector<std::string> units{"", "rad", "A"};
    for (const char* line : {"-,rad,A", ",[rad],(A)", "name,rad,", "\"\",RAD,-"}) {
        const Result<CsvReader> csv = atSecond("run,pitch,current\n"s + line + "\n1,2,3\n", units);
        ASSERT_TRUE(csv) << line;
        EXPECT_EQ(csv->line(), 3) << line;
    }
    EXPECT_TRUE(refused(atSecond("run,pitch,current\n,deg,A\n", units), "text",
                        {"line 2: pitch is 'deg'", "its unit rad"}));
    EXPECT_EQ(atSecond("run,pitch,current\na,nan,nan\n", units)->line(), 2);
}

TEST(CsvReader, boundsFieldsAndTheirLength)
{
    const auto first = [](const std::string& line) {
        return CsvReader::over("text", line + "\n")->next();
    };
    EXPECT_TRUE(first(std::string(CsvReader::kMaxFields - 1, ',')));
    EXPECT_TRUE(refused(first(std::string(CsvReader::kMaxFields, ',')), "text",
                        {"line 1", "more than 100000 fields"}));
    const std::string longest(CsvReader::kMaxFieldLength, 'a');
    EXPECT_TRUE(first("b," + longest + "," + longest));
    for (const std::string& line :
         {"b," + longest + "a", longest + "a,b", "b,\"" + longest + "a\""})
        EXPECT_TRUE(refused(first(line), "text", {"line 1", "more than 65536 bytes"}));
}

TEST(CsvReader, keepsItsFieldsWhenItMoves)
{
    Result<CsvReader> csv = CsvReader::over("text", "a,\"b\"\"c\"\n");
    ASSERT_TRUE(csv && csv->next());
    const CsvReader moved = *std::move(csv);
    EXPECT_EQ(moved.fields().at(1), "b\"c");
    EXPECT_EQ(moved.line(), 1);
}

TEST(CsvText, makesNoFormulaOfAText)
{
    for (const char* text : {"=1+1", "+cmd", "-x", "@sum", "\tx", "\rx", "\nx", "+0.5 m",
                             "\xEF\xBC\x9D"
                             "1",
                             "'=1"}) {
        const std::string field = csvField(text);
        EXPECT_TRUE(field.starts_with("'") || field.starts_with("\"'")) << text;
    }
    for (const char* number : {"-0.5", "+0.5", "-1e-3", "-inf", "0"})
        EXPECT_EQ(csvField(number), number);
    EXPECT_EQ(csvField("a, b"), "\"a, b\"");
}

TEST(CsvText, survivesARoundTrip)
{
    for (const std::string text :
         {"=1+1", "'=1", "''-x", "-0.5", "'-0.5", "'quoted'", "", " a ", "a\"b", "two\nlines",
          "@,;\t", "\r", "'", "x;=1", "x;'=1", "\t=1;;+2\n@3"}) {
        Result<CsvReader> csv = CsvReader::over("text", "x," + csvField(text) + "\n");
        ASSERT_TRUE(csv && csv->next()) << text;
        EXPECT_EQ(csvText(csv->fields().at(1)), text) << text;
    }
}

TEST(CsvReader, skipsCommentsBelowAHeader)
{
    Result<CsvReader> csv = atSecond("a,b\n# made by hand\n1,2\n# the end\n", {"", ""});
    ASSERT_TRUE(csv);
    EXPECT_EQ(csv->line(), 3);
    EXPECT_FALSE(*csv->next());
    EXPECT_EQ(atSecond("a,b\n#1,2\n", {"", ""})->fields().front(), "#1") << "a text";
}

TEST(CsvReader, endsAtControlZAndIgnoresEmptyColumns)
{
    EXPECT_EQ(linesIn("a,b\n1,2\n\x1A"), (Lines{{"a", "b"}, {"1", "2"}}));
    const Result<CsvReader> csv = atSecond("a,b,,\n1,2,,\n", {"m", "m"});
    ASSERT_TRUE(csv);
    EXPECT_EQ(csv->fields().size(), 2U);
}

TEST(CsvReader, blankLinesAboveAHeaderCostTimeInProportion)
{
    const double began = threadMilliseconds();
    const std::string blank(1'000'000, '\n');
    EXPECT_EQ(linesIn(blank + "a,b\n1,2\n"), (Lines{{"a", "b"}, {"1", "2"}}));
    EXPECT_EQ(linesIn("# above\n" + blank + "# and below\na,b\n1,2\n"),
              (Lines{{"a", "b"}, {"1", "2"}}));
    EXPECT_LT(threadMilliseconds() - began, 10'000.0) << "quadratic, it takes minutes";
}

}  // namespace
}  // namespace terratact
