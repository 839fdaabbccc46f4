#include "core/log/session_writer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include "core/base/text.h"
#include "core/log/event_text.h"
#include "core/log/message_json.h"
#include "core/log/session_hash.h"
#include "core/log/session_memory.h"
#include "core/log/session_row_checks.h"
#include "core/log/session_schema.h"
#include "core/log/session_table_insert.h"
#include "core/log/session_tables.h"
#include "core/store/file_read.h"
#include "core/store/sqlite.h"

namespace terratact {
namespace {

constexpr std::size_t kFrameBytes = 30;  // approximate size of a frame in the file [bytes]

/// Returns a message in JSON. One that a reader would refuse, too long or too deep, is left out: the
/// row has its text in English.
std::string shortJsonOf(const Message& message)
{
    std::string json = jsonOf(message);
    const bool isReadable = json.size() <= kMaxTextBytes && messageFromJson(json);
    return isReadable ? json : std::string();
}

/// Returns messages in JSON, one a line; nothing if a reader would refuse one.
std::string shortJsonOf(const std::vector<Message>& messages)
{
    std::string lines;
    for (const Message& message : messages) {
        const std::string json = shortJsonOf(message);
        if (json.empty()) return {};
        lines.append(json).append("\n");
    }
    return lines.size() <= kMaxTextBytes ? lines : std::string();
}

std::int64_t flagsOf(const FrameRow& row)
{
    const CanFrame& f = row.frame;
    return (f.extended ? kExtendedFlag : 0) | (f.remote ? kRemoteFlag : 0)
         | (f.error ? kErrorFlag : 0) | (f.fd ? kFdFlag : 0) | (row.sent ? kSentFlag : 0)
         | (row.local ? kLocalFlag : 0) | std::int64_t{f.length} << kLengthShift;
}

}  // namespace

struct SessionWriter::Impl {
    explicit Impl(std::string name, SqliteFile opened)
        : path(std::move(name)), file(std::move(opened)),
          version(file.integer("PRAGMA user_version")), frameTable(file, version, "can_frame"),
          modelTable(file, version, "model"), settingsTable(file, version, "settings"),
          sceneTable(file, version, "scene"), truthTable(file, version, "scene_truth"),
          estimateTable(file, version, "estimate"), binTable(file, version, "estimate_bin"),
          readingTable(file, version, "reading"), proposalTable(file, version, "proposal"),
          offerTable(file, version, "proposal_offer"), eventTable(file, version, "event"),
          drawsInsert(file.prepare("INSERT INTO estimate_draws VALUES(?, ?)")),
          batchInsert(file.prepare("INSERT INTO batch VALUES(?, ?, ?, ?, ?, ?, ?, ?)")),
          begin(file.prepare("BEGIN IMMEDIATE")), end(file.prepare("COMMIT"))
    {
    }

    /// Moves the journal into the file once it is large enough. A failure loses nothing: committed
    /// rows stay in the journal, and the next commit reports what is wrong with the disk.
    void checkpoint()
    {
        if (++journaledBatches < kCheckpointBatches && journaledBytes < kCheckpointBytes) return;
        journaledBatches = 0;
        journaledBytes = 0;
        try {
            file.checkpoint();
        } catch (const SqliteError&) {
        }
    }

    void start(SessionTime time)
    {
        if (!open) {
            begin.run();
            open = true;
            batch.first = batch.last = time;
        }
        batch.first = std::min(batch.first, time);
        batch.last = std::max(batch.last, time);
    }
    template <class... Values>
    void row(SessionTableInsert& table, const Values&... values)
    {
        const std::string& bytes = table.insert(values...);
        journaledBytes += bytes.size();
        rows.add(table.index(), bytes);
    }
    std::int64_t settingsId(const Settings& settings);
    void addScene(const SceneRow& row);
    void addTruth(std::int64_t scene, ProbeSide side, const Heights& truth);
    void addEstimate(const EstimateRow& row);
    void addBins(std::int64_t estimate, std::string_view side, const TerrainEstimate& e);
    void addProposal(const ProposalRow& row);
    void addEvent(const EventRow& row);
    void commit();
    void goOn();  ///< continues after the rows in the file

