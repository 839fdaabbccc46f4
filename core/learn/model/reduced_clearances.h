#pragma once

#include <Eigen/Core>
#include <list>
#include <memory>
#include <mutex>

#include "core/base/for_each.h"
#include "core/base/poll.h"
#include "core/base/polled_mutex.h"
#include "core/learn/model/clearance_model.h"
#include "core/learn/model/model.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Training rows that processes without some features learn from: about so many, evenly spread, and every row of a
/// regime that has few.
inline constexpr int kReducedRows = 4000;

/// Surface processes for scenes in which currents or forces were not measured.  For each set of missing features the
/// processes are trained anew on the model's own rows without those features, with the model's hyper-parameters (length
/// scales within 0.5 … 6): weights, leave-one-out residuals, scale of novelty and the contacts' sd are made as in
/// clearance_training.h.  Bands widen because the residuals do.
/// Made when first asked for, in two seconds of a processor; the kKept sets used last are kept.  The result does not depend on
/// what was asked for before.  Safe to share between threads.
class ReducedClearances {
public:
    static constexpr std::size_t kKept = 16;

    /// robot: the one the model was trained for.
    ReducedClearances(const ModelData& model, RobotModel robot);

    /// missing: not empty, without pitch and the flipper angles; else std::invalid_argument.
    /// sideBySide: runs the processes' training; empty: one after the other.
    /// poll: every few milliseconds; what it throws comes out, and the next caller begins anew.
    std::shared_ptr<const ClearanceModel>
    without(MissingFeatures missing, const ForEach& sideBySide = {}, const Poll& poll = {}) const;

private:
    struct Entry {
        MissingFeatures missing;
        PolledMutex mutex{};  // of the making
        std::shared_ptr<const ClearanceModel> model{};
    };
    std::shared_ptr<Entry> entry(MissingFeatures missing) const;
    std::shared_ptr<const ClearanceModel> train(MissingFeatures missing, const ForEach& sideBySide,
                                                const Poll& poll) const;

    ModelData rows_;  ///< of the model's rows; residuals and weights are not theirs
    RobotModel robot_;
    mutable std::mutex mutex_;                           // of the list
    mutable std::list<std::shared_ptr<Entry>> entries_;  // the last used first
};

}  // namespace terratact
