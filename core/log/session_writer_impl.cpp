#include "core/log/session_writer_impl.h"

#include <cmath>
#include <limits>
#include <vector>

#include "core/base/text.h"
#include "core/log/rows/message_json.h"
#include "core/log/rows/session_memory.h"

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

}  // namespace

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

/// Stored for a current or force that was not measured, because its column is never NULL.
constexpr double kNotMeasured = std::numeric_limits<double>::infinity();

}  // namespace

void SessionWriter::Impl::addScene(const SceneRow& scene)
{
    const Measurement& m = scene.measurement;
    const auto f = [&m](std::size_t e) {
        return m.missing[kFirstForceFeature + e] ? kNotMeasured : m.force[e];
    };
    const MotorCurrents currents = motorCurrents(m);
    const auto current = [&currents](std::size_t motor) {
        return currents[motor].value_or(kNotMeasured);
    };
    const std::string memory = scene.memory ? bytesOfMemory(*scene.memory) : std::string();
    row(sceneTable, scene.id, batch.id, scene.time, m.time, m.pitch, m.roll, m.frontLeft,
        m.frontRight, m.rearLeft, m.rearRight, current(0), current(1), current(2), current(3), f(0),
        f(1), f(2), f(3), f(4), f(5), static_cast<int>(m.activity), static_cast<int>(m.refusal),
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

}  // namespace terratact
