#include "core/log/session_reader_impl.h"

#include <stdexcept>

#include "core/log/rows/checked_row.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxRows = 500'000;  // rows of one table, except frames
// passes over the rows: their hash, their values, and the row that ends a part
constexpr int kPasses = 3;
constexpr std::size_t kMaxScenes = 100'000;  // scenes and estimates, whose rows are large in memory
constexpr std::size_t kMaxDamage = 10'000;   // spans that are listed one by one

}  // namespace

/// Adds structural faults of the file as damage without a time. Rows that the hashes prove are
/// still shown.
void SessionReader::Impl::checkStructure()
{
    structureChecked = true;
    const std::string fault = file.structureFault();
    if (!fault.empty())
        damage.push_back(
            {begin, end, Message(TR_NOOP("core", "its structure is damaged: %1"), fault)});
}

void SessionReader::Impl::missJournal()
{
    lacksJournal = true;
    damage.push_back({end, end,
                      Message(TR_NOOP("core", "its journal %1 is not beside it: what was recorded "
                                              "after that is in there; both files belong "
                                              "together"),
                              nameWithoutFolder(SqliteFile::journalOf(path)))});
}

void SessionReader::Impl::addDamage(const SessionBatch& batch, const Message& why)
{
    if (damage.size() >= kMaxDamage) {
        SessionDamage& rest = damage.back();
        rest = {std::min(rest.first, batch.first), std::max(rest.last, batch.last),
                Message(TR_NOOP("core", "more than %1 places are damaged"), kMaxDamage)};
        return;
    }
    const SessionDamage found{batch.first, batch.last, why};
    if (std::find(damage.begin(), damage.end(), found) == damage.end()) damage.push_back(found);
}

SessionReader::Impl::Part SessionReader::Impl::nextPart()
{
    constexpr auto kMin = std::numeric_limits<std::int64_t>::min();
    constexpr auto kMax = std::numeric_limits<std::int64_t>::max();
    Part part{.batches = {},
              .from = batches.empty() ? kMin : batches.back().id + 1,
              .to = kMax};  // rows of no batch come in the first or the last part
    SqliteStatement select = file.prepare("SELECT * FROM batch WHERE id > ? ORDER BY id");
    select.bind(0, batches.empty() ? 0 : batches.back().id);
    while (select.step()) {
        if (part.batches.size() == atATime) {
            part.to = part.batches.back().batch.id;
            break;
        }
        require(batches.size() + part.batches.size() < static_cast<std::size_t>(kMaxBatches),
                TR_NOOP("core", "has more batches than a session can have"));
        part.batches.push_back(batchFrom(select));
        const auto& all = part.batches;
        require(all.size() < 2 || all.rbegin()[1].batch.id < all.back().batch.id,
                TR_NOOP("core", "the batches are not in the order of their numbers"));
    }
    return part;
}

/// Finds where the chain breaks, and the batches whose rows are not what was recorded.
void SessionReader::Impl::judge(const Part& part)
{
    const auto hashes = rowHashes(part);
    const std::string none = RowsHash().finish();
    std::int64_t id = batches.empty() ? 1 : batches.back().id + 1;
    std::int64_t frame =
        batches.empty() ? 1 : batches.back().frameFirst + batches.back().frameCount;
    for (const auto& [batch, expected, link] : part.batches) {
        const bool follows = batch.id == id && batch.frameFirst == frame;
        const bool linked = !chainCounts || (follows && chained(chain, batch, expected) == link);
        if (!linked && !broken)
            broken = SessionDamage{batch.first, batch.last,
                                   TR_NOOP("core", "the chain of hashes is broken here")};
        if (!linked) addDamage(batch, TR_NOOP("core", "the chain of hashes is broken here"));
        const auto found = hashes.find(batch.id);
        if (!linked || (found == hashes.end() ? none : found->second) != expected.rows) {
            if (linked) addDamage(batch, TR_NOOP("core", "rows were changed, lost or added"));
            unsound.push_back(batch.id);
        }
        chain = link;
        id = batch.id + 1;
        frame = batch.frameFirst + batch.frameCount;
        if (!broken) proven = link;
        batches.push_back(batch);
        std::copy(expected.frames.begin(), expected.frames.end(),
                  frameHashes.emplace_back().begin());
    }
}

/// Calls visit(select, batch) for the rows of a table after lastRow up to the end of the part.
/// Returns the last row's id.
template <class Take>
std::int64_t SessionReader::Impl::forRows(std::size_t table, const Part& part, Take visit)
{
    std::int64_t last = lastRow.at(table);
    SqliteStatement select = file.prepare(
        "SELECT * FROM " + std::string(kSessionRowTables.at(table)) + " WHERE id > ? ORDER BY id");
    select.bind(0, last);
    while (select.step()) {
        const std::int64_t batch = select.integer(1);
        if (batch > part.to) break;
        const std::int64_t id = select.integer(0);
        require(id > last,
                TR_NOOP("core", "the rows of a table are not in the order of their numbers"));
        last = id;
        visit(select, batch);
    }
    return last;
}

