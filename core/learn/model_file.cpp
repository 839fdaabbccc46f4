#include "core/learn/model_file.h"

#include <algorithm>
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
#include "core/learn/clearance_model.h"
#include "core/learn/columns.h"
#include "core/learn/sha256.h"
#include "core/sqlite.h"
#include "core/text.h"

namespace terratact {
namespace {

constexpr std::int64_t kApplicationId = 0x54544D31;  // "TTM1"
constexpr std::int64_t kUserVersion = 2;
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

/// A table of numbered rows: `more` columns, then one number for each of the first `columns` inputs.
Table rowTable(const std::string& name, std::size_t columns, const std::string& more = {})
{
    std::string sql = "CREATE TABLE " + name + "(row INTEGER PRIMARY KEY" + more;
    for (std::size_t i = 0; i < columns; ++i)
        sql += ", \"" + std::string(inputColumn(i).name) + "\" REAL NOT NULL";
    return {name, sql + ") STRICT"};
}

/// Sorted by name.
std::vector<Table> schema()
{
    const std::string ofSurface = "bin INTEGER NOT NULL, covered INTEGER NOT NULL, ";
    return {
        {"bin",
         "CREATE TABLE bin(feature_set TEXT NOT NULL, bin INTEGER NOT NULL, name TEXT NOT NULL, "
         "signal_sd_m REAL NOT NULL, noise_sd_m REAL NOT NULL, log_likelihood REAL NOT NULL, "
         "PRIMARY KEY(feature_set, bin)) STRICT, WITHOUT ROWID"},
        {"clearance", "CREATE TABLE clearance(key TEXT NOT NULL PRIMARY KEY, value REAL NOT NULL) "
                      "STRICT, WITHOUT ROWID"},
        {"clearance_conditional", "CREATE TABLE clearance_conditional(" + ofSurface
                                      + "signal_sd REAL NOT NULL, noise_sd REAL NOT NULL, "
                                        "PRIMARY KEY(bin, covered)) STRICT, WITHOUT ROWID"},
        {"clearance_conditional_scale",
         "CREATE TABLE clearance_conditional_scale(" + ofSurface
             + "input INTEGER NOT NULL, length_scale REAL NOT NULL, "
               "PRIMARY KEY(bin, covered, input)) STRICT, WITHOUT ROWID"},
        {"input", "CREATE TABLE input(feature_set TEXT NOT NULL, position INTEGER NOT NULL, "
                  "name TEXT NOT NULL, unit TEXT NOT NULL, mean REAL NOT NULL, sd REAL NOT NULL, "
                  "PRIMARY KEY(feature_set, position)) STRICT, WITHOUT ROWID"},
        {"length_scale",
         "CREATE TABLE length_scale(feature_set TEXT NOT NULL, bin INTEGER NOT NULL, "
         "input INTEGER NOT NULL, length_scale REAL NOT NULL, "
         "PRIMARY KEY(feature_set, bin, input)) STRICT, WITHOUT ROWID"},
        {"meta", "CREATE TABLE meta(key TEXT NOT NULL PRIMARY KEY, value TEXT NOT NULL) "
                 "STRICT, WITHOUT ROWID"},
        rowTable("residual_row", kBins, ", covered_bins REAL NOT NULL"),
        rowTable("scanned_row", kBins),
        {"surface",
         "CREATE TABLE surface(" + ofSurface
             + "mean REAL NOT NULL, residual_sd REAL NOT NULL, signal_sd REAL NOT NULL, "
               "noise_sd REAL NOT NULL, PRIMARY KEY(bin, covered)) STRICT, WITHOUT ROWID"},
        {"surface_input", "CREATE TABLE surface_input(position INTEGER PRIMARY KEY, "
                          "mean REAL NOT NULL, sd REAL NOT NULL) STRICT"},
        {"surface_scale", "CREATE TABLE surface_scale(" + ofSurface
                              + "input INTEGER NOT NULL, length_scale REAL NOT NULL, "
                                "PRIMARY KEY(bin, covered, input)) STRICT, WITHOUT ROWID"},
        {"surface_weight", "CREATE TABLE surface_weight(" + ofSurface
                               + "position INTEGER NOT NULL, weight REAL NOT NULL, "
                                 "PRIMARY KEY(bin, covered, position)) STRICT, WITHOUT ROWID"},
        rowTable("training_row", inputs(FeatureSet::Paf)),
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
        {"rows",
         "pa and paf use scanned_row with the features of the same training_row; surface uses "
         "all of training_row"},
        {"surface",
         "a bin under the robot (covered 1): y = log(max(ceiling - height, 0) + 0.003 m), "
         "else y = height; mean(x) = mean + sum weight k(x, z), z: at most 600 of the "
         "bin's training rows, evenly spread; forces as log(1 + F / 3 N)"},
        {"clearance_conditional",
         "y of a bin given the other bins' y and s, on the first 2000 training rows"},
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

void requireSurface(const SurfaceProcess& p, std::size_t rows, const std::string& what)
{
    require(std::isfinite(p.mean) && std::abs(p.mean) <= kMostScale, "mean of " + what);
    requireScale(p.residualSd, "residual_sd of " + what);
    if (p.weights.size() == 0) return;
    requireScale(p.hyper.signalSd, "signal_sd of " + what);
    requireScale(p.hyper.noiseSd, "noise_sd of " + what);
    require(p.hyper.lengthScale.size() == Eigen::Index{kFeatures},
            what + " has the wrong number of length scales");
    for (const double scale : p.hyper.lengthScale) requireScale(scale, "a length scale of " + what);
    require(static_cast<std::size_t>(p.weights.size())
                    == std::min(rows, static_cast<std::size_t>(kInducing))
                && p.weights.allFinite(),
            what + " has not one weight per inducing row");
}

void requireConditional(const Hyperparameters& hyper, const std::string& what)
{
    if (hyper.lengthScale.size() == 0) return;
    require(hyper.lengthScale.size() == kBins - 1 + Eigen::Index{kFeatures},
            what + " has the wrong number of length scales");
    for (const double scale : hyper.lengthScale) requireScale(scale, "a length scale of " + what);
    requireScale(hyper.signalSd, "signal_sd of " + what);
    requireScale(hyper.noiseSd, "noise_sd of " + what);
}

void requireClearance(const ModelData& model)
{
    const ClearanceData& data = model.clearance;
    const Eigen::Index rows = model.heights.rows();
    const auto features = Eigen::Index{kFeatures};
    require(data.featureMean.size() == features && data.featureMean.allFinite()
                && data.featureSd.size() == features,
            "its clearances lack the features' standardisation");
    for (const double sd : data.featureSd) requireScale(sd, "a standard deviation of clearances");
    require(data.residuals.rows() == rows && data.residuals.cols() == kBins
                && data.residuals.allFinite()
                && data.coveredBins.size() == static_cast<std::size_t>(rows),
            "it has not one residual per training row and bin");
    for (const unsigned mask : data.coveredBins)
        require(mask < 1U << static_cast<unsigned>(kBins),
                "a row covers a bin that does not exist");
    for (int bin = 0; bin < kBins; ++bin)
        for (const bool covered : {false, true}) {
            const auto& of = covered ? data.covered : data.open;
            const std::string what = "the surface of bin " + std::to_string(bin);
            requireSurface(of[static_cast<std::size_t>(bin)],
                           rowsOf(data.coveredBins, bin, covered).size(), what);
            requireConditional((covered ? data.conditionalCovered
                                        : data.conditionalOpen)[static_cast<std::size_t>(bin)],
                               "the clearance conditional of bin " + std::to_string(bin));
        }
    requireScale(data.noveltyScale, "novelty_scale");
    requireScale(data.contactSd, "contact_sd");
    require(std::abs(data.contactBias) <= 1.0, "contact_bias is out of range");
}

void requireScannedHeights(const ModelData& model)
{
    require(model.scannedHeights.rows() >= 1 && model.scannedHeights.rows() <= model.heights.rows()
                && model.scannedHeights.cols() == kBins,
            "its scanned rows do not fit its training rows");
    for (Eigen::Index i = 0; i < kBins; ++i)
        for (const double height : model.scannedHeights.col(i)) {
            const Column& column = heightColumns()[static_cast<std::size_t>(i)];
            require(column.holds(height), "scanned row: " + column.refusal(height));
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
    requireScannedHeights(model);
    requireClearance(model);
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
    void add(const SurfaceProcess& process)
    {
        add(process.mean);
        add(process.residualSd);
        add(Eigen::MatrixXd(process.weights));
        if (process.weights.size() > 0) add(process.hyper);
    }
    void add(const Hyperparameters& hyper)
    {
        add(Eigen::MatrixXd(hyper.lengthScale));
        if (hyper.lengthScale.size() == 0) return;
        add(hyper.signalSd);
        add(hyper.noiseSd);
    }
    void add(const ClearanceData& data)
    {
        add(Eigen::MatrixXd(data.featureMean));
        add(Eigen::MatrixXd(data.featureSd));
        for (const auto* processes : {&data.open, &data.covered})
            for (const SurfaceProcess& process : *processes) add(process);
        for (const auto* conditionals : {&data.conditionalOpen, &data.conditionalCovered})
            for (const Hyperparameters& hyper : *conditionals) add(hyper);
        for (const unsigned mask : data.coveredBins) add(std::uint64_t{mask});
        add(data.residuals);
        add(data.noveltyScale);
        add(data.contactBias);
        add(data.contactSd);
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

std::string hashOf(const ModelData& model)
{
    Canonical canonical;
    canonical.add(std::string_view("Terratact model 2"));
    canonical.add(model.pa);
    canonical.add(model.paf);
    canonical.add(model.heights);
    canonical.add(model.features);
    canonical.add(model.scannedHeights);
    canonical.add(model.clearance);
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

/// One row of `table`: its number, then the values.
void writeMatrix(SqliteFile& file, const std::string& table, const Eigen::MatrixXd& values)
{
    std::string sql = "INSERT INTO " + table + " VALUES(?";
    for (Eigen::Index i = 0; i < values.cols(); ++i) sql += ", ?";
    SqliteStatement statement = file.prepare(sql + ")");
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
        int parameter = 0;
        statement.bind(parameter++, std::int64_t{row});
        for (const double value : values.row(row)) statement.bind(parameter++, value);
        statement.run();
    }
}

void writeSurface(SqliteFile& file, const SurfaceProcess& p, int bin, bool covered)
{
    SqliteStatement surface = file.prepare("INSERT INTO surface VALUES(?, ?, ?, ?, ?, ?)");
    SqliteStatement scale = file.prepare("INSERT INTO surface_scale VALUES(?, ?, ?, ?)");
    SqliteStatement weight = file.prepare("INSERT INTO surface_weight VALUES(?, ?, ?, ?)");
    const int regime = covered ? 1 : 0;
    const bool modelled = p.weights.size() > 0;
    insert(surface, bin, regime, p.mean, p.residualSd, modelled ? p.hyper.signalSd : 0.0,
           modelled ? p.hyper.noiseSd : 0.0);
    for (int d = 0; modelled && d < static_cast<int>(kFeatures); ++d)
        insert(scale, bin, regime, d, p.hyper.lengthScale[d]);
    for (int k = 0; k < static_cast<int>(p.weights.size()); ++k)
        insert(weight, bin, regime, k, p.weights[k]);
}

void writeConditional(SqliteFile& file, const Hyperparameters& hyper, int bin, bool covered)
{
    if (hyper.lengthScale.size() == 0) return;
    SqliteStatement conditional =
        file.prepare("INSERT INTO clearance_conditional VALUES(?, ?, ?, ?)");
    SqliteStatement scale =
        file.prepare("INSERT INTO clearance_conditional_scale VALUES(?, ?, ?, ?)");
    insert(conditional, bin, covered ? 1 : 0, hyper.signalSd, hyper.noiseSd);
    for (int d = 0; d < static_cast<int>(hyper.lengthScale.size()); ++d)
        insert(scale, bin, covered ? 1 : 0, d, hyper.lengthScale[d]);
}

void writeClearance(SqliteFile& file, const ClearanceData& data)
{
    SqliteStatement value = file.prepare("INSERT INTO clearance VALUES(?, ?)");
    insert(value, std::string_view("contact_bias"), data.contactBias);
    insert(value, std::string_view("contact_sd"), data.contactSd);
    insert(value, std::string_view("novelty_scale"), data.noveltyScale);
    SqliteStatement input = file.prepare("INSERT INTO surface_input VALUES(?, ?, ?)");
    for (int d = 0; d < static_cast<int>(kFeatures); ++d)
        insert(input, d, data.featureMean[d], data.featureSd[d]);
    for (int bin = 0; bin < kBins; ++bin)
        for (const bool covered : {false, true}) {
            const auto i = static_cast<std::size_t>(bin);
            writeSurface(file, (covered ? data.covered : data.open)[i], bin, covered);
            writeConditional(file, (covered ? data.conditionalCovered : data.conditionalOpen)[i],
                             bin, covered);
        }
    Eigen::MatrixXd rows(data.residuals.rows(), kBins + 1);
    for (Eigen::Index u = 0; u < rows.rows(); ++u)
        rows(u, 0) = data.coveredBins[static_cast<std::size_t>(u)];
    rows.rightCols(kBins) = data.residuals;
    writeMatrix(file, "residual_row", rows);
}

void writeRows(SqliteFile& file, const ModelData& model)
{
    Eigen::MatrixXd rows(model.heights.rows(), kBins + Eigen::Index{kFeatures});
    rows << model.heights, model.features;
    writeMatrix(file, "training_row", rows);
    writeMatrix(file, "scanned_row", model.scannedHeights);
}

void fill(const std::string& path, const ModelData& model)
{
    SqliteFile file = SqliteFile::fill(path);
    createTables(file);
    file.run("BEGIN");
    writeMeta(file, model);
    for (const BinModelData* data : {&model.pa, &model.paf}) writeSet(file, *data);
    writeRows(file, model);
    writeClearance(file, model.clearance);
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

/// All rows of a table whose first column numbers them from 0: the `columns` behind it.
Eigen::MatrixXd readMatrix(SqliteFile& file, const std::string& table, Eigen::Index columns)
{
    const std::int64_t rows = file.integer("SELECT count(*) FROM " + table);
    require(rows >= 1 && rows <= kMostRows, "has " + std::to_string(rows) + " rows in its table "
                                                + table + ", expected 1 to "
                                                + std::to_string(kMostRows));
    Eigen::MatrixXd values(rows, columns);
    SqliteStatement found = file.prepare("SELECT * FROM " + table + " ORDER BY row");
    for (Eigen::Index row = 0; row < rows; ++row) {
        nextRow(found, table);
        require(found.integer(0) == row,
                "the rows of its table " + table + " are not numbered from 0");
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

/// The numbers of a table's rows that belong to one bin and regime, in the order of column `order`, which counts from 0.
Eigen::VectorXd readNumbers(SqliteFile& file, const std::string& table, const std::string& order,
                            int bin, bool covered)
{
    SqliteStatement found =
        file.prepare("SELECT * FROM " + table + " WHERE bin = ? AND covered = ? ORDER BY " + order);
    found.bind(0, bin);
    found.bind(1, covered ? 1 : 0);
    std::vector<double> numbers;
    while (found.step()) {
        require(found.integer(2) == std::ssize(numbers),
                "its table " + table + " is not numbered from 0");
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

void readClearance(SqliteFile& file, ClearanceData& data)
{
    data.contactBias = readValue(file, "contact_bias");
    data.contactSd = readValue(file, "contact_sd");
    data.noveltyScale = readValue(file, "novelty_scale");
    data.featureMean.resize(Eigen::Index{kFeatures});
    data.featureSd.resize(Eigen::Index{kFeatures});
    SqliteStatement input = file.prepare("SELECT * FROM surface_input ORDER BY position");
    for (int d = 0; d < static_cast<int>(kFeatures); ++d) {
        nextRow(input, "surface_input");
        require(input.integer(0) == d, "its table surface_input is not numbered from 0");
        data.featureMean[d] = input.real(1);
        data.featureSd[d] = input.real(2);
    }
    noMoreRows(input, "surface_input");
    for (int bin = 0; bin < kBins; ++bin)
        for (const bool covered : {false, true}) {
            const auto i = static_cast<std::size_t>(bin);
            (covered ? data.covered : data.open)[i] = readSurface(file, bin, covered);
            (covered ? data.conditionalCovered : data.conditionalOpen)[i] =
                readConditional(file, bin, covered);
        }
    const Eigen::MatrixXd rows = readMatrix(file, "residual_row", kBins + 1);
    for (const double mask : rows.col(0)) {
        require(mask >= 0.0 && mask < std::ldexp(1.0, kBins) && mask == std::floor(mask),
                "a row covers a bin that does not exist");
        data.coveredBins.push_back(static_cast<unsigned>(mask));
    }
    data.residuals = rows.rightCols(kBins);
}

/// Rows of no bin, regime or key would not be seen by the reader.
void requireNothingElse(SqliteFile& file)
{
    for (const char* table : {"surface", "surface_scale", "surface_weight", "clearance_conditional",
                              "clearance_conditional_scale"})
        require(file.integer("SELECT count(*) FROM " + std::string(table)
                             + " WHERE bin NOT BETWEEN 0 AND 10 OR covered NOT IN (0, 1)")
                    == 0,
                "its table " + std::string(table) + " holds a bin that does not exist");
    require(file.integer("SELECT count(*) FROM clearance") == 3,
            "its table clearance has too many rows");
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
    readClearance(file, model.clearance);
    requireNothingElse(file);
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
