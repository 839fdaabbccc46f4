#include "core/learn/model/model_reading.h"

#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/learn/data/columns.h"
#include "core/learn/model/model_checks.h"
#include "core/learn/model/model_hash.h"
#include "core/learn/model/model_layout.h"

namespace terratact::model_file {
namespace {

/// Goes to a row that must exist.
void nextRow(SqliteStatement& statement, const std::string& table)
{
    require(statement.step(),
            [&] { return Message(TR_NOOP("core", "its table %1 ends too early"), table); });
}

void noMoreRows(SqliteStatement& statement, const std::string& table)
{
    require(!statement.step(),
            [&] { return Message(TR_NOOP("core", "its table %1 has too many rows"), table); });
}

void checkApplication(SqliteFile& file, std::int64_t expected)
{
    const std::int64_t found = file.integer("PRAGMA application_id");
    if (found == expected) return;
    require(found != kApplicationId, TR_NOOP("core", "is a whole model, expected a part of one"));
    require(found != kPartApplicationId,
            TR_NOOP("core", "is a part of a model; `terratact merge` makes a model of all parts"));
    throw Refused{
        TR_NOOP("core", "is an SQLite file of another application, not a Terratact model")};
}

void checkVersion(SqliteFile& file)
{
    const std::int64_t version = file.integer("PRAGMA user_version");
    require(version == kUserVersion, [&] {
        return Message(
            TR_NOOP("core", "is a model of format version %1, and this program reads version %2"),
            version, kUserVersion);
    });
}

void checkSchema(SqliteFile& file)
{
    require(hasOnlyTables(file, schema()),
            TR_NOOP("core", "its tables are not those of a Terratact model"));
}

std::uint64_t seedFrom(const std::string& text)
{
    const auto seed = writtenIntegerFrom<std::uint64_t>(text);
    require(seed.has_value(),
            [&] { return Message(TR_NOOP("core", "its seed is not a number: %1"), shown(text)); });
    return *seed;
}

int inducingFrom(const std::string& text)
{
    const auto rows = writtenIntegerFrom<int>(text);
    require(rows && *rows > 0, [&] {
        return Message(TR_NOOP("core", "its number of inducing rows is not one: %1"), shown(text));
    });
    return *rows;
}

int repeatsFrom(const std::string& text)
{
    const auto rows = writtenIntegerFrom<int>(text);
    require(rows && *rows > 0, [&] {
        return Message(TR_NOOP("core", "its number of repeated rows is not one: %1"), shown(text));
    });
    return *rows;
}

BinSet binsFrom(const std::string& list)
{
    const auto bins = binSetFrom(list);
    require(bins && text(*bins) == list,
            [&] { return Message(TR_NOOP("core", "its list of bins is wrong: %1"), shown(list)); });
    return *bins;
}

/// Reads meta into the model and, for a part, its portion. Returns the content's hash as stored.
std::string readMeta(SqliteFile& file, ModelData& model, Portion* portion)
{
    std::map<std::string, std::string> meta;
    SqliteStatement row = file.prepare("SELECT key, value FROM meta");
    while (row.step()) meta[row.text(0)] = row.text(1);
    const auto consume = [&meta](const std::string& key) {
        const auto found = meta.find(key);
        require(found != meta.end(),
                [&] { return Message(TR_NOOP("core", "its table meta lacks %1"), key); });
        std::string value = found->second;
        meta.erase(found);
        return value;
    };
    model.command = consume("command");
    model.dataHash = consume("data_sha256");
    model.seed = seedFrom(consume("seed"));
    std::string hash = consume("content_sha256");
    if (meta.contains("inducing_rows"))  // only a sparse model has this key
        model.inducing = inducingFrom(consume("inducing_rows"));
    if (meta.contains("repeated_rows"))  // only a model with repeats has this key
        model.repeats = repeatsFrom(consume("repeated_rows"));
    if (portion) {
        portion->bins = binsFrom(consume("bins"));
        portion->robotHash = consume("robot_sha256");
        portion->commandBeforeOut = consume("command_before_out");
        portion->commandAfterOut = consume("command_after_out");
    }
    require(meta == explanations(),
            TR_NOOP("core", "its table meta describes another kind of model"));
    return hash;
}

/// Returns "pitch_rad [rad]".
std::string named(std::string_view name, std::string_view unit)
{
    return std::string(name) + " [" + std::string(unit) + "]";
}

void requireInput(bool holds, const std::string& found, const std::string& expected)
{
    require(holds, [&] {
        return Message(
            TR_NOOP("core", "is a model of other features: it has %1 where %2 is expected"),
            shown(found), expected);
    });
}

void readInputs(SqliteFile& file, BinModelData& data)
{
    const std::size_t size = inputs(data.set);
    data.mean.resize(static_cast<Eigen::Index>(size));
    data.sd.resize(static_cast<Eigen::Index>(size));
    SqliteStatement row = file.prepare(
        "SELECT position, name, unit, mean, sd FROM input WHERE feature_set = ? ORDER BY position");
    row.bind(0, name(data.set));
    for (std::size_t i = 0; i < size; ++i) {
        nextRow(row, "input");
        const std::string expected = named(inputColumn(i).name, inputColumn(i).unit);
        const std::string found = named(row.text(1), row.text(2));
        requireInput(row.integer(0) == static_cast<std::int64_t>(i) && found == expected, found,
                     expected);
        data.mean[static_cast<Eigen::Index>(i)] = row.real(3);
        data.sd[static_cast<Eigen::Index>(i)] = row.real(4);
    }
    noMoreRows(row, "input");
}

void readBins(SqliteFile& file, BinModelData& data, const BinSet& bins)
{
    SqliteStatement row =
        file.prepare("SELECT bin, name, signal_sd_m, noise_sd_m, log_likelihood FROM bin "
                     "WHERE feature_set = ? ORDER BY bin");
    row.bind(0, name(data.set));
    for (const int bin : binsOf(bins)) {
        const auto i = static_cast<std::size_t>(bin);
        nextRow(row, "bin");
        require(row.integer(0) == static_cast<std::int64_t>(i)
                    && row.text(1) == heightColumns()[i].name,
                [&] {
                    return Message(
                        TR_NOOP("core", "is a model of other bins: it has %1 where %2 is expected"),
                        shown(row.text(1)), heightColumns()[i].name);
                });
        data.bins[i].signalSd = row.real(2);
        data.bins[i].noiseSd = row.real(3);
        data.logLikelihood[i] = row.real(4);
    }
    noMoreRows(row, "bin");
}

void readLengthScales(SqliteFile& file, BinModelData& data, const BinSet& bins)
{
    SqliteStatement row = file.prepare("SELECT bin, input, length_scale FROM length_scale "
                                       "WHERE feature_set = ? ORDER BY bin, input");
    row.bind(0, name(data.set));
    const auto size = static_cast<Eigen::Index>(inputs(data.set)) - 1;
    for (const int bin : binsOf(bins)) {
        Eigen::VectorXd& scales = data.bins[static_cast<std::size_t>(bin)].lengthScale;
        scales.resize(size);
        for (Eigen::Index d = 0; d < size; ++d) {
            nextRow(row, "length_scale");
            require(row.integer(0) == bin && row.integer(1) == (d < bin ? d : d + 1),
                    TR_NOOP("core", "its table length_scale is not in the order of the inputs"));
            scales[d] = row.real(2);
        }
    }
    noMoreRows(row, "length_scale");
}

/// Returns all rows of a table whose first column numbers them from 0: the `columns` behind it.
Eigen::MatrixXd readMatrix(SqliteFile& file, const std::string& table, Eigen::Index columns)
{
    const std::int64_t rows = file.integer("SELECT count(*) FROM " + table);
    require(rows >= 1 && rows <= kMaxRows, [&] {
        return Message(TR_NOOP("core", "has %1 rows in its table %2, expected 1 to %3"), rows,
                       table, kMaxRows);
    });
    Eigen::MatrixXd values(rows, columns);
    SqliteStatement found = file.prepare("SELECT * FROM " + table + " ORDER BY row");
    for (Eigen::Index row = 0; row < rows; ++row) {
        nextRow(found, table);
        require(found.integer(0) == row, [&] {
            return Message(TR_NOOP("core", "the rows of its table %1 are not numbered from 0"),
                           table);
        });
        int column = 1;
        for (double& value : values.row(row)) value = found.real(column++);
    }
    noMoreRows(found, table);
    return values;
}

void readRows(SqliteFile& file, ModelData& model)
{
    const Eigen::MatrixXd rows = readMatrix(file, "training_row", kBins + Eigen::Index{kFeatures});
    model.heights = rows.leftCols(kBins);
    model.features = rows.rightCols(Eigen::Index{kFeatures});
    model.scannedHeights = readMatrix(file, "scanned_row", kBins);
}

/// Returns the numbers of a table's rows for one bin and regime. Column `order`, which counts from
/// 0, gives their order.
Eigen::VectorXd readNumbers(SqliteFile& file, const std::string& table, const std::string& order,
                            int bin, bool covered)
{
    SqliteStatement found =
        file.prepare("SELECT * FROM " + table + " WHERE bin = ? AND covered = ? ORDER BY " + order);
    found.bind(0, bin);
    found.bind(1, covered ? 1 : 0);
    std::vector<double> numbers;
    while (found.step()) {
        require(found.integer(2) == std::ssize(numbers), [&] {
            return Message(TR_NOOP("core", "its table %1 is not numbered from 0"), table);
        });
        numbers.push_back(found.real(3));
    }
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), std::ssize(numbers));
}

