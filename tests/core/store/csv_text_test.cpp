#include "core/store/csv_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
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
