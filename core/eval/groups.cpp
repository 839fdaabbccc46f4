#include "core/eval/groups.h"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "core/base/text.h"
#include "core/store/csv_text.h"

namespace terratact {
namespace {

/// Returns groups by name, labels by first appearance.
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

std::optional<std::size_t> indexOf(const std::vector<std::string_view>& fields,
                                   std::string_view column)
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
    Result<CsvReader> csv = CsvReader::open(path);
    if (!csv) return csv.error();
    return readClasses(*std::move(csv), column);
}

Result<Classes> readClasses(CsvReader csv, const std::string& column)
{
    if (const Result<bool> header = csv.next(); !header) return header.error();
    const auto row = indexOf(csv.fields(), "row");
    const auto wanted = indexOf(csv.fields(), column);
    if (!row || !wanted)
        return csv.error("has no column " + std::string(row ? column : std::string("row")));
    csv.useAsHeader({});
    Classes classes;
    for (;;) {
        const Result<bool> more = csv.next();
        if (!more) return more.error();
        if (!*more) return classes;
        const std::string name = csvText(csv.fields()[*row]);
        if (!classes.try_emplace(name, csvText(csv.fields()[*wanted])).second)
            return csv.error("row " + shown(name) + " appears twice: delete one of the lines");
        if (classes.size() > kMaxClassRows)
            return csv.error("is one row more than the " + std::to_string(kMaxClassRows)
                             + " allowed in a file");
    }
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
