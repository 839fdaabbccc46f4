#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "app/cli/commands.h"
#include "app/runtime/print_text.h"
#include "drivers/gpio_lines.h"
#include "drivers/operator_panel.h"

namespace terratact {
namespace {

volatile std::sig_atomic_t interrupted = 0;

/// Makes SIGINT and SIGTERM end the polling; the lamps are then switched off before exit.
void endOnInterrupt()
{
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });
}

/// Polls the panel for `seconds` and returns the last report.
template <class Watch>
PanelReport pollFor(OperatorPanel& panel, const LampState& lamps, double seconds, Watch watch)
{
    PanelReport report = panel.poll(lamps, OperatorPanel::kPeriod);
    const double first = report.state.time;
    while (report.state.time - first < seconds && !interrupted) {
        watch(report);
        report = panel.poll(lamps, OperatorPanel::kPeriod);
    }
    return report;
}

PanelReport pollFor(OperatorPanel& panel, const LampState& lamps, double seconds)
{
    return pollFor(panel, lamps, seconds, [](const PanelReport&) {});
}

std::string placeText(const GpioPlace& place)
{
    return fmt::format("line {:<3} {}", place.offset, place.name);
}

std::string stateText(PanelContact contact, const PanelState& state)
{
    const ContactState& at = state.contacts[contact];
    if (contact == PanelContact::Stop) {
        if (!at.closed) return "open: STOP is asserted (pressed, or a wire is broken)";
        return at.trusted ? "closed: STOP is released" : "closed, not yet for long enough";
    }
    if (!at.closed) return "open";
    return state.held(contact) ? "closed: pressed" : "closed: does not count";
}

void printFound(const GpioFound& found, const PanelState& state)
{
    printText("chip    {} [{}], {} lines, {}\n", found.chip, found.label, found.lines, found.path);
    for (const PanelContact c : kAllPanelContacts)
        printText("input   {:<13} {:<20} {}\n", name(c),
                  placeText(found.inputs.at(static_cast<std::size_t>(c))), stateText(c, state));
    for (std::size_t i = 0; i < kPanelOutputs; ++i)
        printText("output  {:<13} {}\n", kPanelOutputNames[i], placeText(found.outputs.at(i)));
}

/// Lights each lamp for a second, after the panel's self-test.
Status lightLamps(OperatorPanel& panel)
{
    LampState lamps;
    (void)pollFor(panel, lamps, 1.4);
    for (std::size_t i = 0; i < kPanelOutputs && !interrupted; ++i) {
        lamps = {.link = i == 0, .armed = i == 1, .probing = i == 2, .buzzer = i == 3};
        (void)panel.poll(lamps, OperatorPanel::kPeriod);  // this poll lights the lamp
        printText("lit     {}\n", kPanelOutputNames[i]);
        std::fflush(stdout);
        const PanelReport report = pollFor(panel, lamps, 1.0);
        if (!(report.lamps == lamps)) return Error{report.trouble, 0};
    }
    return Done{};
}

/// Prints each change of the panel's state.
class ChangePrinter {
public:
    explicit ChangePrinter(PanelReport report) : last_(std::move(report)) {}

    void operator()(const PanelReport& now)
    {
        if (now.trouble != last_.trouble)
            print(now, now.trouble.empty() ? "all is well" : now.trouble.english());
        if (now.state.present)
            for (const PanelContact c : kAllPanelContacts) printContact(now, c);
        if (now.counters.lostEdges != last_.counters.lostEdges)
            print(now, "more edges than the kernel has room for: a bouncing contact");
        last_ = now;
    }

private:
    void printContact(const PanelReport& now, PanelContact c) const
    {
        const std::string text = stateText(c, now.state);
        const std::uint64_t edges = now.counters.edges[c] - last_.counters.edges[c];
        if (edges == 0 && last_.state.present && text == stateText(c, last_.state)) return;
        print(now, fmt::format("{:<8} {}{}", name(c), text,
                               edges > 1 ? fmt::format(" ({} edges)", edges) : std::string()));
    }
    void print(const PanelReport& now, const std::string& text) const
    {
        printText("{:8.3f} s  {}\n", now.state.time - begin_, text);
        std::fflush(stdout);
    }

    PanelReport last_;
    double begin_ = last_.state.time;
};

}  // namespace

Status checkPanel(const PanelCheckOptions& options)
{
    auto config = readPanelFile(options.file);
    if (!config) return config.error();
    printText("panel   {}\n", config->name);
    OperatorPanel panel(*std::move(config), openGpioLines);
    endOnInterrupt();
    const PanelReport report = pollFor(panel, {}, 0.1);
    const auto found = panel.found();
    if (!found) return Error{report.trouble, 0};
    printFound(*found, report.state);
    std::fflush(stdout);
    if (options.lamps)
        if (const Status lit = lightLamps(panel); !lit) return lit.error();
    if (options.watch) {
        printText("watching; Ctrl-C ends it\n");
        std::fflush(stdout);
        (void)pollFor(panel, {}, options.seconds, ChangePrinter(report));
        return Done{};
    }
    if (!report.trouble.empty()) return Error{report.trouble, 0};
    return Done{};
}

}  // namespace terratact
