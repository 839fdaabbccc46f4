#include "core/atem/panel_file.h"

#include <cmath>
#include <set>
#include <utility>

#include "core/robot/toml_section.h"

namespace terratact {
namespace {

constexpr double kMaxOffset = 1023.0;

/// Lines of the file: each name or offset may occur once.
class Lines {
public:
    PanelLine lineOf(TomlSection& section)
    {
        PanelLine line;
        if (section.has("line") == section.has("offset"))
            throw TomlRefused{
                Message(TR_NOOP("core", "%1 must have the line's name or its offset, not both"),
                        section.path("line"))};
        if (section.has("line"))
            line.name = section.text("line");
        else
            line.offset = offsetOf(section);
        if (!used_.emplace(line.name, line.offset).second)
            throw TomlRefused{
                Message(TR_NOOP("core", "%1 names a line that the file has used before"),
                        section.path(section.has("line") ? "line" : "offset"))};
        return line;
    }

private:
    static unsigned offsetOf(TomlSection& section)
    {
        const double offset = section.number("offset", {0.0, kMaxOffset});
        if (offset != std::floor(offset))
            throw TomlRefused{Message(TR_NOOP("core", "%1: %2 is not a whole number"),
                                      tomlLine(section.node("offset")), section.path("offset"))};
        return static_cast<unsigned>(offset);
    }

    std::set<std::pair<std::string, std::optional<unsigned>>> used_;
};

void readChip(TomlSection& section, PanelConfig& panel)
{
    if (section.has("label") == section.has("name"))
        throw TomlRefused{TR_NOOP("core", "chip must have a label or a name, not both")};
    if (section.has("label"))
        panel.chipLabel = section.text("label");
    else
        panel.chipName = section.text("name");
}

void readInput(TomlSection& section, Lines& lines, PanelInputLine& input)
{
    input.line = lines.lineOf(section);
    input.to = section.choice("closes_to", {"ground", "supply"}) == 0 ? ContactTo::Ground
                                                                      : ContactTo::Supply;
    input.resistor = section.choice("resistor", {"internal", "external"}) == 0
                       ? PullResistor::Internal
                       : PullResistor::External;
}

void readOutput(TomlSection& section, Lines& lines, PanelOutputLine& output)
{
    output.line = lines.lineOf(section);
    output.litWhenLow = section.choice("lit_when", {"high", "low"}) == 1;
}

void readPanel(TomlSection& file, PanelConfig& panel)
{
    Lines lines;
    panel.name = file.text("name");
    file.section("chip", [&](TomlSection& s) { readChip(s, panel); });
    file.section("inputs", [&](TomlSection& s) {
        for (const PanelContact c : kAllPanelContacts)
            s.section(name(c), [&](TomlSection& t) { readInput(t, lines, panel.inputs[c]); });
    });
    file.section("outputs", [&](TomlSection& s) {
        for (std::size_t i = 0; i < kPanelOutputs; ++i)
            s.section(kPanelOutputNames[i],
                      [&](TomlSection& t) { readOutput(t, lines, panel.outputs[i]); });
    });
}

}  // namespace

Result<PanelConfig> readPanelFile(const std::string& path)
{
    PanelConfig panel;
    const Status read = readTomlFile(path, [&](TomlSection& file) { readPanel(file, panel); });
    if (!read) return read.error();
    return panel;
}

Result<PanelConfig> panelFrom(const std::string& name, const std::string& text)
{
    PanelConfig panel;
    const Status read = readToml(name, text, [&](TomlSection& file) { readPanel(file, panel); });
    if (!read) return read.error();
    return panel;
}

}  // namespace terratact