    std::string path;
    SqliteFile file;
    std::int64_t version;  ///< of the file; only events are added to an older one
    SessionTableInsert frameTable, modelTable, settingsTable, sceneTable, truthTable, estimateTable,
        binTable, readingTable, proposalTable, offerTable, eventTable;
    SqliteStatement drawsInsert, batchInsert, begin, end;

    int journaledBatches = 0;        ///< since the last checkpoint
    std::size_t journaledBytes = 0;  ///< since the last checkpoint, approximate
    bool open = false;               ///< a transaction is open
    bool broken = false;
    bool ended = false;  ///< the file was opened again after its program had ended the session
    SessionBatch batch{.id = 1, .frameFirst = 1};
    Sha256 frameHash;
    RowsHash rows;
    std::string chain;
    std::optional<Settings> settings;
    std::int64_t settingsCount = 0, truthCount = 0, binCount = 0, readingCount = 0, offerCount = 0;
    std::int64_t lastModel = 0, lastScene = 0, lastEstimate = 0, lastProposal = 0, lastEvent = 0;
};

std::int64_t SessionWriter::Impl::settingsId(const Settings& s)
{
    if (settings == s) return settingsCount;
    settings = s;
    row(settingsTable, ++settingsCount, batch.id, name(s.method), name(s.ceiling), name(s.contacts),
        s.forceThreshold, s.contactSd, s.draws, int{s.stopEarly}, s.chains, s.burnIn, name(s.scan),
        name(s.precision), s.inducing, std::to_string(s.seed), s.probeAbove, s.rollLimit,
        s.asymmetryLimit, s.hazardRate);
    return settingsCount;
}

namespace {

/// Returns the stored value. A feature that was not measured is stored as infinity, because its
/// column is never NULL.
double storedFeature(const Measurement& m, std::size_t feature, double value)
{
    return m.missing[feature] ? std::numeric_limits<double>::infinity() : value;
}

}  // namespace

void SessionWriter::Impl::addScene(const SceneRow& scene)
{
    const Measurement& m = scene.measurement;
    const auto f = [&m](std::size_t e) {
        return storedFeature(m, kFirstForceFeature + e, m.force[e]);
    };
    const auto front = [&m](double value) { return storedFeature(m, kFrontCurrentFeature, value); };
    const auto rear = [&m](double value) { return storedFeature(m, kRearCurrentFeature, value); };
    const std::string memory = scene.memory ? bytesOfMemory(*scene.memory) : std::string();
    row(sceneTable, scene.id, batch.id, scene.time, m.time, m.pitch, m.roll, m.frontLeft,
        m.frontRight, m.rearLeft, m.rearRight, front(m.frontLeftCurrent),
        front(m.frontRightCurrent), rear(m.rearLeftCurrent), rear(m.rearRightCurrent), f(0), f(1),
        f(2), f(3), f(4), f(5), static_cast<int>(m.activity), static_cast<int>(m.refusal),
        m.arm ? std::optional(m.arm->bin) : std::nullopt,
        m.arm ? std::optional(m.arm->height) : std::nullopt,
        m.arm ? std::optional(m.arm->sd) : std::nullopt, m.travelled, m.turned, m.differential,
        m.sides.left, m.sides.right, m.rearSides.left, m.rearSides.right,
        m.arm ? std::optional(name(m.arm->side)) : std::nullopt,
        scene.memory ? std::optional(Blob{memory}) : std::nullopt);
    if (scene.truth) addTruth(scene.id, ProbeSide::Middle, *scene.truth);
    if (!scene.sideTruth) return;
    addTruth(scene.id, ProbeSide::Left, scene.sideTruth->at(0));
    addTruth(scene.id, ProbeSide::Right, scene.sideTruth->at(1));
}

void SessionWriter::Impl::addTruth(std::int64_t scene, ProbeSide side, const Heights& truth)
{
    for (int bin = 0; bin < kBins; ++bin)
        row(truthTable, ++truthCount, batch.id, scene, bin, truth[static_cast<std::size_t>(bin)],
            name(side));
}

namespace {

/// Columns that each side of an estimate has, in the order of the table.
struct SideColumns {
    explicit SideColumns(const TerrainEstimate& e)
        : novelty(e.novelty), ending(name(e.ending)), converged(int{e.converged}),
          warnings(english(e.warnings, "\n")), feltTo(e.feltTo), contradicts(int{e.contradicts}),
          messages(shortJsonOf(e.warnings))
    {
    }
    double novelty;
    std::string_view ending;
    int converged;
    std::string warnings;
    double feltTo;
    int contradicts;
    std::string messages;
};

}  // namespace

void SessionWriter::Impl::addEstimate(const EstimateRow& r)
{
    const TwoTrackEstimate& e = r.estimate;
    const std::string draws = bytesOfDraws(e);
    Sha256 drawsHash;
    drawsHash.add(draws);
    const std::int64_t settingsOf = settingsId(e.side[0].settings);
    const SideColumns left(e.side[0]), right(e.side[1]);
    const auto unlessPlane = [&e](const auto& value) {
        return e.onePlane ? std::nullopt : std::optional(value);
    };
    row(estimateTable, r.id, batch.id, r.time, r.scene, settingsOf, r.model, name(r.role),
        r.seconds, r.stepLimit, left.novelty, left.ending, left.converged, left.warnings,
        Blob{drawsHash.finish()}, left.feltTo, left.contradicts, left.messages, int{e.onePlane},
        unlessPlane(right.novelty), unlessPlane(right.ending), unlessPlane(right.converged),
        unlessPlane(right.warnings), unlessPlane(right.feltTo), unlessPlane(right.contradicts),
        unlessPlane(right.messages));
    drawsInsert.bind(0, r.id);
    drawsInsert.bindBlob(1, draws);
    drawsInsert.run();
    journaledBytes += draws.size();
    for (const ArmReading& reading : r.readings)
        row(readingTable, ++readingCount, batch.id, r.id, reading.bin, reading.height, reading.sd,
            name(reading.side));
    if (e.onePlane) return addBins(r.id, kBothSides, e.side[0]);
    addBins(r.id, name(ProbeSide::Left), e.side[0]);
    addBins(r.id, name(ProbeSide::Right), e.side[1]);
}

void SessionWriter::Impl::addBins(std::int64_t estimate, std::string_view side,
                                  const TerrainEstimate& e)
{
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        row(binTable, ++binCount, batch.id, estimate, bin, name(e.origin[i]), e.height[i],
            e.mean[i], e.sd[i], e.q10[i], e.q90[i],
            std::isinf(e.ceiling[i]) ? std::nullopt : std::optional(e.ceiling[i]), e.rhat[i],
            e.ess[i], name(e.touch[i]), side);
    }
}

