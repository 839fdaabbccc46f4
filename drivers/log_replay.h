#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/wire/log_reader.h"
#include "drivers/can_bus.h"

namespace terratact {

/// A log of CAN traffic (core/wire/log_reader.h) as if it were a bus: its frames come at the pace at which
/// they were recorded.  Takes no commands.  Time that runs backwards in the log is no time at all, and a silence of the
/// log that would last longer than kMaxWait takes kShortWait.
///
/// A frame's `time` is when it was due on the steady clock, so that ages and time limits hold as on a bus; at
/// another speed than 1 they are off by that factor.  Its `wallTime` is the log's own time.
class LogReplay final : public CanBus {
public:
    struct Options {
        std::string interface {
        };                   ///< of which frames are replayed; empty: of the only one there is
        double speed = 1.0;  ///< seconds of the log per second
    };
    /// How far it is.
    struct Progress {
        double at = 0.0, length = 0.0;  ///< [s] of the log since its first frame
        bool paused = false, repeats = false;
    };
    struct Clock {
        std::function<double()> now;        ///< [s] steady
        std::function<void(double)> sleep;  ///< [s]
    };

    static constexpr double kMaxWait = 60.0, kShortWait = 2.0;  ///< [s]
    static constexpr std::size_t kMaxPiped = std::size_t{512}
                                          << 20U;  ///< bytes of a log that is no file

    /// Reads the log once from end to end, so that nothing surprises later; one that is no file (a pipe; "-" for
    /// standard input) is kept in memory.  Errors name the log: it is no log, holds no frame or one without a time, none
    /// of the interface, or those of several and none was named.  Throws std::invalid_argument unless
    /// 0 < speed ≤ 1000.
    static Result<std::unique_ptr<LogReplay>> open(const std::string& path, const Options& options);
    static Result<std::unique_ptr<LogReplay>> open(const std::string& path, const Options& options,
                                                   Clock clock);

    /// "REPLAY demo.log"
    std::string name() const override;

    /// The replay begins with the first call.  After the last frame it waits and brings nothing.
    /// Throws std::invalid_argument where there is no room for one frame.
    Result<std::size_t> receive(std::span<BusFrame> frames,
                                std::chrono::milliseconds patience) override;

    // From any thread; what is asked for last holds at the next receive().
    void setPaused(bool paused);    ///< brings nothing meanwhile, and misses nothing
    void setRepeats(bool repeats);  ///< begins again after the last frame
    /// Goes on with the first frame at or after so many seconds of the log, also from its end.  A receiver sees a gap.
    void seek(double seconds);
    Progress progress() const;

    /// Always an Error.
    Status send(const CanFrame& frame) override;

    /// Up, and Ended once the last frame has been handed out.
    BusState state() const override;

    /// dropped: what the log says was lost when it was recorded.
    BusCounters counters() const override;

    /// What is to be said of the log (LogReader::takeRemarks), and the silences that are shortened: a sentence each.
    const std::vector<std::string>& remarks() const { return remarks_; }

    /// [s] until the next frame; empty before the first receive() and after the last frame.  Of the thread that
    /// receives.
    std::optional<double> wait() const;

private:
    LogReplay(std::string name, LogReader log, Options options, Clock clock);
    Status fetch();
    Status obey(double now);
    Status goTo(double seconds, double now);
    Result<std::size_t> takeDue(std::span<BusFrame> frames);

    std::string name_;
    LogReader log_;
    std::function<Result<LogReader>()> again_;  ///< the log from its begin
    Options options_;
    Clock clock_;
    std::optional<LoggedFrame> next_;
    std::vector<std::string> remarks_;
    double logTime_ = 0.0;    ///< [s] of next_, since the log's beginning, on its even clock
    double firstTime_ = 0.0;  ///< [s] likewise, of the first frame
    std::optional<double> pausedAt_;  ///< [s] on the clock
    std::optional<double> due_;       ///< of next_, on the clock; empty before the first receive()
    mutable std::mutex mutex_;        ///< guards those below
    Progress told_;
    std::optional<double> wanted_;  ///< [s] to seek
    BusCounters counters_;
    bool ended_ = false;
};

}  // namespace terratact
