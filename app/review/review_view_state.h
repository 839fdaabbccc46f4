#pragma once

#include <QCoreApplication>
#include <memory>
#include <optional>
#include <vector>

#include "app/mission/probe_proposals.h"
#include "app/pages/terrain_page.h"
#include "app/review/review_forces.h"
#include "app/runtime/revised.h"
#include "app/shell/preferences/preferences.h"
#include "core/atem/probe/arm_choice.h"
#include "core/log/review_moment.h"
#include "core/log/review_strip.h"

namespace terratact {

/// Returns the revision of a recorded estimate, which never changes: its number in the session; null: 0.
inline std::uint64_t revisionOf(const EstimateRow* row)
{
    return row ? static_cast<std::uint64_t>(row->id) : 0;
}

/// Computes the values that the review's pages show at a moment of a session, like LiveViewState for a live run. GUI
/// thread only.
class ReviewViewState {
    Q_DECLARE_TR_FUNCTIONS(ReviewViewState)
public:
    /// The session must outlive the object.
    ReviewViewState(SessionReader& session, const RobotModel& robot);

    /// Sets the obstacle height [m] from now on, instead of the recorded one.
    void setLimit(double metres) { limit_ = metres; }
    /// Returns the obstacle height [m] at this moment.
    double limit(const ReviewMoment& moment) const;
    /// Returns the verdict for that obstacle height on the operator's estimate; empty: there was no estimate.
    std::optional<TwoTrackVerdict> verdict(const ReviewMoment& moment) const;
    /// Returns the contact threshold [N]: that of the estimate, if there was one.
    static double threshold(const ReviewMoment& moment, const Preferences& preferences);

    /// Reads on for the remembered ground (ReviewStrip::readOn()). Returns true if that of the moment has changed.
    bool readOn(const ReviewMoment& moment) { return strip_.readOn(moment.time); }

    /// Returns the state of the terrain page. whatIf: the same scene with other settings; the page shows it as second
    /// estimate. The result points into `moment`, `whatIf` and this object; it is valid until the next call.
    TerrainViewState terrain(const ReviewMoment& moment, const Revised<TwoTrackEstimate>& whatIf,
                             const Preferences& preferences);

private:
    void addMeasured(TerrainViewState& viewState, const ReviewMoment& moment,
                     const Preferences& preferences);
    void addEstimates(TerrainViewState& viewState, const ReviewMoment& moment,
                      const Revised<TwoTrackEstimate>& whatIf) const;
    void addRemembered(TerrainViewState& viewState, const ReviewMoment& moment);
    void addProbe(TerrainViewState& viewState, const ReviewMoment& moment, ProbePolicy policy);
    const ProbeAdvice& adviceOf(const std::shared_ptr<const EstimateRow>& estimate, double limit);

    RobotModel robot_;
    ReviewForces felt_;
    ReviewStrip strip_;
    std::optional<double> limit_;                 ///< [m] obstacle height chosen by the reviewer
    std::shared_ptr<const EstimateRow> advised_;  ///< estimate that advice_ belongs to
    ProbeAdvice advice_;
    std::uint64_t shows_ = 0;

    // Data that the last view state points to.
    std::vector<ForceArray> forces_;
    std::vector<TimedForces> forcesBefore_;
    std::optional<ProbeProposal> proposal_;
};

}  // namespace terratact
