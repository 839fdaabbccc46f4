// Implementation for libgpiod 1.x. The kernel keeps 16 edges of each line and silently drops newer
// ones. An input with dropped edges therefore always has edges left.
#include <gpiod.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <utility>

#include "drivers/gpio_chip.h"
#include "drivers/gpio_lines.h"

namespace terratact {
namespace {

struct CloseChip {
    void operator()(gpiod_chip* chip) const { gpiod_chip_close(chip); }  // also releases its lines
};
using ChipPointer = std::unique_ptr<gpiod_chip, CloseChip>;

int flagsOf(bool activeLow, GpioBias bias)
{
    int flags = activeLow ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0;
    switch (bias) {
    case GpioBias::AsIs: break;
    case GpioBias::PullUp: flags |= GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP; break;
    case GpioBias::PullDown: flags |= GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN; break;
    }
    return flags;
}

double secondsOf(const timespec& time)
{
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::string textOf(const char* text)
{
    return text ? text : "";
}

std::vector<GpioLineInfo> infosOf(gpiod_chip* chip)
{
    std::vector<GpioLineInfo> infos(gpiod_chip_num_lines(chip));
    for (unsigned i = 0; i < infos.size(); ++i)
        if (gpiod_line* const line = gpiod_chip_get_line(chip, i))
            infos[i] = {textOf(gpiod_line_name(line)), gpiod_line_is_used(line),
                        textOf(gpiod_line_consumer(line))};
    return infos;
}

class Lines final : public GpioLines {
public:
    Lines(ChipPointer chip, GpioFound found) : chip_(std::move(chip)), found_(std::move(found)) {}

    /// Requests the lines. Returns 0, or errno.
    int requestLines(const GpioRequest& request)
    {
        const char* const consumer = request.consumer.c_str();
        for (std::size_t i = 0; i < request.inputs.size(); ++i) {
            gpiod_line* const line = gpiod_chip_get_line(chip_.get(), found_.inputs[i].offset);
            const GpioInput& input = request.inputs[i];
            if (!line
                || gpiod_line_request_both_edges_events_flags(line, consumer,
                                                              flagsOf(input.activeLow, input.bias))
                       != 0)
                return errno;
            inputs_.push_back(line);
            descriptors_.push_back(gpiod_line_event_get_fd(line));
        }
        for (std::size_t i = 0; i < request.outputs.size(); ++i) {
            gpiod_line* const line = gpiod_chip_get_line(chip_.get(), found_.outputs[i].offset);
            const int flags = flagsOf(request.outputs[i].activeLow, GpioBias::AsIs);
            if (!line || gpiod_line_request_output_flags(line, consumer, flags, 0) != 0)
                return errno;
            outputs_.push_back(line);
        }
        return 0;
    }

    const GpioFound& found() const override { return found_; }

    Result<GpioEdges> readEdges(std::chrono::milliseconds patience) override
    {
        const auto ready = waitForGpio(found_, descriptors_, patience);
        if (!ready) return ready.error();
        GpioEdges edges;
        for (std::size_t i = 0; i < descriptors_.size(); ++i)
            if ((*ready)[i])
                if (const int code = append(i, edges.edges); code != 0)
                    return gpioFailed(found_, TR_NOOP("core", "reading an edge"), code);
        return edges;
    }

    Result<std::vector<bool>> levels() override
    {
        std::vector<bool> levels;
        for (gpiod_line* const line : inputs_) {
            const int level = gpiod_line_get_value(line);
            if (level < 0) return gpioFailed(found_, TR_NOOP("core", "reading a level"), errno);
            levels.push_back(level != 0);
        }
        return levels;
    }

    Status set(std::size_t output, bool active) override
    {
        if (output >= outputs_.size())
            throw std::invalid_argument("GpioLines: there is no such output");
        if (gpiod_line_set_value(outputs_[output], active ? 1 : 0) != 0)
            return gpioFailed(found_, TR_NOOP("core", "setting an output"), errno);
        return Done{};
    }

private:
    /// Appends the kernel's edges of one input. Returns 0, or errno.
    int append(std::size_t input, std::vector<GpioEdge>& edges)
    {
        std::array<gpiod_line_event, 16> events{};
        const int count =
            gpiod_line_event_read_fd_multiple(descriptors_[input], events.data(), events.size());
        if (count < 0) return errno == EINTR || errno == EAGAIN ? 0 : errno;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
            edges.push_back({.input = input,
                             .active = events[i].event_type == GPIOD_LINE_EVENT_RISING_EDGE,
                             .time = secondsOf(events[i].ts)});
        return 0;
    }

    ChipPointer chip_;
    GpioFound found_;
    std::vector<gpiod_line*> inputs_, outputs_;  // owned by the chip
    std::vector<int> descriptors_;               // of the inputs; owned by the chip
};

}  // namespace

Result<std::unique_ptr<GpioLines>> openGpioLines(const GpioRequest& request)
{
    const auto chip = chooseGpioChip(listGpioChips(), request.chipLabel, request.chipName);
    if (!chip) return chip.error();
    ChipPointer opened(gpiod_chip_open(chip->path.c_str()));
    if (!opened) return gpioForbidden(chip->path, errno);
    const std::vector<GpioLineInfo> infos = infosOf(opened.get());
    auto found = placeGpioLines(request, *chip, infos);
    if (!found) return found.error();
    auto lines = std::make_unique<Lines>(std::move(opened), *found);
    if (const int code = lines->requestLines(request); code != 0)
        return gpioRefused(code, *found, infos);
    return std::unique_ptr<GpioLines>(std::move(lines));
}

}  // namespace terratact
