// Implementation for libgpiod 2.x. The kernel keeps the edges of all lines together and drops the
// oldest ones if it has no room. Their numbers then have a gap.
#include <gpiod.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <utility>

#include "drivers/gpio_chip.h"
#include "drivers/gpio_lines.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxEdges = 256;  ///< edges that the kernel keeps and returns at once

template <auto release>
struct Release {
    template <class T>
    void operator()(T* object) const
    {
        release(object);
    }
};
using ChipPointer = std::unique_ptr<gpiod_chip, Release<gpiod_chip_close>>;
using InfoPointer = std::unique_ptr<gpiod_line_info, Release<gpiod_line_info_free>>;
using SettingsPointer = std::unique_ptr<gpiod_line_settings, Release<gpiod_line_settings_free>>;
using ConfigPointer = std::unique_ptr<gpiod_line_config, Release<gpiod_line_config_free>>;
using RequestPointer = std::unique_ptr<gpiod_request_config, Release<gpiod_request_config_free>>;
using LinesPointer = std::unique_ptr<gpiod_line_request, Release<gpiod_line_request_release>>;
using BufferPointer =
    std::unique_ptr<gpiod_edge_event_buffer, Release<gpiod_edge_event_buffer_free>>;

gpiod_line_bias biasOf(GpioBias bias)
{
    switch (bias) {
    case GpioBias::AsIs: return GPIOD_LINE_BIAS_AS_IS;
    case GpioBias::PullUp: return GPIOD_LINE_BIAS_PULL_UP;
    case GpioBias::PullDown: return GPIOD_LINE_BIAS_PULL_DOWN;
    }
    throw std::invalid_argument("GpioLines: no such bias");
}

std::string textOf(const char* text)
{
    return text ? text : "";
}

std::vector<GpioLineInfo> infosOf(gpiod_chip* chip, unsigned count)
{
    std::vector<GpioLineInfo> infos(count);
    for (unsigned i = 0; i < count; ++i)
        if (const InfoPointer line{gpiod_chip_get_line_info(chip, i)})
            infos[i] = {textOf(gpiod_line_info_get_name(line.get())),
                        gpiod_line_info_is_used(line.get()),
                        textOf(gpiod_line_info_get_consumer(line.get()))};
    return infos;
}

bool add(gpiod_line_config* config, unsigned offset, const GpioInput& input)
{
    const SettingsPointer settings(gpiod_line_settings_new());
    if (!settings) return false;
    gpiod_line_settings_set_active_low(settings.get(), input.activeLow);
    return gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_INPUT) == 0
        && gpiod_line_settings_set_edge_detection(settings.get(), GPIOD_LINE_EDGE_BOTH) == 0
        && gpiod_line_settings_set_bias(settings.get(), biasOf(input.bias)) == 0
        && gpiod_line_settings_set_event_clock(settings.get(), GPIOD_LINE_CLOCK_MONOTONIC) == 0
        && gpiod_line_config_add_line_settings(config, &offset, 1, settings.get()) == 0;
}

bool add(gpiod_line_config* config, unsigned offset, const GpioOutput& output)
{
    const SettingsPointer settings(gpiod_line_settings_new());
    if (!settings) return false;
    gpiod_line_settings_set_active_low(settings.get(), output.activeLow);
    return gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_OUTPUT) == 0
        && gpiod_line_settings_set_output_value(settings.get(), GPIOD_LINE_VALUE_INACTIVE) == 0
        && gpiod_line_config_add_line_settings(config, &offset, 1, settings.get()) == 0;
}

/// Requests all lines at once. Returns null with errno if the kernel refuses.
LinesPointer requestLines(gpiod_chip* chip, const GpioRequest& request, const GpioFound& found)
{
    const ConfigPointer config(gpiod_line_config_new());
    const RequestPointer how(gpiod_request_config_new());
    if (!config || !how) return nullptr;
    for (std::size_t i = 0; i < request.inputs.size(); ++i)
        if (!add(config.get(), found.inputs[i].offset, request.inputs[i])) return nullptr;
    for (std::size_t i = 0; i < request.outputs.size(); ++i)
        if (!add(config.get(), found.outputs[i].offset, request.outputs[i])) return nullptr;
    gpiod_request_config_set_consumer(how.get(), request.consumer.c_str());
    gpiod_request_config_set_event_buffer_size(how.get(), kMaxEdges);
    return LinesPointer(gpiod_chip_request_lines(chip, how.get(), config.get()));
}

