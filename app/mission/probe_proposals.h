#pragma once

#include <optional>
#include <string>

#include "app/mission/estimation.h"
#include "core/atem/probe_policy.h"
#include "core/robot/robot_model.h"
#include "widgets/control/probe_card.h"

namespace terratact {

/// What touching a bin buys, and what it rests on.
struct ProbeBasis {
    const TerrainEstimate& estimate;
    const ProbeAdvice& advice;  ///< of it
    const RobotModel& robot;
    double seconds;  ///< a probe takes
    ProbePolicy policy;
};
ProbeProposal describeProbe(const ProbeBasis& basis, int bin);  ///< its id is 0
/// Of the bin that a probe is best spent on, whether or not it is asked for: without a ranking, the least certain one in
/// the arm's reach that it has not measured.  Empty where there is none.
std::optional<ProbeProposal> bestProbe(const ProbeBasis& basis);

/// The probes that are put to the operator, one at a time, each with an id of its own: what the estimate says of a
/// bin, what touching it buys, and what the other bins of the advice would.
class ProbeProposals {
public:
    /// seconds: a probe takes.  policy: as it is when it is asked for.  The others must outlive it, too.
    ProbeProposals(const Estimation& estimation, const RobotModel& robot, double seconds,
                   const ProbePolicy& policy);

    /// What is to be proposed by the estimate that stands, which there is.
    ProbeOffer offer() const;

    std::optional<ProbeProposal>
    best() const;  ///< bestProbe() of the estimate that stands, if one does

    /// By the estimate that stands, which there is; in place of the one before.
    void propose(int bin);
    void withdraw() { current_.reset(); }

    const std::optional<ProbeProposal>& current() const { return current_; }
    bool isCurrent(quint64 id) const { return current_ && current_->id == id; }
    /// Fingerprint of what current() rested on when it was proposed.
    const std::string& proposedOn() const { return proposedOn_; }
    /// There is a question, and what it rests on is as it was then.
    bool stands() const;
    /// Of what it rests on now; empty where nothing is proposed or estimated, and once the robot may have moved.
    std::string grounds() const;

private:
    ProbeBasis basis() const;  ///< the estimate that stands, which there is

    const Estimation& estimation_;
    const RobotModel& robot_;
    double seconds_;
    const ProbePolicy& policy_;
    std::optional<ProbeProposal> current_;
    std::string proposedOn_;
    quint64 last_ = 0;  ///< id
};

}  // namespace terratact
