#pragma once

#include <Eigen/Core>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "core/base/for_each.h"
#include "core/base/poll.h"
#include "core/base/polled_mutex.h"
#include "core/learn/model/clearance_model.h"
#include "core/learn/model/model.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Approximate number of training rows of processes without some features: evenly spread rows, and
/// every row of a regime with few rows.
inline constexpr int kReducedRows = 4000;

/// Surface processes for scenes without currents or forces, of one plane or of sides. For each set
/// of missing features, the processes are trained again on the model's own rows without them.
/// Hyperparameters are the model's, with length scales within 0.5 … 6. Weights, leave-one-out
/// residuals, scale of novelty and the contacts' sd are computed as in clearance_training.h. Bands
/// widen because the residuals do.
/// Each set is made when it is first needed, in some seconds of processor time. The kKept latest
/// sets are kept. Where more sets take turns, each scene makes its set again. The result does not
/// depend on earlier requests. It may be shared between threads.
class ReducedClearances {
public:
    static constexpr std::size_t kKept = 16;

    /// robot: the robot that the model was trained for. model: without rows, nothing can be requested.
    ReducedClearances(const SurfaceData& model, RobotModel robot);

    /// Returns the model for missing features. missing: not empty, without pitch and flipper
    /// angles. Throws std::invalid_argument otherwise. sideBySide: runs the training of processes
    /// in parallel; empty: one after the other. poll: called every few milliseconds; what it throws
    /// is rethrown, and the next caller starts again.
    std::shared_ptr<const ClearanceModel>
    without(AbsentFeatures missing, const ForEach& sideBySide = {}, const Poll& poll = {}) const;
    std::shared_ptr<const ClearanceModel>
    without(MissingFeatures missing, const ForEach& sideBySide = {}, const Poll& poll = {}) const
    {
        return without(absentFeatures(missing), sideBySide, poll);
    }

private:
    struct Entry {
        AbsentFeatures missing;
        PolledMutex mutex{};  // held while the model is made
        std::shared_ptr<const ClearanceModel> model{};
    };
    std::shared_ptr<Entry> entry(AbsentFeatures missing) const;
    std::shared_ptr<const ClearanceModel> train(AbsentFeatures missing, const ForEach& sideBySide,
                                                const Poll& poll) const;

    SurfaceData rows_;         ///< chosen rows of the model, without its residuals and weights
    std::vector<int> places_;  ///< place of each chosen row
    RobotModel robot_;
    mutable std::mutex mutex_;                           // guards the list
    mutable std::list<std::shared_ptr<Entry>> entries_;  // latest first
};

}  // namespace terratact
