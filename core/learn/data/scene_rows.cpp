#include "core/learn/data/scene_rows.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/text.h"
#include "core/store/csv_field.h"
#include "core/store/csv_text.h"

namespace terratact {
namespace {

// Meaning of a column: one of these, or the n-th number, counted from there.
constexpr int kUnknown = -1;
constexpr int kRun = 0;
constexpr int kTime = 1;
constexpr int kKind = 2;
constexpr int kFirstNumber = 3;
constexpr std::size_t kMaxColumns = 200;
constexpr std::size_t kMaxRunNameLength = 4096;  ///< bytes

std::size_t index(int slot)
{
    return static_cast<std::size_t>(slot - kFirstNumber);
}

/// Names, units and ranges of all columns of a kind of scenes file.
class Slots {
public:
    explicit Slots(const SceneColumns& columns) : columns_(columns) {}

    int count() const { return kFirstNumber + static_cast<int>(columns_.columns.size()); }
    bool hasKinds() const { return !columns_.kinds.empty(); }
    /// Returns false for the column kind in a file that has no kinds.
    bool isUsed(int slot) const { return slot != kKind || hasKinds(); }
    int required() const { return kFirstNumber + static_cast<int>(columns_.required); }
    bool mayBeEmpty(int slot) const
    {
        return slot >= kFirstNumber + static_cast<int>(columns_.neverEmpty);
    }
    std::string_view name(int slot) const
    {
        if (slot == kRun) return "run";
        if (slot == kTime) return "t_s";
        if (slot == kKind) return "kind";
        return columns_.columns[index(slot)].name;
    }
    std::string unit(int slot) const
    {
        if (slot == kRun || slot == kKind) return {};
        if (slot == kTime) return "s";
        return std::string(columns_.columns[index(slot)].unit);
    }
    std::vector<std::string_view> names() const
    {
        std::vector<std::string_view> all;
        for (int slot = 0; slot < count(); ++slot)
            if (isUsed(slot)) all.push_back(name(slot));
        return all;
    }
    int named(std::string_view name) const
    {
        for (int slot = 0; slot < count(); ++slot)
            if (isUsed(slot) && this->name(slot) == name) return slot;
        return kUnknown;
    }
    /// Returns why a value is refused in a column; empty if it is accepted. An infinity is beyond
    /// every range.
    Message refusal(int slot, double value) const
    {
        if (slot == kTime)
            return std::isfinite(value) ? Message()
                                        : Message(TR_NOOP("core", "%1 is not finite"), "t_s");
        const Column& column = columns_.columns[index(slot)];
        return column.holds(value) ? Message() : column.refusal(value);
    }
    /// Returns true for a misspelt height column: it must not be ignored as "unknown".
    bool looksLikeHeight(std::string_view name) const
    {
        constexpr std::string_view kNumberBegins = "+-0123456789";
        return std::ranges::any_of(columns_.heightPrefixes, [&](std::string_view prefix) {
            return name.size() > prefix.size() && name.starts_with(prefix)
                && kNumberBegins.find(name[prefix.size()]) != std::string_view::npos;
        });
    }
    std::string_view heightColumns() const { return columns_.heightColumns; }
    const std::vector<std::string_view>& kinds() const { return columns_.kinds; }

private:
    const SceneColumns& columns_;
};

bool isRunName(std::string_view text)
{
    return !text.empty() && text.size() <= kMaxRunNameLength
        && std::none_of(text.begin(), text.end(),
                        [](char c) { return isControl(c) || c == ',' || c == '"'; });
}

/// Meaning of every column of the file.
struct Layout {
    std::vector<int> slots;
    std::vector<Message> notices;
};

/// Returns true if the line behind its first field, the run, holds numbers: the header is missing.
bool hasNumbersOnly(const std::vector<std::string_view>& fields)
{
    return fields.size() > 1
        && std::all_of(fields.begin() + 1, fields.end(), [](std::string_view field) {
               return field.empty() || csvNumber(withoutBlanks(field), true);
           });
}

Result<Layout> layoutOf(CsvReader& csv, const Slots& known)
{
    if (csv.fields().size() > kMaxColumns)
        return csv.error(Message(TR_NOOP("core", "has more than %1 columns"), kMaxColumns));
    Layout layout{{}, csv.adoptNames(known.names())};
    std::vector<std::string> units;
    std::string unknown;
    for (const std::string_view name : csv.fields()) {
        const int slot = known.named(name);
        units.push_back(slot == kUnknown ? "" : known.unit(slot));
        if (slot == kUnknown && known.looksLikeHeight(name))
            return csv.error(Message(TR_NOOP("core", "%1 is not a height column, expected %2"),
                                     shown(name), known.heightColumns()));
        if (slot != kUnknown && std::count(layout.slots.begin(), layout.slots.end(), slot) > 0)
            return csv.error(Message(TR_NOOP("core", "the column %1 appears twice"), name));
        layout.slots.push_back(slot);
        if (slot != kUnknown || name.empty()) continue;
        layout.notices.emplace_back(
            TR_NOOP("core", "%1: the column %2 is not known and was left out"), csv.name(),
            shown(name));
        unknown += (unknown.empty() ? "" : ", ") + shown(name);
    }
    if (hasNumbersOnly(csv.fields()))
        return csv.error(TR_NOOP("core", "holds numbers, expected the names of the columns: add "
                                         "that line at the top, as docs/files.md shows it"));
    for (int slot = 0; slot < known.required(); ++slot)
        if (known.isUsed(slot) && std::count(layout.slots.begin(), layout.slots.end(), slot) == 0)
            return csv.error(
                unknown.empty()
                    ? Message(TR_NOOP("core", "the column %1 is missing"), known.name(slot))
                    : Message(TR_NOOP("core", "the column %1 is missing; not known: %2"),
                              known.name(slot), unknown));
    csv.useAsHeader(std::move(units));
    return layout;
}

Status readRun(const CsvReader& csv, std::size_t field, SceneFileRow& row)
{
    const std::string text = csvText(csv.fields()[field]);
    if (text.empty()) return csv.error(Message(TR_NOOP("core", "%1 is empty"), "run"));
    if (text.size() > kMaxRunNameLength)
        return csv.error(Message(TR_NOOP("core", "run is longer than %1 bytes: %2"),
                                 kMaxRunNameLength, shown(text)));
    if (!isUtf8(text))
        return csv.error(
            Message(TR_NOOP("core", "run is not text in UTF-8: %1: save the file as CSV in UTF-8"),
                    shown(text)));
    if (!isRunName(text))
        return csv.error(Message(
            TR_NOOP("core",
                    "run is not a name: %1: it holds a comma, a quote or a control character"),
            shown(text)));
    row.run = text;
    return Done{};
}

Status readKind(const CsvReader& csv, std::size_t field, const std::vector<std::string_view>& kinds,
                SceneFileRow& row)
{
    const std::string_view text = csv.fields()[field];
    const auto kind = std::ranges::find(kinds, text);
    if (kind == kinds.end()) {
        std::string expected;
        for (const std::string_view word : kinds)
            expected += (expected.empty() ? "" : " or ") + std::string(word);
        return csv.error("kind is " + shown(text) + ", expected " + expected);
    }
    row.kind = static_cast<std::size_t>(kind - kinds.begin());
    return Done{};
}

Status readField(CsvReader& csv, std::size_t field, int slot, const Slots& known, SceneFileRow& row)
{
    if (slot == kUnknown || (known.mayBeEmpty(slot) && csv.isMissing(field))) return Done{};
    if (slot == kRun) return readRun(csv, field, row);
    if (slot == kKind) return readKind(csv, field, known.kinds(), row);
    const Result<double> value = csv.number(field, known.name(slot));
    if (!value) return value.error();
    if (const Message cause = known.refusal(slot, *value); !cause.empty()) return csv.error(cause);
    if (slot == kTime)
        row.time = *value;
    else
        row.values[index(slot)] = *value;
    return Done{};
}

Status readRow(CsvReader& csv, const Layout& layout, const Slots& known, SceneFileRow& row)
{
    std::ranges::fill(row.values, std::nullopt);
    for (std::size_t i = 0; i < layout.slots.size(); ++i)
        if (Status status = readField(csv, i, layout.slots[i], known, row); !status) return status;
    return Done{};
}

Message tooMany(const Slots& known, std::size_t most)
{
    if (known.hasKinds())
        return Message::verbatim("is one line more than the " + std::to_string(most)
                                 + " allowed in a file");
    return {TR_NOOP("core", "is one scene more than the %1 allowed in a file"), most};
}

/// Returns one number as text. Throws for what the reader would refuse.
std::string field(const std::optional<double>& value, int slot, const Slots& known)
{
    if (!value) return "";
    if (const Message cause = known.refusal(slot, *value); !cause.empty())
        throw std::invalid_argument("writeScenes: " + cause.english());
    return numberText(*value);
}

}  // namespace

Result<std::vector<Message>> readSceneRows(CsvReader& csv, const SceneColumns& columns,
                                           const std::function<Status(const SceneFileRow&)>& add)
{
    const Slots known(columns);
    Result<Layout> layout = layoutOf(csv, known);
    if (!layout) return layout.error();
    SceneFileRow row;
    row.values.resize(columns.columns.size());
    std::size_t count = 0;
    for (;; ++count) {
        const Result<bool> more = csv.next();
        if (!more) return more.error();
        if (!*more) break;
        if (count == columns.most) return csv.error(tooMany(known, columns.most));
        if (const Status status = readRow(csv, *layout, known, row); !status) return status.error();
        if (const Status status = add(row); !status) return status.error();
    }
    if (count == 0)
        return known.hasKinds()
                 ? csv.error("is the header, and no line follows it")
                 : csv.error(TR_NOOP("core", "is the header, and no scene follows it"));
    if (csv.lacksLineEnd())
        layout->notices.emplace_back(
            TR_NOOP("core", "%1: the last line has no line end; it was read as it is"), csv.name());
    return std::move(layout->notices);
}

std::string sceneText(SceneColumns columns, std::size_t count,
                      const std::function<SceneFileRow(std::size_t)>& rowAt)
{
    std::vector<bool> used(columns.columns.size(), false);
    std::fill_n(used.begin(), columns.written, true);
    for (std::size_t k = 0; k < count; ++k) {
        const SceneFileRow row = rowAt(k);
        for (std::size_t i = 0; i < used.size(); ++i)
            used[i] = used[i] || row.values[i].has_value();
    }
    const auto withoutUnused = [&](auto& values) {
        std::size_t i = 0;
        std::erase_if(values, [&](const auto&) { return !used[i++]; });
    };
    withoutUnused(columns.columns);
    std::string text = sceneHeader(columns);
    for (std::size_t k = 0; k < count; ++k) {
        SceneFileRow row = rowAt(k);
        withoutUnused(row.values);
        text += sceneLine(columns, row);
    }
    return text;
}

std::string sceneHeader(const SceneColumns& columns)
{
    const Slots known(columns);
    std::vector<CsvValue> fields;
    fields.reserve(static_cast<std::size_t>(known.count()));
    for (int slot = 0; slot < known.count(); ++slot)
        if (known.isUsed(slot)) fields.emplace_back(known.name(slot));
    return csvLine(fields);
}

std::string sceneLine(const SceneColumns& columns, const SceneFileRow& row)
{
    const Slots known(columns);
    if (!isRunName(row.run))
        throw std::invalid_argument("writeScenes: run is not a name: " + shown(row.run));
    std::vector<CsvValue> fields{row.run, field(row.time, kTime, known)};
    if (known.hasKinds()) fields.emplace_back(columns.kinds.at(row.kind));
    int slot = kFirstNumber;
    for (const std::optional<double>& value : row.values)
        fields.emplace_back(field(value, slot++, known));
    return csvLine(fields);
}

}  // namespace terratact
