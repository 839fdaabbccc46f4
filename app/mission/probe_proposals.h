#pragma once

#include <optional>
#include <string>

#include "app/mission/estimation.h"
#include "core/atem/probe/probe_policy.h"
#include "core/atem/probe/probe_proposal.h"
#include "core/base/message.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Data that a probe's expected gain is computed from.
struct ProbeBasis {
    const TwoTrackEstimate& estimate;
    const ProbeAdvice& advice;  ///< advice for the estimate
    const RobotModel& robot;
    double seconds;  ///< expected duration of a probe
    ProbePolicy policy;
};
ProbeProposal describeProbe(const ProbeBasis& basis, ProbePlace place);  ///< the result has id 0
/// Returns the place with the largest expected gain, whether or not it is proposed. Without a ranking it is the unread
/// place in reach with the largest sd. Empty: no place is left.
std::optional<ProbeProposal> bestProbe(const ProbeBasis& basis);
/// Returns why bestProbe() returns empty for this basis.
Message whyNoBestProbe(const ProbeBasis& basis);

/// Makes the probe proposals, one at a time, each with its own id. A proposal has the bin's estimate, the gain of
/// probing it, and the gains of other bins.
class ProbeProposals {
public:
    /// seconds: expected duration of a probe. policy: read at every offer. All references must outlive the object.
    ProbeProposals(const Estimation& estimation, const RobotModel& robot, double seconds,
                   const ProbePolicy& policy);

    /// Returns what to propose for the present estimate, which must exist.
    ProbeOffer offer() const { return offer(policy_); }
    ProbeOffer offer(ProbePolicy policy) const;  ///< offer() by another policy

    /// Returns bestProbe() of the present estimate; empty without one, or if its pitch was suspected.
    std::optional<ProbeProposal> best() const;
    /// Returns why best() returns empty; empty without an estimate.
    Message whyNoBest() const;

    /// Proposes a place of the present estimate, which must exist; replaces the last proposal. One plane has places
    /// only in the middle, two sides have none there. A place that the estimate lacks is replaced by the
    /// same bin on the side with the larger sd.
    void propose(ProbePlace place);
    void withdraw() { current_.reset(); }

    const std::optional<ProbeProposal>& current() const { return current_; }
    bool isCurrent(quint64 id) const { return current_ && current_->id == id; }
    /// Returns the fingerprint of the data behind current() at its proposal.
    const std::string& proposedOn() const { return proposedOn_; }
    /// Returns true if there is a proposal and its data is unchanged.
    bool stands() const;
    /// Returns the fingerprint of the present data. Empty without proposal or estimate, and once the robot may have
    /// moved.
    std::string grounds() const;

private:
    ProbeBasis basis() const;  ///< basis of the present estimate, which must exist

    const Estimation& estimation_;
    const RobotModel& robot_;
    double seconds_;
    const ProbePolicy& policy_;
    std::optional<ProbeProposal> current_;
    std::string proposedOn_;
    quint64 last_ = 0;  ///< last id
};

}  // namespace terratact
