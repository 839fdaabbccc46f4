#include "core/store/csv_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/store/csv_reader.h"

namespace terratact {
namespace {

TEST(CsvText, aLineQuotesEachFieldAndEnds)
{
    EXPECT_EQ(csvLine(std::array<std::string, 3>{"a", "b, c", ""}), "a,\"b, c\",\n");
    EXPECT_EQ(csvLine({}), "\n");
}

TEST(CsvText, aLineDefusesFormulasButNotNumbers)
{
    EXPECT_EQ(csvLine(std::array<std::string, 3>{"=1+1", "-0.5", "+2"}), "'=1+1,-0.5,+2\n");
}

/// Returns the cells of a spreadsheet that separates at this character: a quote counts only where a
/// cell begins.
std::vector<std::string> cellsOf(const std::string& file, char separator)
{
    std::vector<std::string> cells(1);
    bool isQuoted = false;
    for (std::size_t i = 0; i < file.size(); ++i) {
        const char c = file[i];
        const bool isFirst = cells.back().empty() && (i == 0 || file[i - 1] != '"');
        if (isQuoted && c == '"' && file.substr(i, 2) == "\"\"")
            cells.back() += file[++i];
        else if (c == '"' && (isQuoted || isFirst))
            isQuoted = !isQuoted;
        else if (!isQuoted && (c == separator || c == '\n' || c == '\r'))
            cells.emplace_back();
        else
            cells.back() += c;
    }
    return cells;
}

TEST(CsvText, noSeparatorMakesAFormulaOfAPart)
{
    for (const std::string end : {";", "\t", "\n", "\r\n", ";;", "\t;"})
        for (const std::string sign :
             {"=", "+", "-", "@", " =", "\"=", "'=", " \"'=", "\xEF\xBC\x9D"})
            for (const std::string begin : {"x", "", "\"", "\"x\"", "-5"}) {
                const std::string text = begin + end + sign + "1+1" + end + "y";
                const std::string line = csvLine({291, text, "z" + text, -0.5, "y"});
                for (const char separator : {',', ';', '\t'})
                    for (const std::string& cell : cellsOf(line, separator)) {
                        const auto first = cell.find_first_not_of(" \"");
                        if (first == std::string::npos || cell == "-0.5") continue;
                        EXPECT_EQ(std::string("=+-@\xEF").find(cell[first]), std::string::npos)
                            << line << "separated at " << separator << ": " << cell;
                    }
                auto csv = CsvReader::over("test", "first," + line);
                ASSERT_TRUE(csv && *csv->next()) << line;
                EXPECT_EQ(csvText(csv->fields().at(2)), text);
            }
}

TEST(CsvText, onlyAPartThatIsAFormulaIsDefused)
{
    EXPECT_EQ(csvField("x;=1+1;y"), "\"x;'=1+1;y\"");
    EXPECT_EQ(csvField("a; b\r\nc"), "\"a; b\r\nc\"");
    EXPECT_EQ(csvField("0.1 m, -0.2 m"), "\"0.1 m, -0.2 m\"") << "commas are ours: the quotes hold";
    EXPECT_EQ(csvField("'quoted'; 'too'"), "\"'quoted'; 'too'\"");
}

TEST(CsvText, aLineWritesNumbersAsShortAsPossible)
{
    EXPECT_EQ(csvLine({0.1, -0.0001, 3, std::size_t{7}, true, std::uint8_t{200}}),
              "0.1,-0.0001,3,7,1,200\n");
    EXPECT_EQ(csvLine({std::optional<double>(), std::optional(2.5), CsvValue()}), ",2.5,\n");
    EXPECT_EQ(csvLine({-std::numeric_limits<double>::infinity(), std::string("-inf")}),
              "-inf,-inf\n");
}

TEST(CsvText, aNumberKeepsItsDigits)
{
    EXPECT_EQ(
        csvLine({signedTenth(0.0), signedTenth(-0.3), rounded(1234.5678, 6), rounded(0.5, 3)}),
        "+0.0,-0.3,1234.57,0.5\n");
}

TEST(CsvText, aLineReadsBackAsItsFields)
{
    const std::vector<std::string> fields{"x", "two\nlines", "\"quoted\"", "-SUM(A1)", " outer "};
    auto csv = CsvReader::over("test", csvLine(fields));
    ASSERT_TRUE(csv) << csv.error().text;
    ASSERT_TRUE(*csv->next());
    ASSERT_EQ(csv->fields().size(), fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) EXPECT_EQ(csvText(csv->fields()[i]), fields[i]);
}

}  // namespace
}  // namespace terratact