void SessionWriter::Impl::addProposal(const ProposalRow& r)
{
    row(proposalTable, r.id, batch.id, r.time, r.estimate, r.bin, r.height, r.q10, r.q90, r.sd,
        r.limit, r.armSd, r.seconds, r.stepLimit, r.bitsBefore, r.grounds, name(r.side));
    for (const OfferedBin& offer : r.offers)
        row(offerTable, ++offerCount, batch.id, r.id, offer.bin, offer.varianceShare,
            offer.bitsAfter, name(offer.side));
}

void SessionWriter::Impl::addEvent(const EventRow& r)
{
    const std::int64_t id = ++lastEvent;
    const std::string_view kind = name(r.kind);
    if (version < 3)
        row(eventTable, id, batch.id, r.time, kind, r.subject, r.text, r.number, r.estimate,
            r.proposal, r.shown);
    else if (version < 6)
        row(eventTable, id, batch.id, r.time, kind, r.subject, r.text, r.number, r.estimate,
            r.proposal, r.shown, shortJsonOf(r.message));
    else
        row(eventTable, id, batch.id, r.time, kind, r.subject, r.text, r.number, r.estimate,
            r.proposal, r.shown, shortJsonOf(r.message), shortJsonOf(r.screen));
}

void SessionWriter::Impl::commit()
{
    if (!open) return;
    if (batch.id > kMaxBatches)
        throw SqliteError(TR_NOOP("core", "it has as many batches as a session can have"));
    const BatchHashes hashes{.frames = frameHash.finish(), .rows = rows.finish()};
    std::string next = chained(chain, batch, hashes);
    int column = 0;
    for (const std::int64_t value :
         {batch.id, batch.first, batch.last, batch.frameFirst, batch.frameCount})
        batchInsert.bind(column++, value);
    for (const std::string* hash : {&hashes.frames, &hashes.rows, &std::as_const(next)})
        batchInsert.bindBlob(column++, *hash);
    batchInsert.run();
    end.run();
    open = false;
    chain = std::move(next);
    journaledBytes += kFrameBytes * static_cast<std::size_t>(batch.frameCount);
    batch = {.id = batch.id + 1, .frameFirst = batch.frameFirst + batch.frameCount};
    checkpoint();
}

