#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/atem/panel.h"
#include "core/base/result.h"

namespace terratact {

/// A line of the panel's GPIO chip, by its name; by its offset only where the file says so.
struct PanelLine {
    std::string name;                ///< empty where there is an offset
    std::optional<unsigned> offset;  ///< position on the chip
    bool operator==(const PanelLine&) const = default;
};

/// Where the contact connects its line to when it closes.  A resistor to the other side then holds an
/// open line, so a broken wire always reads as open.
enum class ContactTo : std::uint8_t { Ground, Supply };

enum class PullResistor : std::uint8_t {
    Internal,  ///< the chip's own, switched on with the request
    External,  ///< on the board
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

/// How a panel is wired: resources/panels/example.toml explains every key.
struct PanelConfig {
    std::string name;
    std::string chipLabel;  ///< what `gpiodetect` shows in brackets; empty where there is a name
    std::string chipName;   ///< "gpiochip0": changes when chips are plugged in another order
    PerContact<PanelInputLine> inputs;
    std::array<PanelOutputLine, kPanelOutputs> outputs;  ///< in the order of kPanelOutputNames
    bool operator==(const PanelConfig&) const = default;
};

/// Errors name the file, the line and the key: it cannot be read, is no TOML, lacks a key, has one that
/// is not known, or uses a line twice.
Result<PanelConfig> readPanelFile(const std::string& path);

/// The same for a text at hand, which errors call `name`.
Result<PanelConfig> panelFrom(const std::string& name, const std::string& text);

}  // namespace terratact
