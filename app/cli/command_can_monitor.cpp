#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/cli/commands.h"
#include "app/link/can_monitor.h"
#include "app/link/dbc_book.h"
#include "app/link/open_bus.h"
#include "app/runtime/print_text.h"
#include "drivers/can_bus.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;
using MonitorClock = std::chrono::steady_clock;

double seconds(MonitorClock::time_point time)
{
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

/// The terminal or stream that shows the table.
class Screen {
public:
    Screen() : isTerminal_(::isatty(STDOUT_FILENO) != 0) {}

    bool isRedrawn() const { return isTerminal_; }
    std::chrono::milliseconds period() const { return isTerminal_ ? 200ms : 1000ms; }

    void show(const std::string& headline, const std::vector<std::string>& table) const
    {
        if (isTerminal_) printText("\x1b[H");  // moves the cursor to the upper left corner
        line(headline);
        for (const std::string& text : table) line(text);
        if (isTerminal_)
            printText("\x1b[J");  // clears the rest of the previous table
        else
            printText("\n");
        std::fflush(stdout);
    }

    void clear() const
    {
        if (isTerminal_) printText("\x1b[2J");
    }

private:
    void line(std::string text) const
    {
        if (isTerminal_) text.resize(std::min(text.size(), width()));
        if (isTerminal_)
            printText("{}\x1b[K\n", text);
        else
            printText("{}\n", text);
    }

    static std::size_t width()
    {
        winsize size{};
        const bool known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
        return known ? size.ws_col : 80;
    }

    bool isTerminal_;
};

/// Reads the bus until `until`; a replay ends earlier at its end.
Status receiveUntil(CanBus& bus, bool isReplay, CanMonitor& monitor, MonitorClock::time_point until)
{
    std::array<BusFrame, 64> frames;
    for (;;) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - MonitorClock::now());
        if (left <= 0ms || (isReplay && bus.state() == BusState::Ended)) return Done{};
        const Result<std::size_t> count = bus.receive(frames, left);
        if (!count) return count.error();
        for (std::size_t i = 0; i < *count; ++i) monitor.add(frames[i]);
    }
}

/// The monitored bus.
struct Monitored {
    std::unique_ptr<CanBus> bus;
    LogReplay* replay = nullptr;  ///< the bus as a replay; null: an interface
};

/// Returns true if the name contains a folder or exists as a file; an interface does neither.
bool isLog(const std::string& name)
{
    std::error_code ignored;
    return name == "-" || name.find('/') != std::string::npos
        || (std::filesystem::exists(name, ignored)
            && !std::filesystem::is_directory(name, ignored));
}

Result<Monitored> open(const CanMonitorOptions& options)
{
    if (!isLog(options.bus)) {
        auto bus = openBus(options.bus);
        if (!bus) return bus.error();
        return Monitored{*std::move(bus)};
    }
    auto replay = openReplay(options.bus, options.interface, options.speed);
    if (!replay) return replay.error();
    LogReplay* const log = replay->get();
    return Monitored{*std::move(replay), log};
}

std::string stateText(const Monitored& monitored)
{
    constexpr double kShort = 2.0;  // [s] a shorter wait is not reported
    const CanBus& bus = *monitored.bus;
    if (!monitored.replay) return describe(bus.state(), bus.name()).english();
    if (bus.state() == BusState::Ended) return bus.name() + " has ended";
    const double wait = monitored.replay->wait().value_or(0.0);
    if (wait < kShort) return bus.name();
    return fmt::format("{}, whose next frame comes in {:.0f} s", bus.name(), wait);
}

}  // namespace

Status monitorCan(const CanMonitorOptions& options)
{
    const Result<Monitored> opened = open(options);
    if (!opened) return opened.error();
    const bool isReplay = opened->replay != nullptr;
    CanBus& bus = *opened->bus;
    const auto book = readDbcBook(options.protocol, options.dbc);
    if (!book) return book.error();
    CanMonitor monitor(options.protocol, options.bitrate, *book);
    const Screen screen;
    std::vector<std::string> remarks;
    for (const Message& remark : remarksOf(*book)) remarks.push_back(remark.english());
    if (isReplay)
        for (const Message& remark : opened->replay->remarks()) remarks.push_back(remark.english());
    if (!screen.isRedrawn())
        for (const std::string& remark : remarks) printText(stderr, "terratact: {}\n", remark);
    screen.clear();
    const MonitorClock::time_point begin = MonitorClock::now();
    monitor.mark(seconds(begin));
    for (MonitorClock::time_point next = begin;;) {
        next += screen.period();
        const auto end = options.seconds ? begin
                                               + std::chrono::duration_cast<MonitorClock::duration>(
                                                   std::chrono::duration<double>(*options.seconds))
                                         : MonitorClock::time_point::max();
        if (Status done = receiveUntil(bus, isReplay, monitor, std::min(next, end)); !done)
            return done;
        const double now = seconds(MonitorClock::now());
        monitor.mark(now);
        const bool ended = isReplay && bus.state() == BusState::Ended;
        std::vector<std::string> lines = monitor.table(now);
        if (screen.isRedrawn()) lines.insert(lines.end(), remarks.begin(), remarks.end());
        screen.show(monitor.headline(stateText(*opened), bus.counters()), lines);
        if (ended || MonitorClock::now() >= end) return Done{};
    }
}

}  // namespace terratact
