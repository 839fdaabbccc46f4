#include "core/log/session_writer.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "core/base/text.h"
#include "core/log/event_text.h"
#include "core/log/rows/session_row_checks.h"
#include "core/log/session_writer_impl.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

std::int64_t flagsOf(const FrameRow& row)
{
    const CanFrame& f = row.frame;
    return (f.extended ? kExtendedFlag : 0) | (f.remote ? kRemoteFlag : 0)
         | (f.error ? kErrorFlag : 0) | (f.fd ? kFdFlag : 0) | (row.sent ? kSentFlag : 0)
         | (row.local ? kLocalFlag : 0) | std::int64_t{f.length} << kLengthShift;
}

}  // namespace

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
