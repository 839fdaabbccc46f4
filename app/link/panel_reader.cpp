#include "app/link/panel_reader.h"

#include <exception>
#include <limits>
#include <utility>

#include "app/runtime/steady_now.h"

namespace terratact {
namespace {

constexpr std::size_t kKeptLatencies = 1000;

}  // namespace

PanelReader::PanelReader(std::unique_ptr<OperatorPanel> panel, MeasurementSource& source)
    : panel_(std::move(panel)), source_(source), readAt_(-std::numeric_limits<double>::infinity()),
      thread_([this](const std::stop_token& stop) { read(stop); })
{
}

void PanelReader::read(const std::stop_token& stop)
{
    // A panel that starts with STOP open sends no STOP; it only blocks commands.
    bool stopped = true;
    while (!stop.stop_requested()) {
        LampState lamps;
        {
            const std::scoped_lock lock(mutex_);
            lamps = lamps_;
        }
        const PanelReport report = poll(lamps);
        if (report.state.stop && !stopped) stopRobot(report);
        stopped = report.state.stop;
        add(report);
    }
}

PanelReport PanelReader::poll(const LampState& lamps)
{
    try {
        return panel_->poll(lamps, OperatorPanel::kPeriod);
    } catch (const std::exception& error) {
        std::this_thread::sleep_for(
            OperatorPanel::kPeriod);  // a panel that fails at once must not busy-loop
        PanelReport lost;
        lost.trouble = messageOf(error);
        return lost;
    }
}

void PanelReader::stopRobot(const PanelReport& report)
{
    const Status sent = source_.send(StopCommand{});
    if (!sent || !report.state.present) return;  // a lost panel has no edge to measure from
    const double latency = steadyNow() - report.stopEdge;
    const std::scoped_lock lock(mutex_);
    if (latencies_.size() == kKeptLatencies) latencies_.erase(latencies_.begin());
    latencies_.push_back(latency);
}

void PanelReader::add(const PanelReport& report)
{
    const std::scoped_lock lock(mutex_);
    latest_ = report;
    readAt_ = steadyNow();
    for (const PanelContact button : kPanelButtons)
        if (report.state.pressed[button]) ++presses_[button], ++allPresses_[button];
}

PanelReport PanelReader::latest() const
{
    const std::scoped_lock lock(mutex_);
    return latest_;
}

PerContact<int> PanelReader::consumePresses()
{
    const std::scoped_lock lock(mutex_);
    return std::exchange(presses_, {});
}

PerContact<std::uint64_t> PanelReader::allPresses() const
{
    const std::scoped_lock lock(mutex_);
    return allPresses_;
}

double PanelReader::age(double now) const
{
    const std::scoped_lock lock(mutex_);
    return now - readAt_;
}

void PanelReader::setLamps(const LampState& lamps)
{
    const std::scoped_lock lock(mutex_);
    lamps_ = lamps;
}

std::vector<double> PanelReader::stopLatencies() const
{
    const std::scoped_lock lock(mutex_);
    return latencies_;
}

}  // namespace terratact
