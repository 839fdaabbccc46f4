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

std::string expectedNumber(TomlRange range)
{
    return "expected a number from " + numberText(range.least) + " to " + numberText(range.most);
}

}  // namespace

std::string tomlLine(const toml::node& node)
{
    return "line " + std::to_string(node.source().begin.line);
}

double tomlNumber(const toml::node& node, const std::string& key, TomlRange range)
{
    const std::string place = tomlLine(node) + ": " + key;
    if (!node.is_number()) throw TomlRefused{place + " is not a number, " + expectedNumber(range)};
    const double value = node.value<double>().value_or(std::nan(""));
    if (value >= range.least && value <= range.most) return value;
    throw TomlRefused{place + " is " + numberText(value) + ", " + expectedNumber(range)};
}

const toml::array& tomlArray(const toml::node& node, const std::string& key, std::size_t least,
                             std::size_t most)
{
    const toml::array* const array = node.as_array();
    if (array && array->size() >= least && array->size() <= most) return *array;
    const std::string count = least == most ? std::to_string(least)
                                            : std::to_string(least) + " to " + std::to_string(most);
    throw TomlRefused{tomlLine(node) + ": " + key + " is not an array of " + count + " elements"};
}

TomlSection::TomlSection(const toml::table& table, std::string prefix)
    : table_(table), prefix_(std::move(prefix))
{
}

const toml::node& TomlSection::node(std::string_view key)
{
    known_.emplace(key);
    const toml::node* const found = table_.get(key);
    if (!found) throw TomlRefused{"the key " + path(key) + " is missing"};
    return *found;
}

double TomlSection::number(std::string_view key, TomlRange range)
{
    return tomlNumber(node(key), path(key), range);
}

std::string TomlSection::text(std::string_view key)
{
    const auto* const value = node(key).as_string();
    if (!value || !isReadableName(value->get()))
        throw TomlRefused{
            tomlLine(node(key)) + ": " + path(key)
            + " is not a text of 1 to 100 characters, none of them a control character"};
    return value->get();
}

std::size_t TomlSection::choice(std::string_view key,
                                std::initializer_list<std::string_view> choices)
{
    const std::string value = text(key);
    const auto* const found = std::find(choices.begin(), choices.end(), value);
    if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
    std::string list;
    for (const std::string_view name : choices)
        list.append(list.empty() ? "" : " or ").append("\"").append(name).append("\"");
    throw TomlRefused{tomlLine(node(key)) + ": " + path(key) + " is " + shown(value) + ", expected "
                      + list};
}

const toml::table& TomlSection::table(std::string_view key)
{
    const toml::table* const table = node(key).as_table();
    if (!table) throw TomlRefused{tomlLine(node(key)) + ": " + path(key) + " is not a table"};
    return *table;
}

void TomlSection::refuseUnknown() const
{
    for (const auto& [key, value] : table_)
        if (!known_.contains(std::string(key.str())))
            throw TomlRefused{tomlLine(value) + ": " + shown(path(key.str()))
                              + " is not a known key"};
}

Status readToml(const std::string& name, const std::string& text,
                const std::function<void(TomlSection&)>& read)
{
    if (text.empty()) return fileError(name, "is empty");
    if (text.size() > kMaxBytes)
        return fileError(name,
                         "is larger than the " + std::to_string(kMaxBytes) + " bytes allowed here");
    if (nestingDepth(text) > kDeepest)
        return fileError(name, "nests deeper than " + std::to_string(kDeepest) + " levels");
    try {
        const toml::table table = toml::parse(std::string_view(text));
        TomlSection file(table, "");
        read(file);
        file.refuseUnknown();
        return Done{};
    } catch (const toml::parse_error& error) {
        return fileError(name, "line " + std::to_string(error.source().begin.line)
                                   + ": is not TOML: " + std::string(error.description()));
    } catch (const TomlRefused& refused) {
        return fileError(name, refused.cause);
    }
}

Status readTomlFile(const std::string& path, const std::function<void(TomlSection&)>& read)
{
    const Result<std::string> text = readFile(path, kMaxBytes);
    if (!text) return text.error();
    return readToml(path, *text, read);
}

}  // namespace terratact
