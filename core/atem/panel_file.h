#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/atem/panel.h"
#include "core/base/result.h"

namespace terratact {

/// Line of the panel's GPIO chip, by name, or by offset if the file has one.
struct PanelLine {
    std::string name;                ///< empty if there is an offset
    std::optional<unsigned> offset;  ///< position on the chip
    bool operator==(const PanelLine&) const = default;
};

/// Side to which a closing contact connects its line. A resistor to the other side holds an open
/// line, so that a broken wire reads as open.
enum class ContactTo : std::uint8_t { Ground, Supply };

enum class PullResistor : std::uint8_t {
    Internal,  ///< the chip's own resistor, enabled with the request
    External,  ///< a resistor on the board
};

struct PanelInputLine {
    PanelLine line;
    ContactTo to = ContactTo::Ground;
    PullResistor resistor = PullResistor::Internal;
    bool operator==(const PanelInputLine&) const = default;
};

struct PanelOutputLine {
    PanelLine line;
    bool litWhenLow = false;
    bool operator==(const PanelOutputLine&) const = default;
};

/// Wiring of a panel: resources/panels/example.toml explains every key.
struct PanelConfig {
    std::string name;
    /// The label that `gpiodetect` shows in brackets; empty if there is a chip name.
    std::string chipLabel;
    std::string chipName;  ///< "gpiochip0": changes if chips are plugged in another order
    PerContact<PanelInputLine> inputs;
    std::array<PanelOutputLine, kPanelOutputs> outputs;  ///< in the order of kPanelOutputNames
    bool operator==(const PanelConfig&) const = default;
};

/// Reads a panel file. Errors name the file, the line and the key. Causes: unreadable, no TOML, a
/// missing or unknown key, a line used twice.
Result<PanelConfig> readPanelFile(const std::string& path);

/// Reads the same from a text; errors call it `name`.
Result<PanelConfig> panelFrom(const std::string& name, const std::string& text);

}  // namespace terratact
