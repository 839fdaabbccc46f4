#include "app/link/protocol_dbc.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/store/file_read.h"
#include "core/wire/dbc/dbc_file.h"
#include "core/wire/frame_layout.h"

namespace terratact {
namespace {

bool isTheSame(const DbcSignal& said, const SignalLayout& layout)
{
    const auto type = layout.isSigned ? DbcSignal::Type::Signed : DbcSignal::Type::Unsigned;
    return said.start == layout.start && said.length == layout.length && !said.isBigEndian
        && said.type == type && said.scale == layout.scale && said.offset == 0.0
        && said.unit == layout.unit && said.selectedBy.empty();
}

/// Returns the first difference from the program's layout; empty: none.
std::string differenceOf(const DbcMessage& message, const FrameLayout& layout)
{
    std::string name(layout.name);
    if (message.name != name || message.extended) return name;
    for (const SignalLayout& signal : layout.payload) {
        const auto said = std::find_if(message.payload.begin(), message.payload.end(),
                                       [&](const DbcSignal& s) { return s.name == signal.name; });
        if (said == message.payload.end() || !isTheSame(*said, signal))
            return fmt::format("{}.{}", name, signal.name);
    }
    return {};
}

}  // namespace

Result<std::vector<DbcMessage>> readProtocolDbc(const std::string& path)
{
    Result<DbcFile> file = readDbc(path);
    if (!file) return file.error();
    std::vector<DbcMessage> ordered;
    for (const FrameLayout& layout : frameLayouts()) {
        const auto found =
            std::find_if(file->messages.begin(), file->messages.end(),
                         [&](const DbcMessage& m) { return m.id == layout.id && !m.extended; });
        const std::string difference =
            found == file->messages.end() ? std::string(layout.name) : differenceOf(*found, layout);
        if (!difference.empty())
            return fileError(
                path, Message(TR_NOOP("core", "is not of this program: %1 is another or missing; "
                                              "install the file that came with the program"),
                              difference));
        ordered.push_back(std::move(*found));
    }
    return ordered;
}

}  // namespace terratact
