#include "core/trail/trail_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "core/base/text.h"
#include "core/learn/model/file/model_checks.h"
#include "core/learn/model/file/model_surfaces.h"
#include "core/store/canonical_bytes.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/store/sha256.h"
#include "core/store/sqlite.h"
#include "core/store/sqlite_tables.h"
#include "core/trail/trail_tables.h"

namespace terratact {
namespace {

using model_file::insert;
using model_file::Refused;
using model_file::require;

constexpr std::int64_t kTrailApplication = 0x54544E31;  // "TTN1"
constexpr std::uintmax_t kMaxTrailBytes = std::uintmax_t{32} * 1024 * 1024;
constexpr double kMaxStoredSteps = 32'000.0;

std::string hashOf(const TrailData& data)
{
    CanonicalBytes bytes;
    bytes.add(std::string_view("Terratact trail 3"));
    bytes.add(data.command);
    bytes.add(data.seed);
    for (const auto& [networks, hash] :
         {std::pair{&data.plane, &data.planeHash}, std::pair{&data.side, &data.sideHash}}) {
        bytes.add(*hash);
        trail_file::addContent(bytes, *networks);
    }
    return sha256Hex(bytes.bytes());
}

std::map<std::string, std::string> metaOf(const TrailData& data)
{
    return {{"command", data.command},
            {"content_sha256", hashOf(data)},
            {"plane_data_sha256", data.planeHash},
            {"seed", std::to_string(data.seed)},
            {"side_data_sha256", data.sideHash}};
}

void writeMeta(SqliteFile& file, const TrailData& data)
{
    SqliteStatement row = file.prepare("INSERT INTO meta VALUES(?, ?)");
    for (const auto& [key, value] : metaOf(data))
        insert(row, std::string_view(key), std::string_view(value));
}

void fillTrail(const std::string& path, const TrailData& data)
{
    SqliteFile file = SqliteFile::fill(path);
    file.run("PRAGMA page_size = 4096");
    file.run("PRAGMA application_id = " + std::to_string(kTrailApplication));
    file.run("PRAGMA user_version = " + std::to_string(trail_file::kVersion));
    for (const SqliteTable& table : trail_file::tablesOf(trail_file::kVersion)) file.run(table.sql);
    file.run("BEGIN");
    writeMeta(file, data);
    if (!data.plane.isEmpty()) trail_file::writeNetworks(file, trail_file::kPlaneKind, data.plane);
    if (!data.side.isEmpty()) trail_file::writeNetworks(file, trail_file::kSideKind, data.side);
    file.run("COMMIT");
    file.close();
}

StoredTrail readStoredTrail(SqliteFile& file)
{
    require(file.integer("PRAGMA application_id") == kTrailApplication,
            TR_NOOP("core", "is an SQLite file of another application, not trail networks"));
    const std::int64_t version = file.integer("PRAGMA user_version");
    require(version == trail_file::kVersion || version == trail_file::kVersionWithoutDrives,
            TR_NOOP("core", "is of another format version: `terratact train --drives` makes new "
                            "networks"));
    require(hasOnlyTables(file, trail_file::tablesOf(version)),
            TR_NOOP("core", "its tables are not those of trail networks"));
    std::map<std::string, std::string> meta;
    SqliteStatement row = file.prepare("SELECT key, value FROM meta");
    while (row.step()) meta[row.text(0)] = row.text(1);
    StoredTrail stored;
    TrailData& data = stored.data;
    data.command = meta["command"];
    data.planeHash = meta["plane_data_sha256"];
    data.sideHash = meta["side_data_sha256"];
    const auto seed = writtenIntegerFrom<std::uint64_t>(meta["seed"]);
    require(seed.has_value(), TR_NOOP("core", "its seed is not a number"));
    data.seed = *seed;
    data.plane = trail_file::readNetworks(file, trail_file::kPlaneKind, version);
    data.side = trail_file::readNetworks(file, trail_file::kSideKind, version);
    trail_file::requireKnownRows(file, data, version);
    require(!data.plane.isEmpty() || !data.side.isEmpty(), TR_NOOP("core", "it holds no network"));
    require(metaOf(data) == meta,
            TR_NOOP("core", "its content does not match its hash: it was changed or damaged"));
    stored.contentHash = meta["content_sha256"];
    return stored;
}

}  // namespace

std::int16_t errorSteps(float error)
{
    const double steps = std::round(static_cast<double>(error) / kTrailErrorStep);
    return static_cast<std::int16_t>(std::clamp(steps, -kMaxStoredSteps, kMaxStoredSteps));
}

float errorOfSteps(std::int16_t steps)
{
    return static_cast<float>(steps * kTrailErrorStep);
}

Status writeTrail(const std::string& path, const TrailData& data)
{
    for (const TrailNetworks* networks : {&data.plane, &data.side})
        for (const Network& network : networks->networks)
            for (const NetworkLayer& layer : network.layers)
                if (layer.weight.rows() > trail_file::kMaxWidth
                    || layer.weight.cols() > trail_file::kMaxWidth)
                    throw std::invalid_argument("writeTrail: a layer is too wide");
    const TrailModel valid(data);
    if (!valid.hasPlane() && !valid.hasSides())
        throw std::invalid_argument("writeTrail: no network");
    Result<NewFile> file = NewFile::begin(path, Access::Everybody);
    if (!file) return file.error();
    try {
        fillTrail(file->temporaryPath(), data);
    } catch (const SqliteError& error) {
        return fileError(path, Message(TR_NOOP("core", "cannot be written: %1"), error.message()));
    }
    return file->commit();
}

Result<StoredTrail> readTrail(const std::string& path)
{
    try {
        SqliteFile file = SqliteFile::openUntrusted(path, kMaxTrailBytes);
        return readStoredTrail(file);
    } catch (const SqliteError& error) {
        return fileError(path, error.message());
    } catch (const Refused& refused) {
        return fileError(path, refused.message());
    }
}

}  // namespace terratact
