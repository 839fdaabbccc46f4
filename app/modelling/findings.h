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

/// Part `number` of `count` of an evaluation's scenes (a shard).
struct Shard {
    int number = 1, count = 1;
    bool operator==(const Shard&) const = default;

    /// Its scenes among `total` are begin … end − 1. Block sizes differ by at most one scene.
    std::size_t begin(std::size_t total) const { return at(total, number - 1); }
    std::size_t end(std::size_t total) const { return at(total, number); }

private:
    std::size_t at(std::size_t total, int block) const
    {
        return total * static_cast<std::size_t>(block) / static_cast<std::size_t>(count);
    }
};

/// Parses "2/8"; returns empty unless 1 ≤ number ≤ count ≤ 10 000.
std::optional<Shard> shardFrom(std::string_view text);

/// Data of a scene that the report needs.
struct EvaluatedScene {
    std::string run;
    double time = 0.0;  ///< [s]
    std::vector<int> underFlipper;
    std::string kind;  ///< its class, if classes were requested
    bool operator==(const EvaluatedScene&) const = default;
};

/// Results of one method or baseline.
struct MethodRun {
    std::string label;
    std::size_t scenes = 0, converged = 0, endedBySweeps = 0, endedByTime = 0, failed = 0;
    double seconds = 0.0;  ///< total over all scenes
    /// Estimates that contradict their readings (core/sim/posterior_check.h); empty: not checked.
    std::optional<std::size_t> contradicting{};
};

/// Results of one probe rule in all scenes, with the estimates of one method.
struct ProbeRun {
    std::string label, rule;
    std::vector<ProbeTrial> trials;
};

/// Contents of the report.
struct ReportOptions {
    std::vector<Method> methods;
    std::uint64_t seed = 1;  ///< seed of the bootstraps
    double stepLimit = 0.0;  ///< [m]
    double sdLimit = 0.0;    ///< [m] probe threshold of the sd
    bool classes = false;
    bool operator==(const ReportOptions&) const = default;
};

/// Results of an evaluation or of one part.
struct Findings {
    /// Text that all parts of one evaluation share: version, command, hashes of its files.
    std::map<std::string, std::string> origin;
    ReportOptions options;
    Shard shard;
    std::size_t total = 0;               ///< number of scenes in all parts
    std::vector<EvaluatedScene> scenes;  ///< scenes of this part
    std::vector<MethodRun> runs;         ///< in order of evaluation
    std::vector<BinError> errors;        ///< grouped by run; scene numbers count over all parts
    std::vector<StepForecast> steps;     ///< grouped by run; scene numbers count over all parts
    std::vector<ProbeRun> probes;
};

/// Findings and their file, for messages.
struct NamedFindings {
    std::string path;
    Findings findings;
};

/// Merges parts into the findings of one run over all scenes; measured times are added. Errors name a file and what was
/// expected. Causes: no part, a part of another evaluation, a duplicate or missing part. out: the file to be written,
/// for messages.
Result<Findings> mergeFindings(std::span<const NamedFindings> parts, const std::string& out);

}  // namespace terratact