SessionWriter::SessionWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SessionWriter::SessionWriter(SessionWriter&&) noexcept = default;
SessionWriter& SessionWriter::operator=(SessionWriter&&) noexcept = default;
SessionWriter::~SessionWriter() = default;

namespace {

/// Runs a step that may throw SqliteError. The writer cannot be used after an error.
template <class Impl, class Step>
Status attempt(Impl& impl, Step step)
{
    if (impl.broken) return fileError(impl.path, TR_NOOP("core", "recording into it has ended"));
    try {
        step();
    } catch (const SqliteError& error) {
        impl.broken = true;
        return fileError(impl.path, error.message());
    }
    return Done{};
}

}  // namespace

Result<SessionWriter> SessionWriter::create(const std::string& path, const SessionStart& start)
{
    if (printable(start.bus) != start.bus)
        return fileError(
            path,
            Message(TR_NOOP("core", "is not made: the name of the bus %1 has control characters"),
                    shown(start.bus)));
    bool made = false;
    try {
        SqliteFile file = SqliteFile::createLog(path);
        made = true;
        file.run("PRAGMA application_id = " + std::to_string(kSessionApplicationId));
        file.run("PRAGMA user_version = " + std::to_string(kSessionVersion));
        file.run("BEGIN");
        for (const SchemaEntry& entry : sessionSchema(kSessionVersion)) file.run(entry.sql);
        const std::string genesis = writeSessionStart(file, start);
        file.run("COMMIT");
        file.checkpoint();
        auto impl = std::make_unique<Impl>(path, std::move(file));
        impl->chain = genesis;
        return SessionWriter(std::move(impl));
    } catch (const SqliteError& error) {
        std::error_code none;
        if (made)
            for (const char* const end : {"", "-wal", "-shm"})
                std::filesystem::remove(path + end, none);
        return fileError(path, error.message());
    }
}

