#pragma once

#include <optional>
#include <vector>

#include "core/atem/probe_gain.h"
#include "core/infer/estimate/estimate.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Section 4.4: the bin with the largest sd among those the arm reaches and that were sampled, if that
/// sd exceeds settings.probeAbove; else empty.  The paper asks for a probe when any sd is too large; a
/// large sd out of the arm's reach cannot be helped by it and asks for nothing here.  Nor does anything of a robot whose
/// arm says nothing of a height (armSd 0).
std::optional<int> proposeProbe(const TerrainEstimate& estimate, const RobotModel& robot);

/// What the operator is offered: nothing where proposeProbe() asks for nothing; else its bin for the paper's
/// methods, and for the others the bin whose reading is expected to reduce the sum of all variances most
/// (probe_gain.h): the rule that settles scenes with fewer probes, see docs/evaluation.md.
std::optional<int> chooseProbe(const TerrainEstimate& estimate, const RobotModel& robot);

/// What a probe would buy, for the operator to decide on, or to know where nobody asks him.
struct ProbeAdvice {
    std::optional<int> bin;  ///< chooseProbe()
    Uncertainty before;      ///< of a step ahead of more than stepLimit; 0 without draws
    /// Of the sampled bins in reach, whether or not one is asked for, the best first; empty without draws.
    std::vector<ProbeGain> gains;
    double stepLimit = 0.0;  ///< [m]
    bool operator==(const ProbeAdvice&) const = default;
};
/// poll: in the course of it, which takes longer than many an estimate.
ProbeAdvice adviseProbe(const TerrainEstimate& estimate, const RobotModel& robot, double stepLimit,
                        const Poll& poll = {});

}  // namespace terratact
