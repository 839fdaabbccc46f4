#include "app/recording/session_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "app/recording/session_folder.h"
#include "app/recording/session_text.h"
#include "app/runtime/steady_now.h"
#include "core/log/event_text.h"
#include "core/log/session_reader.h"
#include "core/store/file_write.h"

namespace terratact {
namespace {

constexpr double kTryAgain = 1.0;  // [s]

/// Returns "2026-11-22T031502.123Z" (UTC), so that names sort by time.
std::string stamp(std::int64_t wallTime)
{
    const std::time_t seconds = wallTime / 1'000'000'000;
    std::tm parts{};
    ::gmtime_r(&seconds, &parts);
    return fmt::format("{:04}-{:02}-{:02}T{:02}{:02}{:02}.{:03}Z", parts.tm_year + 1900,
                       parts.tm_mon + 1, parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec,
                       wallTime / 1'000'000 % 1000);
}

std::string freeName(const std::string& folder, std::int64_t wallTime)
{
    const std::string base = folder + "/" + stamp(wallTime);
    std::string path = base + kSessionSuffix;
    for (int n = 2; std::filesystem::exists(path) && n < 1000; ++n)
        path = base + "-" + std::to_string(n) + kSessionSuffix;
    return path;
}

}  // namespace

SessionRecorder::SessionRecorder(Options options)
    : options_(std::move(options)), began_(steadyNow()), on_(options_.on),
      thread_([this](const std::stop_token& stop) {
          options_.start.wallTime = wallNow() - now();
          run(stop);
      })
{
}

SessionRecorder::~SessionRecorder()
{
    thread_.request_stop();
    thread_.join();
}

SessionTime SessionRecorder::now() const
{
    return sessionTimeOf(steadyNow() - began_);
}

void SessionRecorder::add(std::span<const BusFrame> frames)
{
    const std::scoped_lock lock(mutex_);
    if (!on_) return;
    for (const BusFrame& frame : frames) {
        const SessionTime time = sessionTimeOf(frame.time - began_);
        if (waiting_.frames.size() < options_.mostFrames) {
            waiting_.frames.push_back(
                {.time = time, .frame = frame.frame, .sent = frame.echo, .local = frame.local});
            continue;
        }
        if (waiting_.missingFrames++ == 0) waiting_.missingSince = time;
        ++state_.missing;
    }
}

void SessionRecorder::keep(SessionRow row, SessionTime time)
{
    if (waiting_.rows.size() < options_.mostRows) {
        waiting_.rows.push_back(std::move(row));
        return;
    }
    if (waiting_.missingFrames + waiting_.missingRows == 0) waiting_.missingSince = time;
    ++waiting_.missingRows;
}

template <class T>
std::int64_t SessionRecorder::number(T row, std::int64_t& last)
{
    if (row.time == 0) row.time = now();
    const std::scoped_lock lock(mutex_);
    const std::int64_t id = row.id = ++last;
    const SessionTime time = row.time;
    keep(std::move(row), time);
    return id;
}

std::int64_t SessionRecorder::record(ModelRow row)
{
    return number(std::move(row), lastModel_);
}
std::int64_t SessionRecorder::record(SceneRow row)
{
    return number(row, lastScene_);
}
std::int64_t SessionRecorder::record(EstimateRow row)
{
    return number(std::move(row), lastEstimate_);
}
std::int64_t SessionRecorder::record(ProposalRow row)
{
    return number(std::move(row), lastProposal_);
}

void SessionRecorder::record(EventRow row)
{
    const bool isUrgent = row.kind == EventKind::Decision || row.kind == EventKind::Marker;
    if (row.time == 0) row.time = now();
    const std::scoped_lock lock(mutex_);
    const SessionTime time = row.time;
    keep(std::move(row), time);
    urgent_ = urgent_ || isUrgent;
    if (isUrgent) wake_.notify_one();
}

void SessionRecorder::setOn(bool on)
{
    const std::scoped_lock lock(mutex_);
    on_ = on;
    urgent_ = true;
    wake_.notify_one();
}

RecordingState SessionRecorder::state() const
{
    const std::scoped_lock lock(mutex_);
    RecordingState state = state_;
    state.on = on_;
    const double busy = busySince_ ? steadyNow() - *busySince_ : 0.0;
    if (busy > options_.patience && state.trouble.empty())
        state.trouble = Message(
            TR_NOOP("core", "%1: the disk is slow, it has been writing for %2 s; %3 frames wait"),
            options_.folder, fmt::format("{:.0f}", busy), waiting_.frames.size());
    return state;
}

void SessionRecorder::run(const std::stop_token& stop)
{
    bool last = false;
    while (!last) {
        bool on = true;
        {
            std::unique_lock lock(mutex_);
            busySince_.reset();
            wake_.wait_for(lock, stop, options_.batch, [this] { return urgent_; });
            last = stop.stop_requested();
            urgent_ = false;
            on = on_;
            gather();
            busySince_ = steadyNow();
        }
        if (!on) {
            if (writer_ && store()) seal(TR_NOOP("core", "recording was switched off"));
            remember();
            const std::scoped_lock lock(mutex_);
            state_.trouble = {};
            continue;
        }
        const bool nothing = batch_.frames.empty() && batch_.rows.empty();
        if (last && !writer_ && nothing) return;  // the console failed to start
        if (!open()) continue;
        if (store()) measure();
    }
    if (writer_) seal(TR_NOOP("core", "closed with the console"));
}

/// Writes all waiting rows and commits. On failure it closes the file, keeps the rows and returns false.
bool SessionRecorder::store()
{
    Status written = write();
    if (written) written = writer_->commit();
    if (!written) {
        close(written.error().message);
        return false;
    }
    remember();
    return true;
}

/// Writes the end event and seals the file.
void SessionRecorder::seal(SourceText why)
{
    Status ended = writer_->add(
        withText({.time = now(), .kind = EventKind::Session, .subject = "ended"}, why));
    if (ended) ended = writer_->commit();
    if (ended) (void)writer_->seal();  // a reader blocks sealing; then the next start seals it
    close(ended ? Message() : ended.error().message);
}

/// Moves queued rows behind the rows that could not be written yet, within the queue bounds.
void SessionRecorder::gather()
{
    Batch fresh = std::exchange(waiting_, {});
    miss(fresh.missingSince, fresh.missingFrames, fresh.missingRows);
    for (const FrameRow& frame : fresh.frames) {
        if (batch_.frames.size() < options_.mostFrames) {
            batch_.frames.push_back(frame);
        } else {
            miss(frame.time, 1, 0);
            ++state_.missing;
        }
    }
    for (SessionRow& row : fresh.rows) {
        if (batch_.rows.size() < options_.mostRows)
            batch_.rows.push_back(std::move(row));
        else
            miss(now(), 0, 1);
    }
}

void SessionRecorder::miss(SessionTime since, std::int64_t frames, std::int64_t rows)
{
    if (frames + rows == 0) return;
    if (batch_.missingFrames + batch_.missingRows == 0) batch_.missingSince = since;
    batch_.missingFrames += frames;
    batch_.missingRows += rows;
}

/// Opens a file if none is open; returns true if a file can be written.
bool SessionRecorder::open()
{
    if (writer_) return true;
    if (steadyNow() < nextTry_) return false;
    const Status begun = begin();
    if (!begun) close(begun.error().message);
    return writer_.has_value();
}

Status SessionRecorder::begin()
{
    if (options_.folder.empty())
        return Error{
            TR_NOOP("core", "there is no home folder to record in: --sessions names another")};
    if (Status made = makeDirectory(options_.folder, Access::Owner); !made) return made;
    if (const auto left = freeBytes(options_.folder); left && *left < options_.leastFree)
        return Error{Message(TR_NOOP("core", "%1: the disk is full: only %2 MB are free, %3 MB are "
                                             "kept free; recording continues when there is space"),
                             options_.folder, *left >> 20U, options_.leastFree >> 20U)};
    const std::string path = freeName(options_.folder, wallNow());
    auto writer = SessionWriter::create(path, options_.start);
    if (!writer) return writer.error();
    writer_.emplace(std::move(*writer));
    openedAt_ = steadyNow();
    {
        const std::scoped_lock lock(mutex_);
        state_.path = path;
        state_.trouble = {};
        state_.recording = true;
    }
    const bool goesOn = !before_.empty();
    if (Status written = writeContext(); !written) return written;
    Status logged = writer_->add(withText(
        {.time = now(), .kind = EventKind::Session, .subject = goesOn ? "continued" : "begun"},
        goesOn ? Message(TR_NOOP("core", "after %1"), before_) : Message()));
    before_ = path;
    return logged;
}

/// Writes the state at the start of a file that continues another.
Status SessionRecorder::writeContext()
{
    for (const SessionRow& row : context_.rows()) {
        try {
            Status added = std::visit([this](const auto& r) { return writer_->add(r); }, row);
            if (!added) return added;
        } catch (const std::invalid_argument&) {
            miss(now(), 0, 1);
        }
    }
    // A separate batch, because these rows have earlier times.
    return writer_->commit();
}

Status SessionRecorder::write()
{
    for (const FrameRow& frame : batch_.frames)
        if (Status added = writer_->add(frame); !added) return added;
    Status added = Done{};
    std::erase_if(batch_.rows, [&](const SessionRow& row) {
        if (!added) return false;
        try {
            added = std::visit([this](const auto& r) { return writer_->add(r); }, row);
            return false;
        } catch (const std::invalid_argument&) {
            miss(now(), 0, 1);  // an invalid row must not end the recording
            return true;
        }
    });
    if (!added) return added;
    if (batch_.missingFrames + batch_.missingRows == 0) return Done{};
    return writer_->add(
        withText({.time = batch_.missingSince,
                  .kind = EventKind::Gap,
                  .subject = "missing",
                  .number = static_cast<double>(batch_.missingFrames)},
                 {TR_NOOP("core", "%1 frames and %2 other rows were dropped: the disk was slow or "
                                  "full, or they could not be written"),
                  batch_.missingFrames, batch_.missingRows}));
}

void SessionRecorder::remember()
{
    for (const SessionRow& row : batch_.rows) context_.add(row);
    batch_ = {};
}

void SessionRecorder::close(const Message& why)
{
    framesBefore_ += writer_ ? writer_->frames() : 0;
    writer_.reset();
    nextTry_ = steadyNow() + kTryAgain;
    const std::scoped_lock lock(mutex_);
    state_.recording = false;
    state_.trouble = why;
    state_.secondsLeft = 0.0;
}

void SessionRecorder::measure()
{
    const std::int64_t bytes = sizeOf(writer_->path()) + sizeOf(writer_->path() + "-wal");
    const auto left = freeBytes(options_.folder);
    const double elapsed = steadyNow() - openedAt_;
    {
        const std::scoped_lock lock(mutex_);
        state_.frames = framesBefore_ + writer_->frames();
        state_.bytes = bytes;
        state_.secondsLeft = 0.0;
        if (left && elapsed > 10.0 && bytes > 0)
            state_.secondsLeft = static_cast<double>(*left - std::min(*left, options_.leastFree))
                               * elapsed / static_cast<double>(bytes);
    }
    if (left && *left < options_.leastFree) {
        seal(TR_NOOP("core", "the disk is full"));
        const std::scoped_lock lock(mutex_);
        state_.trouble = Message(
            TR_NOOP("core", "%1: the disk is full; recording continues when there is space"),
            options_.folder);
    } else if (bytes > options_.mostBytes || writer_->batches() + 1 >= options_.mostBatches) {
        seal(TR_NOOP("core", "the file is large enough"));
        nextTry_ = 0.0;
    }
}

}  // namespace terratact
