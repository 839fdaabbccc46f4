#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/eval/evaluation.h"
#include "core/eval/probes.h"
#include "core/eval/step_forecasts.h"
#include "core/infer/estimate/variant.h"

namespace terratact {

/// Part `number` of `count` of an evaluation's scenes.
struct Shard {
    int number = 1, count = 1;
    bool operator==(const Shard&) const = default;

    /// Its scenes among `total`: begin … end − 1, blocks of equal size but for one scene.
    std::size_t begin(std::size_t total) const { return at(total, number - 1); }
    std::size_t end(std::size_t total) const { return at(total, number); }

private:
    std::size_t at(std::size_t total, int block) const
    {
        return total * static_cast<std::size_t>(block) / static_cast<std::size_t>(count);
    }
};

/// "2/8"; empty unless 1 ≤ 2 ≤ 8 ≤ 10 000.
std::optional<Shard> shardFrom(std::string_view text);

/// What the report needs of a scene.
struct EvaluatedScene {
    std::string run;
    double time = 0.0;  ///< [s]
    std::vector<int> underFlipper;
    std::string kind;  ///< its class, where classes were asked for
    bool operator==(const EvaluatedScene&) const = default;
};

/// How a method or baseline fared.
struct MethodRun {
    std::string label;
    std::size_t scenes = 0, converged = 0, endedBySweeps = 0, endedByTime = 0, failed = 0;
    double seconds = 0.0;  ///< all scenes together
};

/// What one rule did in all scenes, with the estimates of one method.
struct ProbeRun {
    std::string label, rule;
    std::vector<ProbeTrial> trials;
};

/// What the report is to be about.
struct ReportOptions {
    std::vector<Method> methods;
    std::uint64_t seed = 1;  ///< of the bootstraps
    double stepLimit = 0.0;  ///< [m]
    double sdLimit = 0.0;    ///< [m] of the probes
    bool classes = false;
    bool operator==(const ReportOptions&) const = default;
};

/// What an evaluation, or one part of it, has found out.
struct Findings {
    /// What parts of one evaluation have in common, in words: version, command, hashes of its files.
    std::map<std::string, std::string> origin;
    ReportOptions options;
    Shard shard;
    std::size_t total = 0;               ///< scenes of all parts
    std::vector<EvaluatedScene> scenes;  ///< of this part
    std::vector<MethodRun> runs;         ///< in the order in which they were evaluated
    std::vector<BinError> errors;        ///< run by run; scenes counted over all parts
    std::vector<StepForecast> steps;     ///< likewise
    std::vector<ProbeRun> probes;
};

/// Findings and the file they come from, for messages.
struct NamedFindings {
    std::string path;
    Findings findings;
};

/// The findings that one run over all scenes would have made, the measured times added up.
/// Errors name a file and what was expected: no part, a part of another evaluation, the same part
/// twice, one that is missing.  out: what is to be made of them.
Result<Findings> mergeFindings(std::span<const NamedFindings> parts, const std::string& out);

}  // namespace terratact
