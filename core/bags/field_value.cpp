#include "core/bags/field_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/text.h"

namespace terratact {
namespace {

using FieldKind = FieldValue::Kind;

/// A value, or one element of an array of numbers or texts.
struct FieldPlace {
    const FieldValue* value = nullptr;
    std::optional<std::size_t> element{};
};

constexpr std::array<std::string_view, 3> kNamesOfElements{"child_frame_id", "name", "frame_id"};

/// Returns the text that names an element of an array of messages.
std::optional<std::string_view> nameOfElement(const FieldValue& item)
{
    for (const std::string_view wanted : kNamesOfElements)
        if (const FieldValue* const found = item.member(wanted);
            found && found->kind == FieldKind::Text)
            return found->text;
    if (const FieldValue* const header = item.member("header"))
        if (const FieldValue* const frame = header->member("frame_id");
            frame && frame->kind == FieldKind::Text)
            return frame->text;
    return std::nullopt;
}

std::size_t elementsOf(const FieldValue& value)
{
    switch (value.kind) {
    case FieldKind::Numbers: return value.numbers.size();
    case FieldKind::Texts: return value.texts.size();
    case FieldKind::Items: return value.parts.size();
    default: return 0;
    }
}

/// Returns the names of an array's elements: the texts `name` beside it. Null if there are none.
const std::vector<std::string>* namesBeside(const FieldValue* parent, const FieldValue& array)
{
    const FieldValue* const names = parent ? parent->member("name") : nullptr;
    const bool fits = names && names != &array && names->kind == FieldKind::Texts
                   && names->texts.size() == elementsOf(array);
    return fits ? &names->texts : nullptr;
}

std::optional<std::size_t> elementOf(const FieldValue* parent, const FieldValue& array,
                                     std::string_view key)
{
    const std::size_t count = elementsOf(array);
    if (const auto index = integerFrom<std::size_t>(key))
        return *index < count ? index : std::nullopt;
    const std::vector<std::string>* const names =
        array.kind == FieldKind::Texts ? &array.texts : namesBeside(parent, array);
    if (names) {
        const auto found = std::ranges::find(*names, key);
        if (found != names->end()) return static_cast<std::size_t>(found - names->begin());
    }
    if (array.kind == FieldKind::Items)
        for (std::size_t i = 0; i < count; ++i)
            if (nameOfElement(array.parts[i]) == key) return i;
    return std::nullopt;
}

FieldPlace placeIn(const FieldValue* parent, const FieldValue& value, std::string_view path);

FieldPlace placeOfElement(const FieldValue* parent, const FieldValue& value, std::string_view path)
{
    const std::size_t close = path.find(']');
    if (close == std::string_view::npos) return {};
    const auto element = elementOf(parent, value, path.substr(1, close - 1));
    if (!element) return {};
    const std::string_view rest = path.substr(close + 1);
    if (value.kind == FieldKind::Items) return placeIn(&value, value.parts[*element], rest);
    return rest.empty() ? FieldPlace{&value, element} : FieldPlace{};
}

FieldPlace placeIn(const FieldValue* parent, const FieldValue& value, std::string_view path)
{
    if (path.empty()) return {&value, std::nullopt};
    if (path.front() == '[') return placeOfElement(parent, value, path);
    if (path.front() == '.') path.remove_prefix(1);
    if (const FieldValue* const whole = value.member(path)) return {whole, std::nullopt};
    const std::size_t end = path.find_first_of(".[");
    if (end == std::string_view::npos) return {};
    const FieldValue* const next = value.member(path.substr(0, end));
    return next ? placeIn(&value, *next, path.substr(end)) : FieldPlace{};
}

using NumberVisitor = std::function<void(const std::string&, double)>;

void visitNumbers(const FieldValue* parent, const FieldValue& value, const std::string& path,
                  std::size_t most, const NumberVisitor& visit)
{
    const auto ofElement = [&](std::size_t i) {
        const auto* const names = namesBeside(parent, value);
        std::optional<std::string_view> named;
        if (names) named = (*names)[i];
        if (value.kind == FieldKind::Items) named = nameOfElement(value.parts[i]);
        return path + '[' + (named ? std::string(*named) : std::to_string(i)) + ']';
    };
    switch (value.kind) {
    case FieldKind::Number: return visit(path, value.number);
    case FieldKind::Numbers:
        for (std::size_t i = 0; i < std::min(most, value.numbers.size()); ++i)
            visit(ofElement(i), value.numbers[i]);
        return;
    case FieldKind::Items:
        for (std::size_t i = 0; i < std::min(most, value.parts.size()); ++i)
            visitNumbers(&value, value.parts[i], ofElement(i), most, visit);
        return;
    case FieldKind::Members:
        for (const FieldValue& part : value.parts)
            visitNumbers(&value, part, path.empty() ? part.name : path + '.' + part.name, most,
                         visit);
        return;
    default: return;
    }
}

}  // namespace

FieldValue FieldValue::of(double value)
{
    FieldValue field;
    field.kind = Kind::Number;
    field.number = value;
    return field;
}

FieldValue FieldValue::of(std::string value)
{
    FieldValue field;
    field.kind = Kind::Text;
    field.text = std::move(value);
    return field;
}

const FieldValue* FieldValue::member(std::string_view wanted) const
{
    if (kind != Kind::Members) return nullptr;
    const auto found = std::ranges::find(parts, wanted, &FieldValue::name);
    return found == parts.end() ? nullptr : &*found;
}

std::optional<double> numberAt(const FieldValue& message, std::string_view path)
{
    const FieldPlace place = placeIn(nullptr, message, path);
    if (!place.value) return std::nullopt;
    if (place.element)
        return place.value->kind == FieldKind::Numbers
                 ? std::optional(place.value->numbers[*place.element])
                 : std::nullopt;
    if (place.value->kind == FieldKind::Number) return place.value->number;
    if (place.value->kind == FieldKind::Nothing) return std::numeric_limits<double>::quiet_NaN();
    return std::nullopt;
}

std::optional<std::string> textAt(const FieldValue& message, std::string_view path)
{
    const FieldPlace place = placeIn(nullptr, message, path);
    if (!place.value) return std::nullopt;
    if (place.element)
        return place.value->kind == FieldKind::Texts
                 ? std::optional(place.value->texts[*place.element])
                 : std::nullopt;
    return place.value->kind == FieldKind::Text ? std::optional(place.value->text) : std::nullopt;
}

bool hasField(const FieldValue& message, std::string_view path)
{
    return placeIn(nullptr, message, path).value != nullptr;
}

std::optional<std::int64_t> stampOf(const FieldValue& message)
{
    const FieldValue* const header = message.member("header");
    const FieldValue* const stamp = header ? header->member("stamp") : nullptr;
    if (!stamp) return std::nullopt;
    const auto seconds = numberAt(*stamp, "sec");
    auto rest = numberAt(*stamp, "nanosec");
    if (!rest) rest = numberAt(*stamp, "nsec");
    if (!seconds || !rest || !(std::abs(*seconds) < 9e9) || !(std::abs(*rest) < 9e9))
        return std::nullopt;
    const auto time =
        static_cast<std::int64_t>(*seconds) * 1'000'000'000 + static_cast<std::int64_t>(*rest);
    return time == 0 ? std::nullopt : std::optional(time);
}

void eachNumber(const FieldValue& message, std::size_t most, const NumberVisitor& visit)
{
    visitNumbers(nullptr, message, "", most, visit);
}

}  // namespace terratact
