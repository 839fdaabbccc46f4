//
#include "app/modelling/findings.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/support/refusal.h"
#include "tests/support/some_findings.h"

namespace terratact {
namespace {

std::vector<NamedFindings> partsOf(int count)
{
    std::vector<NamedFindings> parts;
    for (int k = count; k >= 1; --k)
        parts.push_back({std::to_string(k) + ".tte", someFindings({k, count})});
    return parts;
}

TEST(Shard, everySceneBelongsToOnePart)
{
    for (const std::size_t total : {1U, 7U, 64U, 1400U})
        for (int count = 1; count <= 9; ++count) {
            std::size_t next = 0;
            for (int k = 1; k <= count; ++k) {
                const Shard shard{k, count};
                EXPECT_EQ(shard.begin(total), next);
                EXPECT_LE(shard.end(total) - next, total / static_cast<std::size_t>(count) + 1);
                next = shard.end(total);
            }
            EXPECT_EQ(next, total);
        }
}

TEST(Shard, isReadFromText)
{
    EXPECT_EQ(shardFrom("2/8"), (Shard{2, 8}));
    EXPECT_EQ(shardFrom("10000/10000"), (Shard{10'000, 10'000}));
    for (const char* wrong : {"", "/", "1", "1/", "/2", "0/2", "3/2", "-1/2", "1/2/3", "1/10001",
                              "a/b", "1 /2", "1/2 ", "1.0/2"})
        EXPECT_FALSE(shardFrom(wrong)) << wrong;
}

TEST(MergeFindings, givesTheFindingsOfOneRun)
{
    for (const int count : {1, 2, 3, 7, 10}) {
        const auto merged = mergeFindings(partsOf(count), "out");
        ASSERT_TRUE(merged) << merged.error().text;
        expectSame(*merged, someFindings({1, 1}));
        EXPECT_EQ(merged->runs[1].scenes, kFindingScenes);
        EXPECT_EQ(merged->runs[1].failed, static_cast<std::size_t>(count));
        EXPECT_EQ(merged->runs[1].seconds, 0.5 * count);
    }
}

TEST(MergeFindings, namesMissingAndDuplicateParts)
{
    EXPECT_TRUE(refused(mergeFindings({}, "out"), "out", {"no part"}));
    auto parts = partsOf(4);
    parts.push_back(parts[1]);
    parts.back().path = "again.tte";
    EXPECT_TRUE(
        refused(mergeFindings(parts, "out"), "again.tte", {"part 3 of 4 a second time", "3.tte"}));
    parts = partsOf(4);
    parts.erase(parts.begin() + 1, parts.begin() + 3);
    EXPECT_TRUE(refused(mergeFindings(parts, "out"), "out", {"expected 4 parts", "2/4, 3/4"}));
}

TEST(MergeFindings, refusesPartsOfAnotherEvaluation)
{
    const auto refusesAfter = [](const std::function<void(Findings&)>& change,
                                 std::initializer_list<std::string_view> words) {
        auto parts = partsOf(2);
        change(parts[1].findings);
        return refused(mergeFindings(parts, "out"), "1.tte", words);
    };
    EXPECT_TRUE(refusesAfter([](Findings& f) { f.origin["command"] += " --seed 2"; },
                             {"its command is terratact evaluate --seed 2", "as in 2.tte"}));
    EXPECT_TRUE(refusesAfter([](Findings& f) { f.origin.erase("scenes' SHA-256"); },
                             {"is (none), expected scenes"}));
    EXPECT_TRUE(refusesAfter(
        [](Findings& f) {
            f = someFindings({1, 3});
        },
        {"number of parts is 3, expected 2"}));
    EXPECT_TRUE(refusesAfter([](Findings& f) { f.total = 11; }, {"scenes is 11, expected 10"}));
    EXPECT_TRUE(refusesAfter([](Findings& f) { f.options.stepLimit = 0.2; }, {"options"}));
    EXPECT_TRUE(refusesAfter([](Findings& f) { f.runs.pop_back(); }, {"list of methods"}));
}

}  // namespace
}  // namespace terratact
