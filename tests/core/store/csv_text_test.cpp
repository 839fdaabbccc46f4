#include "core/store/csv_text.h"

#include <gtest/gtest.h>

#include <array>
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
