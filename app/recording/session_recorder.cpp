#include "app/recording/session_recorder.h"

#include <fmt/format.h>
#include <pwd.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "app/recording/session_text.h"
#include "app/runtime/steady_now.h"
#include "core/log/session_reader.h"
#include "core/store/file_write.h"

namespace terratact {
namespace {

constexpr double kTryAgain = 1.0;  // [s]
constexpr const char* kSuffix = ".tts";

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
    std::string path = base + kSuffix;
    for (int n = 2; std::filesystem::exists(path) && n < 1000; ++n)
        path = base + "-" + std::to_string(n) + kSuffix;
    return path;
}

std::int64_t sizeOf(const std::string& path)
{
    std::error_code none;
    const auto size = std::filesystem::file_size(path, none);
    return none ? 0 : static_cast<std::int64_t>(size);
}

}  // namespace

std::int64_t wallNow()
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

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

void SessionRecorder::take(std::span<const BusFrame> frames)
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
        state.trouble =
            fmt::format("{}: the disk is slow, it has been writing for {:.0f} s; {} frames wait",
                        options_.folder, busy, waiting_.frames.size());
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
            if (writer_ && store()) seal("recording was switched off");
            remember();
            const std::scoped_lock lock(mutex_);
            state_.trouble.clear();
            continue;
        }
        const bool nothing = batch_.frames.empty() && batch_.rows.empty();
        if (last && !writer_ && nothing) return;  // the console failed to start
        if (!open()) continue;
        if (store()) measure();
    }
    if (writer_) seal("closed with the console");
}

/// Writes all waiting rows and commits. On failure it closes the file, keeps the rows and returns false.
bool SessionRecorder::store()
{
    Status written = write();
    if (written) written = writer_->commit();
    if (!written) {
        close(written.error().text);
        return false;
    }
    remember();
    return true;
}

/// Writes the end event and seals the file.
void SessionRecorder::seal(const std::string& why)
{
    Status ended = writer_->add(
        EventRow{.time = now(), .kind = EventKind::Session, .subject = "ended", .text = why});
    if (ended) ended = writer_->commit();
    if (ended) (void)writer_->seal();  // a reader blocks sealing; then the next start seals it
    close(ended ? std::string() : ended.error().text);
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
    if (!begun) close(begun.error().text);
    return writer_.has_value();
}

Status SessionRecorder::begin()
{
    if (options_.folder.empty())
        return Error{"there is no home folder to record in: --sessions names another"};
    if (Status made = makeDirectory(options_.folder, FolderAccess::Owner); !made) return made;
    if (const auto left = freeBytes(options_.folder); left && *left < options_.leastFree)
        return Error{options_.folder + ": the disk is full: only " + std::to_string(*left >> 20U)
                     + " MB are free, " + std::to_string(options_.leastFree >> 20U)
                     + " MB are left alone; recording goes on when there is room"};
    const std::string path = freeName(options_.folder, wallNow());
    auto writer = SessionWriter::create(path, options_.start);
    if (!writer) return writer.error();
    writer_.emplace(std::move(*writer));
    openedAt_ = steadyNow();
    {
        const std::scoped_lock lock(mutex_);
        state_.path = path;
        state_.trouble.clear();
        state_.recording = true;
    }
    const bool goesOn = !before_.empty();
    if (Status written = writeContext(); !written) return written;
    Status told = writer_->add(EventRow{.time = now(),
                                        .kind = EventKind::Session,
                                        .subject = goesOn ? "continued" : "begun",
                                        .text = goesOn ? "after " + before_ : std::string()});
    before_ = path;
    return told;
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
    return writer_->add(EventRow{
        .time = batch_.missingSince,
        .kind = EventKind::Gap,
        .subject = "missing",
        .text = std::to_string(batch_.missingFrames) + " frames and "
              + std::to_string(batch_.missingRows)
              + " other rows are not here: there was no room while the disk was slow or full, or "
                "they could not be written",
        .number = static_cast<double>(batch_.missingFrames)});
}

void SessionRecorder::remember()
{
    for (const SessionRow& row : batch_.rows) context_.take(row);
    batch_ = {};
}

void SessionRecorder::close(const std::string& why)
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
        seal("the disk is full");
        const std::scoped_lock lock(mutex_);
        state_.trouble =
            options_.folder + ": the disk is full; recording goes on when there is room";
    } else if (bytes > options_.mostBytes || writer_->batches() + 1 >= options_.mostBatches) {
        seal("the file is large enough");
        nextTry_ = 0.0;
    }
}

std::string sessionFolder()
{
    const char* const state = std::getenv("XDG_STATE_HOME");
    if (state && *state == '/') return std::string(state) + "/terratact/sessions";
    const char* home = std::getenv("HOME");
    if (const passwd* const user = ::getpwuid(::getuid()); user && !(home && *home == '/'))
        home = user->pw_dir;
    return home && *home == '/' ? std::string(home) + "/.local/state/terratact/sessions"
                                : std::string();
}

