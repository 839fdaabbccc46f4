#include "core/learn/model_file.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/file_read.h"
#include "core/file_write.h"
#include "core/learn/columns.h"
#include "core/learn/sha256.h"
#include "core/sqlite.h"
#include "core/text.h"

namespace terratact {
namespace {

constexpr std::int64_t kApplicationId = 0x54544D31;  // "TTM1"
constexpr std::int64_t kUserVersion = 1;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} * 1024 * 1024;
constexpr Eigen::Index kMostRows = 20'000;
constexpr std::size_t kMostText = 100'000;
constexpr double kLeastScale = 1e-9, kMostScale = 1e9;        // what squares and quotients survive
constexpr std::array kSets{FeatureSet::Pa, FeatureSet::Paf};  // in the order of their names

/// Why a file is refused.  Thrown and caught in this file only: a sentence that lacks the file's name.
struct Refused {
    std::string cause;
};

// ---------------------------------------------------------------- the file's layout

/// A column of the inputs: the eleven heights, then the features.
const Column& inputColumn(std::size_t position)
{
    return position < kBins ? heightColumns()[position] : featureColumns()[position - kBins];
}

std::size_t inputs(FeatureSet set)
{
    return kBins + featureNames(set).size();
}

struct Table {
    std::string name;
    std::string sql;
};

Table trainingTable()
{
    std::string sql = "CREATE TABLE training_row(row INTEGER PRIMARY KEY";
    for (std::size_t i = 0; i < inputs(FeatureSet::Paf); ++i)
        sql += ", \"" + std::string(inputColumn(i).name) + "\" REAL NOT NULL";
    return {"training_row", sql + ") STRICT"};
}

/// Sorted by name.
std::vector<Table> schema()
{
    return {
        {"bin",
         "CREATE TABLE bin(feature_set TEXT NOT NULL, bin INTEGER NOT NULL, name TEXT NOT NULL, "
         "signal_sd_m REAL NOT NULL, noise_sd_m REAL NOT NULL, log_likelihood REAL NOT NULL, "
         "PRIMARY KEY(feature_set, bin)) STRICT, WITHOUT ROWID"},
        {"input", "CREATE TABLE input(feature_set TEXT NOT NULL, position INTEGER NOT NULL, "
                  "name TEXT NOT NULL, unit TEXT NOT NULL, mean REAL NOT NULL, sd REAL NOT NULL, "
                  "PRIMARY KEY(feature_set, position)) STRICT, WITHOUT ROWID"},
        {"length_scale",
         "CREATE TABLE length_scale(feature_set TEXT NOT NULL, bin INTEGER NOT NULL, "
         "input INTEGER NOT NULL, length_scale REAL NOT NULL, "
         "PRIMARY KEY(feature_set, bin, input)) STRICT, WITHOUT ROWID"},
        {"meta", "CREATE TABLE meta(key TEXT NOT NULL PRIMARY KEY, value TEXT NOT NULL) "
                 "STRICT, WITHOUT ROWID"},
        trainingTable(),
    };
}

/// What the file says of itself, for people who open it with other tools.
const std::map<std::string, std::string>& explanations()
{
    static const std::map<std::string, std::string> texts{
        {"format", "Terratact model: per feature set eleven Gaussian processes, one per bin"},
        {"input", "of a bin: the ten other heights, rear to front, then the features, "
                  "x = (raw - mean) / sd; length_scale.input is input.position"},
        {"kernel", "k(x, x') = signal_sd^2 exp(-1/2 sum (x - x')^2 / length_scale^2) "
                   "+ noise_sd^2 on the diagonal"},
        {"output", "height of the bin - its mean"},
    };
    return texts;
}

// ---------------------------------------------------------------- what a model must be

void require(bool holds, const std::string& cause)
{
    if (!holds) throw Refused{cause};
}

void requireScale(double value, const std::string& what)
{
    require(value >= kLeastScale && value <= kMostScale,
            what + " is " + numberText(value) + ", expected 1e-9 to 1e9");
}

void requireRows(const ModelData& model)
{
    const Eigen::Index rows = model.heights.rows();
    require(rows >= 1 && rows <= kMostRows && model.features.rows() == rows,
            "has " + std::to_string(rows) + " training rows, expected 1 to "
                + std::to_string(kMostRows));
    require(model.heights.cols() == kBins && model.features.cols() == Eigen::Index{kFeatures},
            "its training rows have the wrong number of columns");
    for (Eigen::Index row = 0; row < rows; ++row)
        for (Eigen::Index i = 0; i < kBins + Eigen::Index{kFeatures}; ++i) {
            const double value = i < kBins ? model.heights(row, i) : model.features(row, i - kBins);
            const Column& column = inputColumn(static_cast<std::size_t>(i));
            require(column.holds(value),
                    "training row " + std::to_string(row) + ": " + column.refusal(value));
        }
}

void requireBin(const Hyperparameters& bin, double logLikelihood, Eigen::Index size,
                const std::string& what)
{
    require(bin.lengthScale.size() == size, what + " has the wrong number of length scales");
    for (const double scale : bin.lengthScale) requireScale(scale, "a length scale of " + what);
    requireScale(bin.signalSd, "signal_sd of " + what);
    require(bin.noiseSd >= 0.0 && bin.noiseSd <= kMostScale,
            "noise_sd of " + what + " is out of range");
    require(std::isfinite(logLikelihood), "log_likelihood of " + what + " is not finite");
}

void requireSet(const BinModelData& data, FeatureSet set)
{
    const auto size = static_cast<Eigen::Index>(inputs(set));
    const std::string what = "feature set " + std::string(name(set));
    require(data.set == set && data.mean.size() == size && data.sd.size() == size,
            what + " has the wrong number of inputs");
    require(data.mean.allFinite() && data.mean.cwiseAbs().maxCoeff() <= kMostScale,
            "a mean of " + what + " is out of range");
    for (const double sd : data.sd) requireScale(sd, "a standard deviation of " + what);
    for (std::size_t i = 0; i < kBins; ++i)
        requireBin(data.bins[i], data.logLikelihood[i], size - 1,
                   what + ", bin " + std::string(heightColumns()[i].name));
}

/// Throws Refused unless the model can predict.
void requireModel(const ModelData& model)
{
    requireRows(model);
    requireSet(model.pa, FeatureSet::Pa);
    requireSet(model.paf, FeatureSet::Paf);
    require(model.command.size() <= kMostText && model.dataHash.size() <= kMostText,
            "its texts are too long");
}

// ---------------------------------------------------------------- hash

/// Bytes that do not depend on the machine: numbers as 8 bytes, least first, texts after their length.
class Canonical {
public:
    void add(std::uint64_t value)
    {
        for (int i = 0; i < 8; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xFFU);
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); }  // -0 becomes 0
    void add(std::string_view text)
    {
        add(std::uint64_t{text.size()});
        bytes_ += text;
    }
    /// Row by row.
    void add(const Eigen::MatrixXd& matrix)
    {
        add(static_cast<std::uint64_t>(matrix.rows()));
        add(static_cast<std::uint64_t>(matrix.cols()));
        for (Eigen::Index row = 0; row < matrix.rows(); ++row)
            for (Eigen::Index i = 0; i < matrix.cols(); ++i) add(matrix(row, i));
    }
    void add(const BinModelData& data)
    {
        add(name(data.set));
        for (std::size_t i = 0; i < inputs(data.set); ++i) {
            add(inputColumn(i).name);
            add(inputColumn(i).unit);
        }
        add(Eigen::MatrixXd(data.mean));
        add(Eigen::MatrixXd(data.sd));
        for (std::size_t i = 0; i < kBins; ++i) {
            add(Eigen::MatrixXd(data.bins[i].lengthScale));
            add(data.bins[i].signalSd);
            add(data.bins[i].noiseSd);
            add(data.logLikelihood[i]);
        }
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

std::string hashOf(const ModelData& model)
{
    Canonical canonical;
    canonical.add(std::string_view("Terratact model 1"));
    canonical.add(model.pa);
    canonical.add(model.paf);
    canonical.add(model.heights);
    canonical.add(model.features);
    canonical.add(model.command);
    canonical.add(model.seed);
    canonical.add(model.dataHash);
    return sha256Hex(canonical.bytes());
}

void requireArgument(const ModelData& model, const std::string& caller)
{
    try {
        requireModel(model);
    } catch (const Refused& refused) {
        throw std::invalid_argument(caller + ": " + refused.cause);
    }
}

// ---------------------------------------------------------------- writing

/// Executes an INSERT with one parameter per value.
template <class... Values>
void insert(SqliteStatement& statement, const Values&... values)
{
    int parameter = 0;
    (statement.bind(parameter++, values), ...);
    statement.run();
}

void createTables(SqliteFile& file)
{
    file.run("PRAGMA page_size = 4096");
    file.run("PRAGMA application_id = " + std::to_string(kApplicationId));
    file.run("PRAGMA user_version = " + std::to_string(kUserVersion));
    for (const Table& table : schema()) file.run(table.sql);
}

void writeMeta(SqliteFile& file, const ModelData& model)
{
    std::map<std::string, std::string> meta = explanations();
    meta["command"] = model.command;
    meta["content_sha256"] = hashOf(model);
    meta["data_sha256"] = model.dataHash;
    meta["seed"] = std::to_string(model.seed);
    SqliteStatement row = file.prepare("INSERT INTO meta VALUES(?, ?)");
    for (const auto& [key, value] : meta)
        insert(row, std::string_view(key), std::string_view(value));
}

void writeSet(SqliteFile& file, const BinModelData& data)
{
    const int size = static_cast<int>(data.mean.size());
    SqliteStatement input = file.prepare("INSERT INTO input VALUES(?, ?, ?, ?, ?, ?)");
    for (int i = 0; i < size; ++i) {
        const Column& column = inputColumn(static_cast<std::size_t>(i));
        insert(input, name(data.set), i, column.name, column.unit, data.mean[i], data.sd[i]);
    }
    SqliteStatement bin = file.prepare("INSERT INTO bin VALUES(?, ?, ?, ?, ?, ?)");
    SqliteStatement scale = file.prepare("INSERT INTO length_scale VALUES(?, ?, ?, ?)");
    for (int b = 0; b < kBins; ++b) {
        const auto i = static_cast<std::size_t>(b);
        const Hyperparameters& h = data.bins[i];
        insert(bin, name(data.set), b, heightColumns()[i].name, h.signalSd, h.noiseSd,
               data.logLikelihood[i]);
        for (int d = 0; d < size - 1; ++d)
            insert(scale, name(data.set), b, d < b ? d : d + 1, h.lengthScale[d]);
    }
}

void writeRows(SqliteFile& file, const ModelData& model)
{
    std::string sql = "INSERT INTO training_row VALUES(?";
    for (std::size_t i = 0; i < inputs(FeatureSet::Paf); ++i) sql += ", ?";
    SqliteStatement statement = file.prepare(sql + ")");
    for (Eigen::Index row = 0; row < model.heights.rows(); ++row) {
        int parameter = 0;
        statement.bind(parameter++, std::int64_t{row});
        for (const double value : model.heights.row(row)) statement.bind(parameter++, value);
        for (const double value : model.features.row(row)) statement.bind(parameter++, value);
        statement.run();
    }
}

void fill(const std::string& path, const ModelData& model)
{
    SqliteFile file = SqliteFile::fill(path);
    createTables(file);
    file.run("BEGIN");
    writeMeta(file, model);
    for (const BinModelData* data : {&model.pa, &model.paf}) writeSet(file, *data);
    writeRows(file, model);
    file.run("COMMIT");
    file.run("VACUUM");
    file.close();
}

// ---------------------------------------------------------------- reading

/// Goes to a row that must be there.
void nextRow(SqliteStatement& statement, const std::string& table)
{
    require(statement.step(), "its table " + table + " ends too early");
}

void noMoreRows(SqliteStatement& statement, const std::string& table)
{
    require(!statement.step(), "its table " + table + " has too many rows");
}

void checkIdentity(SqliteFile& file)
{
    require(file.integer("PRAGMA application_id") == kApplicationId,
            "is an SQLite file of another application, not a Terratact model");
    const std::int64_t version = file.integer("PRAGMA user_version");
    require(version == kUserVersion, "is a model of format version " + std::to_string(version)
                                         + ", and this program reads version "
                                         + std::to_string(kUserVersion));
}

void checkSchema(SqliteFile& file)
{
    const std::string other = "its tables are not those of a Terratact model";
    SqliteStatement found =
        file.prepare("SELECT type, name, tbl_name, sql FROM sqlite_schema ORDER BY name");
    for (const Table& table : schema()) {
        require(found.step(), other);
        require(found.text(0) == "table" && found.text(1) == table.name
                    && found.text(2) == table.name && found.text(3) == table.sql,
                other);
    }
    require(!found.step(), other);
}

std::uint64_t seedFrom(const std::string& text)
{
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    require(error == std::errc{} && std::to_string(seed) == text,
            "its seed is not a number: " + shown(text));
    return seed;
}

/// Reads meta into the model; the content's hash as the file has it.
std::string readMeta(SqliteFile& file, ModelData& model)
{
    std::map<std::string, std::string> meta;
    SqliteStatement row = file.prepare("SELECT key, value FROM meta");
    while (row.step()) meta[row.text(0)] = row.text(1);
    const auto take = [&meta](const std::string& key) {
        const auto found = meta.find(key);
        require(found != meta.end(), "its table meta lacks " + key);
        std::string value = found->second;
        meta.erase(found);
        return value;
    };
    model.command = take("command");
    model.dataHash = take("data_sha256");
    model.seed = seedFrom(take("seed"));
    std::string hash = take("content_sha256");
    require(meta == explanations(), "its table meta describes another kind of model");
    return hash;
}

/// "pitch_rad [rad]"
std::string named(std::string_view name, std::string_view unit)
{
    return std::string(name) + " [" + std::string(unit) + "]";
}

void requireInput(bool holds, const std::string& found, const std::string& expected)
{
    require(holds, "is a model of other features: " + shown(found) + " stands where " + expected
                       + " is expected");
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

void readBins(SqliteFile& file, BinModelData& data)
{
    SqliteStatement row =
        file.prepare("SELECT bin, name, signal_sd_m, noise_sd_m, log_likelihood FROM bin "
                     "WHERE feature_set = ? ORDER BY bin");
    row.bind(0, name(data.set));
    for (std::size_t i = 0; i < kBins; ++i) {
        nextRow(row, "bin");
        require(row.integer(0) == static_cast<std::int64_t>(i)
                    && row.text(1) == heightColumns()[i].name,
                "is a model of other bins: " + shown(row.text(1)) + " stands where "
                    + std::string(heightColumns()[i].name) + " is expected");
        data.bins[i].signalSd = row.real(2);
        data.bins[i].noiseSd = row.real(3);
        data.logLikelihood[i] = row.real(4);
    }
    noMoreRows(row, "bin");
}

void readLengthScales(SqliteFile& file, BinModelData& data)
{
    SqliteStatement row = file.prepare("SELECT bin, input, length_scale FROM length_scale "
                                       "WHERE feature_set = ? ORDER BY bin, input");
    row.bind(0, name(data.set));
    const auto size = static_cast<Eigen::Index>(inputs(data.set)) - 1;
    for (std::int64_t bin = 0; bin < kBins; ++bin) {
        Eigen::VectorXd& scales = data.bins[static_cast<std::size_t>(bin)].lengthScale;
        scales.resize(size);
        for (Eigen::Index d = 0; d < size; ++d) {
            nextRow(row, "length_scale");
            require(row.integer(0) == bin && row.integer(1) == (d < bin ? d : d + 1),
                    "its table length_scale is not in the order of the inputs");
            scales[d] = row.real(2);
        }
    }
    noMoreRows(row, "length_scale");
}

void readRows(SqliteFile& file, ModelData& model)
{
    const std::int64_t rows = file.integer("SELECT count(*) FROM training_row");
    require(rows >= 1 && rows <= kMostRows, "has " + std::to_string(rows)
                                                + " training rows, expected 1 to "
                                                + std::to_string(kMostRows));
    model.heights.resize(rows, kBins);
    model.features.resize(rows, Eigen::Index{kFeatures});
    SqliteStatement found = file.prepare("SELECT * FROM training_row ORDER BY row");
    for (Eigen::Index row = 0; row < rows; ++row) {
        nextRow(found, "training_row");
        require(found.integer(0) == row, "its training rows are not numbered from 0");
        int column = 1;
        for (double& value : model.heights.row(row)) value = found.real(column++);
        for (double& value : model.features.row(row)) value = found.real(column++);
    }
    noMoreRows(found, "training_row");
}

void requireNoOtherSet(SqliteFile& file)
{
    for (const char* table : {"input", "bin", "length_scale"})
        require(file.integer("SELECT count(*) FROM " + std::string(table)
                             + " WHERE feature_set NOT IN ('pa', 'paf')")
                    == 0,
                "its table " + std::string(table) + " holds a feature set other than pa and paf");
}

StoredModel readStored(SqliteFile& file)
{
    checkIdentity(file);
    checkSchema(file);
    ModelData model;
    const std::string stored = readMeta(file, model);
    for (const FeatureSet set : kSets) {
        BinModelData& data = set == FeatureSet::Pa ? model.pa : model.paf;
        data.set = set;
        readInputs(file, data);
        readBins(file, data);
        readLengthScales(file, data);
    }
    requireNoOtherSet(file);
    readRows(file, model);
    requireModel(model);
    const std::string hash = hashOf(model);
    require(hash == stored,
            "its content was altered: it does not have the hash that was stored with it");
    return {std::move(model), hash};
}

}  // namespace

std::string contentHash(const ModelData& model)
{
    requireArgument(model, "contentHash");
    return hashOf(model);
}

Status writeModel(const std::string& path, const ModelData& model)
{
    requireArgument(model, "writeModel");
    Result<NewFile> file = NewFile::begin(path);
    if (!file) return file.error();
    try {
        fill(file->temporaryPath(), model);
    } catch (const SqliteError& error) {
        return fileError(path, "cannot be written: " + std::string(error.what()));
    }
    return file->commit();
}

Result<StoredModel> readModel(const std::string& path)
{
    try {
        SqliteFile file = SqliteFile::openUntrusted(path, kMostBytes);
        return readStored(file);
    } catch (const SqliteError& error) {
        return fileError(path, error.what());
    } catch (const Refused& refused) {
        return fileError(path, refused.cause);
    }
}

}  // namespace terratact
