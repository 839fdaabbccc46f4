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
#include "core/base/message.h"
#include "core/log/rows/session_schema.h"
#include "core/log/session_writer.h"
#include "drivers/can_bus.h"

namespace terratact {

/// Status of a recording.
struct RecordingState {
    bool on = true;            ///< recording is wanted
    bool recording = false;    ///< a file is open and accepts rows
    std::string path;          ///< path of the file; empty before the first
    Message trouble;           ///< reason that nothing is recorded; empty: recording works
    std::int64_t frames = 0;   ///< committed frames in all files
    std::int64_t missing = 0;  ///< dropped frames in all files
    std::int64_t bytes = 0;    ///< size of the file and its journal
    double secondsLeft = 0.0;  ///< time until the disk is full at the present rate; 0: unknown
};

/// Records a session (docs/sessions.md) in its own thread and never blocks a caller. Frames and rows wait in bounded
/// queues; what a full queue drops is counted and recorded. A file that cannot be written any more is left as it is.
/// The recorder begins a new file with the waiting rows once writing works again.
///
/// Every method may be called from any thread and returns at once.
class SessionRecorder {
public:
    struct Options {
        std::string folder;  ///< created with mode 0700 if missing; empty: no recording
        SessionStart start;  ///< the recorder sets wallTime
        bool on = true;      ///< see setOn()
        /// Queue bound in frames: two seconds of a full bus of 1 Mbit/s.
        std::size_t mostFrames = 18'018;
        std::size_t mostRows = 10'000;         ///< queue bound of the other rows
        std::chrono::milliseconds batch{200};  ///< between two commits
        std::int64_t mostBytes = std::int64_t{4}
                              << 30U;  ///< maximum size of a file; then the next file begins
        /// Maximum batches of a file; then the next file begins.
        std::int64_t mostBatches = kMaxBatches;
        double patience = 0.6;  ///< [s] a longer write is reported as trouble
        std::uint64_t leastFree = std::uint64_t{50} << 20U;  ///< bytes of the disk that stay free
    };
    /// Starts recording at once.
    explicit SessionRecorder(Options options);
    ~SessionRecorder();  ///< commits and seals the file

    /// Adds frames of the bus; their times are those of the steady clock.
    void add(std::span<const BusFrame> frames);

    // Each adds a row and returns its new id. An unset time becomes now. An operator's decision is committed at once.
    std::int64_t record(ModelRow row);
    std::int64_t record(SceneRow row);
    std::int64_t record(EstimateRow row);
    std::int64_t record(ProposalRow row);
    void record(EventRow row);

    /// Switches recording. Off closes the file and keeps only rows that later rows may refer to.
    void setOn(bool on);

    RecordingState state() const;
    const std::string& folder() const { return options_.folder; }  ///< folder of the session files

private:
    struct Batch {
        std::vector<FrameRow> frames{};
        std::vector<SessionRow> rows{};
        std::int64_t missingFrames = 0, missingRows = 0;
        SessionTime missingSince = 0;
    };

    template <class T>
    std::int64_t number(T row, std::int64_t& last);
    void keep(SessionRow row, SessionTime time);  ///< call with the mutex locked
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
    void close(const Message& why);
    void seal(SourceText why);
    void measure();

    Options options_;
    double began_;  ///< [s] steady clock at time 0

    // Used by the thread only.
    std::optional<SessionWriter> writer_;
    Batch batch_;                    ///< not committed yet
    RecordingContext context_;       ///< state for the next file
    std::int64_t framesBefore_ = 0;  ///< frames in earlier files
    double nextTry_ = 0.0;           ///< [s] steady clock of the next attempt
    double openedAt_ = 0.0;
    std::string before_;  ///< previous file

    mutable std::mutex mutex_;  // guards the members below
    std::condition_variable_any wake_;
    Batch waiting_;
    std::int64_t lastModel_ = 0, lastScene_ = 0, lastEstimate_ = 0, lastProposal_ = 0;
    bool urgent_ = false;
    bool on_ = true;
    std::optional<double> busySince_;  ///< [s] steady clock at the start of the present write
    RecordingState state_;

    std::jthread thread_;  // last member: the thread starts after all others exist
};

}  // namespace terratact
