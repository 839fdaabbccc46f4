#include "drivers/log_replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <span>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

namespace terratact {
namespace {

constexpr std::size_t kMaxNames = 16;  // interfaces that are listed

Error fileError(const std::string& path, Message cause)
{
    return {Message::joined(Message::verbatim(path), std::move(cause))};
}

/// A log that can be read as often as needed.
class LogSource {
public:
    static Result<LogSource> of(const std::string& path)
    {
        std::error_code failure;
        LogSource source;
        source.path_ = path == "-" ? "standard input" : path;
        const auto type = std::filesystem::status(path, failure).type();
        if (type == std::filesystem::file_type::directory)
            return fileError(path, TR_NOOP("core", "is a folder, no log of CAN traffic"));
        const bool isFile = type == std::filesystem::file_type::regular && path != "/dev/stdin";
        const bool isMissing = type == std::filesystem::file_type::not_found && path != "-";
        if (isFile || isMissing) return source;
        if (const Status kept = source.keep(path); !kept) return kept.error();
        return source;
    }

    Result<LogReader> read() const
    {
        if (!kept_) return LogReader::open(path_);
        return LogReader(path_, [kept = kept_, at = std::size_t{0}](std::span<char> room) mutable {
            const std::size_t count = std::min(room.size(), kept->size() - at);
            std::copy_n(kept->begin() + static_cast<std::ptrdiff_t>(at), count, room.begin());
            at += count;
            return Result<std::size_t>(count);
        });
    }
    const std::string& name() const { return path_; }

private:
    Status keep(const std::string& path)
    {
        const auto bytes = LogBytes::sourceOf(path == "/dev/stdin" ? "-" : path);
        if (!bytes) return bytes.error();
        auto kept = std::make_shared<std::string>();
        std::vector<char> block(std::size_t{64} * 1024);
        for (;;) {
            const Result<std::size_t> got = (*bytes)(block);
            if (!got) return fileError(path_, got.error().message);
            if (*got == 0) break;
            if (kept->size() + *got > LogReplay::kMaxPiped)
                return fileError(
                    path_, TR_NOOP("core", "is no file, and too long to be kept: copy it to one"));
            kept->append(block.data(), *got);
        }
        kept_ = std::move(kept);
        return Done{};
    }

