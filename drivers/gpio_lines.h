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

/// What holds a line that nothing drives.
enum class GpioBias : std::uint8_t {
    AsIs,  ///< something on the board, or as the chip was set before
    PullUp,
    PullDown,
};

struct GpioInput {
    std::string name;
    std::optional<unsigned> offset;  ///< counts where the name is empty
    bool activeLow = false;
    GpioBias bias = GpioBias::AsIs;
};

struct GpioOutput {
    std::string name;
    std::optional<unsigned> offset;  ///< counts where the name is empty
    bool activeLow = false;
};

/// Lines of one chip, which is found by its label, or by its name where the label is empty.
struct GpioRequest {
    std::string chipLabel, chipName;
    std::string consumer;  ///< who others are told holds the lines
    std::vector<GpioInput> inputs;
    std::vector<GpioOutput> outputs;
};

struct GpioPlace {
    unsigned offset = 0;
    std::string name;  ///< empty: the line has none
};

/// What was asked for, and where it is.
struct GpioFound {
    std::string path, chip, label;           ///< "/dev/gpiochip0", "gpiochip0", "pinctrl-bcm2711"
    unsigned lines = 0;                      ///< of the chip
    std::vector<GpioPlace> inputs, outputs;  ///< in the order of the request
};

struct GpioEdge {
    std::size_t input = 0;  ///< of the request
    bool active = false;    ///< became active
    double time = 0.0;      ///< [s] steady clock, the kernel's stamp
};

struct GpioEdges {
    std::vector<GpioEdge> edges;
    bool lost = false;  ///< there were more, and of which inputs is not known
};

/// Holds the lines of one chip until it is destroyed.  Moves levels and gives them no meaning.  For one
/// thread.  A chip that is gone is an Error with the code ENODEV; nothing works again then.
class GpioLines {
public:
    virtual ~GpioLines() = default;

    virtual const GpioFound& found() const = 0;

    /// Edges of the inputs, waiting at most `patience` for the first.  A kernel keeps few of a burst, and
    /// not always the last: an input's edges say that it moved, levels() where it stands.
    virtual Result<GpioEdges> readEdges(std::chrono::milliseconds patience) = 0;

    /// Whether each input is active now.
    virtual Result<std::vector<bool>> levels() = 0;

    /// Throws std::invalid_argument where the request had no such output.
    virtual Status set(std::size_t output, bool active) = 0;
};

/// Takes the lines; outputs begin inactive.  Errors say what is missing and how to mend it: no such chip
/// (which there are), no such line, a line that somebody else holds, no permission.
/// In gpio_lines_v1.cpp for libgpiod 1.x, in gpio_lines_v2.cpp for 2.x; a program links one of them.
Result<std::unique_ptr<GpioLines>> openGpioLines(const GpioRequest& request);

}  // namespace terratact
