#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "app/recording/recording_context.h"
#include "core/log/session_schema.h"
#include "core/log/session_writer.h"
#include "drivers/can_bus.h"

namespace terratact {

/// How a recording goes on.
struct RecordingState {
    bool on = true;            ///< recording is wanted
    bool recording = false;    ///< a file is open and takes rows
    std::string path;          ///< of the file; empty before the first
    std::string trouble;       ///< why nothing is recorded; empty: it is
    std::int64_t frames = 0;   ///< committed, in all files
    std::int64_t missing = 0;  ///< frames that found no room, in all
    std::int64_t bytes = 0;    ///< of the file and its journal
    double secondsLeft = 0.0;  ///< until the disk is full at the present rate; 0: not known yet
};

/// Records a session (docs/sessions.md) in a thread of its own and is never in anybody's way: frames and rows wait
/// in bounded queues, what finds no room is counted and told in the file.  A file that cannot be written any more is
/// left as it is; a new one is begun as soon as that works again, with what still waited.
///
/// Every method may be called from any thread and returns at once.
class SessionRecorder {
public:
    struct Options {
        std::string
            folder;  ///< made for its owner alone (mode 0700) where it is not there; empty: there is none
        SessionStart start;                    ///< wallTime is set here
        bool on = true;                        ///< see setOn()
        std::size_t mostFrames = 18'018;       ///< that wait: two seconds of a full bus of 1 Mbit/s
        std::size_t mostRows = 10'000;         ///< likewise, of the other rows
        std::chrono::milliseconds batch{200};  ///< between two commits
        std::int64_t mostBytes = std::int64_t{4}
                              << 30U;            ///< of a file; then it goes on in the next
        std::int64_t mostBatches = kMaxBatches;  ///< likewise
        double patience = 0.6;                   ///< [s] that writing may take before it is trouble
        std::uint64_t leastFree = std::uint64_t{50}
                               << 20U;  ///< bytes of the disk that are left alone
    };
    /// Begins at once.
    explicit SessionRecorder(Options options);
    ~SessionRecorder();  ///< commits, and seals the file

    /// Frames of the bus; times are those of the steady clock.
    void take(std::span<const BusFrame> frames);

    // Rows; the id, which is returned, and, unless it is set, the time are given here.  An operator's decision is
    // committed at once.
    std::int64_t record(ModelRow row);
    std::int64_t record(SceneRow row);
    std::int64_t record(EstimateRow row);
    std::int64_t record(ProposalRow row);
    void record(EventRow row);

    /// Off: the file is closed, and nothing is kept but what later rows may refer to.
    void setOn(bool on);

    RecordingState state() const;
    const std::string& folder() const { return options_.folder; }  ///< of its files

private:
    struct Batch {
        std::vector<FrameRow> frames{};
        std::vector<SessionRow> rows{};
        std::int64_t missingFrames = 0, missingRows = 0;
        SessionTime missingSince = 0;
    };

    template <class T>
    std::int64_t number(T row, std::int64_t& last);
    void keep(SessionRow row, SessionTime time);  ///< with the mutex held
    void gather();
    void miss(SessionTime since, std::int64_t frames, std::int64_t rows);
    SessionTime now() const;
    void run(const std::stop_token& stop);
    bool open();
    Status begin();
    Status write();
    Status writeContext();
    bool store();
    void remember();
    void close(const std::string& why);
    void seal(const std::string& why);
    void measure();

    Options options_;
    double began_;  ///< [s] steady clock, of time 0

    // Only the thread touches these.
    std::optional<SessionWriter> writer_;
    Batch batch_;                    ///< not committed yet
    RecordingContext context_;       ///< for the next file
    std::int64_t framesBefore_ = 0;  ///< in files before this one
    double nextTry_ = 0.0;           ///< [s] steady clock
    double openedAt_ = 0.0;
    std::string before_;  ///< the file before this one

    mutable std::mutex mutex_;  // guards what follows
    std::condition_variable_any wake_;
    Batch waiting_;
    std::int64_t lastModel_ = 0, lastScene_ = 0, lastEstimate_ = 0, lastProposal_ = 0;
    bool urgent_ = false;
    bool on_ = true;
    std::optional<double> busySince_;  ///< [s] steady clock; when the thread went to the disk
    RecordingState state_;

    std::jthread thread_;  // last: it starts when all else stands
};

/// The folder of this user's sessions: terratact/sessions in XDG_STATE_HOME, or in .local/state of the home folder, which
/// HOME or else the system's list of users names; both count only where they begin with '/'.  Empty: there is none.
std::string sessionFolder();

/// What is on a disk besides; empty where that cannot be told.
std::optional<std::uint64_t> freeBytes(const std::string& folder);

/// The files of a folder's sessions, closed or not, in the order of their names.  Symbolic links are none: whoever
/// rewrites or deletes a session does so in this folder.
std::vector<std::string> sessionsIn(const std::string& folder);

/// Closes those sessions whose program died (recoverSession); one sentence for each that was, or could not be.
/// Sessions that somebody records just now are left alone.
std::vector<std::string> recoverDeadSessions(const std::vector<std::string>& paths);

/// Limits a user has set; 0: none.
struct RetentionLimits {
    double days = 0.0;
    double gigabytes = 0.0;  ///< of all closed sessions together
    bool confirmed = false;  ///< the user has said once that what is beyond them may be deleted
    bool operator==(const RetentionLimits&) const = default;
};

/// Deletes the oldest closed ones of these sessions, the oldest first, beyond the limits; one sentence for each.
/// Unless that is confirmed, deletes nothing, and says in one sentence how much it would.
///
/// A session ends when it says or when its file was last written, whatever is later: the clock of a computer whose
/// battery is flat says 1970.  One of which either time cannot be true, before 2020 or more than a day from now, is
/// never deleted; nor is anything while `now` itself is before 2020.  Without a limit nothing is deleted, and never
/// what is not a session, not closed, or reached through a symbolic link.
/// now: [ns] since 1970.  goesOn: asked before each file; false ends it.
std::vector<std::string> applyRetention(
    const std::vector<std::string>& paths, const RetentionLimits& limits, std::int64_t now,
    const std::function<bool()>& goesOn = [] { return true; });

/// [ns] since 1970, by this computer's clock.
std::int64_t wallNow();

}  // namespace terratact