SurfaceProcess readSurface(SqliteFile& file, int bin, bool covered)
{
    SqliteStatement found = file.prepare("SELECT * FROM surface WHERE bin = ? AND covered = ?");
    found.bind(0, bin);
    found.bind(1, covered ? 1 : 0);
    nextRow(found, "surface");
    SurfaceProcess process;
    process.mean = found.real(2);
    process.residualSd = found.real(3);
    process.hyper.signalSd = found.real(4);
    process.hyper.noiseSd = found.real(5);
    process.hyper.lengthScale = readNumbers(file, "surface_scale", "input", bin, covered);
    process.weights = readNumbers(file, "surface_weight", "position", bin, covered);
    return process;
}

Hyperparameters readConditional(SqliteFile& file, int bin, bool covered)
{
    SqliteStatement found =
        file.prepare("SELECT * FROM clearance_conditional WHERE bin = ? AND covered = ?");
    found.bind(0, bin);
    found.bind(1, covered ? 1 : 0);
    if (!found.step()) return {};
    return {readNumbers(file, "clearance_conditional_scale", "input", bin, covered), found.real(2),
            found.real(3)};
}

double readValue(SqliteFile& file, std::string_view key)
{
    SqliteStatement found = file.prepare("SELECT value FROM clearance WHERE key = ?");
    found.bind(0, key);
    nextRow(found, "clearance");
    return found.real(0);
}

