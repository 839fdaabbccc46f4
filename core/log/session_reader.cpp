#include "core/log/session_reader.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/log/rows/checked_row.h"
#include "core/log/session_journal.h"
#include "core/log/session_reader_impl.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr int kMaxLength = 64 << 20;  // bytes of one value: draws

}  // namespace

SessionReader::SessionReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SessionReader::SessionReader(SessionReader&&) noexcept = default;
SessionReader& SessionReader::operator=(SessionReader&&) noexcept = default;
SessionReader::~SessionReader() = default;

Result<SessionReader> SessionReader::open(const std::string& path, std::size_t atATime)
{
    return open(path, atATime, true);
}

Result<SessionReader> SessionReader::openFragments(const std::string& path)
{
    return open(path, kAtATime, false);
}

Result<SessionReader> SessionReader::open(const std::string& path, std::size_t atATime,
                                          bool chainCounts)
{
    try {
        const bool sealed = !SqliteFile::isJournaled(path);
        const bool lacksJournal = SqliteFile::lacksJournal(path);
        auto impl = std::make_unique<Impl>(path, SqliteFile::openLog(path, kMaxLength), sealed,
                                           std::max<std::size_t>(atATime, 1));
        requireSessionSchema(impl->file, lacksJournal ? nameWithoutFolder(path) : std::string());
        impl->stored = readSessionStart(impl->file);
        if (!sealed && !lacksJournal) requireOwnJournal(path, impl->file);
        impl->chain = impl->proven = impl->stored.hash;
        impl->chainCounts = chainCounts;
        static_cast<void>(impl->readMore());
        if (impl->file.size() <= kMaxChecked) impl->checkStructure();
        if (lacksJournal) impl->missJournal();
        if (const auto damage = sealed ? std::nullopt : damageOfJournal(path))
            impl->damage.push_back({impl->end, impl->end, *damage});
        return SessionReader(std::move(impl));
    } catch (const SqliteError& error) {
        return fileError(path, error.message(), error.code());
    } catch (const RefusedRow& refused) {
        return fileError(path, refused.message());
    }
}

Result<bool> SessionReader::refresh()
{
    const auto failed = [this](const Message& cause) {
        try {
            impl_->file.run("ROLLBACK");
        } catch (const SqliteError&) {
            // no transaction was open
        }
        return fileError(impl_->path, cause);
    };
    try {
        return impl_->readMore();
    } catch (const SqliteError& error) {
        return failed(error.message());
    } catch (const RefusedRow& refused) {
        return failed(refused.message());
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
bool SessionReader::lacksJournal() const
{
    return impl_->lacksJournal;
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
    return impl_->rows.models;
}
const std::vector<SceneRow>& SessionReader::scenes() const
{
    return impl_->rows.scenes;
}
const std::vector<EstimateRow>& SessionReader::estimates() const
{
    return impl_->rows.estimates;
}
const std::vector<ProposalRow>& SessionReader::proposals() const
{
    return impl_->rows.proposals;
}
const std::vector<EventRow>& SessionReader::events() const
{
    return impl_->rows.events;
}
const std::vector<SessionBatch>& SessionReader::batches() const
{
    return impl_->batches;
}
const ModelRow* SessionReader::model(std::int64_t id) const
{
    return byId(impl_->rows.models, id);
}
const SceneRow* SessionReader::scene(std::int64_t id) const
{
    return byId(impl_->rows.scenes, id);
}
const EstimateRow* SessionReader::estimate(std::int64_t id) const
{
    return byId(impl_->rows.estimates, id);
}
const ProposalRow* SessionReader::proposal(std::int64_t id) const
{
    return byId(impl_->rows.proposals, id);
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
    if (impl_->chainCounts && !impl_->isSound(wanted.id)) return {};
    try {
        return impl_->frames(batch);
    } catch (const RefusedRow& refused) {
        impl_->addDamage(wanted, refused.message());
    } catch (const SqliteError& error) {
        impl_->addDamage(wanted, error.message());
    }
    return {};
}

Result<SideDraws> SessionReader::draws(std::int64_t estimate)
{
    try {
        return impl_->draws(estimate);
    } catch (const SqliteError& error) {
        return fileError(impl_->path, error.message());
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
        if (!impl_->structureChecked) impl_->checkStructure();
        impl_->countStrayFrames();
    } catch (const SqliteError& error) {
        impl_->damage.push_back({0, 0, error.message()});
    }
    for (const EstimateRow& row : impl_->rows.estimates)
        if (const auto stored = draws(row.id); !stored)
            impl_->damage.push_back({row.time, row.time, stored.error().message});
    found.events = static_cast<std::int64_t>(impl_->rows.events.size());
    found.damage = impl_->damage;
    found.broken = impl_->broken;
    for (const SessionDamage& damage : found.damage)
        if (!found.broken || damage.first < found.broken->first) found.broken = damage;
    found.chain = hexOf(impl_->proven);
    return found;
}

}  // namespace terratact
