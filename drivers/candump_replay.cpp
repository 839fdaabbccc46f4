#include "drivers/candump_replay.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

namespace terratact {
namespace {

constexpr std::size_t kMostNames = 16;  // of interfaces that are remembered

Error fileError(const std::string& path, const std::string& cause)
{
    return Error{path + ": " + cause};
}

std::string listed(const std::set<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// The interfaces of a log that can be replayed.
Result<std::set<std::string>> interfacesOf(const std::string& path)
{
    std::error_code failure;
    if (std::filesystem::exists(path, failure) && !std::filesystem::is_regular_file(path, failure))
        return fileError(path, "is no file; a replay reads its log twice");
    Result<CandumpReader> log = CandumpReader::open(path);
    if (!log) return log.error();
    std::set<std::string> names;
    for (;;) {
        const auto frame = log->next();
        if (!frame) return frame.error();
        if (!*frame) return names;
        if (!(*frame)->time) return log->error("has no time; record with candump -L");
        if (names.size() < kMostNames) names.insert((*frame)->interface);
    }
}

/// The one to be replayed.
Result<std::string> chosen(const std::string& path, const std::string& wanted)
{
    const Result<std::set<std::string>> names = interfacesOf(path);
    if (!names) return names.error();
    if (names->empty()) return fileError(path, "holds no frame");
    if (!wanted.empty() && !names->contains(wanted))
        return fileError(path, "holds no frame of " + wanted + ", only of " + listed(*names));
    if (!wanted.empty()) return wanted;
    if (names->size() > 1)
        return fileError(path, "holds frames of " + listed(*names)
                                   + ": name the one to replay with --interface");
    return *names->begin();
}

CandumpReplay::Clock steadyClock()
{
    using Seconds = std::chrono::duration<double>;
    return {[] { return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count(); },
            [](double seconds) { std::this_thread::sleep_for(Seconds(seconds)); }};
}

}  // namespace

Result<std::unique_ptr<CandumpReplay>> CandumpReplay::open(const std::string& path,
                                                           const Options& options)
{
    return open(path, options, steadyClock());
}

Result<std::unique_ptr<CandumpReplay>> CandumpReplay::open(const std::string& path,
                                                           const Options& options, Clock clock)
{
    if (!(options.speed > 0.0 && options.speed <= 1000.0))
        throw std::invalid_argument("CandumpReplay: the speed must be over 0 and at most 1000");
    Result<std::string> interface = chosen(path, options.interface);
    if (!interface) return interface.error();
    Result<CandumpReader> log = CandumpReader::open(path);
    if (!log) return log.error();
    std::unique_ptr<CandumpReplay> replay(new CandumpReplay(
        "REPLAY " + std::filesystem::path(path).filename().string(), *std::move(log),
        {*std::move(interface), options.speed}, std::move(clock)));
    if (const Status done = replay->fetch(); !done) return done.error();
    return replay;
}

CandumpReplay::CandumpReplay(std::string name, CandumpReader log, Options options, Clock clock)
    : name_(std::move(name)), log_(std::move(log)), options_(std::move(options)),
      clock_(std::move(clock))
{
}

std::string CandumpReplay::name() const
{
    return name_;
}

// Goes to the next frame of the interface, and moves what is due on by the time between the two.
Status CandumpReplay::fetch()
{
    const double before = logTime_;
    do {
        Result<std::optional<LoggedFrame>> got = log_.next();
        if (!got) return got.error();
        next_ = *std::move(got);
        if (next_ && !next_->time) return log_.error("has lost its time: the log has changed");
    } while (next_ && next_->interface != options_.interface);
    if (next_) logTime_ = *next_->time;
    if (due_) *due_ += std::max(0.0, logTime_ - before) / options_.speed;
    const std::lock_guard lock(mutex_);
    counters_.dropped = log_.dropped();
    ended_ = !next_;
    return Done{};
}

Result<std::size_t> CandumpReplay::takeDue(std::span<BusFrame> frames)
{
    const double now = clock_.now();
    if (!due_) due_ = now;
    std::size_t count = 0;
    for (; count < frames.size() && next_ && *due_ <= now; ++count) {
        frames[count] = {.frame = next_->frame,
                         .time = *due_,
                         .wallTime = logTime_,
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

Result<std::size_t> CandumpReplay::receive(std::span<BusFrame> frames,
                                           std::chrono::milliseconds patience)
{
    if (frames.empty())
        throw std::invalid_argument("CandumpReplay: there is no room for one frame");
    const double until = clock_.now() + std::chrono::duration<double>(patience).count();
    for (;;) {
        Result<std::size_t> count = takeDue(frames);
        if (!count || *count > 0) return count;
        const double now = clock_.now();
        if (now >= until) return std::size_t{0};
        clock_.sleep((next_ ? std::min(*due_, until) : until) - now);
    }
}

Status CandumpReplay::send(const CanFrame&)
{
    const std::lock_guard lock(mutex_);
    ++counters_.notSent;
    return Error{name_ + ": a replay takes no commands"};
}

BusState CandumpReplay::state() const
{
    const std::lock_guard lock(mutex_);
    return ended_ ? BusState::Ended : BusState::Up;
}

BusCounters CandumpReplay::counters() const
{
    const std::lock_guard lock(mutex_);
    return counters_;
}

}  // namespace terratact
