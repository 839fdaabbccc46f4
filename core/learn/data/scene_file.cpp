#include "core/learn/data/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "core/base/text.h"
#include "core/learn/data/columns.h"
#include "core/store/csv_text.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/store/sha256.h"
#include "core/wire/dbc/dbc_text.h"

namespace terratact {
namespace {

// Meaning of a column: one of these, or the n-th feature or height, counted from there.
constexpr int kUnknown = -1;
constexpr int kRun = 0;
constexpr int kTime = 1;
constexpr int kFirstFeature = 2;
constexpr int kFirstHeight = kFirstFeature + static_cast<int>(kFeatures);
constexpr int kSlots = kFirstHeight + kBins;
constexpr int kNeverEmpty = kFirstFeature + 3;  ///< run, time, pitch and flipper angles
constexpr std::size_t kMaxColumns = 200;
constexpr std::size_t kMaxRunNameLength = 4096;  ///< bytes

std::size_t index(int slot, int first)
{
    return static_cast<std::size_t>(slot - first);
}

std::string_view slotName(int slot)
{
    if (slot == kRun) return "run";
    if (slot == kTime) return "t_s";
    if (slot < kFirstHeight) return featureColumns()[index(slot, kFirstFeature)].name;
    return heightColumns()[index(slot, kFirstHeight)].name;
}

std::string unitOf(int slot)
{
    if (slot == kRun) return {};
    if (slot == kTime) return "s";
    return std::string((slot < kFirstHeight ? featureColumns()[index(slot, kFirstFeature)]
                                            : heightColumns()[index(slot, kFirstHeight)])
                           .unit);
}

int slotNamed(std::string_view name)
{
    for (int slot = 0; slot < kSlots; ++slot)
        if (slotName(slot) == name) return slot;
    return kUnknown;
}

/// Returns true for a misspelt height column: it must not be ignored as "unknown".
bool looksLikeHeight(std::string_view name)
{
    constexpr std::string_view kNumberBegins = "+-0123456789";
    return name.size() > 2 && name.starts_with("h_")
        && kNumberBegins.find(name[2]) != std::string_view::npos;
}

bool isRunName(std::string_view text)
{
    return !text.empty() && text.size() <= kMaxRunNameLength
        && std::none_of(text.begin(), text.end(),
                        [](char c) { return isControl(c) || c == ',' || c == '"'; });
}

/// Returns why a value is refused in a column; empty if it is accepted. An infinity is beyond every
/// range.
Message refusal(int slot, double value)
{
    if (slot == kTime)
        return std::isfinite(value) ? Message()
                                    : Message(TR_NOOP("core", "%1 is not finite"), "t_s");
    const Column& column = slot < kFirstHeight ? featureColumns()[index(slot, kFirstFeature)]
                                               : heightColumns()[index(slot, kFirstHeight)];
    return column.holds(value) ? Message() : column.refusal(value);
}

/// Meaning of every column of the file.
struct Layout {
    std::vector<int> slots;
    std::vector<Message> notices;
};

Result<Layout> layoutOf(CsvReader& csv)
{
    if (csv.fields().size() > kMaxColumns)
        return csv.error(Message(TR_NOOP("core", "has more than %1 columns"), kMaxColumns));
    Layout layout;
    std::vector<std::string> units;
    std::string unknown;
    for (const std::string_view name : csv.fields()) {
        const int slot = slotNamed(name);
        units.push_back(slot == kUnknown ? "" : unitOf(slot));
        if (slot == kUnknown && looksLikeHeight(name))
            return csv.error(Message(TR_NOOP("core", "%1 is not a height column, expected %2"),
                                     shown(name), "h_-0.3_m … h_+0.0_m … h_+0.7_m"));
        if (slot != kUnknown && std::count(layout.slots.begin(), layout.slots.end(), slot) > 0)
            return csv.error(Message(TR_NOOP("core", "the column %1 appears twice"), name));
        layout.slots.push_back(slot);
        if (slot != kUnknown || name.empty()) continue;
        layout.notices.emplace_back(
            TR_NOOP("core", "%1: the column %2 is not known and was left out"), csv.name(),
            shown(name));
        unknown += (unknown.empty() ? "" : ", ") + shown(name);
    }
    for (int slot = 0; slot < kFirstHeight; ++slot)
        if (std::count(layout.slots.begin(), layout.slots.end(), slot) == 0)
            return csv.error(
                unknown.empty()
                    ? Message(TR_NOOP("core", "the column %1 is missing"), slotName(slot))
                    : Message(TR_NOOP("core", "the column %1 is missing; not known: %2"),
                              slotName(slot), unknown));
    csv.useAsHeader(std::move(units));
    return layout;
}

/// A scene whose fields are being read.
struct Draft {
    std::string run;
    double time = 0.0;
    FeatureValues features{};
    OptionalHeights truth{};