class Lines final : public GpioLines {
public:
    Lines(ChipPointer chip, LinesPointer lines, BufferPointer buffer, GpioFound found)
        : chip_(std::move(chip)), lines_(std::move(lines)), buffer_(std::move(buffer)),
          found_(std::move(found))
    {
        for (const GpioPlace& place : found_.inputs) offsets_.push_back(place.offset);
    }

    const GpioFound& found() const override { return found_; }

    Result<GpioEdges> readEdges(std::chrono::milliseconds patience) override
    {
        const int descriptor = gpiod_line_request_get_fd(lines_.get());
        const auto ready = waitForGpio(found_, {&descriptor, 1}, patience);
        if (!ready) return ready.error();
        GpioEdges edges;
        if (!ready->front()) return edges;
        const int count =
            gpiod_line_request_read_edge_events(lines_.get(), buffer_.get(), kMaxEdges);
        if (count < 0 && errno != EINTR && errno != EAGAIN)
            return gpioFailed(found_, TR_NOOP("core", "reading an edge"), errno);
        for (int i = 0; i < count; ++i) append(static_cast<unsigned long>(i), edges);
        return edges;
    }

    Result<std::vector<bool>> levels() override
    {
        std::vector<gpiod_line_value> values(offsets_.size(), GPIOD_LINE_VALUE_ERROR);
        if (gpiod_line_request_get_values_subset(lines_.get(), offsets_.size(), offsets_.data(),
                                                 values.data())
            != 0)
            return gpioFailed(found_, TR_NOOP("core", "reading the levels"), errno);
        std::vector<bool> levels(values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            levels[i] = values[i] == GPIOD_LINE_VALUE_ACTIVE;
        return levels;
    }

    Status set(std::size_t output, bool active) override
    {
        if (output >= found_.outputs.size())
            throw std::invalid_argument("GpioLines: there is no such output");
        if (gpiod_line_request_set_value(lines_.get(), found_.outputs[output].offset,
                                         active ? GPIOD_LINE_VALUE_ACTIVE
                                                : GPIOD_LINE_VALUE_INACTIVE)
            != 0)
            return gpioFailed(found_, TR_NOOP("core", "setting an output"), errno);
        return Done{};
    }

private:
    void append(unsigned long index, GpioEdges& edges)
    {
        gpiod_edge_event* const event = gpiod_edge_event_buffer_get_event(buffer_.get(), index);
        const unsigned long number = gpiod_edge_event_get_global_seqno(event);
        edges.lost |= number != lastNumber_ + 1;
        lastNumber_ = number;
        const unsigned offset = gpiod_edge_event_get_line_offset(event);
        const auto input = std::find(offsets_.begin(), offsets_.end(), offset);
        edges.edges.push_back(
            {.input = static_cast<std::size_t>(input - offsets_.begin()),
             .active = gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE,
             .time = 1e-9 * static_cast<double>(gpiod_edge_event_get_timestamp_ns(event))});
    }

    ChipPointer chip_;
    LinesPointer lines_;
    BufferPointer buffer_;
    GpioFound found_;
    std::vector<unsigned> offsets_;  // offsets of the inputs
    unsigned long lastNumber_ = 0;   // number of the last edge; the kernel starts with 1
};

}  // namespace

Result<std::unique_ptr<GpioLines>> openGpioLines(const GpioRequest& request)
{
    const auto chip = chooseGpioChip(listGpioChips(), request.chipLabel, request.chipName);
    if (!chip) return chip.error();
    ChipPointer opened(gpiod_chip_open(chip->path.c_str()));
    if (!opened) return gpioForbidden(chip->path, errno);
    const std::vector<GpioLineInfo> infos = infosOf(opened.get(), chip->lines);
    const auto found = placeGpioLines(request, *chip, infos);
    if (!found) return found.error();
    LinesPointer taken = requestLines(opened.get(), request, *found);
    if (!taken) return gpioRefused(errno, *found, infos);
    BufferPointer buffer(gpiod_edge_event_buffer_new(kMaxEdges));
    if (!buffer) return gpioRefused(errno, *found, infos);
    return std::unique_ptr<GpioLines>(
        std::make_unique<Lines>(std::move(opened), std::move(taken), std::move(buffer), *found));
}

}  // namespace terratact
