#pragma once

#include <chrono>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "drivers/gpio_lines.h"

namespace terratact {

// What finding and asking for GPIO lines has in common for every version of libgpiod.

struct GpioChip {
    std::string path, name, label;
    unsigned lines = 0;
    int error = 0;  ///< errno where it could not be opened; label and lines are unknown then
};

/// The GPIO chips among the device files of a directory, in the order of their names.
std::vector<GpioChip> listGpioChips(const std::string& directory = "/dev");

/// The chip of that label, or of that name where the label is empty.  Errors say which chips there are.
Result<GpioChip> chooseGpioChip(const std::vector<GpioChip>& chips, const std::string& label,
                                const std::string& name);

/// One line of a chip as the kernel describes it.
struct GpioLineInfo {
    std::string name;
    bool used = false;
    std::string holder;  ///< who uses it, where the kernel says so
};

/// Where the request's lines are on the chip.  Errors: no line has the name, several have, the chip has
/// no such offset, two of the request are one line.
Result<GpioFound> placeGpioLines(const GpioRequest& request, const GpioChip& chip,
                                 const std::vector<GpioLineInfo>& lines);

/// Why the kernel did not hand the lines out: an errno, and the lines as they were before.
Error gpioRefused(int code, const GpioFound& found, const std::vector<GpioLineInfo>& lines);

/// Whose the device file is and what lets this user open it.
Error gpioForbidden(const std::string& path, int code);

/// A chip that answers no longer, or not as it should.
Error gpioFailed(const GpioFound& found, const std::string& action, int code);

/// Waits until one of the descriptors has something to read; which of them have.  None where the time is
/// over or a signal came.  An Error with ENODEV where a descriptor's chip is gone.
Result<std::vector<bool>> waitForGpio(const GpioFound& found, std::span<const int> descriptors,
                                      std::chrono::milliseconds patience);

}  // namespace terratact
