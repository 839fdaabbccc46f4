#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/modelling/findings.h"
#include "app/modelling/scene_estimates.h"
#include "core/eval/probes.h"

namespace terratact {

/// A rule that selects the bin to probe.
struct NamedRule {
    std::string name;
    ProbeRule choose;
};

/// Returns the probe rules. "sd": the largest sd (section 4.4 of the paper). "variance": the largest expected reduction
/// of the summed variance. "step": the largest expected reduction of the entropy of "is there a step of more than
/// stepLimit [m]?". Candidates are unread bins within the arm's reach. The robot must outlive the rules.
std::vector<NamedRule> probeRules(const RobotModel& robot, double stepLimit);

/// Applies every rule to every scene that has an estimate and truth ahead, on all cores. Returns one run per rule with
/// trials in the order of the scenes. estimates: those of the scenes, without readings. first: number of the first
/// scene among all. Scene k uses settings.seed + k. seconds: see estimateWith().
std::vector<ProbeRun> tryProbeRules(const std::string& label, std::span<const Scene> scenes,
                                    const std::vector<SceneEstimate>& estimates, std::size_t first,
                                    const EstimatorBundle& bundle, const Settings& settings,
                                    double stepLimit, double seconds = 0.0);

}  // namespace terratact
