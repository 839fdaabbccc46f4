#include "core/log/session_salvage.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "core/base/text.h"
#include "core/log/rows/page_rows.h"
#include "core/log/rows/session_hash.h"
#include "core/log/rows/session_schema.h"
#include "core/log/rows/session_tables.h"
#include "core/log/session_journal.h"
#include "core/store/file_read.h"
#include "core/store/sqlite.h"

namespace terratact {
namespace {

constexpr std::uint32_t kPageSize = 8192;  // page size of the sessions that this program writes

struct ColumnShape {
    StoredValue::Type type;
    bool mayBeNone, isId;
};

struct TableShape {
    std::string name;
    std::uint32_t root;
    std::vector<ColumnShape> columns;
    SqliteStatement insert;
};

StoredValue::Type typeNamed(const std::string& name)
{
    if (name == "INTEGER") return StoredValue::Type::Integer;
    if (name == "REAL") return StoredValue::Type::Real;
    return name == "TEXT" ? StoredValue::Type::Text : StoredValue::Type::Blob;
}

std::vector<ColumnShape> columnsOf(SqliteFile& file, const std::string& table)
{
    std::vector<ColumnShape> columns;
    SqliteStatement info = file.prepare("PRAGMA table_info(" + table + ")");
    while (info.step())
        columns.push_back({.type = typeNamed(info.text(2)),
                           .mayBeNone = info.integer(3) == 0,
                           .isId = info.integer(5) == 1});
    return columns;
}

/// Returns the tables of the schema. Root pages are those of a file that this program writes.
std::vector<TableShape> tablesOf(SqliteFile& file)
{
    std::vector<TableShape> tables;
    SqliteStatement select = file.prepare("SELECT name, rootpage FROM sqlite_schema "
                                          "WHERE type = 'table' AND name <> 'meta'");
    while (select.step()) {
        const std::string name = select.text(0);
        std::vector<ColumnShape> columns = columnsOf(file, name);
        std::string sql = "INSERT OR IGNORE INTO " + name + " VALUES(?";
        for (std::size_t i = 1; i < columns.size(); ++i) sql += ", ?";
        tables.push_back({.name = name,
                          .root = static_cast<std::uint32_t>(select.integer(1)),
                          .columns = std::move(columns),
                          .insert = file.prepare(sql + ")")});
    }
    return tables;
}

bool fits(const StoredValue& value, const ColumnShape& column)
{
    using Type = StoredValue::Type;
    if (value.type == Type::None) return column.isId || column.mayBeNone;
    if (column.isId) return false;    // stored beside the row
    if (value.type == Type::Integer)  // SQLite stores a whole number as an integer
        return column.type == Type::Integer || column.type == Type::Real;
    return value.type == column.type;
}

bool fits(const StoredRow& row, const TableShape& table)
{
    return row.id
        && std::equal(row.values.begin(), row.values.end(), table.columns.begin(),
                      table.columns.end(),
                      [](const auto& value, const auto& c) { return fits(value, c); });
}

void insert(const StoredRow& row, TableShape& table)
{
    using Type = StoredValue::Type;
    int at = 0;
    for (std::size_t i = 0; i < row.values.size(); ++i, ++at) {
        const StoredValue& value = row.values[i];
        if (table.columns[i].isId)
            table.insert.bind(at, *row.id);
        else if (value.type == Type::Integer)
            table.insert.bind(at, value.integer);
        else if (value.type == Type::Real)
            table.insert.bind(at, value.real);
        else if (value.type == Type::Text)
            table.insert.bind(at, value.bytes);
        else if (value.type == Type::Blob)
            table.insert.bindBlob(at, value.bytes);
        else
            table.insert.bind(at, nullptr);
    }
    table.insert.run();
}

/// Sorts rows into the tables of a new file.
class Salvage {
public:
    Salvage(SqliteFile& file, PageRows& pages) : file_(file), pages_(pages), tables_(tablesOf(file))
    {
    }

    SalvagedPages run()
    {
        file_.run("BEGIN");
        pages_.forEach([this](const StoredRow& row) { add(row); });
        SalvagedPages found;
        found.start = start(found.startIsWhole);
        writeSessionStart(file_, found.start);
        found.isProven = file_.integer("SELECT count(*) FROM batch") > 0;
        found.isCut = pages_.isCut();
        if (!found.isProven) adoptFrames();
        dropStrays();
        file_.run("COMMIT");
        found.batches = file_.integer("SELECT count(*) FROM batch");
        found.lastBatch = file_.integer("SELECT coalesce(max(id), 0) FROM batch");
        found.frames = file_.integer("SELECT count(*) FROM can_frame");
        return found;
    }

private:
    void add(const StoredRow& row)
    {
        if (!row.id) return addMeta(row);
        std::vector<TableShape*> fitting;
        for (TableShape& table : tables_)
            if (fits(row, table)) fitting.push_back(&table);
        if (fitting.empty()) return;
        // Two tables have the same columns: only the tree of pages distinguishes them.
        const auto owns = [&](TableShape* table) { return leaves(*table).contains(row.page); };
        const auto owner = fitting.size() == 1 ? fitting.begin()
                                               : std::find_if(fitting.begin(), fitting.end(), owns);
        insert(row, owner == fitting.end() ? *fitting.front() : **owner);
    }

    void addMeta(const StoredRow& row)
    {
        using Type = StoredValue::Type;
        if (row.values.size() != 2 || row.values[0].type != Type::Text
            || row.values[1].type != Type::Text || row.values[1].bytes.size() > kMaxMetaBytes)
            return;
        meta_.emplace(row.values[0].bytes, row.values[1].bytes);
    }

