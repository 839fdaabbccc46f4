#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/wire/logs/log_reader.h"
#include "drivers/can_bus.h"

namespace terratact {

/// Replays a log of CAN traffic (core/wire/logs/log_reader.h) as a bus, at the pace of its recording. It
/// sends no commands. Time that runs backwards in the log takes no time. A silence longer than
/// kMaxWait takes kShortWait.
///
/// A frame's `time` is its due time on the steady clock: ages and time limits hold as on a bus. At
/// a speed other than 1 they change by that factor. Its `wallTime` is the log's own time.
class LogReplay final : public CanBus {
public:
    struct Options {
        std::string interface {
        };  ///< Interface whose frames are replayed; empty: the only one in the log.
        double speed = 1.0;  ///< seconds of the log per second
    };
    /// Progress of the replay.
    struct Progress {
        double at = 0.0, length = 0.0;  ///< time of the log since its first frame [s]
        bool paused = false, repeats = false;
    };
    struct Clock {
        std::function<double()> now;        ///< [s] steady
        std::function<void(double)> sleep;  ///< [s]
    };

    static constexpr double kMaxWait = 60.0, kShortWait = 2.0;  ///< [s]
    static constexpr std::size_t kMaxPiped = std::size_t{512}
                                          << 20U;  ///< bytes of a log that is a pipe

    /// Opens a log and reads it once from end to end, so that errors show at the start. A pipe
    /// (also "-", standard input) is kept in memory. Errors name the log: it is no log, holds no
    /// frame, or has a frame without a time. It may also lack frames of the interface, or have
    /// several interfaces while none was named. Throws std::invalid_argument unless 0 < speed ≤
    /// 1000.
    static Result<std::unique_ptr<LogReplay>> open(const std::string& path, const Options& options);
    static Result<std::unique_ptr<LogReplay>> open(const std::string& path, const Options& options,
                                                   Clock clock);

    /// Returns "REPLAY demo.log".
    std::string name() const override;

    /// Delivers frames. The replay begins with the first call. After the last frame it waits and
    /// delivers nothing. Throws std::invalid_argument if there is no room for one frame.
    Result<std::size_t> receive(std::span<BusFrame> frames,
                                std::chrono::milliseconds patience) override;

    // Controls for any thread; the latest values apply at the next receive().
    void setPaused(bool paused);    ///< true: delivers nothing meanwhile, and skips nothing
    void setRepeats(bool repeats);  ///< true: starts again after the last frame
    /// Continues with the first frame at or after this time of the log, even after its end. A
    /// receiver sees a gap.
    void seek(double seconds);
    Progress progress() const;

    /// Always returns an Error.
    Status send(const CanFrame& frame) override;

    /// Returns Up, and Ended once the last frame was delivered.
    BusState state() const override;

    /// Returns the counters. dropped: frames that the log reports as lost.
    BusCounters counters() const override;

    /// Returns one sentence for each remark about the log (LogReader::consumeRemarks) and each
    /// shortened silence.
    const std::vector<Message>& remarks() const { return remarks_; }

    /// Returns the time until the next frame [s]; empty before the first receive() and after the
    /// last frame. For the receiving thread.
    std::optional<double> wait() const;

private:
    LogReplay(std::string name, LogReader log, Options options, Clock clock);
    Status fetch();
    Status obey(double now);
    Status goTo(double seconds, double now);
    Result<std::size_t> consumeDue(std::span<BusFrame> frames);

    std::string name_;
    LogReader log_;
    std::function<Result<LogReader>()> again_;  ///< opens the log from its beginning
    Options options_;
    Clock clock_;
    std::optional<LoggedFrame> next_;
    std::vector<Message> remarks_;
    /// Time of next_ since the log's beginning [s], on its continuous clock.
    double logTime_ = 0.0;
    double firstTime_ = 0.0;          ///< the same time of the first frame [s]
    std::optional<double> pausedAt_;  ///< time of the pause [s on the clock]
    std::optional<double> due_;  ///< time of next_ on the clock; empty before the first receive()
    mutable std::mutex mutex_;   ///< guards the members below
    Progress progress_;
    std::optional<double> wanted_;  ///< time to seek [s]
    BusCounters counters_;
    bool ended_ = false;
};

}  // namespace terratact
