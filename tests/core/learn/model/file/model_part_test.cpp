#include "core/learn/model/file/model_part.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <array>
#include <functional>
#include <stdexcept>

#include "core/learn/model/file/model_file.h"
#include "tests/support/refusal.h"
#include "tests/support/sessions/execute_sql.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

const char* const kRobotHash = "robot";

/// Returns a whole model as one run over all bins writes it to "model.ttm".
const ModelData& wholeModel()
{
    static const ModelData whole = [] {
        ModelData model = toyModel(5);
        model.command = "terratact train --out model.ttm --seed 1";
        model.dataHash = "scenes";
        model.clearance.conditionalOpen[4] = {Eigen::VectorXd::Constant(21, 2.0), 1.0, 0.1};
        return model;
    }();
    return whole;
}

/// Returns what a run over these bins only would have made.
ModelPart partOf(const ModelData& whole, const std::string& list)
{
    const BinSet bins = *binSetFrom(list);
    ModelPart part{whole, {bins, kRobotHash, "terratact train --out ", " --seed 1"}};
    part.model.command = "terratact train --out part --seed 1 --bins " + list;
    ClearanceData& clearance = part.model.clearance;
    for (const int bin : binsOf(~bins)) {
        const auto i = static_cast<std::size_t>(bin);
        for (BinModelData* data : {&part.model.pa, &part.model.paf}) {
            data->bins[i] = {};
            data->logLikelihood[i] = 0.0;
        }
        clearance.open[i] = clearance.covered[i] = {};
        clearance.conditionalOpen[i] = clearance.conditionalCovered[i] = {};
        clearance.residuals.col(bin).setZero();
    }
    clearance.noveltyScale = clearance.contactBias = clearance.contactSd = 0.0;
    return part;
}

std::vector<NamedModelPart> partsOf(const std::vector<std::string>& lists)
{
    std::vector<NamedModelPart> parts;
    for (const std::string& list : lists)
        parts.push_back({list + ".ttp", partOf(wholeModel(), list)});
    return parts;
}

Result<ModelData> merged(const std::vector<NamedModelPart>& parts,
                         const std::string& robotHash = kRobotHash)
{
    return mergeModelParts(parts, absolem(), robotHash, "model.ttm");
}

