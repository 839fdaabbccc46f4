#include "core/learn/model/file/model_writing.h"

#include <map>
#include <string_view>
#include <vector>

#include "core/learn/data/columns.h"
#include "core/learn/model/file/model_hash.h"
#include "core/learn/model/file/model_layout.h"
#include "core/learn/model/file/model_sides.h"
#include "core/learn/model/file/model_surfaces.h"
#include "core/store/sqlite.h"

namespace terratact::model_file {
namespace {

void createTables(SqliteFile& file, std::int64_t applicationId, const ModelContent& content)
{
    file.run("PRAGMA page_size = 4096");
    file.run("PRAGMA application_id = " + std::to_string(applicationId));
    file.run("PRAGMA user_version = "
             + std::to_string(content.sides ? kSidesVersion : kUserVersion));
    for (const SqliteTable& table : schema(content)) file.run(table.sql);
}

void writeMeta(SqliteFile& file, const ModelData& model, const Portion* portion)
{
    std::map<std::string, std::string> meta = explanations(contentOf(model));
    meta["command"] = model.command;
    meta["content_sha256"] = hashOf(model, portion);
    meta["data_sha256"] = model.dataHash;
    meta["seed"] = std::to_string(model.seed);
    if (model.inducing > 0) meta["inducing_rows"] = std::to_string(model.inducing);
    if (model.repeats > 0) meta["repeated_rows"] = std::to_string(model.repeats);
    if (model.hasSides()) {
        meta["sides_data_sha256"] = model.sidesHash;
        meta["sides_command"] = model.sidesCommand;
    }
    if (portion) {
        meta["bins"] = text(portion->bins);
        meta["robot_sha256"] = portion->robotHash;
        meta["command_before_out"] = portion->commandBeforeOut;
        meta["command_after_out"] = portion->commandAfterOut;
    }
    SqliteStatement row = file.prepare("INSERT INTO meta VALUES(?, ?)");
    for (const auto& [key, value] : meta)
        insert(row, std::string_view(key), std::string_view(value));
}

void writeSet(SqliteFile& file, const BinModelData& data, const BinSet& bins)
{
    const int size = static_cast<int>(data.mean.size());
    SqliteStatement input = file.prepare("INSERT INTO input VALUES(?, ?, ?, ?, ?, ?)");
    for (int i = 0; i < size; ++i) {
        const Column& column = inputColumn(static_cast<std::size_t>(i));
        insert(input, name(data.set), i, column.name, column.unit, data.mean[i], data.sd[i]);
    }
    SqliteStatement bin = file.prepare("INSERT INTO bin VALUES(?, ?, ?, ?, ?, ?)");
    SqliteStatement scale = file.prepare("INSERT INTO length_scale VALUES(?, ?, ?, ?)");
    for (const int b : binsOf(bins)) {
        const auto i = static_cast<std::size_t>(b);
        const Hyperparameters& h = data.bins[i];
        insert(bin, name(data.set), b, heightColumns()[i].name, h.signalSd, h.noiseSd,
               data.logLikelihood[i]);
        for (int d = 0; d < size - 1; ++d)
            insert(scale, name(data.set), b, d < b ? d : d + 1, h.lengthScale[d]);
    }
}

/// Writes rows of `table`: the number of each row, then its values.
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

void writeClearance(SqliteFile& file, const ClearanceData& data, const BinSet& bins)
{
    writeSurfaces(file, "", data, bins);
    for (const int bin : binsOf(bins))
        for (const bool covered : {false, true})
            writeConditional(file,
                             (covered ? data.conditionalCovered
                                      : data.conditionalOpen)[static_cast<std::size_t>(bin)],
                             bin, covered);
    Eigen::MatrixXd rows(data.residuals.rows(), kBins + 1);
    for (Eigen::Index u = 0; u < rows.rows(); ++u)
        rows(u, 0) = data.coveredBins[static_cast<std::size_t>(u)];
    rows.rightCols(kBins) = data.residuals;
    writeMatrix(file, "residual_row", rows);
}

/// Writes masks of bins as numbered rows.
void writeMasks(SqliteFile& file, const std::string& table, const std::vector<unsigned>& masks)
{
    Eigen::MatrixXd column(std::ssize(masks), 1);
    for (Eigen::Index u = 0; u < column.rows(); ++u)
        column(u, 0) = masks[static_cast<std::size_t>(u)];
    writeMatrix(file, table, column);
}

void writeRows(SqliteFile& file, const ModelData& model)
{
    Eigen::MatrixXd rows(model.heights.rows(), kBins + Eigen::Index{kFeatures});
    rows << model.heights, model.features;
    writeMatrix(file, "training_row", rows);
    writeMatrix(file, "scanned_row", model.scannedHeights);
    if (contentOf(model).heightSd) writeMatrix(file, kSdTable, model.heightSd);
    if (contentOf(model).sideSd) writeMatrix(file, kSideSdTable, model.sides.heightSd);
    if (contentOf(model).unknown) writeMasks(file, kUnknownTable, model.unknownBins);
    if (contentOf(model).sideUnknown) writeMasks(file, kSideUnknownTable, model.sides.unknownBins);
}

}  // namespace

void fill(const std::string& path, const ModelData& model, const Portion* portion)
{
    const BinSet bins = portion ? portion->bins : kAllBins;
    SqliteFile file = SqliteFile::fill(path);
    createTables(file, portion ? kPartApplicationId : kApplicationId, contentOf(model));
    file.run("BEGIN");
    writeMeta(file, model, portion);
    for (const BinModelData* data : {&model.pa, &model.paf}) writeSet(file, *data, bins);
    writeRows(file, model);
    writeClearance(file, model.clearance, bins);
    if (model.hasSides()) writeSides(file, model.sides);
    file.run("COMMIT");
    file.run("VACUUM");
    file.close();
}

}  // namespace terratact::model_file
