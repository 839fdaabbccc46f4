#pragma once

#include <string>
#include <vector>

#include "core/learn/data/bin_set.h"
#include "core/learn/model/model.h"
#include "core/store/sqlite.h"
#include "core/store/sqlite_tables.h"

namespace terratact::model_file {

// Tables of surface processes: of one plane with the prefix "", of both sides with kSidePrefix.
inline constexpr const char* kSidePrefix = "side_";

/// Returns the tables clearance, surface, surface_input, surface_scale and surface_weight.
std::vector<SqliteTable> surfaceTables(const std::string& prefix);

/// Writes the processes of some bins, the features' standardisation and the three numbers of a whole
/// model.
void writeSurfaces(SqliteFile& file, const std::string& prefix, const ClearanceData& data,
                   const BinSet& bins);

/// Reads the same. features: number of features. Throws Refused for rows that are missing or too
/// many.
void readSurfaces(SqliteFile& file, const std::string& prefix, int features, const BinSet& bins,
                  ClearanceData& data);

/// Executes an INSERT with one parameter per value.
template <class... Values>
void insert(SqliteStatement& statement, const Values&... values)
{
    int parameter = 0;
    (statement.bind(parameter++, values), ...);
    statement.run();
}

/// Goes to a row that must exist.
void nextRow(SqliteStatement& statement, const std::string& table);

/// Throws Refused if there is another row.
void noMoreRows(SqliteStatement& statement, const std::string& table);

/// Returns the numbers of a table's rows for one bin and regime. Column `order`, which counts from
/// 0, gives their order.
Eigen::VectorXd readNumbers(SqliteFile& file, const std::string& table, const std::string& order,
                            int bin, bool covered);

/// Refuses rows of another bin or regime.
void requireBinsOnly(SqliteFile& file, const std::string& table, const BinSet& bins);

}  // namespace terratact::model_file
