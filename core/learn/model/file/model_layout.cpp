#include "core/learn/model/file/model_layout.h"

#include <algorithm>

#include "core/learn/model/file/model_sides.h"
#include "core/learn/model/file/model_surfaces.h"

namespace terratact::model_file {

const Column& inputColumn(std::size_t position)
{
    return position < kBins ? heightColumns()[position] : featureColumns()[position - kBins];
}

std::size_t inputs(FeatureSet set)
{
    return kBins + featureNames(set).size();
}

namespace {

/// Returns a table of numbered rows: the columns `more`, then one number for each of the first
/// `columns` inputs.
SqliteTable rowTable(const std::string& name, std::size_t columns, const std::string& more = {})
{
    std::string sql = "CREATE TABLE " + name + "(row INTEGER PRIMARY KEY" + more;
    for (std::size_t i = 0; i < columns; ++i)
        sql += ", \"" + std::string(inputColumn(i).name) + "\" REAL NOT NULL";
    return {name, sql + ") STRICT"};
}

/// Returns a table of numbered rows with the sd of eleven heights.
SqliteTable sdTable(const std::string& name)
{
    std::string sql = "CREATE TABLE " + name + "(row INTEGER PRIMARY KEY";
    for (const Column& column : heightSdColumns())
        sql += ", \"" + std::string(column.name) + "\" REAL NOT NULL";
    return {name, sql + ") STRICT"};
}

/// Returns a table of numbered rows with a mask of bins.
SqliteTable unknownTable(const std::string& name)
{
    return {name, "CREATE TABLE " + name
                      + "(row INTEGER PRIMARY KEY, unknown_bins REAL NOT NULL) STRICT"};
}

}  // namespace

ModelContent contentOf(const ModelData& model)
{
    return {.sides = model.hasSides(),
            .heightSd = model.heightSd.rows() > 0,
            .sideSd = model.hasSides() && model.sides.heightSd.rows() > 0,
            .unknown = !model.unknownBins.empty(),
            .sideUnknown = model.hasSides() && !model.sides.unknownBins.empty()};
}

std::vector<SqliteTable> schema(const ModelContent& content)
{
    const std::string ofSurface = "bin INTEGER NOT NULL, covered INTEGER NOT NULL, ";
    std::vector<SqliteTable> tables{
        {"bin",
         "CREATE TABLE bin(feature_set TEXT NOT NULL, bin INTEGER NOT NULL, name TEXT NOT NULL, "
         "signal_sd_m REAL NOT NULL, noise_sd_m REAL NOT NULL, log_likelihood REAL NOT NULL, "
         "PRIMARY KEY(feature_set, bin)) STRICT, WITHOUT ROWID"},
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
        rowTable("training_row", inputs(FeatureSet::Paf)),
    };
    const auto add = [&tables](const std::vector<SqliteTable>& more) {
        tables.insert(tables.end(), more.begin(), more.end());
    };
    add(surfaceTables(""));
    if (content.sides) add(sideTables());
    if (content.heightSd) tables.push_back(sdTable(kSdTable));
    if (content.sideSd) tables.push_back(sdTable(kSideSdTable));
    if (content.unknown) tables.push_back(unknownTable(kUnknownTable));
    if (content.sideUnknown) tables.push_back(unknownTable(kSideUnknownTable));
    std::sort(tables.begin(), tables.end(),
              [](const SqliteTable& a, const SqliteTable& b) { return a.name < b.name; });
    return tables;
}

std::map<std::string, std::string> explanations(const ModelContent& content)
{
    std::map<std::string, std::string> texts{
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
         "a bin under the robot (covered 1): y = asinh(max(ceiling - height, -0.03 m) / 0.01 m), "
         "else y = height; mean(x) = mean + sum weight k(x, z), z: at most 600 of the "
         "bin's training rows, evenly spread; forces as log(1 + F / 3 N)"},
        {"clearance_conditional",
         "of a bin under the robot: y = log(max(ceiling - height, 0) + 0.003 m), else y = height; "
         "given the other bins' y and s, on the first 2000 training rows"},
    };
    if (content.sides) texts["sides"] = kSidesExplanation;
    if (content.heightSd || content.sideSd)
        texts["height_sd"] = "sd of each height of the same training_row (side_: rows 2k and 2k + "
                             "1 are left and right "
                             "of side_row k): its square is added to the noise of that row";
    if (content.unknown || content.sideUnknown)
        texts["unknown_bins"] = "bit i of unknown_bins is set where the height of bin i is unknown "
                                "in the same training_row (side_: rows 2k and 2k + 1 are left and "
                                "right of side_row k): the row counts for its other bins only";
    return texts;
}

}  // namespace terratact::model_file
