#include "core/eval/groups.h"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <variant>

#include "core/file_read.h"
#include "core/text.h"

namespace terratact {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} * 1024 * 1024;
constexpr std::size_t kMostFields = 1000, kLongestField = 4096;

/// Groups by name, labels by first appearance.
std::vector<GroupSummary> summaries(const std::map<std::string, std::vector<BinError>>& groups)
{
    std::vector<GroupSummary> result;
    for (const auto& [group, errors] : groups)
        for (const std::string& label : labelsOf(errors)) {
            const auto own = errorsOf(label, errors);
            std::set<std::size_t> scenes;
            for (const BinError& e : own) scenes.insert(e.scene);
            result.push_back({group, label, scenes.size(), statistics(own)});
        }
    return result;
}

/// The fields of a line, or why there are none.
std::variant<std::vector<std::string>, std::string> fieldsOf(std::string_view line)
{
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
        const char c = line[k];
        if (quoted && c == '"' && k + 1 < line.size() && line[k + 1] == '"') {
            fields.back() += '"';
            ++k;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            if (fields.size() == kMostFields)
                return "has more than " + std::to_string(kMostFields) + " fields";
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
        if (fields.back().size() > kLongestField)
            return "has a field of more than " + std::to_string(kLongestField) + " bytes";
    }
    if (quoted) return "a quote does not end";
    return fields;
}

/// The lines of an index file, one after the other.
class IndexFile {
public:
    IndexFile(std::string path, std::string text) : path_(std::move(path)), text_(std::move(text))
    {
    }

    bool atEnd() const { return at_ >= text_.size(); }
    Error error(const std::string& cause) const
    {
        std::string where = "line ";
        where += std::to_string(line_);
        where += ": ";
        where += cause;
        return fileError(path_, where);
    }
    Result<std::vector<std::string>> next()
    {
        ++line_;
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        std::string_view line = std::string_view(text_).substr(at_, end - at_);
        at_ = end + 1;
        if (line.ends_with('\r')) line.remove_suffix(1);
        auto fields = fieldsOf(line);
        if (const auto* const cause = std::get_if<std::string>(&fields)) return error(*cause);
        return std::get<0>(std::move(fields));
    }

private:
    std::string path_, text_;
    std::size_t at_ = 0;
    int line_ = 0;
};

std::optional<std::size_t> indexOf(const std::vector<std::string>& fields, std::string_view column)
{
    const auto found = std::find(fields.begin(), fields.end(), column);
    if (found == fields.end()) return std::nullopt;
    return static_cast<std::size_t>(found - fields.begin());
}

}  // namespace

std::vector<GroupSummary> byNovelty(std::span<const BinError> errors)
{
    std::map<std::string, std::vector<BinError>> groups;
    for (const BinError& e : errors)
        if (e.novelty > 0.0) groups[e.novelty <= 1.0 ? "inside" : "outside"].push_back(e);
    return summaries(groups);
}

Result<Classes> readClasses(const std::string& path, const std::string& column)
{
    auto text = readFile(path, kMostBytes);
    if (!text) return text.error();
    return classesFrom(path, *std::move(text), column);
}

Result<Classes> classesFrom(const std::string& name, std::string text, const std::string& column)
{
    IndexFile file(name, std::move(text));
    const auto header = file.next();
    if (!header) return header.error();
    const auto row = indexOf(*header, "row");
    const auto wanted = indexOf(*header, column);
    if (!row || !wanted)
        return file.error("has no column " + std::string(row ? column : std::string("row")));
    Classes classes;
    while (!file.atEnd()) {
        auto fields = file.next();
        if (!fields) return fields.error();
        if (fields->size() != header->size())
            return file.error("has " + std::to_string(fields->size()) + " fields, not "
                              + std::to_string(header->size()));
        if (!classes.try_emplace((*fields)[*row], (*fields)[*wanted]).second)
            return file.error("row " + shown((*fields)[*row]) + " appears twice");
        if (classes.size() > kMostClassRows)
            return file.error("is one row more than the " + std::to_string(kMostClassRows)
                              + " allowed in a file");
    }
    return classes;
}

std::vector<GroupSummary> byClass(std::span<const BinError> errors, std::span<const Scene> scenes,
                                  const Classes& classes)
{
    std::map<std::string, std::vector<BinError>> groups;
    for (const BinError& e : errors) {
        if (e.scene >= scenes.size())
            throw std::invalid_argument("byClass: an error of a scene that is not there");
        const auto found = classes.find(scenes[e.scene].run);
        groups[found == classes.end() ? std::string(kNoClass) : found->second].push_back(e);
    }
    return summaries(groups);
}

}  // namespace terratact
