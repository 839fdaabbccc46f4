#include "app/modelling/findings.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "app/modelling/findings_file.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

constexpr std::size_t kScenes = 10;

BinError errorOf(std::size_t scene, const std::string& label)
{
    const double x = 0.1 * static_cast<double>(scene) + 1.0 / 3.0;
    BinError e{.scene = scene, .label = label, .bin = static_cast<int>(scene), .error = -x};
    e.scores = {
        .crps = x, .pit = 0.25, .in50 = true, .in80 = false, .in95 = true, .width = 2.0 * x};
    e.origin = scene % 2 == 0 ? Origin::Arm : Origin::Contact;
    e.novelty = x;
    return e;
}

/// Returns the findings of one part's scenes.
Findings findingsOf(Shard shard)
{
    Findings f;
    f.origin = {{"command", "terratact evaluate"}, {"scenes' SHA-256", "scenes"}};
    f.options = {.methods = {Method::Local},
                 .seed = ~std::uint64_t{0},
                 .stepLimit = 0.1,
                 .sdLimit = 0.06,
                 .classes = true};
    f.shard = shard;
    f.total = kScenes;
    const std::size_t begin = shard.begin(kScenes), end = shard.end(kScenes);
    for (std::size_t k = begin; k < end; ++k)
        f.scenes.push_back({"run, \"" + std::to_string(k / 3) + "\"",
                            0.1 * static_cast<double>(k),
                            {static_cast<int>(k), 10},
                            "kind"});
    ProbeRun probes{"local", "sd", {}};
    for (const char* label : {"local", "flat"}) {
        f.runs.push_back({label, end - begin, end - begin - 1, 2, 1, 1, 0.5});
        for (std::size_t k = begin; k < end; ++k) {
            if (k % 4 == 3) continue;
            f.errors.push_back(errorOf(k, label));
            f.steps.push_back({k, label, StepPlace::Ahead, 1.0 / 3.0, k % 2 == 0});
        }
    }
    for (std::size_t k = begin; k < end; ++k)
        probes.trials.push_back({{0.1, 0.2}, {0.05, 1.0 / static_cast<double>(k + 1)}, 2, true});
    f.probes = {probes};
    return f;
}

std::vector<NamedFindings> partsOf(int count)
{
    std::vector<NamedFindings> parts;
    for (int k = count; k >= 1; --k)
        parts.push_back({std::to_string(k) + ".tte", findingsOf({k, count})});
    return parts;
}

void expectSame(const Findings& a, const Findings& b)
{
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.options, b.options);
    EXPECT_EQ(a.shard, b.shard);
    EXPECT_EQ(a.total, b.total);
    EXPECT_EQ(a.scenes, b.scenes);
    EXPECT_EQ(a.errors, b.errors);
    ASSERT_EQ(a.steps.size(), b.steps.size());
    for (std::size_t k = 0; k < a.steps.size(); ++k) {
        EXPECT_EQ(a.steps[k].scene, b.steps[k].scene);
        EXPECT_EQ(a.steps[k].label, b.steps[k].label);
        EXPECT_EQ(a.steps[k].place, b.steps[k].place);
        EXPECT_EQ(a.steps[k].probability, b.steps[k].probability);
        EXPECT_EQ(a.steps[k].observed, b.steps[k].observed);
    }
    ASSERT_EQ(a.probes.size(), b.probes.size());
    for (std::size_t k = 0; k < a.probes.size(); ++k) {
        const auto &p = a.probes[k].trials, &q = b.probes[k].trials;
        ASSERT_EQ(p.size(), q.size());
        for (std::size_t t = 0; t < p.size(); ++t)
            EXPECT_TRUE(p[t].before == q[t].before && p[t].after == q[t].after
                        && p[t].probes == q[t].probes && p[t].settled == q[t].settled);
    }
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
        expectSame(*merged, findingsOf({1, 1}));
        EXPECT_EQ(merged->runs[1].scenes, kScenes);
        EXPECT_EQ(merged->runs[1].failed, static_cast<std::size_t>(count));
        EXPECT_EQ(merged->runs[1].seconds, 0.5 * count);
    }
}

