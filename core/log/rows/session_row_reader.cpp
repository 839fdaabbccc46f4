#include "core/log/rows/session_row_reader.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/named.h"
#include "core/infer/estimate/contradiction.h"
#include "core/infer/estimate/missing_sensors.h"
#include "core/log/rows/checked_row.h"
#include "core/log/rows/message_json.h"
#include "core/log/rows/recorded_words.h"
#include "core/log/rows/session_memory.h"
#include "core/log/rows/session_schema.h"
#include "core/log/rows/session_tables.h"
#include "core/robot/side_plane.h"
#include "core/robot/two_tracks.h"

namespace terratact {
namespace {

constexpr std::int64_t kMaxPerBatch = 200'000;  // frames

std::optional<Origin> originFromName(std::string_view text)
{
    return named(text, std::array{Origin::Sampled, Origin::Contact, Origin::Arm});
}

std::optional<Ending> endingFromName(std::string_view text)
{
    return named(text,
                 std::array{Ending::Converged, Ending::Sweeps, Ending::Time, Ending::NotSampled});
}

std::uint64_t seedFrom(const std::string& text)
{
    std::uint64_t seed = 0;
    for (const char c : text) {
        require(c >= '0' && c <= '9' && text.size() <= 20, TR_NOOP("core", "a seed is no number"));
        seed = seed * 10 + static_cast<std::uint64_t>(c - '0');
    }
    return seed;
}

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        lines.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return lines;
}

Message messageFrom(const std::string& json)
{
    auto message = messageFromJson(json);
    require(message.has_value(), TR_NOOP("core", "a message is no JSON"));
    return *std::move(message);
}

/// Returns the warnings of an estimate: the messages, one a line in JSON; without them the English
/// lines.
std::vector<Message> warningsFrom(const std::string& english, const std::string& json)
{
    std::vector<Message> warnings;
    for (std::string& line : linesOf(json.empty() ? english : json))
        warnings.push_back(json.empty() ? Message::verbatim(std::move(line)) : messageFrom(line));
    return warnings;
}

ArmReading readingFrom(CheckedRow& row)
{
    ArmReading reading;
    reading.bin = row.small(0, kBins - 1);
    reading.height = row.real();
    reading.sd = row.real(0.0);
    return reading;
}

CanFrame canFrameFrom(CheckedRow& row, std::int64_t& flags)
{
    CanFrame frame;
    frame.id = static_cast<std::uint32_t>(row.integer(0, 0x1FFFFFFF));
    flags = row.integer(0, (64 << kLengthShift) + 63);
    frame.extended = (flags & kExtendedFlag) != 0;
    frame.remote = (flags & kRemoteFlag) != 0;
    frame.error = (flags & kErrorFlag) != 0;
    frame.fd = (flags & kFdFlag) != 0;
    frame.length = static_cast<std::uint8_t>(flags >> kLengthShift);
    require(frame.length <= (frame.fd ? kFdBytes : kClassicBytes),
            TR_NOOP("core", "a frame is too long"));
    require(frame.extended || frame.error || frame.id <= 0x7FF,
            TR_NOOP("core", "an identifier is too large"));
    const std::string data = row.blob();
    // Older sessions stored only the first eight bytes of a longer CAN FD frame.
    frame.isCut = data.size() == kClassicBytes && frame.length > kClassicBytes;
    require(data.size() == bytesOf(frame).size(), TR_NOOP("core", "a frame has the wrong length"));
    std::copy(data.begin(), data.end(), reinterpret_cast<char*>(frame.data.data()));
    return frame;
}

Settings settingsFrom(CheckedRow& row)
{
    Settings s;
    s.method = row.named(methodFromName);
    s.ceiling = row.named(ceilingRuleFromName);
    s.contacts = row.named(contactRuleFromName);
    s.forceThreshold = row.real();
    s.contactSd = row.real(0.0);
    s.draws = row.small(1, 10'000'000);
    s.stopEarly = row.flag();
    s.chains = row.small(1, 100'000);
    s.burnIn = row.small(0, 10'000'000);
    s.scan = row.named(scanOrderFromName);
    s.precision = row.named(precisionFromName);
    s.inducing = row.small(0, 10'000'000);
    s.seed = seedFrom(row.text());
    s.probeAbove = row.real(0.0);
    s.rollLimit = row.real(0.0);
    s.asymmetryLimit = row.real(0.0);
    s.hazardRate = row.hasMore() ? row.real(0.0, 1.0) : 0.0;
    return s;
}

ModelRow modelFrom(CheckedRow& row, std::int64_t id)
{
    ModelRow model{.id = id, .time = row.time()};
    model.name = row.text();
    model.hash = row.text();
    model.details = row.text();
    if (!row.hasMore()) return model;
    model.trailName = row.text();
    model.trailHash = row.text();
    return model;
}

void addTruth(CheckedRow& row, std::vector<SceneRow>& scenes)
{
    SceneRow* const scene = byId(scenes, row.id());
    require(scene != nullptr, TR_NOOP("core", "truth of no scene"));
    const auto bin = static_cast<std::size_t>(row.small(0, kBins - 1));
    const double height = row.real();
    const ProbeSide side = row.hasMore() ? row.named(probeSideFromName) : ProbeSide::Middle;
    if (side == ProbeSide::Middle) {
        if (!scene->truth) scene->truth = Heights{};
        scene->truth->at(bin) = height;
        return;
    }
    if (!scene->sideTruth) scene->sideTruth.emplace();
    scene->sideTruth->at(side == ProbeSide::Left ? 0 : 1).at(bin) = height;
}

void addReading(CheckedRow& row, std::vector<EstimateRow>& estimates)
{
    EstimateRow* const estimate = byId(estimates, row.id());
    require(estimate != nullptr, TR_NOOP("core", "a reading of no estimate"));
    ArmReading reading = readingFrom(row);
    if (row.hasMore()) reading.side = row.named(probeSideFromName);
    estimate->readings.push_back(reading);
}

void addOffer(CheckedRow& row, std::vector<ProposalRow>& proposals)
{
    ProposalRow* const proposal = byId(proposals, row.id());
    require(proposal != nullptr, TR_NOOP("core", "an offer of no proposal"));
    OfferedBin offer;
    offer.bin = row.small(0, kBins - 1);
    offer.varianceShare = row.real();
    offer.bitsAfter = row.real();
    if (row.hasMore()) offer.side = row.named(probeSideFromName);
    proposal->offers.push_back(offer);
}

std::optional<TrailHistory> memoryOrNone(CheckedRow& row)
{
    if (row.isNone()) return std::nullopt;
    const std::optional<TrailHistory> memory = memoryFrom(row.blob());
    require(memory.has_value(),
            TR_NOOP("core", "a memory of the way is expected to hold 103 or 202 "
                            "numbers in their ranges"));
    return memory;
}

SceneRow sceneFrom(CheckedRow& row, std::int64_t id)
{
    SceneRow scene{.id = id, .time = row.time()};
    Measurement& m = scene.measurement;
    for (double* value :
         {&m.time, &m.pitch, &m.roll, &m.frontLeft, &m.frontRight, &m.rearLeft, &m.rearRight})
        *value = row.real();
    MotorCurrents currents;
    for (std::optional<double>& current : currents) current = row.realOrInfinite();
    setCurrents(m, currents);
    for (std::size_t e = 0; e < m.force.size(); ++e) {
        const std::optional<double> stored = row.realOrInfinite();
        m.missing[kFirstForceFeature + e] = !stored;
        m.force[e] = stored.value_or(0.0);
    }
    m.activity = static_cast<RobotActivity>(row.small(0, static_cast<int>(RobotActivity::Stopped)));
    m.refusal = static_cast<Refusal>(row.small(0, static_cast<int>(Refusal::OutOfLimits)));
    if (!row.isNone())
        m.arm = readingFrom(row);
    else
        row.skip(3);
    m.travelled = row.realOrNone();
    m.turned = row.realOrNone();
    if (!row.hasMore()) return scene;
    m.differential = row.realOrNone();
    for (auto* side : {&m.sides.left, &m.sides.right, &m.rearSides.left, &m.rearSides.right})
        for (std::optional<double>& force : *side) force = row.realOrNone();
    if (m.arm)
        m.arm->side = row.named(probeSideFromName);
    else
        row.skip(1);
    if (row.hasMore()) scene.memory = memoryOrNone(row);
    return scene;
}

/// Reads the columns of the left side, or of one plane.
void readLeft(CheckedRow& row, TerrainEstimate& e)
{
    e.novelty = row.real();
    e.ending = row.named(endingFromName);
    e.converged = row.flag();
    const std::string warnings = row.text();
    row.skip(1);  // the hash of the draws
    if (row.hasMore()) e.feltTo = row.real();
    std::optional<bool> contradicts;
    if (row.hasMore()) contradicts = row.flag();
    e.warnings = warningsFrom(warnings, row.hasMore() ? row.text() : std::string());
    e.contradicts = contradicts.value_or(haveContradiction(e.warnings));
}

/// Reads the columns of the right side, which are all there, or all NULL for an estimate of one plane.
void readRight(CheckedRow& row, TwoTrackEstimate& estimate)
{
    constexpr int kSideColumns = 7;
    row.requireNone(estimate.onePlane, kSideColumns,
                    TR_NOOP("core", "columns of the right side are expected for two sides, and "
                                    "none for one plane"));
    if (estimate.onePlane) return;
    TerrainEstimate& e = estimate.side[1];
    e.novelty = row.real();
    e.ending = row.named(endingFromName);
    e.converged = row.flag();
    const std::string warnings = row.text();
    e.feltTo = row.real();
    e.contradicts = row.flag();
    e.warnings = warningsFrom(warnings, row.text());
}

/// Writes which features each side lacks: they follow from the scene.
void writeMissing(TwoTrackEstimate& estimate, const Measurement& scene)
{
    const Method method = estimate.side[0].settings.method;
    if (estimate.onePlane) {
        for (TerrainEstimate& side : estimate.side)
            side.missing = missingFor(method, proprioception(scene));
        return;
    }
    const TwoTrackReadings s = twoTrackReadings(scene);
    estimate.side[0].missing = missingFor(method, sideReadings(s, Side::Left));
    estimate.side[1].missing = missingFor(method, sideReadings(s, Side::Right));
}

EstimateRow estimateFrom(CheckedRow& row, std::int64_t id, const SessionRows& rows,
                         const std::map<std::int64_t, Settings>& settings)
{
    EstimateRow r{.id = id, .time = row.time()};
    r.scene = row.id();
    const SceneRow* const scene = byId(rows.scenes, r.scene);
    require(scene != nullptr, TR_NOOP("core", "an estimate of no scene"));
    const auto found = settings.find(row.id());
    require(found != settings.end(), TR_NOOP("core", "an estimate without settings"));
    r.model = row.id();
    require(byId(rows.models, r.model) != nullptr, TR_NOOP("core", "an estimate without a model"));
    r.role = row.named(estimateRoleFromName);
    r.seconds = row.real(0.0);
    r.stepLimit = row.real(0.0);
    TwoTrackEstimate& e = r.estimate;
    e.side[0].settings = found->second;
    readLeft(row, e.side[0]);
    e.onePlane = !row.hasMore() || row.flag();
    e.side[1] = e.side[0];
    if (row.hasMore()) readRight(row, e);
    writeMissing(e, scene->measurement);
    return r;
}

/// Returns the sides that a bin belongs to, as [first, end). Sessions of versions 1 to 3 have no
/// column for it: `side` is empty.
std::pair<std::size_t, std::size_t> sidesOfBin(const TwoTrackEstimate& estimate,
                                               std::string_view side)
{
    const bool both = side.empty() || side == kBothSides;
    require(both == estimate.onePlane,
            TR_NOOP("core", "bins of one plane are expected to be of both sides, and others of "
                            "one"));
    if (both) return {0, 2};
    const auto own = probeSideFromName(side);
    require(own && *own != ProbeSide::Middle, TR_NOOP("core", "an unknown name"));
    const std::size_t at = *own == ProbeSide::Left ? 0 : 1;
    return {at, at + 1};
}

void addBin(CheckedRow& row, std::vector<EstimateRow>& estimates)
{
    EstimateRow* const found = byId(estimates, row.id());
    require(found != nullptr, TR_NOOP("core", "a bin of no estimate"));
    const auto i = static_cast<std::size_t>(row.small(0, kBins - 1));
    TerrainEstimate e;
    e.origin[i] = row.named(originFromName);
    for (double* const value : {&e.height[i], &e.mean[i]}) *value = row.real();
    e.sd[i] = row.real(0.0);
    for (double* const value : {&e.q10[i], &e.q90[i]}) *value = row.real();
    e.ceiling[i] = row.realOrNone().value_or(std::numeric_limits<double>::infinity());
    for (double* const value : {&e.rhat[i], &e.ess[i]}) *value = row.real();
    if (row.hasMore()) e.touch[i] = row.named(touchFromName);
    const auto [first, end] =
        sidesOfBin(found->estimate, row.hasMore() ? row.text() : std::string());
    for (std::size_t k = first; k < end; ++k) {
        TerrainEstimate& side = found->estimate.side.at(k);
        side.origin[i] = e.origin[i];
        side.touch[i] = e.touch[i];
        for (const auto values :
             {&TerrainEstimate::height, &TerrainEstimate::mean, &TerrainEstimate::sd,
              &TerrainEstimate::q10, &TerrainEstimate::q90, &TerrainEstimate::ceiling,
              &TerrainEstimate::rhat, &TerrainEstimate::ess})
            (side.*values)[i] = (e.*values)[i];
    }
}

ProposalRow proposalFrom(CheckedRow& row, std::int64_t id, const SessionRows& rows)
{
    ProposalRow p{.id = id, .time = row.time()};
    p.estimate = row.id();
    require(byId(rows.estimates, p.estimate) != nullptr,
            TR_NOOP("core", "a proposal without an estimate"));
    p.bin = row.small(0, kBins - 1);
    for (double* value : {&p.height, &p.q10, &p.q90, &p.sd, &p.limit, &p.armSd, &p.seconds,
                          &p.stepLimit, &p.bitsBefore})
        *value = row.real();
    p.grounds = row.text();
    if (row.hasMore()) p.side = row.named(probeSideFromName);
    return p;
}

EventRow eventFrom(CheckedRow& row, std::int64_t id)
{
    EventRow e{.id = id, .time = row.time()};
    e.kind = row.named(eventKindFromName);
    e.subject = row.text();
    e.text = row.text();
    e.number = row.realOrNone();
    e.estimate = row.idOrNone();
    e.proposal = row.idOrNone();
    e.shown = row.text();
    if (!row.hasMore()) return withNames(std::move(e));
    e.message = messageFrom(row.text());
    if (row.hasMore()) e.screen = messageFrom(row.text());
    return e;
}

}  // namespace

StoredBatch batchFrom(const SqliteStatement& select)
{
    CheckedRow row(select);
    StoredBatch stored;
    SessionBatch& batch = stored.batch;
    batch.id = row.id();
    batch.first = row.time();
    batch.last = row.time();
    require(batch.first <= batch.last, TR_NOOP("core", "a batch ends before it begins"));
    batch.frameFirst = row.id();
    batch.frameCount = row.integer(0, kMaxPerBatch);
    stored.hashes.frames = row.hash();
    stored.hashes.rows = row.hash();
    stored.link = row.hash();
    return stored;
}

FrameRow frameFrom(const SqliteStatement& select)
{
    CheckedRow row(select, 1);
    FrameRow frame;
    frame.time = row.time();
    row.skip(1);
    std::int64_t flags = 0;
    frame.frame = canFrameFrom(row, flags);
    frame.sent = (flags & kSentFlag) != 0;
    frame.local = (flags & kLocalFlag) != 0;
    return frame;
}

void SessionRows::add(std::size_t table, const SqliteStatement& select)
{
    CheckedRow row(select);
    const std::int64_t id = row.id();
    row.skip(1);
    const std::string_view name = kSessionRowTables.at(table);
    if (name == "settings")
        settings_[id] = settingsFrom(row);
    else if (name == "model")
        models.push_back(modelFrom(row, id));
    else if (name == "scene")
        scenes.push_back(sceneFrom(row, id));
    else if (name == "scene_truth")
        addTruth(row, scenes);
    else if (name == "estimate")
        estimates.push_back(estimateFrom(row, id, *this, settings_));
    else if (name == "reading")
        addReading(row, estimates);
    else if (name == "estimate_bin")
        addBin(row, estimates);
    else if (name == "proposal")
        proposals.push_back(proposalFrom(row, id, *this));
    else if (name == "proposal_offer")
        addOffer(row, proposals);
    else
        events.push_back(eventFrom(row, id));
}

}  // namespace terratact
