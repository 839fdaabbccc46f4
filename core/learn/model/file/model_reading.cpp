#include "core/learn/model/file/model_reading.h"

#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/learn/data/columns.h"
#include "core/learn/model/file/model_checks.h"
#include "core/learn/model/file/model_hash.h"
#include "core/learn/model/file/model_layout.h"
#include "core/learn/model/file/model_sides.h"
#include "core/learn/model/file/model_surfaces.h"

namespace terratact::model_file {
namespace {

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

/// Returns true for a model of two tracks.
bool checkVersion(SqliteFile& file)
{
    const std::int64_t version = file.integer("PRAGMA user_version");
    require(version == kUserVersion || version == kSidesVersion, [&] {
        return Message(TR_NOOP("core", "is a model of format version %1, and this program reads "
                                       "versions %2 and %3: `terratact train` makes a new one"),
                       version, kUserVersion, kSidesVersion);
    });
    return version == kSidesVersion;
}

bool hasTable(SqliteFile& file, const std::string& name)
{
    return file.integer("SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = '"
                        + name + "'")
         > 0;
}

ModelContent readSchema(SqliteFile& file, bool sides)
{
    const ModelContent content{.sides = sides,
                               .heightSd = hasTable(file, kSdTable),
                               .sideSd = sides && hasTable(file, kSideSdTable),
                               .unknown = hasTable(file, kUnknownTable),
                               .sideUnknown = sides && hasTable(file, kSideUnknownTable)};
    require(hasOnlyTables(file, schema(content)),
            TR_NOOP("core", "its tables are not those of a Terratact model"));
    return content;
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
        return Message(TR_NOOP("core", "its inducing row count is not a positive whole number: %1"),
                       shown(text));
    });
    return *rows;
}

int repeatsFrom(const std::string& text)
{
    const auto rows = writtenIntegerFrom<int>(text);
    require(rows && *rows > 0, [&] {
        return Message(TR_NOOP("core", "its repeated row count is not a positive whole number: %1"),
                       shown(text));
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
std::string readMeta(SqliteFile& file, ModelData& model, Portion* portion,
                     const ModelContent& content)
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
    if (content.sides) {
        model.sidesHash = consume("sides_data_sha256");
        model.sidesCommand = consume("sides_command");
    }
    if (portion) {
        portion->bins = binsFrom(consume("bins"));
        portion->robotHash = consume("robot_sha256");
        portion->commandBeforeOut = consume("command_before_out");
        portion->commandAfterOut = consume("command_after_out");
    }
    require(meta == explanations(content),
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
Eigen::MatrixXd readMatrix(SqliteFile& file, const std::string& table, Eigen::Index columns,
                           Eigen::Index most = kMaxRows)
{
    const std::int64_t rows = file.integer("SELECT count(*) FROM " + table);
    require(rows >= 1 && rows <= most, [&] {
        return Message(TR_NOOP("core", "has %1 rows in its table %2, expected 1 to %3"), rows,
                       table, most);
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

/// Returns masks of bins. Throws Refused with `what` for a number that is none.
std::vector<unsigned> masksFrom(const Eigen::VectorXd& numbers, SourceText what)
{
    std::vector<unsigned> masks;
    masks.reserve(static_cast<std::size_t>(numbers.size()));
    for (const double mask : numbers) {
        require(mask >= 0.0 && mask < std::ldexp(1.0, kBins) && mask == std::floor(mask), what);
        masks.push_back(static_cast<unsigned>(mask));
    }
    return masks;
}

std::vector<unsigned> readUnknown(SqliteFile& file, const std::string& table, Eigen::Index most)
{
    return masksFrom(readMatrix(file, table, 1, most),
                     TR_NOOP("core", "an unknown height is of a bin that does not exist"));
}

void readRows(SqliteFile& file, ModelData& model)
{
    const Eigen::MatrixXd rows = readMatrix(file, "training_row", kBins + Eigen::Index{kFeatures});
    model.heights = rows.leftCols(kBins);
    model.features = rows.rightCols(Eigen::Index{kFeatures});
    model.scannedHeights = readMatrix(file, "scanned_row", kBins);
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

void readClearance(SqliteFile& file, ClearanceData& data, const BinSet& bins)
{
    readSurfaces(file, "", static_cast<int>(kFeatures), bins, data);
    for (const int bin : binsOf(bins))
        for (const bool covered : {false, true})
            (covered ? data.conditionalCovered
                     : data.conditionalOpen)[static_cast<std::size_t>(bin)] =
                readConditional(file, bin, covered);
    for (const char* table : {"clearance_conditional", "clearance_conditional_scale"})
        requireBinsOnly(file, table, bins);
    const Eigen::MatrixXd rows = readMatrix(file, "residual_row", kBins + 1);
    data.coveredBins =
        masksFrom(rows.col(0), TR_NOOP("core", "a row covers a bin that does not exist"));
    data.residuals = rows.rightCols(kBins);
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
    const bool sides = checkVersion(file);
    require(!sides || !portion, TR_NOOP("core", "is a part of a model of two tracks"));
    const ModelContent content = readSchema(file, sides);
    const std::string stored = readMeta(file, model, portion, content);
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
    if (sides) model.sides = readSides(file);
    if (content.heightSd) model.heightSd = readMatrix(file, kSdTable, kBins);
    if (content.sideSd)
        model.sides.heightSd = readMatrix(file, kSideSdTable, kBins, Eigen::Index{2} * kKeptScenes);
    if (content.unknown) model.unknownBins = readUnknown(file, kUnknownTable, kMaxRows);
    if (content.sideUnknown)
        model.sides.unknownBins =
            readUnknown(file, kSideUnknownTable, Eigen::Index{2} * kKeptScenes);
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