TEST(MergeFindings, namesPartsThatAreMissingOrThereTwice)
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
            f = findingsOf({1, 3});
        },
        {"number of parts is 3, expected 2"}));
    EXPECT_TRUE(refusesAfter([](Findings& f) { f.total = 11; }, {"scenes is 11, expected 10"}));
    EXPECT_TRUE(refusesAfter([](Findings& f) { f.options.stepLimit = 0.2; }, {"options"}));
    EXPECT_TRUE(refusesAfter([](Findings& f) { f.runs.pop_back(); }, {"list of methods"}));
}

struct FindingsFile : testing::Test {
    const TemporaryDirectory dir;
    const std::string path = dir.file("part.tte");
    const Findings findings = findingsOf({2, 3});

    FindingsFile()
    {
        if (!writeFindings(path, findings)) throw std::runtime_error("no findings");
    }
    testing::AssertionResult refusesAfter(const std::string& sql,
                                          std::initializer_list<std::string_view> words)
    {
        const std::string changed = dir.write("changed.tte", contentOf(path));
        sqlite3* file = nullptr;
        sqlite3_open(changed.c_str(), &file);
        const int code = sqlite3_exec(file, sql.c_str(), nullptr, nullptr, nullptr);
        sqlite3_close(file);
        if (code != SQLITE_OK) return testing::AssertionFailure() << sql;
        return refused(readFindings(changed), changed, words);
    }
};

TEST_F(FindingsFile, everyNumberSurvivesARoundTrip)
{
    const auto read = readFindings(path);
    ASSERT_TRUE(read) << read.error().text;
    expectSame(*read, findings);
    ASSERT_EQ(read->runs.size(), 2U);
    EXPECT_EQ(read->runs[1].label, "flat");
    EXPECT_EQ(read->runs[1].converged, findings.runs[1].converged);
    EXPECT_EQ(read->runs[1].endedBySweeps, 2U);
    EXPECT_EQ(read->runs[1].endedByTime, 1U);
    EXPECT_EQ(read->runs[1].seconds, 0.5);
    EXPECT_EQ(read->probes[0].rule, "sd");
}

TEST_F(FindingsFile, isDistinguishedFromOtherFiles)
{
    EXPECT_TRUE(isFindingsFile(path));
    EXPECT_FALSE(isFindingsFile(dir.file("none.tte")));
    EXPECT_FALSE(isFindingsFile(dir.write("short.tte", "SQLite format 3")));
    EXPECT_TRUE(refusesAfter("PRAGMA application_id = 7", {"another application"}));
    EXPECT_TRUE(refusesAfter("PRAGMA user_version = 9", {"version 9", "reads version 2"}));
    EXPECT_TRUE(refusesAfter("CREATE TABLE zebra(x)", {"tables"}));
}

TEST_F(FindingsFile, isRefusedAfterModification)
{
    EXPECT_TRUE(refusesAfter("UPDATE bin_error SET error_m = 0.5 WHERE position = 1", {"altered"}));
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = 'x' WHERE key = 'command'", {"altered"}));
    EXPECT_TRUE(refusesAfter("UPDATE part SET seed = '1'", {"altered"}));
    EXPECT_TRUE(refusesAfter("UPDATE part SET seed = '1x'", {"seed is not a number"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM part", {"which part"}));
    EXPECT_TRUE(refusesAfter("UPDATE part SET number = 3", {}));
    EXPECT_TRUE(refusesAfter("UPDATE part SET number = 4", {"out of range in its table part"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM scene WHERE position = 0", {"not numbered from 0"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM scene WHERE position = 2", {"scenes of its part"}));
    EXPECT_TRUE(
        refusesAfter("UPDATE bin_error SET scene = 9 WHERE position = 1", {"out of range"}));
    EXPECT_TRUE(refusesAfter("UPDATE bin_error SET run = 2 WHERE position = 1", {"out of range"}));
    EXPECT_TRUE(refusesAfter("UPDATE bin_error SET error_m = 9e999", {"out of range"}));
    EXPECT_TRUE(refusesAfter("UPDATE method SET name = 'guess'", {"unknown method", "'guess'"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM method_run", {"lacks a method"}));
}

}  // namespace
}  // namespace terratact
