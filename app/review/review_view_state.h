#pragma once

#include <QCoreApplication>
#include <memory>
#include <optional>
#include <vector>

#include "app/mission/probe_proposals.h"
#include "app/pages/terrain_page.h"
#include "app/review/review_forces.h"
#include "app/shell/preferences.h"
#include "core/atem/arm_choice.h"
#include "core/log/review_ghost.h"
#include "core/log/review_moment.h"

namespace terratact {

/// Reads off a moment of a session the plain values that the pages of a review show, as LiveViewState does of what
/// runs.  GUI thread only.
class ReviewViewState {
    Q_DECLARE_TR_FUNCTIONS(ReviewViewState)
public:
    /// The session must outlive it.
    ReviewViewState(SessionReader& session, const RobotModel& robot);

    /// Of an obstacle [m], from now on, whatever was recorded.
    void setLimit(double metres) { limit_ = metres; }
    /// Of an obstacle [m], at this moment.
    double limit(const ReviewMoment& moment) const;
    /// By that limit, from what the operator had; empty: no estimate stood.
    std::optional<Verdict> verdict(const ReviewMoment& moment) const;
    /// Of contact [N]: the estimate's where one stood.
    static double threshold(const ReviewMoment& moment, const Preferences& preferences);

    /// whatIf: of the same scene with other settings, shown as the second estimate.  What the sight points to is
    /// moment's, whatIf's, and this object's until the next call.
    TerrainViewState terrain(const ReviewMoment& moment,
                             const std::optional<TerrainEstimate>& whatIf,
                             const Preferences& preferences);

private:
    void addMeasured(TerrainViewState& viewState, const ReviewMoment& moment, double threshold);
    void addEstimates(TerrainViewState& viewState, const ReviewMoment& moment,
                      const std::optional<TerrainEstimate>& whatIf) const;
    void addGhost(TerrainViewState& viewState, const ReviewMoment& moment);
    void addProbe(TerrainViewState& viewState, const ReviewMoment& moment, ProbePolicy policy);
    const ProbeAdvice& adviceOf(const std::shared_ptr<const EstimateRow>& estimate, double limit);

    RobotModel robot_;
    ReviewForces felt_;
    ReviewGhost ghost_;
    std::optional<double> limit_;                 ///< [m] where the reviewer asks for another
    std::shared_ptr<const EstimateRow> advised_;  ///< what advice_ is of
    ProbeAdvice advice_;
    std::uint64_t shows_ = 0;

    // What the last sight points to.
    std::vector<ForceArray> forces_;
    std::vector<TimedForces> forcesBefore_;
    std::optional<ProbeProposal> proposal_;
};

}  // namespace terratact
