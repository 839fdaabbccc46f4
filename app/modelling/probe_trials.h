#pragma once

#include <string>
#include <vector>

#include "app/modelling/findings.h"
#include "app/modelling/scene_estimates.h"
#include "core/eval/probes.h"

namespace terratact {

/// A way to choose the bin to touch.
struct NamedRule {
    std::string name;
    ProbeRule choose;
};

/// "sd": the largest sd (section 4.4 of the paper); "variance": the largest expected reduction of the sum
/// of the variances; "step": of the entropy of "is there a step of more than stepLimit [m]?".  Bins the
/// arm reaches and that were not read; the robot must outlive the rules.
std::vector<NamedRule> probeRules(const RobotModel& robot, double stepLimit);

/// Every rule in every scene with truth ahead that has an estimate, on all cores: one run per rule, its trials
/// in the order of the scenes.
/// estimates: of the scenes, without a reading; first: the number of the first scene among all.  The seed
/// of scene k of all is settings.seed + k.  seconds: as estimateWith.
std::vector<ProbeRun> tryProbeRules(const std::string& label, const std::vector<Scene>& scenes,
                                    const std::vector<SceneEstimate>& estimates, std::size_t first,
                                    const EstimatorBundle& bundle, const Settings& settings,
                                    double stepLimit, double seconds = 0.0);

}  // namespace terratact
