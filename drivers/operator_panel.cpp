#include "drivers/operator_panel.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace terratact {
namespace {

constexpr double kFirstBackOff = 0.1, kMaxBackOff = 1.0;  ///< [s]

double steadySeconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

GpioBias biasOf(const PanelInputLine& input)
{
    if (input.resistor == PullResistor::External) return GpioBias::AsIs;
    return input.to == ContactTo::Ground ? GpioBias::PullUp : GpioBias::PullDown;
}

PerContact<bool> disturbedBy(const GpioEdges& edges)
{
    PerContact<bool> disturbed;
    if (edges.lost) disturbed.values.fill(true);
    for (const GpioEdge& edge : edges.edges) disturbed.values.at(edge.input) = true;
    return disturbed;
}

}  // namespace

GpioRequest requestOf(const PanelConfig& panel)
{
    GpioRequest request{.chipLabel = panel.chipLabel,
                        .chipName = panel.chipName,
                        .consumer = "terratact",
                        .inputs = {},
                        .outputs = {}};
    for (const PanelInputLine& input : panel.inputs.values)
        request.inputs.push_back({.name = input.line.name,
                                  .offset = input.line.offset,
                                  .activeLow = input.to == ContactTo::Ground,
                                  .bias = biasOf(input)});
    for (const PanelOutputLine& output : panel.outputs)
        request.outputs.push_back({.name = output.line.name,
                                   .offset = output.line.offset,
                                   .activeLow = output.litWhenLow});
    return request;
}

OperatorPanel::OperatorPanel(PanelConfig panel, Open open)
    : OperatorPanel(std::move(panel), std::move(open), steadySeconds)
{
}

OperatorPanel::OperatorPanel(PanelConfig panel, Open open, Clock clock)
    : panel_(std::move(panel)), open_(std::move(open)), clock_(std::move(clock)),
      nextOpening_(clock_())
{
    report_.state.time = nextOpening_;
}

OperatorPanel::~OperatorPanel()
{
    if (lines_)
        for (std::size_t i = 0; i < kPanelOutputs; ++i) (void)lines_->set(i, false);
}

PanelReport OperatorPanel::poll(const LampState& lamps, std::chrono::milliseconds patience)
{
    patience = std::clamp(patience, std::chrono::milliseconds(0), kPeriod);
    if (!lines_) open();
    if (lines_)
        poll(patience);
    else
        std::this_thread::sleep_for(patience);
    if (lines_)
        light(lampTest(report_.state.time - *firstOpened_).value_or(lamps));
    else
        report_.state =
            nextPanel(report_.state, {.now = clock_(), .closed = std::nullopt, .disturbed = {}});
    report_.trouble = trouble();
    return report_;
}

std::optional<GpioFound> OperatorPanel::found() const
{
    if (!lines_) return std::nullopt;
    return lines_->found();
}

void OperatorPanel::open()
{
    const double now = clock_();
    if (now < nextOpening_) return;
    auto lines = open_(requestOf(panel_));
    if (lines) {
        lines_ = *std::move(lines);
        absence_ = {};
        backOff_ = 0.0;
        lit_ = false;
        if (!firstOpened_) firstOpened_ = now;
        return;
    }
    absence_ = lines.error().message;
    backOff_ = std::clamp(2.0 * backOff_, kFirstBackOff, kMaxBackOff);
    nextOpening_ = now + backOff_;
}

void OperatorPanel::poll(std::chrono::milliseconds patience)
{
    const auto edges = lines_->readEdges(patience);
    if (!edges) return lose(edges.error());
    const auto levels = lines_->levels();  // after the edges: the result of a burst
    if (!levels) return lose(levels.error());
    PerContact<bool> closed;
    for (std::size_t i = 0; i < kPanelContacts; ++i) closed.values[i] = levels->at(i);
    count(*edges);
    report_.state = nextPanel(
        report_.state, {.now = clock_(), .closed = closed, .disturbed = disturbedBy(*edges)});
}

void OperatorPanel::count(const GpioEdges& edges)
{
    report_.counters.lostEdges += edges.lost;
    for (const GpioEdge& edge : edges.edges) {
        ++report_.counters.edges.values.at(edge.input);
        if (edge.input == static_cast<std::size_t>(PanelContact::Stop))
            report_.stopEdge = edge.time;
    }
}

void OperatorPanel::lose(const Error& why)
{
    lines_.reset();
    absence_ = why.message;
    ++report_.counters.losses;
    report_.lamps = {};
    lampTrouble_ = {};
    nextOpening_ = clock_();
}

void OperatorPanel::light(const LampState& lamps)
{
    const auto wanted = outputsOf(lamps), are = outputsOf(report_.lamps);
    Message failed;
    for (std::size_t i = 0; i < kPanelOutputs; ++i) {
        if (lit_ && wanted[i] == are[i]) continue;
        const Status done = lines_->set(i, wanted[i]);
        if (!done && failed.empty())
            failed = {TR_NOOP("core", "the panel's %1 does not obey: %2"), kPanelOutputNames[i],
                      done.error().message};
    }
    lampTrouble_ = failed;
    lit_ = failed.empty();  // otherwise all are set again at the next reading
    if (lit_) report_.lamps = lamps;
}

Message OperatorPanel::trouble() const
{
    if (!lines_) return {TR_NOOP("core", "the panel is absent: %1"), absence_};
    if (!lampTrouble_.empty()) return lampTrouble_;
    for (const PanelContact button : kPanelButtons)
        if (auto text = buttonTrouble(button, report_.state.contacts[button].phase); !text.empty())
            return text;
    return {};
}

}  // namespace terratact
