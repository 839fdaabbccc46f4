// Fuzzes panel files. Accepted files name every line exactly once, in plain characters.
#include "core/atem/panel_file.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/fuzz/promise.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

void promiseName(const std::string& name)
{
    promise(name.size() <= 100, "a name is short");
    promise(std::all_of(name.begin(), name.end(),
                        [](char c) { return static_cast<unsigned char>(c) >= ' ' && c != '\x7f'; }),
            "a name holds no control character");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const Result<PanelConfig> panel = panelFrom("f", textOf(data, size));
    if (!panel) return promiseRefusal(panel.error(), "f"), 0;
    promise(panel->chipLabel.empty() != panel->chipName.empty(), "a chip has one name");
    for (const std::string& name : {panel->name, panel->chipLabel, panel->chipName})
        promiseName(name);
    std::vector<PanelLine> lines;
    for (const PanelContact c : kAllPanelContacts) lines.push_back(panel->inputs[c].line);
    for (const PanelOutputLine& output : panel->outputs) lines.push_back(output.line);
    for (const PanelLine& line : lines) {
        promise(line.name.empty() == line.offset.has_value(), "a line has a name or an offset");
        promise(std::count(lines.begin(), lines.end(), line) == 1, "no line is used twice");
        promiseName(line.name);
    }
    return 0;
}
