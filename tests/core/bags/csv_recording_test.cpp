// Tests time series in CSV files.
#include "core/bags/csv_recording.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct CsvSeries : testing::Test {
    /// Returns the times of the rows, and the values of column `pitch`.
    std::vector<std::pair<std::int64_t, double>> rows(const std::string& content,
                                                      const CsvTime& time = {})
    {
        const std::string file = directory.file("a.csv");
        std::ofstream(file) << content;
        auto csv = openRecording(file, time);
        if (!csv) {
            why = csv.error().text;
            return {};
        }
        std::vector<std::pair<std::int64_t, double>> found;
        for (RecordedMessage message;;) {
            const auto more = (*csv)->next(message);
            if (!more) why = more.error().text;
            if (!more || !*more) break;
            found.emplace_back(message.time,
                               numberAt(*(*csv)->decode(message), "pitch").value_or(-1.0));
        }
        remarks = (*csv)->consumeRemarks();
        return found;
    }

    using Rows = std::vector<std::pair<std::int64_t, double>>;
    std::string why;
    std::vector<std::string> remarks;
    TemporaryDirectory directory;
};

TEST_F(CsvSeries, timesAreExactToTheNanosecond)
{
    EXPECT_EQ(rows("__time,pitch\n1793000000.123456789,0.5\n1793000000.223456789,0.25\n"),
              (Rows{{1'793'000'000'123'456'789, 0.5}, {1'793'000'000'223'456'789, 0.25}}));
    EXPECT_EQ(rows("%time,pitch\n1793000000123456789,0.5\n"),
              (Rows{{1'793'000'000'123'456'789, 0.5}}));
}

