#pragma once

#include <array>
#include <optional>

#include "core/infer/sampling/conditionals.h"
#include "core/learn/model/clearance_conditionals.h"

namespace terratact {

/// Conditionals over clearances at one scene: the state of a bin under the robot is y = log(clearance + δ), of
/// another its height (core/learn/model/clearance.h).  A bin that was measured keeps its conditional and is drawn too,
/// from the product with the measurement's Gaussian: p(yᵢ | y_{J∖i}, s) N(yᵢ; m, v).  Chains start from the
/// training set's Gaussian of (bin, regime), times the measurement.
/// Refers to the models, which must live longer.
class ClearanceStates final : public Conditionals {
public:
    /// Measurements of states; empty: none.
    using Measured = std::array<std::optional<Normal>, kBins>;

    /// s: 11 raw features, order of featureNames(Paf); precision, inducing: see Settings; poll: while models are
    /// factorised and packed, see BinModels::bin.
    ClearanceStates(const ClearanceConditionals& models, const Heights& ceiling, Eigen::VectorXd s,
                    Measured measured, Precision precision, int inducing = 0, Poll poll = {});

    StartDraw start(int bin) const override;
    double height(int bin, double state) const override;
    /// Throws std::invalid_argument where a bin's regime was not trained.
    std::unique_ptr<SceneConditionals> at(const Heights& known,
                                          const std::vector<int>& unknown) const override;

private:
    const ClearanceRegimeData& scale(int bin) const;

    const ClearanceConditionals& models_;
    Heights ceiling_;
    Eigen::VectorXd s_;
    Measured measured_;
    Precision precision_;
    int inducing_;
    Poll poll_;
};

/// A height z with its sd as a measurement of the state.  Open: exact.  Covered, by the delta method:
///   m = log(c + δ), √v = sd / (c + δ),  c = max(ceiling − z, 0),
/// so that a height measured on the ceiling says little about y while sd is above δ.
/// Throws std::invalid_argument unless z is finite and sd > 0.
Normal measuredState(double z, double sd, double ceiling);

}  // namespace terratact
