#pragma once

#include <chrono>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "drivers/gpio_lines.h"

namespace terratact {

// Common parts of finding and requesting GPIO lines, for every version of libgpiod.

struct GpioChip {
    std::string path, name, label;
    unsigned lines = 0;
    int error = 0;  ///< errno if it could not be opened; label and lines are then unknown
};

/// Returns the GPIO chips among the device files of a directory, in the order of their names.
std::vector<GpioChip> listGpioChips(const std::string& directory = "/dev");

/// Returns the chip of that label, or of that name if the label is empty. Errors list the chips.
Result<GpioChip> chooseGpioChip(const std::vector<GpioChip>& chips, const std::string& label,
                                const std::string& name);

/// A line of a chip as the kernel describes it.
struct GpioLineInfo {
    std::string name;
    bool used = false;
    std::string holder;  ///< program that uses it, if the kernel names it
};

/// Returns the positions of the request's lines on the chip. Errors: no line has the name, several
/// have it, the chip has no such offset, two requested lines are the same.
Result<GpioFound> placeGpioLines(const GpioRequest& request, const GpioChip& chip,
                                 const std::vector<GpioLineInfo>& lines);

/// Returns why the kernel refused the lines, from an errno and the state of the lines before.
Error gpioRefused(int code, const GpioFound& found, const std::vector<GpioLineInfo>& lines);

/// Returns the owner of the device file, and what gives this user access.
Error gpioForbidden(const std::string& path, int code);

/// Returns the Error of a chip that fails, or is gone.
Error gpioFailed(const GpioFound& found, SourceText action, int code);

/// Waits until one of the descriptors is readable, and returns which are. Returns none after the time,
/// or after a signal. The Error's code is ENODEV if a descriptor's chip is gone.
Result<std::vector<bool>> waitForGpio(const GpioFound& found, std::span<const int> descriptors,
                                      std::chrono::milliseconds patience);

}  // namespace terratact