void readClearance(SqliteFile& file, ClearanceData& data, const BinSet& bins)
{
    data.contactBias = readValue(file, "contact_bias");
    data.contactSd = readValue(file, "contact_sd");
    data.noveltyScale = readValue(file, "novelty_scale");
    data.featureMean.resize(Eigen::Index{kFeatures});
    data.featureSd.resize(Eigen::Index{kFeatures});
    SqliteStatement input = file.prepare("SELECT * FROM surface_input ORDER BY position");
    for (int d = 0; d < static_cast<int>(kFeatures); ++d) {
        nextRow(input, "surface_input");
        require(input.integer(0) == d,
                TR_NOOP("core", "its table surface_input is not numbered from 0"));
        data.featureMean[d] = input.real(1);
        data.featureSd[d] = input.real(2);
    }
    noMoreRows(input, "surface_input");
    for (const int bin : binsOf(bins))
        for (const bool covered : {false, true}) {
            const auto i = static_cast<std::size_t>(bin);
            (covered ? data.covered : data.open)[i] = readSurface(file, bin, covered);
            (covered ? data.conditionalCovered : data.conditionalOpen)[i] =
                readConditional(file, bin, covered);
        }
    const Eigen::MatrixXd rows = readMatrix(file, "residual_row", kBins + 1);
    for (const double mask : rows.col(0)) {
        require(mask >= 0.0 && mask < std::ldexp(1.0, kBins) && mask == std::floor(mask),
                TR_NOOP("core", "a row covers a bin that does not exist"));
        data.coveredBins.push_back(static_cast<unsigned>(mask));
    }
    data.residuals = rows.rightCols(kBins);
}

/// Refuses rows of no bin, regime or key, which the reader would not see.
void requireNothingElse(SqliteFile& file, const BinSet& bins)
{
    std::string list;
    for (const int bin : binsOf(bins))
        list.append(list.empty() ? "" : ", ").append(std::to_string(bin));
    for (const char* table : {"surface", "surface_scale", "surface_weight", "clearance_conditional",
                              "clearance_conditional_scale"})
        require(file.integer("SELECT count(*) FROM " + std::string(table) + " WHERE bin NOT IN ("
                             + list + ") OR covered NOT IN (0, 1)")
                    == 0,
                [&] {
                    return Message(TR_NOOP("core", "its table %1 holds a bin that does not exist"),
                                   table);
                });
    require(file.integer("SELECT count(*) FROM clearance") == 3,
            TR_NOOP("core", "its table clearance has too many rows"));
}

void requireNoOtherSet(SqliteFile& file)
{
    for (const char* table : {"input", "bin", "length_scale"})
        require(file.integer("SELECT count(*) FROM " + std::string(table)
                             + " WHERE feature_set NOT IN ('pa', 'paf')")
                    == 0,
                [&] {
                    return Message(
                        TR_NOOP("core", "its table %1 holds a feature set other than pa and paf"),
                        table);
                });
}

/// Reads everything behind the file's identifiers. Returns the stored hash.
std::string readContent(SqliteFile& file, ModelData& model, Portion* portion)
{
    checkVersion(file);
    checkSchema(file);
    const std::string stored = readMeta(file, model, portion);
    const BinSet bins = portion ? portion->bins : kAllBins;
    for (const FeatureSet set : kSets) {
        BinModelData& data = set == FeatureSet::Pa ? model.pa : model.paf;
        data.set = set;
        readInputs(file, data);
        readBins(file, data, bins);
        readLengthScales(file, data, bins);
    }
    requireNoOtherSet(file);
    readRows(file, model);
    readClearance(file, model.clearance, bins);
    requireNothingElse(file, bins);
    requireModel(model, portion);
    std::string hash = hashOf(model, portion);
    require(hash == stored,
            TR_NOOP("core",
                    "its content was altered: it does not have the hash that was stored with it"));
    return hash;
}

}  // namespace

StoredModel readStored(SqliteFile& file)
{
    checkApplication(file, kApplicationId);
    StoredModel stored;
    stored.contentHash = readContent(file, stored.data, nullptr);
    return stored;
}

ModelPart readStoredPart(SqliteFile& file)
{
    checkApplication(file, kPartApplicationId);
    ModelPart part;
    readContent(file, part.model, &part.portion);
    return part;
}

}  // namespace terratact::model_file