std::optional<std::uint64_t> freeBytes(const std::string& folder)
{
    struct statvfs disk {};
    if (::statvfs(folder.c_str(), &disk) != 0) return std::nullopt;
    return std::uint64_t{disk.f_bavail} * disk.f_frsize;
}

std::vector<std::string> sessionsIn(const std::string& folder)
{
    std::vector<std::string> paths;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none))
        if (entry.path().extension() == kSuffix && !entry.is_symlink(none)
            && entry.is_regular_file(none))
            paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

std::vector<std::string> recoverDeadSessions(const std::vector<std::string>& paths)
{
    std::vector<std::string> told;
    for (const std::string& path : paths) {
        const auto recovery =
            recoverSession(path, true);  // true: a journal missing in this folder never comes back
        if (!recovery)
            told.push_back("session not recovered: " + recovery.error().text);
        else if (*recovery == SessionRecovery::Recovered)
            told.push_back("session recovered, whose program had ended without closing it: "
                           + path);
    }
    return told;
}

namespace {

constexpr std::int64_t kDay = std::int64_t{86'400} * 1'000'000'000;  // [ns]
constexpr std::int64_t kYear2020 = std::int64_t{1'577'836'800} * 1'000'000'000;

bool canBeTrue(std::int64_t time, std::int64_t now)
{
    return time >= kYear2020 && time <= now + kDay;
}

/// Returns the last write [ns] since 1970; 0 if unknown.
std::int64_t writtenAt(const std::string& path)
{
    struct stat file {};
    if (::stat(path.c_str(), &file) != 0) return 0;
    return std::int64_t{file.st_mtim.tv_sec} * 1'000'000'000 + file.st_mtim.tv_nsec;
}

struct ClosedSession {
    std::string path;
    double bytes;
    std::int64_t ended;   ///< [ns] since 1970
    bool mayBeDeleted;    ///< its times are plausible
    bool tooOld = false;  ///< beyond the age limit; otherwise the total size is
};

/// Returns the closed sessions, oldest first; empty if goesOn() cancelled.
std::vector<ClosedSession> closedOnes(const std::vector<std::string>& paths, std::int64_t now,
                                      const std::function<bool()>& goesOn)
{
    std::vector<ClosedSession> sessions;
    for (const std::string& path : paths) {
        if (!goesOn()) return {};
        // A session being written, even by this process, has a journal and is not opened. Closing any descriptor of it
        // would release this process's locks on the file.
        std::error_code none;
        if (std::filesystem::exists(path + "-wal", none)) continue;
        if (std::filesystem::is_symlink(path, none)) continue;
        const auto session = SessionReader::open(path);
        if (!session || !session->sealed()) continue;
        const std::int64_t recorded = wallTimeOf(session->start(), session->end());
        const std::int64_t written = writtenAt(path);
        sessions.push_back({.path = path,
                            .bytes = static_cast<double>(sizeOf(path)),
                            .ended = std::max(recorded, written),
                            .mayBeDeleted = canBeTrue(recorded, now) && canBeTrue(written, now)});
    }
    std::stable_sort(
        sessions.begin(), sessions.end(),
        [](const ClosedSession& a, const ClosedSession& b) { return a.ended < b.ended; });
    return sessions;
}

/// Returns the sessions beyond the limits, in the same order.
std::vector<ClosedSession> beyond(const std::vector<ClosedSession>& sessions,
                                  const RetentionLimits& limits, std::int64_t now)
{
    double total = 0.0;
    for (const ClosedSession& session : sessions) total += session.bytes;
    std::vector<ClosedSession> found;
    for (ClosedSession session : sessions) {
        const double age = static_cast<double>(now - session.ended) / static_cast<double>(kDay);
        session.tooOld = limits.days > 0.0 && age > limits.days;
        const bool tooMuch = limits.gigabytes > 0.0 && total > limits.gigabytes * 1e9;
        if (!session.mayBeDeleted || (!session.tooOld && !tooMuch)) continue;
        total -= session.bytes;
        found.push_back(session);
    }
    return found;
}

}  // namespace

std::vector<std::string> applyRetention(const std::vector<std::string>& paths,
                                        const RetentionLimits& limits, std::int64_t now,
                                        const std::function<bool()>& goesOn)
{
    if ((limits.days <= 0.0 && limits.gigabytes <= 0.0) || now < kYear2020) return {};
    const std::vector<ClosedSession> surplus = beyond(closedOnes(paths, now, goesOn), limits, now);
    if (!limits.confirmed) {
        if (surplus.empty()) return {};
        double bytes = 0.0;
        for (const ClosedSession& session : surplus) bytes += session.bytes;
        return {fmt::format("{} sessions of {:.1f} MB are beyond the limits that you have set; "
                            "none is deleted until the page of the settings says that they may be",
                            surplus.size(), 1e-6 * bytes)};
    }
    std::vector<std::string> told;
    for (const ClosedSession& session : surplus) {
        if (!goesOn()) break;
        std::error_code none;
        if (std::filesystem::remove(session.path, none))
            told.push_back(std::string("session deleted, since ")
                           + (session.tooOld ? "it is older" : "all together are larger")
                           + " than you have set: " + session.path);
    }
    return told;
}

}  // namespace terratact