Status SessionWriter::add(const FrameRow& row)
{
    return attempt(*impl_, [&] {
        impl_->start(row.time);
        const auto bytes = bytesOf(row.frame);
        const std::string_view data(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        impl_->frameHash.add(
            impl_->frameTable.insert(impl_->batch.frameFirst + impl_->batch.frameCount, row.time, 0,
                                     std::int64_t{row.frame.id}, flagsOf(row), Blob{data}));
        ++impl_->batch.frameCount;
    });
}

Status SessionWriter::add(const ModelRow& row)
{
    requireNext(row.id, impl_->lastModel);
    return attempt(*impl_, [&] {
        impl_->start(row.time);
        impl_->row(impl_->modelTable, row.id, impl_->batch.id, row.time, row.name, row.hash,
                   row.details, row.trailName, row.trailHash);
    });
}

Status SessionWriter::add(const SceneRow& row)
{
    requireFinite(row);
    requireNext(row.id, impl_->lastScene);
    return attempt(*impl_, [&] {
        impl_->start(row.time);
        impl_->addScene(row);
    });
}

Status SessionWriter::add(const EstimateRow& row)
{
    requireFinite(row);
    requireSides(row);
    requireKnown(row.scene, impl_->lastScene, false);
    requireKnown(row.model, impl_->lastModel, false);
    requireNext(row.id, impl_->lastEstimate);
    return attempt(*impl_, [&] {
        impl_->start(row.time);
        impl_->addEstimate(row);
    });
}

Status SessionWriter::add(const ProposalRow& row)
{
    requireFinite(row);
    requireKnown(row.estimate, impl_->lastEstimate, false);
    requireNext(row.id, impl_->lastProposal);
    return attempt(*impl_, [&] {
        impl_->start(row.time);
        impl_->addProposal(row);
    });
}

Status SessionWriter::add(const EventRow& row)
{
    requireFinite({row.number.value_or(0.0)});
    requireKnown(row.estimate, impl_->lastEstimate, true);
    requireKnown(row.proposal, impl_->lastProposal, true);
    return attempt(*impl_, [&] {
        impl_->start(row.time);
        impl_->addEvent(row);
    });
}

Status SessionWriter::commit()
{
    return attempt(*impl_, [&] { impl_->commit(); });
}

Status SessionWriter::seal()
{
    return attempt(*impl_, [&] {
        impl_->commit();
        impl_->broken = true;
        if (!impl_->file.leaveJournal())
            throw SqliteError(
                TR_NOOP("core", "is open in another program, so its journal stays beside it"));
    });
}

std::int64_t SessionWriter::frames() const
{
    return impl_->batch.frameFirst - 1;
}
std::int64_t SessionWriter::batches() const
{
    return impl_->batch.id - 1;
}
std::string SessionWriter::chain() const
{
    return hexOf(impl_->chain);
}
const std::string& SessionWriter::path() const
{
    return impl_->path;
}

void SessionWriter::Impl::goOn()
{
    chain = readSessionStart(file).hash;
    const auto counted = [](std::int64_t value) {
        constexpr std::int64_t kMax = std::int64_t{1} << 48U;
        if (value < 0 || value > kMax)
            throw SqliteError(TR_NOOP("core", "a number is out of range"));
        return value;
    };
    SqliteStatement newest = file.prepare(
        "SELECT id, frame_first, frame_count, t_last, chain FROM batch ORDER BY id DESC LIMIT 1");
    if (newest.step()) {
        batch = {.id = counted(newest.integer(0)) + 1,
                 .first = newest.integer(3),
                 .last = newest.integer(3),
                 .frameFirst = counted(newest.integer(1)) + counted(newest.integer(2))};
        chain = newest.blob(4);
    }
    lastEvent = counted(file.integer("SELECT coalesce(max(id), 0) FROM event"));
    SqliteStatement last = file.prepare("SELECT kind, subject FROM event ORDER BY id DESC LIMIT 1");
    ended = last.step() && last.text(0) == name(EventKind::Session) && last.text(1) == "ended";
}

Result<SessionRecovery> SessionWriter::finish(const std::string& path, SqliteFile file)
{
    auto impl = std::make_unique<Impl>(path, std::move(file));
    impl->goOn();
    const SessionTime time = impl->batch.last;
    const bool ended = impl->ended;  // only its journal was left to close
    SessionWriter writer(std::move(impl));
    Status added = Done{};
    if (!ended)
        added = writer.add(withText(
            {.time = time, .kind = EventKind::Session, .subject = "recovered"},
            TR_NOOP("core", "the program that recorded ended without closing the session")));
    const Status sealed = added ? writer.seal() : added;
    if (!sealed) return sealed.error();
    return SessionRecovery::Recovered;
}

}  // namespace terratact