    const std::set<std::uint32_t>& leaves(const TableShape& table)
    {
        const auto found = leaves_.find(table.name);
        if (found != leaves_.end()) return found->second;
        return leaves_.emplace(table.name, pages_.leavesOf(table.root)).first->second;
    }

    std::string meta(const char* key, bool& whole) const
    {
        const auto found = meta_.find(key);
        whole = whole && found != meta_.end();
        return found == meta_.end() ? std::string() : found->second;
    }

    SessionStart start(bool& whole) const
    {
        whole = true;
        SessionStart start{.program = meta("program", whole),
                           .source = meta("source", whole),
                           .bus = printable(meta("bus", whole)),
                           .transmits = meta("transmits", whole) == "yes",
                           .robot = meta("robot", whole),
                           .robotHash = meta("robot_sha256", whole)};
        const auto wallTime = writtenIntegerFrom<std::int64_t>(meta("wall_time_ns", whole));
        whole = whole && wallTime && *wallTime >= 0 && *wallTime <= kMaxWallTime;
        if (whole) start.wallTime = *wallTime;
        return start;
    }

    /// Makes batches of consecutive frames whose own batches are lost.
    void adoptFrames()
    {
        constexpr std::int64_t kFrames = 200;  // frames of a batch
        const std::string none = RowsHash().finish();
        SqliteStatement insert = file_.prepare("INSERT INTO batch VALUES(?, ?, ?, ?, ?, ?, ?, ?)");
        SqliteStatement select =
            file_.prepare("SELECT * FROM can_frame WHERE seq > 0 ORDER BY seq");
        SessionBatch batch;
        Sha256 hash;
        RowBytes bytes;
        const auto end = [&] {
            if (batch.frameCount == 0) return;
            int column = 0;
            for (const std::int64_t value :
                 {++batch.id, batch.first, batch.last, batch.frameFirst, batch.frameCount})
                insert.bind(column++, value);
            insert.bindBlob(column++, hash.finish());
            insert.bindBlob(column++, none);
            insert.bindBlob(column, none);  // openFragments() needs no chain
            insert.run();
            batch.frameCount = 0;
        };
        while (select.step()) {
            const std::int64_t seq = select.integer(0), time = select.integer(1);
            if (batch.frameCount == kFrames || seq != batch.frameFirst + batch.frameCount) end();
            if (batch.frameCount++ == 0) {
                batch.frameFirst = seq;
                batch.first = batch.last = time;
            }
            batch.first = std::min(batch.first, time);
            batch.last = std::max(batch.last, time);
            bytes.clear();
            bytes.addRow(select, select.columns());
            hash.add(bytes.bytes());
        }
        end();
    }

    /// Drops rows that were not committed when the recording ended, and rows that lost their batch.
    void dropStrays()
    {
        for (const std::string_view table : kSessionRowTables)
            file_.run("DELETE FROM " + std::string(table)
                      + " WHERE batch NOT IN (SELECT id FROM batch)");
        file_.run("DELETE FROM can_frame WHERE seq < 1 OR seq > (SELECT "
                  "coalesce(max(frame_first + frame_count - 1), 0) FROM batch WHERE id = "
                  "(SELECT max(id) FROM batch))");
    }

    SqliteFile& file_;
    PageRows& pages_;
    std::vector<TableShape> tables_;
    std::map<std::string, std::set<std::uint32_t>> leaves_;
    std::map<std::string, std::string> meta_;
};

/// Returns the format version in the header of a damaged session; the newest version if the header
/// is damaged.
/// Source: sqlite.org/fileformat2.html, "user version": 4 bytes at offset 60, most significant first.
std::int64_t versionOf(const std::string& path)
{
    constexpr std::streamoff kUserVersion = 60;
    std::array<unsigned char, 4> bytes{};
    std::error_code none;  // a pipe would block
    if (!std::filesystem::is_regular_file(path, none)) return kSessionVersion;
    std::ifstream file(path, std::ios::binary);
    file.seekg(kUserVersion);
    file.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    std::int64_t version = 0;
    for (const unsigned char byte : bytes) version = version * 256 + byte;
    const bool known = file && version >= kFirstSessionVersion && version <= kSessionVersion;
    return known ? version : kSessionVersion;
}

/// Returns a session of that version without rows.
SqliteFile emptySession(const std::string& path, std::int64_t version)
{
    SqliteFile::makeEmpty(path);
    SqliteFile file = SqliteFile::fill(path);
    file.run("PRAGMA page_size = " + std::to_string(kPageSize));
    file.run("PRAGMA application_id = " + std::to_string(kSessionApplicationId));
    file.run("PRAGMA user_version = " + std::to_string(version));
    for (const SchemaEntry& entry : sessionSchema(version)) file.run(entry.sql);
    return file;
}

}  // namespace

Result<SalvagedPages> salvagePages(const std::string& path, const std::string& scratch)
{
    bool made = false;
    try {
        SqliteFile file = emptySession(scratch, versionOf(path));
        made = true;
        PageRows pages(path, kPageSize,
                       hasForeignJournal(path) ? std::string() : SqliteFile::journalOf(path));
        const SalvagedPages found = Salvage(file, pages).run();
        file.close();
        if (found.batches > 0) return found;
        std::error_code none;
        std::filesystem::remove(scratch, none);
        return fileError(path, TR_NOOP("core", "nothing of a session is whole in it"),
                         kNothingWhole);
    } catch (const SqliteError& error) {
        std::error_code none;
        if (made) std::filesystem::remove(scratch, none);
        return fileError(scratch, error.message());
    }
}

}  // namespace terratact