    void set(int slot, double value)
    {
        if (slot == kTime)
            time = value;
        else if (slot < kFirstHeight)
            features[index(slot, kFirstFeature)] = value;
        else
            truth[index(slot, kFirstHeight)] = value;
    }
};

Status readField(CsvReader& csv, std::size_t field, int slot, Draft& draft)
{
    if (slot == kUnknown || (slot >= kNeverEmpty && csv.isMissing(field))) return Done{};
    if (slot == kRun) {
        const std::string_view text = csvText(csv.fields()[field]);
        if (text.empty()) return csv.error(Message(TR_NOOP("core", "%1 is empty"), "run"));
        if (text.size() > kMaxRunNameLength)
            return csv.error(Message(TR_NOOP("core", "run is longer than %1 bytes: %2"),
                                     kMaxRunNameLength, shown(text)));
        if (!isUtf8(text))
            return csv.error(Message(
                TR_NOOP("core", "run is not text in UTF-8: %1: save the file as CSV in UTF-8"),
                shown(text)));
        if (!isRunName(text))
            return csv.error(Message(
                TR_NOOP("core",
                        "run is not a name: %1: it holds a comma, a quote or a control character"),
                shown(text)));
        draft.run = text;
        return Done{};
    }
    const Result<double> value = csv.number(field, slotName(slot));
    if (!value) return value.error();
    if (const Message cause = refusal(slot, *value); !cause.empty()) return csv.error(cause);
    draft.set(slot, *value);
    return Done{};
}

Result<Scene> readScene(CsvReader& csv, const Layout& layout)
{
    Draft draft;
    for (std::size_t i = 0; i < layout.slots.size(); ++i)
        if (const Status status = readField(csv, i, layout.slots[i], draft); !status)
            return status.error();
    return Scene{std::move(draft.run), draft.time, proprioception(draft.features), draft.truth};
}

std::string header()
{
    std::vector<CsvValue> fields;
    fields.reserve(kSlots);
    for (int slot = 0; slot < kSlots; ++slot) fields.emplace_back(slotName(slot));
    return csvLine(fields);
}

/// Returns one field of a scene as text. Throws for what the reader would refuse.
std::string field(const std::optional<double>& value, int slot)
{
    if (!value) return "";
    if (const Message cause = refusal(slot, *value); !cause.empty())
        throw std::invalid_argument("writeScenes: " + cause.english());
    return numberText(*value);
}

std::string lineOf(const Scene& scene)
{
    if (!isRunName(scene.run))
        throw std::invalid_argument("writeScenes: run is not a name: " + shown(scene.run));
    std::vector<CsvValue> fields{scene.run, field(scene.time, kTime)};
    int slot = kFirstFeature;
    for (const std::optional<double>& value : featureValues(scene.s))
        fields.emplace_back(field(value, slot++));
    for (const std::optional<double>& value : scene.truth)
        fields.emplace_back(field(value, slot++));
    return csvLine(fields);
}

}  // namespace

Result<SceneFile> readScenes(const std::string& path)
{
    Result<std::string> text = CsvReader::textOf(path);
    if (!text) return text.error();
    std::string hash = sha256Hex(*text);
    Result<CsvReader> csv = CsvReader::over(path, *std::move(text));
    if (!csv) return csv.error();
    Result<SceneFile> file = readScenes(*std::move(csv));
    if (file) file->hash = std::move(hash);
    return file;
}

Result<SceneFile> readScenes(CsvReader csv)
{
    if (const Result<bool> first = csv.next(); !first) return first.error();
    Result<Layout> layout = layoutOf(csv);
    if (!layout) return layout.error();
    SceneFile file;
    file.notices = std::move(layout->notices);
    for (;;) {
        const Result<bool> more = csv.next();
        if (!more) return more.error();
        if (!*more) break;
        if (file.scenes.size() == kMaxScenes)
            return csv.error(Message(
                TR_NOOP("core", "is one scene more than the %1 allowed in a file"), kMaxScenes));
        Result<Scene> scene = readScene(csv, *layout);
        if (!scene) return scene.error();
        file.scenes.push_back(*std::move(scene));
    }
    if (file.scenes.empty())
        return csv.error(TR_NOOP("core", "is the header, and no scene follows it"));
    if (csv.lacksLineEnd())
        file.notices.emplace_back(
            TR_NOOP("core", "%1: the last line has no line end; it was read as it is"), csv.name());
    return file;
}

Result<SceneFile> readScenesWithTruth(const std::string& path)
{
    auto file = readScenes(path);
    if (!file) return file;
    const std::size_t left = std::erase_if(file->scenes, [](const Scene& scene) {
        return std::ranges::none_of(scene.truth, [](const auto& h) { return h.has_value(); });
    });
    if (file->scenes.empty())
        return fileError(
            path, TR_NOOP("core", "no scene has a known height (columns h_-0.3_m … h_+0.7_m)"));
    if (left > 0)
        file->notices.emplace_back(TR_NOOP("core", "%1 scenes without any known height left out"),
                                   left);
    return file;
}

std::string scenesText(const std::vector<Scene>& scenes)
{
    if (scenes.size() > kMaxScenes)
        throw std::invalid_argument("writeScenes: more than " + std::to_string(kMaxScenes)
                                    + " scenes, which is what a file may hold");
    std::string content = header();
    for (const Scene& scene : scenes) content += lineOf(scene);
    return content;
}

Status writeScenes(const std::string& path, const std::vector<Scene>& scenes)
{
    return writeFileAtomically(path, scenesText(scenes));
}

}  // namespace terratact
