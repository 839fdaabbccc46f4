#include "core/learn/model/file/model_file.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>

#include <array>
#include <csignal>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/support/random_model.h"
#include "tests/support/refusal.h"
#include "tests/support/sessions/execute_sql.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct ModelFile : testing::Test {
    const TemporaryDirectory dir;
    const std::string path = dir.file("model.ttm");
    const ModelData model = randomModel(3);

    ModelFile()
    {
        if (!writeModel(path, model)) throw std::runtime_error("no model");
    }
    /// Returns whether the model's file is refused after the SQL was executed on it.
    testing::AssertionResult refusesAfter(const std::string& sql,
                                          std::initializer_list<std::string_view> parts)
    {
        const std::string changed = dir.write("changed.ttm", contentOf(path));
        executeSql(changed, sql);
        return refused(readModel(changed), changed, parts);
    }
    testing::AssertionResult refuses(const std::string& content,
                                     std::initializer_list<std::string_view> parts)
    {
        const std::string changed = dir.write("changed.ttm", content);
        return refused(readModel(changed), changed, parts);
    }
};

TEST_F(ModelFile, everyModelSurvivesARoundTrip)
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const ModelData sent = randomModel(seed, seed);
        ASSERT_TRUE(writeModel(path, sent));
        const Result<StoredModel> got = readModel(path);
        ASSERT_TRUE(got) << got.error().text;
        EXPECT_TRUE(same(got->data, sent));
        EXPECT_EQ(got->contentHash, contentHash(sent));
    }
    EXPECT_EQ(dir.entries(), std::set<std::string>{"model.ttm"});
}

TEST_F(ModelFile, storesTheNumberOfInducingRowsIfThereIsOne)
{
    ModelData sparse = model;
    sparse.inducing = 350;
    ASSERT_TRUE(writeModel(path, sparse));
    const auto got = readModel(path);
    ASSERT_TRUE(got) << got.error().text;
    EXPECT_EQ(got->data.inducing, 350);
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = '-5' WHERE key = 'inducing_rows'",
                             {"inducing row count", "-5"}));
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = '351' WHERE key = 'inducing_rows'",
                             {"content was altered"}));
    ASSERT_TRUE(writeModel(path, model));
    EXPECT_EQ(contentOf(path).find("inducing_rows"), std::string::npos);
}

TEST_F(ModelFile, storesTheNumberOfRepeatedRowsIfThereIsOne)
{
    ModelData repeated = model;
    repeated.repeats = 2;
    ASSERT_TRUE(writeModel(path, repeated));
    const auto got = readModel(path);
    ASSERT_TRUE(got) << got.error().text;
    EXPECT_EQ(got->data.repeats, 2);
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = 'two' WHERE key = 'repeated_rows'",
                             {"repeated row count", "two"}));
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = '3' WHERE key = 'repeated_rows'",
                             {"repeated rows", "out of range"}));
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = '1' WHERE key = 'repeated_rows'",
                             {"content was altered"}));
    ASSERT_TRUE(writeModel(path, model));
    EXPECT_EQ(contentOf(path).find("repeated_rows"), std::string::npos);
}

