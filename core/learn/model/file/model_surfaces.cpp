#include "core/learn/model/file/model_surfaces.h"

#include <string_view>

#include "core/learn/model/file/model_checks.h"

namespace terratact::model_file {
namespace {

std::string insertInto(const std::string& table)
{
    return "INSERT INTO " + table + " VALUES";
}

void writeSurface(SqliteFile& file, const std::string& prefix, const SurfaceProcess& p, int bin,
                  bool covered)
{
    SqliteStatement surface = file.prepare(insertInto(prefix + "surface") + "(?, ?, ?, ?, ?, ?)");
    SqliteStatement scale = file.prepare(insertInto(prefix + "surface_scale") + "(?, ?, ?, ?)");
    SqliteStatement weight = file.prepare(insertInto(prefix + "surface_weight") + "(?, ?, ?, ?)");
    const int regime = covered ? 1 : 0;
    const bool modelled = p.weights.size() > 0;
    insert(surface, bin, regime, p.mean, p.residualSd, modelled ? p.hyper.signalSd : 0.0,
           modelled ? p.hyper.noiseSd : 0.0);
    for (int d = 0; modelled && d < static_cast<int>(p.hyper.lengthScale.size()); ++d)
        insert(scale, bin, regime, d, p.hyper.lengthScale[d]);
    for (int k = 0; k < static_cast<int>(p.weights.size()); ++k)
        insert(weight, bin, regime, k, p.weights[k]);
}

SurfaceProcess readSurface(SqliteFile& file, const std::string& prefix, int bin, bool covered)
{
    SqliteStatement found =
        file.prepare("SELECT * FROM " + prefix + "surface WHERE bin = ? AND covered = ?");
    found.bind(0, bin);
    found.bind(1, covered ? 1 : 0);
    nextRow(found, prefix + "surface");
    SurfaceProcess process;
    process.mean = found.real(2);
    process.residualSd = found.real(3);
    process.hyper.signalSd = found.real(4);
    process.hyper.noiseSd = found.real(5);
    process.hyper.lengthScale = readNumbers(file, prefix + "surface_scale", "input", bin, covered);
    process.weights = readNumbers(file, prefix + "surface_weight", "position", bin, covered);
    return process;
}

double readValue(SqliteFile& file, const std::string& prefix, std::string_view key)
{
    SqliteStatement found = file.prepare("SELECT value FROM " + prefix + "clearance WHERE key = ?");
    found.bind(0, key);
    nextRow(found, prefix + "clearance");
    return found.real(0);
}

void readStandardisation(SqliteFile& file, const std::string& prefix, int features,
                         ClearanceData& data)
{
    const std::string table = prefix + "surface_input";
    data.featureMean.resize(features);
    data.featureSd.resize(features);
    SqliteStatement input = file.prepare("SELECT * FROM " + table + " ORDER BY position");
    for (int d = 0; d < features; ++d) {
        nextRow(input, table);
        require(input.integer(0) == d, [&] {
            return Message(TR_NOOP("core", "its table %1 is not numbered from 0"), table);
        });
        data.featureMean[d] = input.real(1);
        data.featureSd[d] = input.real(2);
    }
    noMoreRows(input, table);
}

}  // namespace

std::vector<SqliteTable> surfaceTables(const std::string& prefix)
{
    const std::string ofSurface = "(bin INTEGER NOT NULL, covered INTEGER NOT NULL, ";
    const auto table = [&prefix](const std::string& name, const std::string& columns) {
        return SqliteTable{prefix + name, "CREATE TABLE " + prefix + name + columns};
    };
    return {
        table("clearance",
              "(key TEXT NOT NULL PRIMARY KEY, value REAL NOT NULL) STRICT, WITHOUT ROWID"),
        table("surface", ofSurface
                             + "mean REAL NOT NULL, residual_sd REAL NOT NULL, signal_sd REAL NOT "
                               "NULL, noise_sd REAL NOT NULL, PRIMARY KEY(bin, covered)) STRICT, "
                               "WITHOUT ROWID"),
        table("surface_input",
              "(position INTEGER PRIMARY KEY, mean REAL NOT NULL, sd REAL NOT NULL) STRICT"),
        table("surface_scale",
              ofSurface
                  + "input INTEGER NOT NULL, length_scale REAL NOT NULL, PRIMARY KEY(bin, "
                    "covered, input)) STRICT, WITHOUT ROWID"),
        table("surface_weight", ofSurface
                                    + "position INTEGER NOT NULL, weight REAL NOT NULL, PRIMARY "
                                      "KEY(bin, covered, position)) STRICT, WITHOUT ROWID"),
    };
}

void writeSurfaces(SqliteFile& file, const std::string& prefix, const ClearanceData& data,
                   const BinSet& bins)
{
    SqliteStatement value = file.prepare(insertInto(prefix + "clearance") + "(?, ?)");
    insert(value, std::string_view("contact_bias"), data.contactBias);
    insert(value, std::string_view("contact_sd"), data.contactSd);
    insert(value, std::string_view("novelty_scale"), data.noveltyScale);
    SqliteStatement input = file.prepare(insertInto(prefix + "surface_input") + "(?, ?, ?)");
    for (int d = 0; d < static_cast<int>(data.featureMean.size()); ++d)
        insert(input, d, data.featureMean[d], data.featureSd[d]);
    for (const int bin : binsOf(bins))
        for (const bool covered : {false, true})
            writeSurface(file, prefix,
                         (covered ? data.covered : data.open)[static_cast<std::size_t>(bin)], bin,
                         covered);
}

void readSurfaces(SqliteFile& file, const std::string& prefix, int features, const BinSet& bins,
                  ClearanceData& data)
{
    data.contactBias = readValue(file, prefix, "contact_bias");
    data.contactSd = readValue(file, prefix, "contact_sd");
    data.noveltyScale = readValue(file, prefix, "novelty_scale");
    const std::string values = prefix + "clearance";
    require(file.integer("SELECT count(*) FROM " + values) == 3,
            [&] { return Message(TR_NOOP("core", "its table %1 has too many rows"), values); });
    readStandardisation(file, prefix, features, data);
    for (const int bin : binsOf(bins))
        for (const bool covered : {false, true})
            (covered ? data.covered : data.open)[static_cast<std::size_t>(bin)] =
                readSurface(file, prefix, bin, covered);
    for (const char* table : {"surface", "surface_scale", "surface_weight"})
        requireBinsOnly(file, prefix + table, bins);
}

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

void requireBinsOnly(SqliteFile& file, const std::string& table, const BinSet& bins)
{
    std::string list;
    for (const int bin : binsOf(bins))
        list.append(list.empty() ? "" : ", ").append(std::to_string(bin));
    require(file.integer("SELECT count(*) FROM " + table + " WHERE bin NOT IN (" + list
                         + ") OR covered NOT IN (0, 1)")
                == 0,
            [&] {
                return Message(TR_NOOP("core", "its table %1 holds a bin that does not exist"),
                               table);
            });
}

}  // namespace terratact::model_file