TEST(MergeModelParts, givesTheModelOfOneRunForAnySplit)
{
    const std::vector<std::vector<std::string>> sharings{
        {"0-10"},
        {"0-3", "4-7", "8-10"},
        {"8-10", "0-3", "4-7"},
        {"0,2,4,6,8,10", "1,3,5,7,9"},
        {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10"}};
    for (const auto& sharing : sharings) {
        const auto model = merged(partsOf(sharing));
        ASSERT_TRUE(model) << model.error().text;
        EXPECT_EQ(contentHash(*model), contentHash(wholeModel()));
    }
}

TEST(MergeModelParts, givesTheSameAfterTheFile)
{
    const TemporaryDirectory dir;
    std::vector<NamedModelPart> parts = partsOf({"0-4", "5-10"});
    for (NamedModelPart& part : parts) {
        part.path = dir.file(part.path);
        ASSERT_TRUE(writeModelPart(part.path, part.part));
        auto read = readModelPart(part.path);
        ASSERT_TRUE(read) << read.error().text;
        EXPECT_EQ(read->portion.bins, part.part.portion.bins);
        EXPECT_EQ(read->model.command, part.part.model.command);
        part.part = *std::move(read);
    }
    const auto model = merged(parts);
    ASSERT_TRUE(model) << model.error().text;
    EXPECT_EQ(contentHash(*model), contentHash(wholeModel()));
}

TEST(MergeModelParts, namesMissingAndDuplicateBins)
{
    EXPECT_TRUE(refused(merged({}), "model.ttm", {"no part"}));
    EXPECT_TRUE(refused(merged(partsOf({"0-3", "8-10"})), "model.ttm",
                        {"bins 4-7 are in no part", "expected 0-10", "0-3.ttp (0-3)", "8-10.ttp"}));
    EXPECT_TRUE(refused(merged(partsOf({"0-5", "5-10"})), "5-10.ttp",
                        {"holds bins 5 a second time", "0-5.ttp (0-5)"}));
}

TEST(MergeModelParts, refusesPartsOfAnotherTraining)
{
    const auto refusesAfter = [](const std::function<void(ModelPart&)>& change,
                                 std::initializer_list<std::string_view> words) {
        std::vector<NamedModelPart> parts = partsOf({"0-5", "6-10"});
        change(parts[1].part);
        return refused(merged(parts), "6-10.ttp", words);
    };
    EXPECT_TRUE(refusesAfter([](ModelPart& p) { p.model.seed = 7; }, {"seed is 7, expected 0"}));
    EXPECT_TRUE(refusesAfter([](ModelPart& p) { p.model.dataHash = "other"; },
                             {"scenes' SHA-256 is other, expected scenes", "0-5.ttp"}));
    EXPECT_TRUE(refusesAfter([](ModelPart& p) { p.portion.robotHash = "other"; },
                             {"robot's SHA-256 is other"}));
    EXPECT_TRUE(refusesAfter([](ModelPart& p) { p.portion.commandAfterOut = " --seed 2"; },
                             {"its command is", "--seed 2", "--seed 1"}));
    EXPECT_TRUE(refusesAfter([](ModelPart& p) { p.model.heights(0, 0) += 1e-9; },
                             {"expected the training rows of 0-5.ttp"}));
    EXPECT_TRUE(refusesAfter([](ModelPart& p) { p.model.scannedHeights(0, 0) += 1e-9; },
                             {"expected the training rows of 0-5.ttp"}));
    EXPECT_TRUE(refusesAfter([](ModelPart& p) { p.model.heights.conservativeResize(40, kBins); },
                             {"expected the training rows of 0-5.ttp"}));
    EXPECT_TRUE(refused(merged(partsOf({"0-5", "6-10"}), "mine"), "0-5.ttp",
                        {"another robot", "expected mine"}));
}

struct ModelPartFile : testing::Test {
    const TemporaryDirectory dir;
    const std::string path = dir.file("part.ttp");
    const ModelPart part = partOf(wholeModel(), "2,4-5");

    ModelPartFile()
    {
        if (!writeModelPart(path, part)) throw std::runtime_error("no part");
    }
    testing::AssertionResult refusesAfter(const std::string& sql,
                                          std::initializer_list<std::string_view> words)
    {
        const std::string changed = dir.write("changed.ttp", contentOf(path));
        executeSql(changed, sql);
        return refused(readModelPart(changed), changed, words);
    }
};

TEST_F(ModelPartFile, isNoModelAndAModelIsNoPart)
{
    EXPECT_TRUE(refused(readModel(path), path, {"is a part of a model", "terratact merge"}));
    const std::string model = dir.file("model.ttm");
    ASSERT_TRUE(writeModel(model, wholeModel()));
    EXPECT_TRUE(refused(readModelPart(model), model, {"is a whole model, expected a part"}));
}

TEST_F(ModelPartFile, isRefusedOnceAltered)
{
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = '2,4' WHERE key = 'bins'", {}));
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = '4-5,2' WHERE key = 'bins'",
                             {"list of bins is wrong", "'4-5,2'"}));
    EXPECT_TRUE(
        refusesAfter("UPDATE meta SET value = 'x' WHERE key = 'robot_sha256'", {"altered"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM meta WHERE key = 'command_after_out'", {"lacks"}));
    EXPECT_TRUE(refusesAfter("UPDATE surface SET mean = 1.0 WHERE bin = 4", {"altered"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM bin WHERE bin = 5", {"bin ends too early"}));
    EXPECT_TRUE(refusesAfter("INSERT INTO surface VALUES(3, 0, 0.0, 1.0, 1.0, 1.0)",
                             {"surface holds a bin that does not exist"}));
    EXPECT_TRUE(refusesAfter("UPDATE residual_row SET \"h_-0.3_m\" = 0.5 WHERE row = 0",
                             {"residuals of a bin that is not in its list"}));
    EXPECT_TRUE(refusesAfter("UPDATE clearance SET value = 1.0", {"only a whole model has"}));
}

TEST_F(ModelPartFile, throwsRatherThanWriteAPartThatItWouldRefuse)
{
    const std::array<std::function<void(ModelPart&)>, 5> faults{
        [](ModelPart& p) { p.portion.bins.reset(); },
        [](ModelPart& p) { p.portion.bins.set(3); },
        [](ModelPart& p) { p.portion.bins.reset(4); },
        [](ModelPart& p) { p.model.clearance.noveltyScale = 1.0; },
        [](ModelPart& p) { p.model.pa.bins[2].signalSd = -1.0; },
    };
    for (const auto& fault : faults) {
        ModelPart wrong = part;
        fault(wrong);
        EXPECT_THROW(static_cast<void>(writeModelPart(path, wrong)), std::invalid_argument);
    }
}

}  // namespace
}  // namespace terratact
