#include "core/log/rows/session_tables.h"

#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/base/text.h"
#include "core/log/rows/session_hash.h"
#include "core/log/rows/session_schema.h"

namespace terratact {
namespace {

constexpr std::size_t kDrawBytes = sizeof(double) * kBins;

void requireStored(bool holds, const Message& cause)
{
    if (!holds) throw SqliteError(cause);
}

using MetaRow = std::pair<const char*, std::string>;

/// Returns the rows sorted by key, as they are stored.
std::array<MetaRow, 7> metaOf(const SessionStart& start)
{
    return {MetaRow{"bus", start.bus},
            MetaRow{"program", start.program},
            MetaRow{"robot", start.robot},
            MetaRow{"robot_sha256", start.robotHash},
            MetaRow{"source", start.source},
            MetaRow{"transmits", start.transmits ? "yes" : "no"},
            MetaRow{"wall_time_ns", std::to_string(start.wallTime)}};
}

std::string hashOf(const SessionStart& start)
{
    RowBytes bytes;
    for (const auto& [key, value] : metaOf(start)) {
        bytes.add(key);
        bytes.add(std::string_view(value));
    }
    Sha256 hash;
    hash.add(bytes.bytes());
    return hash.finish();
}

std::int64_t wallTimeFrom(const std::string& text)
{
    const auto value = writtenIntegerFrom<std::int64_t>(text);
    requireStored(value && *value >= 0 && *value <= kMaxWallTime,
                  Message(TR_NOOP("core", "its start is no time: %1"), shown(text)));
    return *value;
}

void addBytes(std::string& bytes, const Heights& draw)
{
    for (const double height : draw) addLittleEndian(bytes, height);
}

/// Returns the draw of one side that begins at byte `at`, and moves `at` behind it.
Heights drawFrom(std::string_view bytes, std::size_t& at)
{
    Heights draw{};
    for (double& height : draw) {
        height = littleEndianAt(bytes, at);
        at += sizeof(double);
        requireStored(std::isfinite(height), TR_NOOP("core", "has a draw that is not finite"));
    }
    return draw;
}

}  // namespace

std::int64_t requireSessionSchema(SqliteFile& file, const std::string& lonely)
{
    if (!lonely.empty() && !file.prepare("SELECT 1 FROM sqlite_schema").step())
        throw SqliteError(
            Message(TR_NOOP("core", "is empty without its journal %1, which is missing: copy both "
                                    "files"),
                    lonely + "-wal"));
    requireStored(file.integer("PRAGMA application_id") == kSessionApplicationId,
                  TR_NOOP("core", "is an SQLite file of another application, not a session"));
    const std::int64_t version = file.integer("PRAGMA user_version");
    requireStored(
        version >= kFirstSessionVersion && version <= kSessionVersion,
        Message(
            TR_NOOP("core",
                    "is a session of format version %1, and this program reads versions %2 to %3"),
            version, kFirstSessionVersion, kSessionVersion));
    const Message other(TR_NOOP("core", "its tables are not those of a session"));
    SqliteStatement found = file.prepare("SELECT type, name, sql FROM sqlite_schema ORDER BY name");
    for (const SchemaEntry& entry : sessionSchema(version)) {
        requireStored(found.step(), other);
        requireStored(found.text(0) == entry.type && found.text(1) == entry.name && !found.isNull(2)
                          && found.text(2) == entry.sql,
                      other);
    }
    requireStored(!found.step(), other);
    return version;
}

std::string writeSessionStart(SqliteFile& file, const SessionStart& start)
{
    SqliteStatement insert = file.prepare("INSERT INTO meta VALUES(?, ?)");
    for (const auto& [key, value] : metaOf(start)) {
        insert.bind(0, key);
        insert.bind(1, std::string_view(value));
        insert.run();
    }
    return hashOf(start);
}

StoredStart readSessionStart(SqliteFile& file)
{
    SqliteStatement select = file.prepare("SELECT key, value FROM meta ORDER BY key");
    std::array<std::string, 7> values;
    const auto keys = metaOf({});
    for (std::size_t i = 0; i < keys.size(); ++i) {
        requireStored(select.step() && select.text(0) == keys[i].first,
                      Message(TR_NOOP("core", "lacks the entry %1"), keys[i].first));
        values[i] = select.text(1);
        requireStored(values[i].size() <= kMaxMetaBytes,
                      Message(TR_NOOP("core", "has too long an entry %1"), keys[i].first));
    }
    requireStored(!select.step(), TR_NOOP("core", "has unknown entries about its start"));
    requireStored(values[5] == "yes" || values[5] == "no",
                  TR_NOOP("core", "lacks the entry whether it could transmit"));
    StoredStart stored{{.wallTime = wallTimeFrom(values[6]),
                        .program = values[1],
                        .source = values[4],
                        .bus = values[0],
                        .transmits = values[5] == "yes",
                        .robot = values[2],
                        .robotHash = values[3]},
                       {}};
    stored.hash = hashOf(stored.start);
    return stored;
}

void addLittleEndian(std::string& bytes, double value)
{
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int i = 0; i < 8; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xFFU);
}

double littleEndianAt(std::string_view bytes, std::size_t at)
{
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(double); ++i)
        bits |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    return std::bit_cast<double>(bits);
}

std::string bytesOfDraws(const TwoTrackEstimate& estimate)
{
    const auto& left = estimate.side[0].draws;
    const auto& right = estimate.side[1].draws;
    if (left.size() != right.size())
        throw std::invalid_argument("both sides must have the same number of draws");
    std::string bytes;
    bytes.reserve(left.size() * kDrawBytes * (estimate.onePlane ? 1 : 2));
    for (std::size_t k = 0; k < left.size(); ++k) {
        addBytes(bytes, left[k]);
        if (!estimate.onePlane) addBytes(bytes, right[k]);
    }
    return bytes;
}

SideDraws drawsFrom(std::string_view bytes, bool onePlane)
{
    const std::size_t drawBytes = onePlane ? kDrawBytes : 2 * kDrawBytes;
    requireStored(bytes.size() % drawBytes == 0, TR_NOOP("core", "has draws that are not whole"));
    SideDraws draws;
    for (auto& side : draws) side.resize(bytes.size() / drawBytes);
    std::size_t at = 0;
    for (std::size_t k = 0; k < draws[0].size(); ++k) {
        draws[0][k] = drawFrom(bytes, at);
        draws[1][k] = onePlane ? draws[0][k] : drawFrom(bytes, at);
    }
    return draws;
}

}  // namespace terratact