TEST_F(CsvSeries, theUnitOfTimesFollowsNameOrSize)
{
    EXPECT_EQ(rows("pitch,time_ms\n1,1500\n"), (Rows{{1'500'000'000, 1.0}}));
    EXPECT_EQ(rows("pitch,T [us]\n1,1500\n"), (Rows{{1'500'000, 1.0}}));
    EXPECT_EQ(rows("time,pitch\n1793000000123,1\n"), (Rows{{1'793'000'000'123'000'000, 1.0}}));
    EXPECT_EQ(rows("time,pitch\n0.5,1\n"), (Rows{{500'000'000, 1.0}}));
    EXPECT_EQ(rows("tick,pitch\n250,1\n", {.column = "tick", .unit = 1e-3}),
              (Rows{{250'000'000, 1.0}}));
    EXPECT_EQ(rows("time;pitch\n1,5e0;2,5\n"), (Rows{{1'500'000'000, 2.5}})) << "decimal commas";
}

TEST_F(CsvSeries, theUnitOfTimesFromTheBeginFollowsTheirSteps)
{
    for (const auto& [name, perSecond] :
         {std::pair{"s", 1e9}, {"ms", 1e6}, {"us", 1e3}, {"ns", 1.0}})
        for (const std::int64_t begin : {0LL, 1'793'000'000'000'000'000LL}) {
            Rows wanted;
            std::string text = "time,pitch\n";
            for (int i = 0; i < 5; ++i) {
                wanted.emplace_back(begin + i * 50'000'000LL, 0.5);
                const bool isWhole = perSecond < 1e9;
                const auto whole = wanted.back().first / static_cast<std::int64_t>(perSecond);
                text += isWhole ? fmt::format("{},0.5\n", whole)
                                : fmt::format("{}.{:02},0.5\n", whole, 5 * i);
            }
            EXPECT_EQ(rows(text), wanted) << name << " from " << begin << ": " << why;
            if (begin > 0 || perSecond == 1e9) {
                EXPECT_TRUE(remarks.empty());
                continue;
            }
            ASSERT_EQ(remarks.size(), 1U) << name;
            EXPECT_NE(remarks[0].find(fmt::format("is taken for {}; if it is not, name its unit "
                                                  "in the mapping: [csv] time_unit",
                                                  name)),
                      std::string::npos)
                << remarks[0];
        }
    EXPECT_EQ(rows("time,pitch\n0,0.5\n50,0.5\n", {.unit = 1.0}),
              (Rows{{0, 0.5}, {50'000'000'000, 0.5}}))
        << "the mapping decides";
}

TEST_F(CsvSeries, missingColumnsAndTimesAreNamed)
{
    EXPECT_TRUE(rows("a,pitch\n1,2\n").empty());
    EXPECT_NE(
        why.find("line 1: has no column of times; its columns are 'a', 'pitch'; name one in the "
                 "mapping: [csv] time_column"),
        std::string::npos)
        << why;
    rows("time,pitch\n1,2\nx,3\n");
    EXPECT_NE(why.find("line 3: time is not a number"), std::string::npos) << why;
    rows("time,pitch\n1e300,2\n");
    EXPECT_NE(why.find("later than the year 2262: name its unit"), std::string::npos) << why;
    rows("time_s,pitch\n1793000000123000000,2\n");
    EXPECT_NE(why.find("[csv] time_unit"), std::string::npos) << why;
}

TEST_F(CsvSeries, aSecondTableIsNamed)
{
    for (const auto& [line, cause] :
         {std::pair("time,pitch", "line 5: repeats the header: a second table begins here: save "
                                  "each table as a file of its own"),
          std::pair("stamp,roll", "line 5: time is not a number: 'stamp', and its line holds none: "
                                  "does a second table begin here?"),
          std::pair("stamp,roll,yaw", "line 5: has 3 fields where the header has 2, and no number: "
                                      "does a second table begin here?")}) {
        EXPECT_EQ(rows(fmt::format("time,pitch\n1,2\n2,3\n\n{}\n1,4\n", line)).size(), 2U);
        EXPECT_NE(why.find(cause), std::string::npos) << why;
    }
}

TEST_F(CsvSeries, aTornLastLineIsLeftOut)
{
    EXPECT_EQ(rows("time,pitch,roll\n1,2,3\n2,2"), (Rows{{1'000'000'000, 2.0}}));
    EXPECT_EQ(remarks, std::vector<std::string>{"ends within its last line, which is left out"});
}

TEST_F(CsvSeries, aLineOfUnitsIsLeftOutAndShown)
{
    EXPECT_EQ(rows("t,pitch,x\ns,deg,\n1,0.5,\n"), (Rows{{1'000'000'000, 0.5}}));
    EXPECT_EQ(remarks, std::vector<std::string>{
                           "line 2 holds no number but 's', 'deg', and is left out; where these "
                           "are units, the mapping must give them"});
    EXPECT_TRUE(rows("t,pitch\nx,0.5\n").empty());
    EXPECT_NE(why.find("line 2: t is not a number: 'x'"), std::string::npos) << why;
}

TEST_F(CsvSeries, infiniteNumbersAreNoTexts)
{
    for (const char* const infinite : {"inf", "-inf", "Infinity"}) {
        const std::string file = directory.write("a.csv", fmt::format("t,pitch\n1,{}\n", infinite));
        const auto csv = openRecording(file);
        ASSERT_TRUE(csv) << csv.error().text;
        RecordedMessage message;
        ASSERT_TRUE((*csv)->next(message));
        const auto row = (*csv)->decode(message);
        ASSERT_TRUE(row);
        EXPECT_EQ(row->parts.at(1).kind, FieldValue().kind) << infinite;
    }
}

TEST_F(CsvSeries, datesAreNamed)
{
    EXPECT_TRUE(rows("t,pitch\n2024-01-02 03:04:05.678,0.5\n").empty());
    EXPECT_NE(why.find("line 2: 't' is '2024-01-02 03:04:05.678', a date or a clock, expected a "
                       "number: export times as seconds"),
              std::string::npos)
        << why;
}

}  // namespace
}  // namespace terratact
