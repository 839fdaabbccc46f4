#include "core/robot/toml_section.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/robot/toml_depth.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} * 1024;
constexpr int kDeepest = 16;

}  // namespace

Message tomlLine(const toml::node& node)
{
    return {TR_NOOP("core", "line %1"), node.source().begin.line};
}

double tomlNumber(const toml::node& node, const std::string& key, TomlRange range)
{
    if (!node.is_number())
        throw TomlRefused{
            Message(TR_NOOP("core", "%1: %2 is not a number, expected a number from %3 to %4"),
                    tomlLine(node), key, range.least, range.most)};
    const double value = node.value<double>().value_or(std::nan(""));
    if (value >= range.least && value <= range.most) return value;
    throw TomlRefused{Message(TR_NOOP("core", "%1: %2 is %3, expected a number from %4 to %5"),
                              tomlLine(node), key, value, range.least, range.most)};
}

const toml::array& tomlArray(const toml::node& node, std::string_view key, std::size_t least,
                             std::size_t most)
{
    const toml::array* const array = node.as_array();
    if (array && array->size() >= least && array->size() <= most) return *array;
    if (least == most)
        throw TomlRefused{Message(TR_NOOP("core", "%1: %2 is not an array of %3 elements"),
                                  tomlLine(node), key, least)};
    throw TomlRefused{Message(TR_NOOP("core", "%1: %2 is not an array of %3 to %4 elements"),
                              tomlLine(node), key, least, most)};
}

TomlSection::TomlSection(const toml::table& table, std::string prefix)
    : table_(table), prefix_(std::move(prefix))
{
}

const toml::node& TomlSection::node(std::string_view key)
{
    known_.emplace(key);
    const toml::node* const found = table_.get(key);
    if (found) return *found;
    if (prefix_.empty())
        throw TomlRefused{Message(TR_NOOP("core", "the key %1 is missing"), path(key))};
    throw TomlRefused{
        Message(TR_NOOP("core", "%1: the key %2 is missing"), tomlLine(table_), path(key))};
}

double TomlSection::number(std::string_view key, TomlRange range)
{
    return tomlNumber(node(key), path(key), range);
}

std::string TomlSection::text(std::string_view key)
{
    const auto* const value = node(key).as_string();
    if (!value || !isReadableName(value->get()))
        throw TomlRefused{Message(
            TR_NOOP(
                "core",
                "%1: %2 is not a text of 1 to 100 characters, none of them a control character"),
            tomlLine(node(key)), path(key))};
    return value->get();
}

std::size_t TomlSection::choice(std::string_view key,
                                std::initializer_list<std::string_view> choices)
{
    const std::string value = text(key);
    const auto* const found = std::find(choices.begin(), choices.end(), value);
    if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
    Message list;
    for (const std::string_view name : choices) {
        const Message quoted = Message::verbatim('"' + std::string(name) + '"');
        list = list.empty() ? quoted : Message(TR_NOOP("core", "%1 or %2"), list, quoted);
    }
    throw TomlRefused{Message(TR_NOOP("core", "%1: %2 is %3, expected %4"), tomlLine(node(key)),
                              path(key), shown(value), list)};
}

const toml::table& TomlSection::table(std::string_view key)
{
    const toml::table* const table = node(key).as_table();
    if (!table)
        throw TomlRefused{
            Message(TR_NOOP("core", "%1: %2 is not a table"), tomlLine(node(key)), path(key))};
    return *table;
}

void TomlSection::refuseUnknown() const
{
    for (const auto& [key, value] : table_)
        if (!known_.contains(std::string(key.str())))
            throw TomlRefused{Message(TR_NOOP("core", "%1: %2 is not a known key"), tomlLine(value),
                                      shown(path(key.str())))};
}

Status readToml(const std::string& name, const std::string& text,
                const std::function<void(TomlSection&)>& read)
{
    if (text.empty()) return fileError(name, TR_NOOP("core", "is empty"));
    if (text.size() > kMaxBytes)
        return fileError(
            name, Message(TR_NOOP("core", "is larger than the %1 bytes allowed here"), kMaxBytes));
    if (nestingDepth(text) > kDeepest)
        return fileError(name, Message(TR_NOOP("core", "nests deeper than %1 levels"), kDeepest));
    try {
        const toml::table table = toml::parse(std::string_view(text));
        TomlSection file(table, "");
        read(file);
        file.refuseUnknown();
        return Done{};
    } catch (const toml::parse_error& error) {
        return fileError(name, Message(TR_NOOP("core", "line %1: is not TOML: %2"),
                                       error.source().begin.line, error.description()));
    } catch (const TomlRefused& refused) {
        return fileError(name, refused.message());
    }
}

Status readTomlFile(const std::string& path, const std::function<void(TomlSection&)>& read)
{
    const Result<std::string> text = readFile(path, kMaxBytes);
    if (!text) return text.error();
    return readToml(path, *text, read);
}

}  // namespace terratact
