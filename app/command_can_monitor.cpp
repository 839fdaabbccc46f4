#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "app/can_commands.h"
#include "app/can_monitor.h"
#include "app/dbc_book.h"
#include "app/open_bus.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

double seconds(Clock::time_point time)
{
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

/// Where the table goes.
class Screen {
public:
    Screen() : isTerminal_(::isatty(STDOUT_FILENO) != 0) {}

    bool isRedrawn() const { return isTerminal_; }
    std::chrono::milliseconds period() const { return isTerminal_ ? 200ms : 1000ms; }

    void show(const std::string& headline, const std::vector<std::string>& table) const
    {
        if (isTerminal_) fmt::print("\x1b[H");  // to the upper left corner
        line(headline);
        for (const std::string& text : table) line(text);
        fmt::print("{}", isTerminal_ ? "\x1b[J" : "\n");  // nothing left of the table before
        std::fflush(stdout);
    }

    void clear() const
    {
        if (isTerminal_) fmt::print("\x1b[2J");
    }

private:
    void line(std::string text) const
    {
        if (isTerminal_) text.resize(std::min(text.size(), width()));
        fmt::print("{}{}\n", text, isTerminal_ ? "\x1b[K" : "");
    }

    static std::size_t width()
    {
        winsize size{};
        const bool known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
        return known ? size.ws_col : 80;
    }

    bool isTerminal_;
};

/// Reads the bus until `until`, a replay to its end at most.
Status takeUntil(CanBus& bus, bool isReplay, CanMonitor& monitor, Clock::time_point until)
{
    std::array<BusFrame, 64> frames;
    for (;;) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
        if (left <= 0ms || (isReplay && bus.state() == BusState::Ended)) return Done{};
        const Result<std::size_t> count = bus.receive(frames, left);
        if (!count) return count.error();
        for (std::size_t i = 0; i < *count; ++i) monitor.take(frames[i]);
    }
}

}  // namespace

Status monitorCan(const CanMonitorOptions& options)
{
    const bool isReplay = std::filesystem::is_regular_file(options.bus);
    const auto bus =
        isReplay ? openReplay(options.bus, options.interface, options.speed) : openBus(options.bus);
    if (!bus) return bus.error();
    const auto book = readDbcBook(options.protocol, options.dbc);
    if (!book) return book.error();
    CanMonitor monitor(options.protocol, options.bitrate, *book);
    const Screen screen;
    const std::vector<std::string> remarks = remarksOf(*book);
    if (!screen.isRedrawn())
        for (const std::string& remark : remarks) fmt::print(stderr, "terratact: {}\n", remark);
    screen.clear();
    const Clock::time_point begin = Clock::now();
    monitor.mark(seconds(begin));
    for (Clock::time_point next = begin;;) {
        next += screen.period();
        const auto end = options.seconds ? begin
                                               + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(*options.seconds))
                                         : Clock::time_point::max();
        if (Status done = takeUntil(**bus, isReplay, monitor, std::min(next, end)); !done)
            return done;
        const double now = seconds(Clock::now());
        monitor.mark(now);
        const bool ended = isReplay && (*bus)->state() == BusState::Ended;
        const std::string state = !isReplay ? describe((*bus)->state(), (*bus)->name())
                                : ended     ? (*bus)->name() + " has ended"
                                            : (*bus)->name();
        std::vector<std::string> lines = monitor.table(now);
        if (screen.isRedrawn()) lines.insert(lines.end(), remarks.begin(), remarks.end());
        screen.show(monitor.headline(state, (*bus)->counters()), lines);
        if (ended || Clock::now() >= end) return Done{};
    }
}

}  // namespace terratact