    std::string path_;
    std::shared_ptr<const std::string> kept_;  // null: it is a file
};

/// Contents of a log.
struct LogScan {
    struct Interface {
        double last = 0.0;              ///< time of its newest frame [s], on the continuous clock
        std::vector<Message> silences;  ///< silences that a replay shortens
    };
    std::map<std::string, Interface> interfaces;
    std::vector<Message> remarks;
};

Message silenceText(const LogReader& log, double seconds)
{
    return log
        .error({TR_NOOP("core", "follows %1 s of silence, which the replay shortens to %2 s"),
                fixed(seconds, 0), fixed(LogReplay::kShortWait, 0)})
        .message;
}

Result<LogScan> scan(const LogSource& source, double speed)
{
    constexpr std::size_t kMaxSilences = 10;  // silences listed for one interface
    Result<LogReader> log = source.read();
    if (!log) return log.error();
    LogScan found;
    for (;;) {
        const auto frame = log->next();
        if (!frame) return frame.error();
        if (!*frame) break;
        if (!(*frame)->time)
            return log->error(TR_NOOP("core", "has no time; record with candump -L"));
        const auto known = found.interfaces.find((*frame)->interface);
        if (known == found.interfaces.end()) {
            if (found.interfaces.size() < kMaxNames)
                found.interfaces[(*frame)->interface].last = log->elapsed();
            continue;
        }
        LogScan::Interface& of = known->second;
        const double silence = log->elapsed() - std::exchange(of.last, log->elapsed());
        if (silence / speed > LogReplay::kMaxWait && of.silences.size() < kMaxSilences)
            of.silences.push_back(silenceText(*log, silence));
    }
    found.remarks = log->consumeRemarks();
    return found;
}

std::string listed(const LogScan& scan)
{
    std::string text;
    for (const auto& [name, of] : scan.interfaces) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// Returns the interface to replay.
Result<std::string> chosen(const std::string& path, const LogScan& scan, const std::string& wanted)
{
    if (scan.interfaces.empty()) return fileError(path, TR_NOOP("core", "holds no frame"));
    if (!wanted.empty() && !scan.interfaces.contains(wanted))
        return fileError(path, Message(TR_NOOP("core", "holds no frame of %1, only of %2"), wanted,
                                       listed(scan)));
    if (!wanted.empty()) return wanted;
    if (scan.interfaces.size() > 1)
        return fileError(
            path,
            Message(TR_NOOP("core", "holds frames of %1: name the one to replay with --interface"),
                    listed(scan)));
    return scan.interfaces.begin()->first;
}

LogReplay::Clock steadyClock()
{
    using Seconds = std::chrono::duration<double>;
    return {[] { return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count(); },
            [](double seconds) { std::this_thread::sleep_for(Seconds(seconds)); }};
}

}  // namespace

Result<std::unique_ptr<LogReplay>> LogReplay::open(const std::string& path, const Options& options)
{
    return open(path, options, steadyClock());
}

Result<std::unique_ptr<LogReplay>> LogReplay::open(const std::string& path, const Options& options,
                                                   Clock clock)
{
    if (!(options.speed > 0.0 && options.speed <= 1000.0))
        throw std::invalid_argument("LogReplay: the speed must be over 0 and at most 1000");
    const Result<LogSource> source = LogSource::of(path);
    if (!source) return source.error();
    Result<LogScan> found = scan(*source, options.speed);
    if (!found) return found.error();
    Result<std::string> interface = chosen(source->name(), *found, options.interface);
    if (!interface) return interface.error();
    Result<LogReader> log = source->read();
    if (!log) return log.error();
    std::unique_ptr<LogReplay> replay(
        new LogReplay("REPLAY " + std::filesystem::path(source->name()).filename().string(),
                      *std::move(log), {*interface, options.speed}, std::move(clock)));
    replay->remarks_ = std::move(found->remarks);
    const auto& silences = found->interfaces[*interface].silences;
    replay->remarks_.insert(replay->remarks_.end(), silences.begin(), silences.end());
    replay->again_ = [from = *source] { return from.read(); };
    if (const Status done = replay->fetch(); !done) return done.error();
    replay->firstTime_ = replay->logTime_;
    replay->progress_.at = 0.0;
    replay->progress_.length = found->interfaces[*interface].last - replay->firstTime_;
    return replay;
}

LogReplay::LogReplay(std::string name, LogReader log, Options options, Clock clock)
    : name_(std::move(name)), log_(std::move(log)), options_(std::move(options)),
      clock_(std::move(clock))
{
}

std::string LogReplay::name() const
{
    return name_;
}

// Goes to the next frame of the interface, and advances the due time by the time between the two.
Status LogReplay::fetch()
{
    const double before = logTime_;
    do {
        Result<std::optional<LoggedFrame>> got = log_.next();
        if (!got) return got.error();
        next_ = *std::move(got);
        if (next_ && !next_->time)
            return log_.error(TR_NOOP("core", "has lost its time: the log has changed"));
    } while (next_ && next_->interface != options_.interface);
    logTime_ = log_.elapsed();
    const double wait = (logTime_ - before) / options_.speed;
    if (due_) *due_ += wait > kMaxWait ? kShortWait : wait;
    const std::lock_guard lock(mutex_);
    progress_.at = next_ ? logTime_ - firstTime_ : progress_.length;
    counters_.dropped = log_.dropped();
    ended_ = !next_;
    return Done{};
}

/// Applies the controls that were set since the last call.
Status LogReplay::obey(double now)
{
    std::optional<double> to;
    bool paused = false;
    {
        const std::lock_guard lock(mutex_);
        to = std::exchange(wanted_, std::nullopt);
        paused = progress_.paused;
        if (!to && ended_ && progress_.repeats && progress_.length > 0.0) to = 0.0;
    }
    if (to) {
        if (Status done = goTo(*to, now); !done) return done;
    }
    if (paused && !pausedAt_) pausedAt_ = now;
    if (!paused && pausedAt_) *due_ += now - *std::exchange(pausedAt_, std::nullopt);
    return Done{};
}

Status LogReplay::goTo(double seconds, double now)
{
    if (!next_ || firstTime_ + seconds < logTime_) {
        Result<LogReader> log = again_();
        if (!log) return log.error();
        log_ = *std::move(log);
        logTime_ = 0.0;
        if (Status done = fetch(); !done) return done;
    }
    while (next_ && logTime_ < firstTime_ + seconds)
        if (Status done = fetch(); !done) return done;
    due_ = now;
    if (pausedAt_) pausedAt_ = now;
    return Done{};
}

void LogReplay::setPaused(bool paused)
{
    const std::lock_guard lock(mutex_);
    progress_.paused = paused;
}

void LogReplay::setRepeats(bool repeats)
{
    const std::lock_guard lock(mutex_);
    progress_.repeats = repeats;
}

void LogReplay::seek(double seconds)
{
    const std::lock_guard lock(mutex_);
    wanted_ = std::max(0.0, seconds);
}

LogReplay::Progress LogReplay::progress() const
{
    const std::lock_guard lock(mutex_);
    return progress_;
}

Result<std::size_t> LogReplay::consumeDue(std::span<BusFrame> frames)
{
    const double now = clock_.now();
    if (!due_) due_ = now;
    if (const Status done = obey(now); !done) return done.error();
    std::size_t count = 0;
    for (; !pausedAt_ && count < frames.size() && next_ && *due_ <= now; ++count) {
        frames[count] = {.frame = next_->frame,
                         .time = *due_,
                         .wallTime = *next_->time,
                         .echo = false,
                         .local = next_->direction == LogDirection::Sent};
        {
            const std::lock_guard lock(mutex_);
            ++counters_.received;
            if (next_->frame.error) ++counters_.errorFrames;
        }
        if (const Status done = fetch(); !done) return done.error();
    }
    return count;
}

Result<std::size_t> LogReplay::receive(std::span<BusFrame> frames,
                                       std::chrono::milliseconds patience)
{
    if (frames.empty()) throw std::invalid_argument("LogReplay: there is no room for one frame");
    const double until = clock_.now() + std::chrono::duration<double>(patience).count();
    for (;;) {
        Result<std::size_t> count = consumeDue(frames);
        if (!count || *count > 0) return count;
        const double now = clock_.now();
        if (now >= until) return std::size_t{0};
        const bool waitsForFrame = next_ && !pausedAt_ && *due_ > now;
        clock_.sleep((waitsForFrame ? std::min(*due_, until) : until) - now);
    }
}

Status LogReplay::send(const CanFrame&)
{
    const std::lock_guard lock(mutex_);
    ++counters_.notSent;
    return Error{Message(TR_NOOP("core", "%1: a replay takes no commands"), name_)};
}

std::optional<double> LogReplay::wait() const
{
    if (!due_ || !next_) return std::nullopt;
    return std::max(0.0, *due_ - clock_.now());
}

BusState LogReplay::state() const
{
    const std::lock_guard lock(mutex_);
    return ended_ ? BusState::Ended : BusState::Up;
}

BusCounters LogReplay::counters() const
{
    const std::lock_guard lock(mutex_);
    return counters_;
}

}  // namespace terratact
