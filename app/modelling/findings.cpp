#include "app/modelling/findings.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/text.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr int kMaxShards = 10'000;

std::optional<int> countFrom(std::string_view text)
{
    const auto count = integerFrom<int>(text);
    return count && *count >= 1 && *count <= kMaxShards ? count : std::nullopt;
}

std::vector<std::string> labels(const Findings& findings)
{
    std::vector<std::string> list;
    list.reserve(findings.runs.size() + findings.probes.size());
    for (const MethodRun& run : findings.runs) list.push_back(run.label);
    for (const ProbeRun& run : findings.probes) list.push_back(run.label + " " + run.rule);
    return list;
}

std::string valueOf(const std::map<std::string, std::string>& map, const std::string& key)
{
    const auto found = map.find(key);
    return found == map.end() ? "(none)" : found->second;
}

Error foreign(const NamedFindings& part, const NamedFindings& first, std::string_view what,
              std::string_view found, std::string_view expected)
{
    return fileError(
        part.path,
        fmt::format("is a part of another evaluation: its {} is {}, expected {} as in {}", what,
                    found, expected, first.path));
}

Status requireSameEvaluation(const NamedFindings& part, const NamedFindings& first)
{
    const Findings& found = part.findings;
    const Findings& expected = first.findings;
    for (const auto& [what, value] : expected.origin)
        if (const std::string own = valueOf(found.origin, what); own != value)
            return foreign(part, first, what, own, value);
    if (found.shard.count != expected.shard.count)
        return foreign(part, first, "number of parts", std::to_string(found.shard.count),
                       std::to_string(expected.shard.count));
    if (found.total != expected.total)
        return foreign(part, first, "number of scenes", std::to_string(found.total),
                       std::to_string(expected.total));
    if (found.options != expected.options || labels(found) != labels(expected))
        return foreign(part, first, "list of methods and options", "another", "that");
    return Done{};
}

/// Returns the parts ordered by number; each must occur once.
Result<std::vector<const Findings*>> inOrder(std::span<const NamedFindings> parts,
                                             const std::string& out)
{
    const auto count = static_cast<std::size_t>(parts.front().findings.shard.count);
    std::vector<const NamedFindings*> byNumber(count, nullptr);
    for (const NamedFindings& part : parts) {
        const int number = part.findings.shard.number;
        const NamedFindings*& place = byNumber[static_cast<std::size_t>(number - 1)];
        if (place)
            return fileError(part.path, fmt::format("is part {} of {} a second time, expected each "
                                                    "once; the first is {}",
                                                    number, count, place->path));
        place = &part;
    }
    std::vector<std::string> missing;
    std::vector<const Findings*> ordered;
    for (std::size_t k = 0; k < count; ++k) {
        if (byNumber[k])
            ordered.push_back(&byNumber[k]->findings);
        else
            missing.push_back(fmt::format("{}/{}", k + 1, count));
    }
    if (!missing.empty())
        return fileError(out,
                         fmt::format("cannot be made: expected {} parts as {} says, missing {}",
                                     count, parts.front().path, fmt::join(missing, ", ")));
    return ordered;
}

/// Appends the entries of one label that begin at `next`, and advances `next` behind them.
template <class Entry>
void moveOfLabel(const std::string& label, const std::vector<Entry>& from, std::size_t& next,
                 std::vector<Entry>& into)
{
    for (; next < from.size() && from[next].label == label; ++next) into.push_back(from[next]);
}

void addRuns(const Findings& from, Findings& into)
{
    for (std::size_t k = 0; k < into.runs.size(); ++k) {
        into.runs[k].scenes += from.runs[k].scenes;
        into.runs[k].converged += from.runs[k].converged;
        into.runs[k].endedBySweeps += from.runs[k].endedBySweeps;
        into.runs[k].endedByTime += from.runs[k].endedByTime;
        into.runs[k].failed += from.runs[k].failed;
        into.runs[k].seconds += from.runs[k].seconds;
    }
    for (std::size_t k = 0; k < into.probes.size(); ++k)
        into.probes[k].trials.insert(into.probes[k].trials.end(), from.probes[k].trials.begin(),
                                     from.probes[k].trials.end());
}

/// Appends the errors grouped by run, in the order of a single evaluation.
void addErrors(const std::vector<const Findings*>& parts, Findings& into)
{
    struct Next {
        std::size_t error = 0, step = 0;
    };
    std::vector<Next> next(parts.size());
    for (const MethodRun& run : into.runs)
        for (std::size_t p = 0; p < parts.size(); ++p) {
            moveOfLabel(run.label, parts[p]->errors, next[p].error, into.errors);
            moveOfLabel(run.label, parts[p]->steps, next[p].step, into.steps);
        }
}

}  // namespace

std::optional<Shard> shardFrom(std::string_view text)
{
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto number = countFrom(text.substr(0, slash));
    const auto count = countFrom(text.substr(slash + 1));
    if (!number || !count || *number > *count) return std::nullopt;
    return Shard{*number, *count};
}

Result<Findings> mergeFindings(std::span<const NamedFindings> parts, const std::string& out)
{
    if (parts.empty()) return fileError(out, "cannot be made of no part");
    for (const NamedFindings& part : parts)
        if (Status same = requireSameEvaluation(part, parts.front()); !same) return same.error();
    const auto ordered = inOrder(parts, out);
    if (!ordered) return ordered.error();
    Findings merged = *ordered->front();
    merged.shard = {};
    merged.errors.clear();
    merged.steps.clear();
    for (std::size_t p = 1; p < ordered->size(); ++p) {
        const Findings& part = *(*ordered)[p];
        merged.scenes.insert(merged.scenes.end(), part.scenes.begin(), part.scenes.end());
        addRuns(part, merged);
    }
    addErrors(*ordered, merged);
    return merged;
}

}  // namespace terratact
