#include "core/log/session_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "core/file_read.h"
#include "core/log/session_schema.h"
#include "core/log/session_tables.h"
#include "core/sqlite.h"

namespace terratact {
namespace {

constexpr int kLongest = 64 << 20;          // bytes of one value: draws
constexpr std::size_t kMostRows = 500'000;  // of one table but the frames
constexpr double kMostNumber = 1e12;
constexpr SessionTime kMostTime = std::int64_t{1} << 60;  // 36 years
constexpr std::int64_t kMostCount = std::int64_t{1} << 48;
constexpr std::int64_t kMostPerBatch = 200'000;  // frames
constexpr std::size_t kMostBatches = 4'000'000;

/// What a row holds is not what a session has.  Thrown and caught in this file only.
struct Refused {
    std::string cause;
};

void require(bool holds, const char* cause)
{
    if (!holds) throw Refused{cause};
}

/// The present row of a statement, column by column, each checked.
class Row {
public:
    explicit Row(const SqliteStatement& statement, int from = 0) : statement_(statement), at_(from)
    {
    }
    std::int64_t integer(std::int64_t least, std::int64_t most)
    {
        const std::int64_t value = statement_.integer(at_++);
        require(value >= least && value <= most, "a number is out of range");
        return value;
    }
    int small(int least, int most) { return static_cast<int>(integer(least, most)); }
    std::int64_t id() { return integer(1, kMostCount); }
    std::int64_t idOrNone() { return integer(0, kMostCount); }
    SessionTime time() { return integer(-kMostTime, kMostTime); }
    bool flag() { return integer(0, 1) == 1; }
    double real(double least = -kMostNumber, double most = kMostNumber)
    {
        const double value = statement_.real(at_++);
        require(value >= least && value <= most, "a number is out of range");
        return value;
    }
    std::optional<double> realOrNone()
    {
        if (!statement_.isNull(at_)) return real();
        ++at_;
        return std::nullopt;
    }
    bool isNone() const { return statement_.isNull(at_); }
    void skip(int columns) { at_ += columns; }
    std::string text() { return statement_.text(at_++); }
    std::string blob() { return statement_.blob(at_++); }
    std::string hash()
    {
        std::string value = blob();
        require(value.size() == Sha256::kBytes, "a hash has the wrong length");
        return value;
    }
    template <class Value>
    Value named(std::optional<Value> (*fromName)(std::string_view))
    {
        const auto value = fromName(text());
        require(value.has_value(), "an unknown name");
        return *value;
    }

private:
    const SqliteStatement& statement_;
    int at_;
};

std::optional<Origin> originFromName(std::string_view text)
{
    for (const Origin origin : {Origin::Sampled, Origin::Contact, Origin::Arm})
        if (name(origin) == text) return origin;
    return std::nullopt;
}

std::optional<Ending> endingFromName(std::string_view text)
{
    for (const Ending e : {Ending::Converged, Ending::Sweeps, Ending::Time, Ending::NotSampled})
        if (name(e) == text) return e;
    return std::nullopt;
}

std::uint64_t seedFrom(const std::string& text)
{
    std::uint64_t seed = 0;
    for (const char c : text) {
        require(c >= '0' && c <= '9' && text.size() <= 20, "a seed is no number");
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

ArmReading readingFrom(Row& row)
{
    ArmReading reading;
    reading.bin = row.small(0, kBins - 1);
    reading.height = row.real();
    reading.sd = row.real(0.0);
    return reading;
}

CanFrame frameFrom(Row& row, std::int64_t& flags)
{
    CanFrame frame;
    frame.id = static_cast<std::uint32_t>(row.integer(0, 0x1FFFFFFF));
    flags = row.integer(0, (64 << kLengthShift) + 63);
    frame.extended = (flags & kExtendedFlag) != 0;
    frame.remote = (flags & kRemoteFlag) != 0;
    frame.error = (flags & kErrorFlag) != 0;
    frame.fd = (flags & kFdFlag) != 0;
    frame.length = static_cast<std::uint8_t>(flags >> kLengthShift);
    require(frame.fd || frame.length <= frame.data.size(), "a frame is too long");
    require(frame.extended || frame.error || frame.id <= 0x7FF, "an identifier is too large");
    const std::string data = row.blob();
    const std::size_t expected =
        frame.remote ? 0 : std::min<std::size_t>(frame.length, frame.data.size());
    require(data.size() == expected, "a frame has the wrong length");
    std::copy(data.begin(), data.end(), reinterpret_cast<char*>(frame.data.data()));
    return frame;
}

template <class Rows>
auto* byId(Rows& rows, std::int64_t id)
{
    const auto found = std::lower_bound(rows.begin(), rows.end(), id,
                                        [](const auto& row, std::int64_t i) { return row.id < i; });
    return found != rows.end() && found->id == id ? &*found : nullptr;
}

}  // namespace

struct SessionReader::Impl {
    Impl(std::string name, SqliteFile opened, bool isSealed)
        : path(std::move(name)), file(std::move(opened)), sealed(isSealed)
    {
    }

    bool readMore();
    std::vector<SessionBatch> newBatches(std::vector<std::string>& links);
    void judge(std::vector<SessionBatch>& fresh, const std::vector<std::string>& links);
    std::map<std::int64_t, std::string> rowHashes(const std::vector<SessionBatch>& fresh);
    SqliteStatement rowsFrom(std::size_t table, std::int64_t batch);
    void readRows(std::int64_t from);
    void take(std::size_t table, Row& row, std::int64_t batch);
    void addDamage(const SessionBatch& batch, const std::string& why);
    bool isSound(std::int64_t batch) const
    {
        return byId(batches, batch) && !std::binary_search(unsound.begin(), unsound.end(), batch);
    }
    std::vector<FrameRow> frames(const SessionBatch& batch);
    void countStrayFrames();
    void readSettings(Row& row, std::int64_t id);
    void readModel(Row& row, std::int64_t id);
    void readTruth(Row& row);
    void readReading(Row& row);
    void readOffer(Row& row);
    void readScene(Row& row, std::int64_t id);
    void readEstimate(Row& row, std::int64_t id);
    void readBin(Row& row);
    void readProposal(Row& row, std::int64_t id);
    void readEvent(Row& row, std::int64_t id);

    std::string path;
    SqliteFile file;
    bool sealed;
    StoredStart stored;
    std::vector<SessionBatch> batches;
    std::string chain;   ///< the file's own, after batches.back()
    std::string proven;  ///< the last link that holds
    std::optional<SessionDamage> broken;
    std::vector<std::int64_t> unsound;  ///< batches whose rows are not handed out, ascending
    std::vector<SessionDamage> damage;
    SessionTime begin = 0, end = 0;

    std::vector<ModelRow> models;
    std::vector<SceneRow> scenes;
    std::vector<EstimateRow> estimates;
    std::vector<ProposalRow> proposals;
    std::vector<EventRow> events;
    std::map<std::int64_t, Settings> settings;
};

void SessionReader::Impl::addDamage(const SessionBatch& batch, const std::string& why)
{
    const SessionDamage found{batch.first, batch.last, why};
    if (std::find(damage.begin(), damage.end(), found) == damage.end()) damage.push_back(found);
}

std::vector<SessionBatch> SessionReader::Impl::newBatches(std::vector<std::string>& links)
{
    std::vector<SessionBatch> fresh;
    SqliteStatement select = file.prepare("SELECT * FROM batch WHERE id > ? ORDER BY id");
    select.bind(0, batches.empty() ? 0 : batches.back().id);
    while (select.step()) {
        if (fresh.size() % 1024 == 0) file.grantSteps();
        require(batches.size() + fresh.size() < kMostBatches, "has too many batches");
        Row row(select);
        SessionBatch batch;
        batch.id = row.id();
        batch.first = row.time();
        batch.last = row.time();
        require(batch.first <= batch.last, "a batch ends before it begins");
        batch.frameFirst = row.id();
        batch.frameCount = row.integer(0, kMostPerBatch);
        batch.framesHash = row.hash();
        batch.rowsHash = row.hash();
        links.push_back(row.hash());
        fresh.push_back(std::move(batch));
    }
    return fresh;
}

/// Where the chain is broken, and which batches' rows are not what was recorded.
void SessionReader::Impl::judge(std::vector<SessionBatch>& fresh,
                                const std::vector<std::string>& links)
{
    const auto hashes = rowHashes(fresh);
    const std::string none = RowsHash().take();
    std::int64_t id = batches.empty() ? 1 : batches.back().id + 1;
    std::int64_t frame =
        batches.empty() ? 1 : batches.back().frameFirst + batches.back().frameCount;
    std::string before = chain;
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        const SessionBatch& batch = fresh[i];
        const bool follows = batch.id == id && batch.frameFirst == frame;
        const bool linked = follows && chained(before, batch) == links[i];
        if (!linked && !broken)
            broken = SessionDamage{batch.first, batch.last, "the chain of hashes is broken here"};
        if (!linked) addDamage(batch, "the chain of hashes is broken here");
        const auto rows = hashes.find(batch.id);
        if (!linked || (rows == hashes.end() ? none : rows->second) != batch.rowsHash) {
            if (linked) addDamage(batch, "rows were changed, lost or added");
            unsound.push_back(batch.id);
        }
        before = links[i];
        id = batch.id + 1;
        frame = batch.frameFirst + batch.frameCount;
        if (!broken) proven = links[i];
    }
    chain = before;
}

SqliteStatement SessionReader::Impl::rowsFrom(std::size_t table, std::int64_t batch)
{
    SqliteStatement select =
        file.prepare("SELECT * FROM " + std::string(kSessionRowTables.at(table))
                     + " WHERE batch >= ? ORDER BY id");
    select.bind(0, batch);
    return select;
}

/// rows_hash of every one of the batches that has rows, as they are in the file.  Rows of a batch stand together
/// in each table; those of no batch are damage.
std::map<std::int64_t, std::string>
SessionReader::Impl::rowHashes(const std::vector<SessionBatch>& fresh)
{
    std::map<std::int64_t, std::string> parts;  // the tables' hashes one behind the other
    const std::string none = Sha256().take();
    const auto fill = [&](std::string& part, std::size_t tables) {
        while (part.size() < tables * Sha256::kBytes) part += none;
    };
    std::size_t strays = 0;
    for (std::size_t table = 0; table < kSessionRowTables.size(); ++table) {
        Sha256 hash;
        std::optional<std::int64_t> current;
        const auto finish = [&] {
            if (!current) return;
            std::string& part = parts[*current];
            fill(part, table);
            part += hash.take();  // a second one in this table makes it too long, and wrong
        };
        RowBytes bytes;
        // From the beginning at first, so that rows of no batch are seen.
        SqliteStatement select = rowsFrom(
            table, batches.empty() ? std::numeric_limits<std::int64_t>::min() : fresh.front().id);
        for (std::size_t rows = 0; select.step(); ++rows) {
            require(rows < kMostRows, "a table has more rows than a session can have");
            if (rows % 1024 == 0) file.grantSteps();
            const std::int64_t batch = select.integer(1);
            if (!byId(fresh, batch)) {
                ++strays;
                continue;
            }
            if (batch != current) {
                finish();
                current = batch;
            }
            bytes.clear();
            bytes.addRow(select, select.columns());
            hash.add(bytes.bytes());
        }
        finish();
    }
    const SessionTime last = fresh.back().last;
    if (strays > 0)
        damage.push_back({last, last, std::to_string(strays) + " rows belong to no batch"});
    for (auto& [batch, part] : parts) {
        fill(part, kSessionRowTables.size());
        Sha256 all;
        all.add(part);
        part = all.take();
    }
    return parts;
}

void SessionReader::Impl::readRows(std::int64_t from)
{
    for (std::size_t table = 0; table < kSessionRowTables.size(); ++table) {
        SqliteStatement select = rowsFrom(table, from);
        for (std::size_t rows = 0; select.step(); ++rows) {
            if (rows % 1024 == 0) file.grantSteps();
            const std::int64_t batch = select.integer(1);
            if (batch > batches.back().id || !isSound(batch)) continue;
            Row row(select);
            take(table, row, batch);
        }
    }
}

void SessionReader::Impl::take(std::size_t table, Row& row, std::int64_t batch)
{
    const std::int64_t id = row.id();
    row.skip(1);
    const std::string_view name = kSessionRowTables.at(table);
    try {
        if (name == "settings")
            readSettings(row, id);
        else if (name == "model")
            readModel(row, id);
        else if (name == "scene")
            readScene(row, id);
        else if (name == "scene_truth")
            readTruth(row);
        else if (name == "estimate")
            readEstimate(row, id);
        else if (name == "reading")
            readReading(row);
        else if (name == "estimate_bin")
            readBin(row);
        else if (name == "proposal")
            readProposal(row, id);
        else if (name == "proposal_offer")
            readOffer(row);
        else
            readEvent(row, id);
    } catch (const Refused& refused) {
        addDamage(*byId(batches, batch),
                  std::string("a row of its table ").append(name) + ": " + refused.cause);
    }
}

void SessionReader::Impl::readSettings(Row& row, std::int64_t id)
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
    settings[id] = s;
}

void SessionReader::Impl::readModel(Row& row, std::int64_t id)
{
    ModelRow model{.id = id, .time = row.time()};
    model.name = row.text();
    model.hash = row.text();
    model.details = row.text();
    models.push_back(std::move(model));
}

void SessionReader::Impl::readTruth(Row& row)
{
    SceneRow* const scene = byId(scenes, row.id());
    require(scene != nullptr, "truth of no scene");
    const auto bin = static_cast<std::size_t>(row.small(0, kBins - 1));
    if (!scene->truth) scene->truth = Heights{};
    scene->truth->at(bin) = row.real();
}

void SessionReader::Impl::readReading(Row& row)
{
    EstimateRow* const estimate = byId(estimates, row.id());
    require(estimate != nullptr, "a reading of no estimate");
    estimate->readings.push_back(readingFrom(row));
}

void SessionReader::Impl::readOffer(Row& row)
{
    ProposalRow* const proposal = byId(proposals, row.id());
    require(proposal != nullptr, "an offer of no proposal");
    OfferedBin offer;
    offer.bin = row.small(0, kBins - 1);
    offer.varianceShare = row.real();
    offer.bitsAfter = row.real();
    proposal->offers.push_back(offer);
}

void SessionReader::Impl::readScene(Row& row, std::int64_t id)
{
    SceneRow scene{.id = id, .time = row.time()};
    Measurement& m = scene.measurement;
    for (double* value :
         {&m.time, &m.pitch, &m.roll, &m.frontLeft, &m.frontRight, &m.rearLeft, &m.rearRight,
          &m.frontLeftCurrent, &m.frontRightCurrent, &m.rearLeftCurrent, &m.rearRightCurrent})
        *value = row.real();
    for (double& force : m.force) force = row.real();
    m.activity = static_cast<RobotActivity>(row.small(0, static_cast<int>(RobotActivity::Stopped)));
    m.refusal = static_cast<Refusal>(row.small(0, static_cast<int>(Refusal::OutOfLimits)));
    if (!row.isNone())
        m.arm = readingFrom(row);
    else
        row.skip(3);
    m.travelled = row.realOrNone();
    m.turned = row.realOrNone();
    scenes.push_back(scene);
}

void SessionReader::Impl::readEstimate(Row& row, std::int64_t id)
{
    EstimateRow r{.id = id, .time = row.time()};
    r.scene = row.id();
    require(byId(scenes, r.scene) != nullptr, "an estimate of no scene");
    const auto found = settings.find(row.id());
    require(found != settings.end(), "an estimate without settings");
    r.model = row.id();
    require(byId(models, r.model) != nullptr, "an estimate without a model");
    r.role = row.named(estimateRoleFromName);
    r.seconds = row.real(0.0);
    r.stepLimit = row.real(0.0);
    TerrainEstimate& e = r.estimate;
    e.settings = found->second;
    e.novelty = row.real();
    e.ending = row.named(endingFromName);
    e.converged = row.flag();
    e.warnings = linesOf(row.text());
    estimates.push_back(std::move(r));
}

void SessionReader::Impl::readBin(Row& row)
{
    EstimateRow* const found = byId(estimates, row.id());
    require(found != nullptr, "a bin of no estimate");
    TerrainEstimate& e = found->estimate;
    const auto i = static_cast<std::size_t>(row.small(0, kBins - 1));
    e.origin[i] = row.named(originFromName);
    e.height[i] = row.real();
    e.mean[i] = row.real();
    e.sd[i] = row.real(0.0);
    e.q10[i] = row.real();
    e.q90[i] = row.real();
    e.ceiling[i] = row.realOrNone().value_or(std::numeric_limits<double>::infinity());
    e.rhat[i] = row.real();
    e.ess[i] = row.real();
}

void SessionReader::Impl::readProposal(Row& row, std::int64_t id)
{
    ProposalRow p{.id = id, .time = row.time()};
    p.estimate = row.id();
    require(byId(estimates, p.estimate) != nullptr, "a proposal without an estimate");
    p.bin = row.small(0, kBins - 1);
    for (double* value : {&p.height, &p.q10, &p.q90, &p.sd, &p.limit, &p.armSd, &p.seconds,
                          &p.stepLimit, &p.bitsBefore})
        *value = row.real();
    p.grounds = row.text();
    proposals.push_back(std::move(p));
}

void SessionReader::Impl::readEvent(Row& row, std::int64_t id)
{
    EventRow e{.id = id, .time = row.time()};
    e.kind = row.named(eventKindFromName);
    e.subject = row.text();
    e.text = row.text();
    e.number = row.realOrNone();
    e.estimate = row.idOrNone();
    e.proposal = row.idOrNone();
    e.shown = row.text();
    events.push_back(std::move(e));
}

/// Where its frames begin: before them a file that goes on after another repeats what that said.
SessionTime beginOf(const std::vector<SessionBatch>& batches)
{
    const auto first = std::find_if(batches.begin(), batches.end(),
                                    [](const SessionBatch& batch) { return batch.frameCount > 0; });
    return (first == batches.end() ? batches.front() : *first).first;
}

bool SessionReader::Impl::readMore()
{
    file.grantSteps();
    file.run("BEGIN");
    std::vector<std::string> links;
    std::vector<SessionBatch> fresh = newBatches(links);
    if (!fresh.empty()) {
        judge(fresh, links);
        if (batches.empty()) begin = beginOf(fresh);
        for (const SessionBatch& batch : fresh) end = std::max(end, batch.last);
        const std::int64_t from = fresh.front().id;
        batches.insert(batches.end(), std::make_move_iterator(fresh.begin()),
                       std::make_move_iterator(fresh.end()));
        readRows(from);
    }
    file.run("COMMIT");
    return !fresh.empty();
}

void SessionReader::Impl::countStrayFrames()
{
    const std::int64_t last =
        batches.empty() ? 0 : batches.back().frameFirst + batches.back().frameCount - 1;
    file.grantSteps();
    SqliteStatement select =
        file.prepare("SELECT seq FROM can_frame WHERE seq < 1 OR seq > ? LIMIT 1");
    select.bind(0, last);
    if (sealed && select.step()) damage.push_back({end, end, "frames belong to no batch"});
}

std::vector<FrameRow> SessionReader::Impl::frames(const SessionBatch& batch)
{
    file.grantSteps();
    SqliteStatement select =
        file.prepare("SELECT * FROM can_frame WHERE seq >= ? AND seq < ? ORDER BY seq");
    select.bind(0, batch.frameFirst);
    select.bind(1, batch.frameFirst + batch.frameCount);
    std::vector<FrameRow> rows;
    Sha256 hash;
    RowBytes bytes;
    while (select.step()) {
        bytes.clear();
        bytes.addRow(select, select.columns());
        hash.add(bytes.bytes());
        Row row(select, 1);
        FrameRow frame;
        frame.time = row.time();
        row.skip(1);
        std::int64_t flags = 0;
        frame.frame = frameFrom(row, flags);
        frame.sent = (flags & kSentFlag) != 0;
        frame.local = (flags & kLocalFlag) != 0;
        rows.push_back(frame);
        if (rows.size() % 1024 == 0) file.grantSteps();
    }
    require(hash.take() == batch.framesHash, "frames were changed, lost or added");
    return rows;
}

SessionReader::SessionReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SessionReader::SessionReader(SessionReader&&) noexcept = default;
SessionReader& SessionReader::operator=(SessionReader&&) noexcept = default;
SessionReader::~SessionReader() = default;

Result<SessionReader> SessionReader::open(const std::string& path)
{
    try {
        const bool sealed = !SqliteFile::isJournaled(path);
        auto impl = std::make_unique<Impl>(path, SqliteFile::openLog(path, kLongest), sealed);
        requireSessionSchema(impl->file);
        impl->stored = readSessionStart(impl->file);
        impl->chain = impl->proven = impl->stored.hash;
        static_cast<void>(impl->readMore());
        return SessionReader(std::move(impl));
    } catch (const SqliteError& error) {
        return fileError(path, error.what());
    } catch (const Refused& refused) {
        return fileError(path, refused.cause);
    }
}

Result<bool> SessionReader::refresh()
{
    const auto failed = [this](const std::string& cause) {
        try {
            impl_->file.run("ROLLBACK");
        } catch (const SqliteError&) {
            // there was nothing to end
        }
        return fileError(impl_->path, cause);
    };
    try {
        return impl_->readMore();
    } catch (const SqliteError& error) {
        return failed(error.what());
    } catch (const Refused& refused) {
        return failed(refused.cause);
    }
}

const std::string& SessionReader::path() const
{
    return impl_->path;
}
const SessionStart& SessionReader::start() const
{
    return impl_->stored.start;
}
bool SessionReader::sealed() const
{
    return impl_->sealed;
}
SessionTime SessionReader::begin() const
{
    return impl_->begin;
}
SessionTime SessionReader::end() const
{
    return impl_->end;
}
std::int64_t SessionReader::frameCount() const
{
    return impl_->batches.empty()
             ? 0
             : impl_->batches.back().frameFirst + impl_->batches.back().frameCount - 1;
}
const std::vector<ModelRow>& SessionReader::models() const
{
    return impl_->models;
}
const std::vector<SceneRow>& SessionReader::scenes() const
{
    return impl_->scenes;
}
const std::vector<EstimateRow>& SessionReader::estimates() const
{
    return impl_->estimates;
}
const std::vector<ProposalRow>& SessionReader::proposals() const
{
    return impl_->proposals;
}
const std::vector<EventRow>& SessionReader::events() const
{
    return impl_->events;
}
const std::vector<SessionBatch>& SessionReader::batches() const
{
    return impl_->batches;
}
const ModelRow* SessionReader::model(std::int64_t id) const
{
    return byId(impl_->models, id);
}
const SceneRow* SessionReader::scene(std::int64_t id) const
{
    return byId(impl_->scenes, id);
}
const EstimateRow* SessionReader::estimate(std::int64_t id) const
{
    return byId(impl_->estimates, id);
}
const ProposalRow* SessionReader::proposal(std::int64_t id) const
{
    return byId(impl_->proposals, id);
}
const std::vector<SessionDamage>& SessionReader::damage() const
{
    return impl_->damage;
}

std::size_t SessionReader::batchAt(SessionTime time) const
{
    const auto& all = impl_->batches;
    const auto found =
        std::lower_bound(all.begin(), all.end(), time,
                         [](const SessionBatch& b, SessionTime t) { return b.last < t; });
    return static_cast<std::size_t>(found - all.begin());
}

std::vector<FrameRow> SessionReader::frames(std::size_t batch)
{
    if (batch >= impl_->batches.size())
        throw std::invalid_argument("SessionReader::frames: no such batch");
    const SessionBatch& wanted = impl_->batches[batch];
    if (!impl_->isSound(wanted.id)) return {};
    try {
        return impl_->frames(wanted);
    } catch (const Refused& refused) {
        impl_->addDamage(wanted, refused.cause);
    } catch (const SqliteError& error) {
        impl_->addDamage(wanted, error.what());
    }
    return {};
}

Result<std::vector<Heights>> SessionReader::draws(std::int64_t estimate)
{
    try {
        impl_->file.grantSteps();
        SqliteStatement select =
            impl_->file.prepare("SELECT d.draws, e.draws_sha256 FROM estimate_draws d "
                                "JOIN estimate e ON e.id = d.id WHERE d.id = ?");
        select.bind(0, estimate);
        if (!select.step()) return fileError(impl_->path, "the draws of an estimate are missing");
        const std::string bytes = select.blob(0);
        Sha256 hash;
        hash.add(bytes);
        if (hash.take() != select.blob(1))
            return fileError(impl_->path, "the draws of an estimate were changed");
        return drawsFrom(bytes);
    } catch (const SqliteError& error) {
        return fileError(impl_->path, error.what());
    }
}

SessionVerification SessionReader::verify(const std::function<bool(double)>& progress)
{
    SessionVerification found;
    for (std::size_t i = 0; i < impl_->batches.size(); ++i) {
        found.frames += static_cast<std::int64_t>(frames(i).size());
        const double share =
            static_cast<double>(i + 1) / static_cast<double>(impl_->batches.size());
        if (progress && i % 64 == 0 && !progress(share)) break;
        ++found.batches;
    }
    try {
        impl_->countStrayFrames();
    } catch (const SqliteError& error) {
        impl_->damage.push_back({0, 0, error.what()});
    }
    for (const EstimateRow& row : impl_->estimates)
        if (const auto stored = draws(row.id); !stored)
            impl_->damage.push_back({row.time, row.time, stored.error().text});
    found.events = static_cast<std::int64_t>(impl_->events.size());
    found.damage = impl_->damage;
    found.broken = impl_->broken;
    for (const SessionDamage& damage : found.damage)
        if (!found.broken || damage.first < found.broken->first) found.broken = damage;
    found.chain = hexOf(impl_->proven);
    return found;
}

}  // namespace terratact
