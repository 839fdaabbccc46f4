#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "app/cli/commands.h"
#include "app/figures/report/findings_report.h"
#include "app/modelling/evaluation/model_cards.h"
#include "app/modelling/findings.h"
#include "app/modelling/findings_file.h"
#include "app/runtime/print_text.h"
#include "core/learn/model/file/model_file.h"
#include "core/learn/model/file/model_part.h"
#include "core/robot/robot_model.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/store/sha256.h"

namespace terratact {

namespace {

constexpr std::size_t kMaxRobotFile = std::size_t{1} << 20U;

template <class Named, class Read>
Result<std::vector<Named>> readParts(const std::vector<std::string>& paths, Read read)
{
    std::vector<Named> parts;
    for (const std::string& path : paths) {
        auto part = read(path);
        if (!part) return part.error();
        parts.push_back({path, *std::move(part)});
    }
    return parts;
}

Status mergeTraining(const MergeOptions& options)
{
    const auto bytes = readFile(options.robot, kMaxRobotFile);
    if (!bytes) return bytes.error();
    const auto robot = robotModelFrom(options.robot, *bytes);
    if (!robot) return robot.error();
    const auto parts = readParts<NamedModelPart>(options.parts, readModelPart);
    if (!parts) return parts.error();
    if (Status s = checkCardReplaceable(options.out); !s) return s;
    const auto model = mergeModelParts(*parts, *robot, sha256Hex(*bytes), options.out);
    if (!model) return model.error();
    if (Status written = writeModel(options.out, *model); !written) return written;
    if (Status card = writeNewCard(options.out, *model, {}); !card) return card;
    printText("{} parts; content {}; written to {}\n", parts->size(), contentHash(*model),
              options.out);
    return Done{};
}

/// Returns true if any method, not a baseline, has estimated a scene.
bool anyEstimate(const Findings& findings)
{
    const auto methods = static_cast<std::ptrdiff_t>(findings.options.methods.size());
    return std::any_of(findings.runs.begin(), findings.runs.begin() + methods,
                       [](const MethodRun& run) { return run.failed < run.scenes; });
}

Status mergeEvaluation(const MergeOptions& options)
{
    const auto parts = readParts<NamedFindings>(options.parts, readFindings);
    if (!parts) return parts.error();
    const auto findings = mergeFindings(*parts, options.out);
    if (!findings) return findings.error();
    if (!anyEstimate(*findings))
        return fileError(options.out, "cannot be made: no scene has what the methods need");
    if (Status made = makeDirectory(options.out); !made) return made;
    for (const MethodRun& run : findings->runs) printRun(run);
    return reportFindings(*findings, options.out);
}

}  // namespace

bool isEvaluation(const MergeOptions& options)
{
    return std::any_of(options.parts.begin(), options.parts.end(), isFindingsFile);
}

Status merge(const MergeOptions& options)
{
    return isEvaluation(options) ? mergeEvaluation(options) : mergeTraining(options);
}

}  // namespace terratact
