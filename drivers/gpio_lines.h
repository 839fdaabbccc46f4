#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace terratact {

/// Bias resistor of a line that nothing drives.
enum class GpioBias : std::uint8_t {
    AsIs,  ///< a resistor on the board, or the chip's earlier setting
    PullUp,
    PullDown,
};

struct GpioInput {
    std::string name;
    std::optional<unsigned> offset;  ///< used if the name is empty
    bool activeLow = false;
    GpioBias bias = GpioBias::AsIs;
};

struct GpioOutput {
    std::string name;
    std::optional<unsigned> offset;  ///< used if the name is empty
    bool activeLow = false;
};

/// Lines of one chip, found by its label, or by its name if the label is empty.
struct GpioRequest {
    std::string chipLabel, chipName;
    std::string consumer;  ///< shown to other programs as the holder of the lines
    std::vector<GpioInput> inputs;
    std::vector<GpioOutput> outputs;
};

struct GpioPlace {
    unsigned offset = 0;
    std::string name;  ///< empty: the line has no name
};

/// Requested lines and their positions.
struct GpioFound {
    std::string path, chip, label;           ///< "/dev/gpiochip0", "gpiochip0", "pinctrl-bcm2711"
    unsigned lines = 0;                      ///< number of the chip's lines
    std::vector<GpioPlace> inputs, outputs;  ///< in the order of the request
};

struct GpioEdge {
    std::size_t input = 0;  ///< index in the request
    bool active = false;    ///< true: became active
    double time = 0.0;      ///< steady clock, the kernel's stamp [s]
};

struct GpioEdges {
    std::vector<GpioEdge> edges;
    bool lost = false;  ///< edges were lost; their inputs are unknown
};

/// Holds the lines of one chip until it is destroyed. Moves levels without knowing their meaning.
/// One thread may use it. If the chip is gone, calls return an Error with the code ENODEV; the
/// object then never works again.
class GpioLines {
public:
    virtual ~GpioLines() = default;

    virtual const GpioFound& found() const = 0;

    /// Returns edges of the inputs, waiting at most `patience` for the first. The kernel keeps few
    /// edges of a burst, and not always the last. Edges show that an input changed; levels()
    /// returns its value.
    virtual Result<GpioEdges> readEdges(std::chrono::milliseconds patience) = 0;

    /// Returns true for each input that is active now.
    virtual Result<std::vector<bool>> levels() = 0;

    /// Throws std::invalid_argument if the request has no such output.
    virtual Status set(std::size_t output, bool active) = 0;
};

/// Requests the lines; outputs start inactive. Errors name what is missing and how to repair it.
/// Causes: no such chip (with the list of chips), no such line, a line that another program holds,
/// no permission. gpio_lines_v1.cpp defines it for libgpiod 1.x, and gpio_lines_v2.cpp for 2.x. A
/// program links one of them.
Result<std::unique_ptr<GpioLines>> openGpioLines(const GpioRequest& request);

}  // namespace terratact