/// Returns the rows_hash of every batch that has rows in the file. Rows of a batch are contiguous
/// in each table; rows of no batch are damage.
std::map<std::int64_t, std::string> SessionReader::Impl::rowHashes(const Part& part)
{
    std::map<std::int64_t, std::string> hashes;  // the tables' hashes, concatenated
    const std::string none = Sha256().finish();
    const auto fill = [&](std::string& tables, std::size_t count) {
        while (tables.size() < count * Sha256::kBytes) tables += none;
    };
    const auto isOfPart = [&part](std::int64_t batch) {
        const auto found =
            std::lower_bound(part.batches.begin(), part.batches.end(), batch,
                             [](const StoredBatch& b, std::int64_t id) { return b.batch.id < id; });
        return found != part.batches.end() && found->batch.id == batch;
    };
    std::size_t strays = 0;
    for (std::size_t table = 0; table < kSessionRowTables.size(); ++table) {
        Sha256 hash;
        std::optional<std::int64_t> current;
        const auto finish = [&] {
            if (!current) return;
            std::string& tables = hashes[*current];
            fill(tables, table);
            // a second hash from the same table makes it too long, and therefore invalid
            tables += hash.finish();
        };
        RowBytes bytes;
        forRows(table, part, [&](const SqliteStatement& select, std::int64_t batch) {
            if (!isOfPart(batch)) {
                ++strays;
                return;
            }
            if (batch != current) {
                finish();
                current = batch;
            }
            bytes.clear();
            bytes.addRow(select, select.columns());
            hash.add(bytes.bytes());
        });
        finish();
    }
    const SessionTime last = part.batches.back().batch.last;
    if (strays > 0)
        damage.push_back(
            {last, last, Message(TR_NOOP("core", "%1 rows belong to no batch"), strays)});
    for (auto& [batch, tables] : hashes) {
        fill(tables, kSessionRowTables.size());
        Sha256 all;
        all.add(tables);
        tables = all.finish();
    }
    return hashes;
}

void SessionReader::Impl::readRows(const Part& part)
{
    for (std::size_t table = 0; table < kSessionRowTables.size(); ++table) {
        const std::string_view name = kSessionRowTables.at(table);
        const std::size_t most = name == "scene" || name == "estimate" ? kMaxScenes : kMaxRows;
        lastRow.at(table) =
            forRows(table, part, [&](const SqliteStatement& select, std::int64_t batch) {
                require(++rowCount.at(table) <= most,
                        TR_NOOP("core", "a table has more rows than a session can have"));
                if (batch < part.from || !isSound(batch)) return;
                try {
                    rows.add(table, select);
                } catch (const RefusedRow& refused) {
                    addDamage(*byId(batches, batch), {TR_NOOP("core", "row %1 of its table %2: %3"),
                                                      select.integer(0), name, refused.message()});
                }
            });
    }
}

/// Returns the start of the frames. The rows before them repeat what an earlier file of the
/// recording holds.
SessionTime beginOf(const std::vector<SessionBatch>& batches)
{
    const auto first = std::find_if(batches.begin(), batches.end(),
                                    [](const SessionBatch& batch) { return batch.frameCount > 0; });
    return (first == batches.end() ? batches.front() : *first).first;
}

bool SessionReader::Impl::readMore()
{
    const std::size_t before = batches.size();
    file.grantPasses(kPasses);
    file.run("BEGIN");
    for (Part part = nextPart(); !part.batches.empty(); part = nextPart()) {
        judge(part);
        readRows(part);
    }
    file.run("COMMIT");
    if (batches.size() == before) return false;
    if (before == 0) begin = beginOf(batches);
    for (std::size_t i = before; i < batches.size(); ++i) end = std::max(end, batches[i].last);
    return true;
}

void SessionReader::Impl::countStrayFrames()
{
    const std::int64_t last =
        batches.empty() ? 0 : batches.back().frameFirst + batches.back().frameCount - 1;
    file.grantPasses(1);
    SqliteStatement select =
        file.prepare("SELECT seq FROM can_frame WHERE seq < 1 OR seq > ? LIMIT 1");
    select.bind(0, last);
    if (sealed && select.step())
        damage.push_back({end, end, TR_NOOP("core", "frames belong to no batch")});
}

std::vector<FrameRow> SessionReader::Impl::frames(std::size_t index)
{
    const SessionBatch& batch = batches[index];
    file.grantPasses(2);  // one for the hash, one for the frame
    SqliteStatement select =
        file.prepare("SELECT * FROM can_frame WHERE seq >= ? AND seq < ? ORDER BY seq");
    select.bind(0, batch.frameFirst);
    select.bind(1, batch.frameFirst + batch.frameCount);
    std::vector<FrameRow> found;
    Sha256 hash;
    RowBytes bytes;
    while (select.step()) {
        require(select.integer(0) == batch.frameFirst + static_cast<std::int64_t>(found.size()),
                TR_NOOP("core", "frames were changed, lost or added"));
        found.push_back(frameFrom(select));
        bytes.clear();
        bytes.addRow(select, select.columns());
        hash.add(bytes.bytes());
    }
    const Hash& expected = frameHashes[index];
    require(hash.finish() == std::string_view(expected.data(), expected.size()),
            TR_NOOP("core", "frames were changed, lost or added"));
    return found;
}

SideDraws SessionReader::Impl::draws(std::int64_t estimate)
{
    file.grantPasses(2);
    SqliteStatement select = file.prepare("SELECT d.draws, e.draws_sha256 FROM estimate_draws d "
                                          "JOIN estimate e ON e.id = d.id WHERE d.id = ?");
    select.bind(0, estimate);
    const EstimateRow* const row = byId(rows.estimates, estimate);
    if (!row || !select.step())
        throw SqliteError(TR_NOOP("core", "the draws of an estimate are missing"));
    const std::string bytes = select.blob(0);
    const auto size = static_cast<std::int64_t>(bytes.size());
    if (drawn.emplace(estimate, size).second) drawnBytes += size;
    if (drawnBytes > file.size())
        throw SqliteError(
            TR_NOOP("core", "its rows hold more bytes than the file has: they share pages"));
    Sha256 hash;
    hash.add(bytes);
    if (hash.finish() != select.blob(1))
        throw SqliteError(TR_NOOP("core", "the draws of an estimate were changed"));
    return drawsFrom(bytes, row->estimate.onePlane);
}

}  // namespace terratact