TEST_F(ModelFile, storesTheSdOfHeightsIfThereIsOne)
{
    ModelData measured = model;
    measured.heightSd = Eigen::MatrixXd::Constant(model.heights.rows(), kBins, 0.0125);
    ASSERT_TRUE(writeModel(path, measured));
    const auto got = readModel(path);
    ASSERT_TRUE(got) << got.error().text;
    EXPECT_EQ(got->data.heightSd, measured.heightSd);
    EXPECT_TRUE(refusesAfter("UPDATE height_sd_row SET \"sd_+0.0_m\" = -1 WHERE row = 0",
                             {"sd of a height", "sd_+0.0_m is -1"}));
    EXPECT_TRUE(refusesAfter("UPDATE height_sd_row SET \"sd_+0.0_m\" = 0.5 WHERE row = 0",
                             {"content was altered"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM height_sd_row WHERE row > 0", {"do not fit"}));
    ASSERT_TRUE(writeModel(path, model));
    EXPECT_EQ(contentOf(path).find("height_sd"), std::string::npos);
}

TEST_F(ModelFile, storesUnknownHeightsIfThereAreSome)
{
    ModelData holed = model;
    holed.unknownBins.assign(static_cast<std::size_t>(model.heights.rows()), 0U);
    holed.unknownBins.back() = 1U << 10U;  // open in every row: no process has it as inducing row
    holed.heights(model.heights.rows() - 1, 10) = 0.0;
    holed.clearance.residuals(model.heights.rows() - 1, 10) = 0.0;
    auto& open = holed.clearance.open[10];
    open.weights.conservativeResize(open.weights.size() - 1);
    ASSERT_TRUE(writeModel(path, holed));
    const auto got = readModel(path);
    ASSERT_TRUE(got) << got.error().text;
    EXPECT_EQ(got->data.unknownBins, holed.unknownBins);
    EXPECT_EQ(got->contentHash, contentHash(holed));
    EXPECT_TRUE(refusesAfter("UPDATE unknown_bins_row SET unknown_bins = 2048 WHERE row = 1",
                             {"unknown height", "does not exist"}));
    EXPECT_TRUE(refusesAfter("UPDATE unknown_bins_row SET unknown_bins = 512 WHERE row = 2",
                             {"a number for a height that is unknown"}));
    EXPECT_TRUE(refusesAfter("UPDATE unknown_bins_row SET unknown_bins = 0", {"names none"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM unknown_bins_row WHERE row > 0", {"do not fit"}));
    EXPECT_TRUE(refusesAfter("DROP TABLE unknown_bins_row", {"another kind of model"}));
    ASSERT_TRUE(writeModel(path, model));
    EXPECT_EQ(contentOf(path).find("unknown_bins"), std::string::npos);
}

TEST_F(ModelFile, numbersThatSqliteStoresInOtherFormsSurvive)
{
    ModelData sent = model;
    sent.heights.row(0) << -0.0, 0.0, 1.0, -5.0, 5e-324, 1e-300, 0.1, 1.0 / 3.0, -1e-17,
        4.999999999999999, 2.0;
    sent.paf.bins[4].noiseSd = 0.0;
    sent.paf.bins[4].signalSd = 1.0;
    sent.command = "čárka, \"uvozovky\"\n" + std::string(1000, 'x');
    sent.seed = 0;
    ASSERT_TRUE(writeModel(path, sent));
    const Result<StoredModel> got = readModel(path);
    ASSERT_TRUE(got) << got.error().text;
    EXPECT_TRUE(same(got->data, sent));
}

TEST_F(ModelFile, theSameModelGivesTheSameBytes)
{
    ASSERT_TRUE(writeModel(dir.file("again.ttm"), model));
    EXPECT_EQ(contentOf(dir.file("again.ttm")), contentOf(path));
}

TEST_F(ModelFile, aModelOf1400RowsIsBelowTwoMegabytes)
{
    ASSERT_TRUE(writeModel(path, randomModel(1400)));
    EXPECT_LT(std::filesystem::file_size(path), 2'000'000U);
    EXPECT_TRUE(readModel(path));
}

TEST_F(ModelFile, carriesTheNumbersOfItsFormat)
{
    const std::string bytes = contentOf(path);
    EXPECT_EQ(bytes.substr(68, 4), "TTM1");
    EXPECT_EQ(bytes.substr(60, 4), std::string("\0\0\0\3", 4));
}

TEST_F(ModelFile, everyTruncationIsRefused)
{
    const std::string bytes = contentOf(path);
    EXPECT_TRUE(refuses("", {"is empty"}));
    for (std::size_t size = 1; size < bytes.size(); size += size < 200 ? 1 : 97)
        ASSERT_TRUE(refuses(bytes.substr(0, size), {})) << size;
    EXPECT_TRUE(refuses(bytes.substr(0, bytes.size() - 1),
                        {"truncated", std::to_string(bytes.size() - 1)}));
    EXPECT_TRUE(refuses(bytes.substr(0, bytes.size() - 4096), {"truncated"}));
    EXPECT_TRUE(refuses(bytes + "x", {"bytes where its header says"}));
}

// Flips all bits of the header and of the beginning of every page, which hold the layout. Of the
// other bytes it flips one bit in every ninth.
TEST_F(ModelFile, everyBitFlipIsRefusedOrChangesNothing)
{
    const std::string bytes = contentOf(path);
    const std::string hash = contentHash(model);
    const std::string changed = dir.write("changed.ttm", bytes);
    std::fstream file(changed, std::ios::in | std::ios::out | std::ios::binary);
    const auto put = [&file](std::size_t at, char byte) {
        file.seekp(static_cast<std::streamoff>(at));
        file.put(byte).flush();
    };
    int refusals = 0, flips = 0;
    const auto flip = [&](std::size_t at, std::size_t bit) {
        put(at, static_cast<char>(bytes[at] ^ (1 << bit)));
        const Result<StoredModel> got = readModel(changed);
        EXPECT_EQ(got ? got->contentHash : hash, hash) << "byte " << at << " bit " << bit;
        refusals += !got;
        ++flips;
        put(at, bytes[at]);
    };
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        const bool layout = at < 100 || at % 4096 < 12;
        for (std::size_t bit = 0; bit < 8 && layout; ++bit) flip(at, bit);
        if (!layout && at % 31 == 0) flip(at, at / 31 % 8);
    }
    EXPECT_GT(refusals, flips / 3);  // much of a small file is free space
    EXPECT_TRUE(readModel(changed)) << "put back";
}

TEST_F(ModelFile, refusesWhatIsNoModel)
{
    EXPECT_TRUE(refuses(std::string(5000, 'x'), {"not an SQLite file"}));
    EXPECT_TRUE(refuses("SQLite format 3", {"not an SQLite file"}));
    EXPECT_TRUE(refused(readModel(dir.file("")), dir.file(""), {"is a directory"}));
    const std::string none = dir.file("none.ttm");
    EXPECT_TRUE(refused(readModel(none), none, {"cannot be opened", "No such file"}));
    const std::string other = dir.file("other.db");
    executeSql(other, "CREATE TABLE song(title TEXT); INSERT INTO song VALUES('x')");
    EXPECT_TRUE(refused(readModel(other), other, {"another application"}));
    EXPECT_FALSE(std::filesystem::exists(none));
}

TEST_F(ModelFile, refusesOtherVersionsAndTables)
{
    EXPECT_TRUE(refusesAfter("PRAGMA application_id = 7", {"another application"}));
    EXPECT_TRUE(refusesAfter("PRAGMA user_version = 1", {"version 1", "reads versions 3 and 4"}));
    EXPECT_TRUE(refusesAfter("CREATE TABLE zebra(x)", {"tables"}));
    EXPECT_TRUE(refusesAfter("CREATE VIEW a AS SELECT 1", {"tables"}));
    EXPECT_TRUE(
        refusesAfter("CREATE TRIGGER t AFTER INSERT ON meta BEGIN SELECT 1; END", {"tables"}));
    EXPECT_TRUE(refusesAfter("CREATE INDEX i ON meta(value)", {"tables"}));
    EXPECT_TRUE(refusesAfter("DROP TABLE meta", {"tables"}));
    EXPECT_TRUE(
        refusesAfter("ALTER TABLE bin RENAME COLUMN signal_sd_m TO signal_sd_mm", {"tables"}));
}

TEST_F(ModelFile, refusesModelsOfOtherFeatures)
{
    EXPECT_TRUE(refusesAfter(
        "UPDATE input SET name = 'roll_rad' WHERE feature_set = 'pa' AND position = 11",
        {"other features", "'roll_rad [rad]'", "pitch_rad [rad]"}));
    EXPECT_TRUE(
        refusesAfter("UPDATE input SET unit = 'mm' WHERE feature_set = 'paf' AND position = 0",
                     {"other features", "'h_-0.3_m [mm]'", "h_-0.3_m [m]"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM input WHERE feature_set = 'paf' AND position = 21",
                             {"input ends too early"}));
    EXPECT_TRUE(refusesAfter("INSERT INTO input VALUES('pa', 14, 'x', 'm', 0.0, 1.0)",
                             {"input has too many"}));
    EXPECT_TRUE(refusesAfter("INSERT INTO input VALUES('pb', 0, 'x', 'm', 0.0, 1.0)",
                             {"feature set other than"}));
    EXPECT_TRUE(refusesAfter("UPDATE bin SET name = 'h_+0.8_m' WHERE bin = 10",
                             {"other bins", "'h_+0.8_m'"}));
    EXPECT_TRUE(refusesAfter(
        "UPDATE length_scale SET input = 20 WHERE feature_set = 'pa' AND bin = 1 AND input = 0",
        {"length_scale"}));
}

TEST_F(ModelFile, refusesNumbersThatCannotPredict)
{
    EXPECT_TRUE(refusesAfter("UPDATE input SET sd = 0.0 WHERE position = 3",
                             {"standard deviation", "is 0"}));
    EXPECT_TRUE(refusesAfter("UPDATE input SET mean = 9e999 WHERE position = 3", {"mean"}));
    EXPECT_TRUE(
        refusesAfter("UPDATE length_scale SET length_scale = -1.0", {"length scale", "is -1"}));
    EXPECT_TRUE(refusesAfter("UPDATE length_scale SET length_scale = 1e300", {"length scale"}));
    EXPECT_TRUE(refusesAfter("UPDATE bin SET signal_sd_m = 0.0", {"signal_sd", "is 0"}));
    EXPECT_TRUE(refusesAfter("UPDATE bin SET noise_sd_m = -0.1", {"noise_sd"}));
    EXPECT_TRUE(refusesAfter("UPDATE bin SET log_likelihood = -9e999", {"log_likelihood"}));
    EXPECT_TRUE(refusesAfter("UPDATE training_row SET \"h_+0.1_m\" = 240.0 WHERE row = 2",
                             {"training row 2", "h_+0.1_m is 240", "mm"}));
    EXPECT_TRUE(
        refusesAfter("UPDATE training_row SET force_3_n = -1.0", {"training row 0", "force_3_n"}));
    EXPECT_TRUE(refusesAfter("UPDATE scanned_row SET \"h_+0.1_m\" = 240.0 WHERE row = 0",
                             {"scanned row", "h_+0.1_m is 240"}));
    EXPECT_TRUE(refusesAfter("UPDATE surface SET residual_sd = 0.0 WHERE bin = 2",
                             {"residual_sd of the surface of bin 2"}));
    EXPECT_TRUE(refusesAfter("UPDATE surface_scale SET length_scale = 0.0 WHERE bin = 3",
                             {"length scale of the surface of bin 3"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM surface_weight WHERE bin = 0 AND position = 0",
                             {"surface_weight is not numbered from 0"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM surface WHERE bin = 4", {"surface ends too early"}));
    EXPECT_TRUE(refusesAfter("INSERT INTO surface VALUES(11, 0, 0.0, 1.0, 1.0, 1.0)",
                             {"surface holds a bin that does not exist"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM clearance WHERE key = 'contact_sd'",
                             {"clearance ends too early"}));
    EXPECT_TRUE(
        refusesAfter("INSERT INTO clearance VALUES('more', 1.0)", {"clearance has too many"}));
    EXPECT_TRUE(refusesAfter("UPDATE residual_row SET covered_bins = 2048.0 WHERE row = 0",
                             {"bin that does not exist"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM surface_input WHERE position = 10",
                             {"surface_input ends too early"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM training_row", {"0 rows in its table training_row"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM training_row WHERE row = 1", {"not numbered"}));
}

TEST_F(ModelFile, refusesContentThatWasAltered)
{
    const std::string altered = "altered";
    EXPECT_TRUE(refusesAfter("UPDATE training_row SET \"h_+0.1_m\" = 0.1", {altered}));
    EXPECT_TRUE(refusesAfter(
        "UPDATE bin SET log_likelihood = 1.0 WHERE feature_set = 'pa' AND bin = 0", {altered}));
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = 'x' WHERE key = 'command'", {altered}));
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = '1' WHERE key = 'seed'", {altered}));
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = '01' WHERE key = 'seed'", {"seed"}));
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = 'x' WHERE key = 'data_sha256'", {altered}));
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = 'x' WHERE key = 'kernel'", {"another kind"}));
    EXPECT_TRUE(refusesAfter("INSERT INTO meta VALUES('note', 'x')", {"another kind"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM meta WHERE key = 'command'", {"lacks command"}));
}

TEST_F(ModelFile, ignoresJournalsThatLieBesideIt)
{
    dir.write("model.ttm-journal", std::string(4096, '\xd9'));
    dir.write("model.ttm-wal", std::string(4096, '\x37'));
    const Result<StoredModel> got = readModel(path);
    ASSERT_TRUE(got) << got.error().text;
    EXPECT_TRUE(same(got->data, model));
}

TEST_F(ModelFile, isReadFromAnyPathWithReadPermission)
{
    const std::string odd = dir.write("čidlo 100%?a=b#c.ttm", contentOf(path));
    std::filesystem::permissions(odd, std::filesystem::perms::owner_read);
    const Result<StoredModel> got = readModel(odd);
    ASSERT_TRUE(got) << got.error().text;
    EXPECT_TRUE(same(got->data, model));
}

TEST_F(ModelFile, theHashDependsOnEveryPart)
{
    const std::array<std::function<void(ModelData&)>, 29> changes{
        [](ModelData& m) { m.heights(1, 2) += 1e-9; },
        [](ModelData& m) { m.features(2, 10) += 1e-9; },
        [](ModelData& m) { m.pa.mean[13] += 1e-9; },
        [](ModelData& m) { m.pa.sd[0] += 1e-9; },
        [](ModelData& m) { m.scannedHeights(0, 3) += 1e-9; },
        [](ModelData& m) { m.clearance.featureMean[2] += 1e-9; },
        [](ModelData& m) { m.clearance.featureSd[2] += 1e-9; },
        [](ModelData& m) { m.clearance.residuals(1, 4) += 1e-9; },
        [](ModelData& m) { m.clearance.noveltyScale += 1e-9; },
        [](ModelData& m) { m.clearance.contactBias += 1e-9; },
        [](ModelData& m) { m.clearance.contactSd += 1e-9; },
        [](ModelData& m) { m.clearance.covered[2].mean += 1e-9; },
        [](ModelData& m) { m.clearance.covered[2].residualSd += 1e-9; },
        [](ModelData& m) { m.clearance.covered[2].weights[0] += 1e-9; },
        [](ModelData& m) { m.clearance.covered[2].hyper.lengthScale[3] += 1e-9; },
        [](ModelData& m) { m.clearance.covered[2].hyper.noiseSd += 1e-9; },
        [](ModelData& m) { m.paf.mean[21] += 1e-9; },
        [](ModelData& m) { m.paf.sd[5] += 1e-9; },
        [](ModelData& m) { m.pa.bins[10].lengthScale[12] += 1e-9; },
        [](ModelData& m) { m.paf.bins[0].signalSd += 1e-9; },
        [](ModelData& m) { m.paf.bins[7].noiseSd += 1e-9; },
        [](ModelData& m) { m.pa.logLikelihood[3] += 1e-9; },
        [](ModelData& m) { m.command += " "; },
        [](ModelData& m) { m.seed -= 1; },
        [](ModelData& m) { m.dataHash[63] = 'b'; },
        [](ModelData& m) { m.inducing = 2; },
        [](ModelData& m) { m.repeats = 2; },
        [](ModelData& m) { m.heightSd = Eigen::MatrixXd::Zero(m.heights.rows(), kBins); },
        [](ModelData& m) { m.heightSd = Eigen::MatrixXd::Ones(m.heights.rows(), kBins); },
    };
    std::set<std::string> hashes{contentHash(model)};
    for (const auto& change : changes) {
        ModelData changed = model;
        change(changed);
        hashes.insert(contentHash(changed));
    }
    EXPECT_EQ(hashes.size(), 1U + changes.size());
    EXPECT_EQ(contentHash(model), contentHash(randomModel(3)));
}

TEST_F(ModelFile, throwsRatherThanWriteAModelThatItWouldRefuse)
{
    const std::array<std::function<void(ModelData&)>, 13> faults{
        [](ModelData& m) { m.heights(0, 0) = std::numeric_limits<double>::quiet_NaN(); },
        [](ModelData& m) { m.heights.resize(0, kBins), m.features.resize(0, 11); },
        [](ModelData& m) { m.features.resize(2, 11); },
        [](ModelData& m) { m.features.conservativeResize(3, 10); },
        [](ModelData& m) { m.pa.set = FeatureSet::Paf; },
        [](ModelData& m) { m.pa.sd[3] = 0.0; },
        [](ModelData& m) { m.paf.bins[2].lengthScale.conservativeResize(20); },
        [](ModelData& m) { m.paf.bins[2].lengthScale[4] = 0.0; },
        [](ModelData& m) { m.inducing = -1; },
        [](ModelData& m) { m.repeats = 3; },
        [](ModelData& m) { m.clearance.covered[0].weights[2] = -1e16; },
        [](ModelData& m) { m.clearance.residuals(2, 10) = -1e10; },
        [](ModelData& m) { m.clearance.featureMean[10] = 1e10; },
    };
    const std::string before = contentOf(path);
    for (const auto& fault : faults) {
        ModelData wrong = model;
        fault(wrong);
        EXPECT_THROW(static_cast<void>(writeModel(path, wrong)), std::invalid_argument);
        EXPECT_THROW(static_cast<void>(contentHash(wrong)), std::invalid_argument);
    }
    EXPECT_EQ(contentOf(path), before);
}

TEST_F(ModelFile, leavesTheOldFileWhenTheDiskIsFull)
{
    const std::string before = contentOf(path);
    struct rlimit limit {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
    const struct rlimit tight {
        50000, limit.rlim_max
    };
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    const Status status = writeModel(path, randomModel(1000));
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_TRUE(refused(status, path, {"cannot be written"}));
    EXPECT_EQ(contentOf(path), before);
    EXPECT_EQ(dir.entries(), std::set<std::string>{"model.ttm"});
}

}  // namespace
}  // namespace terratact
