#include "core/learn/model/file/model_sides.h"

#include <array>
#include <cmath>
#include <string>

#include "core/learn/data/columns.h"
#include "core/learn/data/side_features.h"
#include "core/learn/model/file/model_checks.h"
#include "core/learn/model/file/model_surfaces.h"
#include "core/learn/model/side_training.h"

namespace terratact::model_file {
namespace {

constexpr const char* kRowTable = "side_row";
constexpr std::array<const char*, 2> kSideNames{"left", "right"};
constexpr std::array<const char*, kSideFeatures> kFeatureNames{
    "pitch",         "roll",          "front_left",    "rear_left",     "front_right",
    "rear_right",    "front_left_a",  "rear_left_a",   "front_right_a", "rear_right_a",
    "left_force_1",  "left_force_2",  "left_force_3",  "left_force_4",  "left_force_5",
    "left_force_6",  "right_force_1", "right_force_2", "right_force_3", "right_force_4",
    "right_force_5", "right_force_6"};

std::string rowColumns()
{
    std::string columns;
    const auto add = [&columns](const std::string& column) {
        columns += ", \"" + column + "\" INTEGER NOT NULL";
    };
    for (const char* feature : kFeatureNames) add(feature);
    for (const std::string side : kSideNames) {
        add(side + "_covered_bins");
        for (const Column& height : heightColumns()) add(side + "_" + std::string(height.name));
        for (const Column& height : heightColumns())
            add(side + "_residual_" + std::string(height.name));
    }
    return columns;
}

/// Writes numbers as whole multiples of steps.
class StepWriter {
public:
    explicit StepWriter(SqliteStatement& statement) : statement_(statement) {}
    void add(double value, double step) { add(std::llround(value / step)); }
    void add(long long number) { statement_.bind(parameter_++, std::int64_t{number}); }

private:
    SqliteStatement& statement_;
    int parameter_ = 0;
};

/// Reads them again.
class StepReader {
public:
    explicit StepReader(SqliteStatement& statement) : statement_(statement) {}
    double next(double step) { return static_cast<double>(next()) * step + 0.0; }
    std::int64_t next() { return statement_.integer(column_++); }

private:
    SqliteStatement& statement_;
    int column_ = 0;
};

unsigned coveredFrom(std::int64_t mask)
{
    require(mask >= 0 && mask < std::int64_t{1} << kBins,
            TR_NOOP("core", "a row covers a bin that does not exist"));
    return static_cast<unsigned>(mask);
}

void readScene(SqliteStatement& found, Eigen::Index scene, SurfaceData& sides)
{
    StepReader reader(found);
    require(reader.next() == scene, [] {
        return Message(TR_NOOP("core", "the rows of its table %1 are not numbered from 0"),
                       kRowTable);
    });
    const Eigen::Index left = 2 * scene;
    for (std::size_t d = 0; d < kSideFeatures; ++d)
        sides.features(left, static_cast<Eigen::Index>(d)) = reader.next(sideFeatureStep(d));
    const TwoTrackReadings s = readingsOf(sides.features.row(left).transpose());
    sides.features.row(left + 1) = sideFeatures(s, Side::Right).transpose();
    for (const Eigen::Index row : {left, left + 1}) {
        sides.clearance.coveredBins.push_back(coveredFrom(reader.next()));
        for (double& height : sides.heights.row(row)) height = reader.next(kHeightStep);
        for (double& residual : sides.clearance.residuals.row(row))
            residual = reader.next(kResidualStep);
    }
}

}  // namespace

std::vector<SqliteTable> sideTables()
{
    std::vector<SqliteTable> tables = surfaceTables(kSidePrefix);
    tables.push_back({kRowTable, std::string("CREATE TABLE ") + kRowTable
                                     + "(row INTEGER PRIMARY KEY" + rowColumns() + ") STRICT"});
    return tables;
}

void writeSides(SqliteFile& file, const SurfaceData& sides)
{
    writeSurfaces(file, kSidePrefix, sides.clearance, kAllBins);
    std::string sql = std::string("INSERT INTO ") + kRowTable + " VALUES(?";
    for (std::size_t i = 0; i < kSideFeatures + 2 * (1 + 2 * std::size_t{kBins}); ++i) sql += ", ?";
    SqliteStatement statement = file.prepare(sql + ")");
    for (Eigen::Index left = 0; left < sides.heights.rows(); left += 2) {
        StepWriter writer(statement);
        writer.add(left / 2);
        for (std::size_t d = 0; d < kSideFeatures; ++d)
            writer.add(sides.features(left, static_cast<Eigen::Index>(d)), sideFeatureStep(d));
        for (const Eigen::Index row : {left, left + 1}) {
            writer.add(
                static_cast<long long>(sides.clearance.coveredBins[static_cast<std::size_t>(row)]));
            for (const double height : sides.heights.row(row)) writer.add(height, kHeightStep);
            for (const double residual : sides.clearance.residuals.row(row))
                writer.add(residual, kResidualStep);
        }
        statement.run();
    }
}

SurfaceData readSides(SqliteFile& file)
{
    const std::int64_t scenes = file.integer(std::string("SELECT count(*) FROM ") + kRowTable);
    require(scenes >= 1 && scenes <= kKeptScenes, [&] {
        return Message(TR_NOOP("core", "has %1 rows in its table %2, expected 1 to %3"), scenes,
                       kRowTable, kKeptScenes);
    });
    SurfaceData sides;
    readSurfaces(file, kSidePrefix, static_cast<int>(kSideFeatures), kAllBins, sides.clearance);
    sides.features.resize(2 * scenes, Eigen::Index{kSideFeatures});
    sides.heights.resize(2 * scenes, kBins);
    sides.clearance.residuals.resize(2 * scenes, kBins);
    SqliteStatement found =
        file.prepare(std::string("SELECT * FROM ") + kRowTable + " ORDER BY row");
    for (Eigen::Index scene = 0; scene < scenes; ++scene) {
        nextRow(found, kRowTable);
        readScene(found, scene, sides);
    }
    return sides;
}

}  // namespace terratact::model_file
