#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/atem/probe/probe_gain.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Returns the sides whose bins the arm may touch: the middle of one plane, or left and right.
std::span<const ProbeSide> sidesToProbe(const TwoTrackEstimate& estimate);

/// Proposes a probe as in section 4.4 of the paper. It returns the sampled bin in the arm's reach
/// with the largest sd. It returns empty unless that sd exceeds the probe threshold
/// settings.probeAbove.
/// The paper proposes a probe if any sd is too large. Here a large sd beyond the arm's reach is
/// ignored, because the arm cannot reduce it. A robot whose arm measures no height (armSd 0) gets no
/// proposal.
std::optional<int> proposeProbe(const TerrainEstimate& estimate, const RobotModel& robot);

/// Chooses the bin that is offered to the operator; empty if proposeProbe() returns empty. The
/// paper's methods use its bin. The other methods use the bin whose reading is expected to reduce
/// the sum of all variances most (probe_gain.h). That rule needs fewer probes per scene, see
/// docs/evaluation.md.
std::optional<int> chooseProbe(const TerrainEstimate& estimate, const RobotModel& robot);

/// Return a place for an estimate of both sides. proposeProbe() returns the place with the largest sd
/// of both sides. chooseProbe() returns the place whose reading reduces the expected sum of all
/// variances most. The arm reaches a side's bin if it reaches its line (RobotModel::armReaches). For
/// an estimate of one plane, both return the bins of the functions above, in the middle.
std::optional<ProbePlace> proposeProbe(const TwoTrackEstimate& estimate, const RobotModel& robot);
std::optional<ProbePlace> chooseProbe(const TwoTrackEstimate& estimate, const RobotModel& robot);

/// Expected benefit of a probe, which helps the operator to decide.
struct ProbeAdvice {
    std::optional<ProbePlace> place;  ///< chooseProbe()
    Uncertainty before;               ///< for a step ahead of more than stepLimit; 0 without draws
    /// Gains of the sampled bins in reach, best first, even if no probe is proposed; empty without
    /// draws.
    std::vector<ProbeGain> gains;
    double stepLimit = 0.0;  ///< [m]
    bool operator==(const ProbeAdvice&) const = default;
};
/// Computes the advice. poll: called during the work, which takes longer than many estimates.
ProbeAdvice adviseProbe(const TerrainEstimate& estimate, const RobotModel& robot, double stepLimit,
                        const Poll& poll = {});
ProbeAdvice adviseProbe(const TwoTrackEstimate& estimate, const RobotModel& robot, double stepLimit,
                        const Poll& poll = {});

}  // namespace terratact
