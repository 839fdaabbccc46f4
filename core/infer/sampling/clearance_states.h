#pragma once

#include <array>
#include <optional>

#include "core/infer/sampling/conditionals.h"
#include "core/learn/model/clearance_conditionals.h"

namespace terratact {

/// Conditionals over clearances at one scene. The state of a covered bin is y = log(clearance + δ);
/// the state of another bin is its height (core/learn/model/clearance.h).
/// A measured bin is drawn as well, from its conditional times the measurement's Gaussian: p(yᵢ |
/// y_{J∖i}, s) N(yᵢ; m, v). Chains start from the training set's Gaussian of (bin, regime), times
/// the measurement. The models must outlive this object.
class ClearanceStates final : public Conditionals {
public:
    /// Measured states; empty: not measured.
    using Measured = std::array<std::optional<Normal>, kBins>;

    /// s: 11 raw features in the order of featureNames(Paf). precision, inducing: see Settings.
    /// poll: called while models are factorised and packed, see BinModels::bin.
    ClearanceStates(const ClearanceConditionals& models, const Heights& ceiling, Eigen::VectorXd s,
                    Measured measured, Precision precision, int inducing = 0, Poll poll = {});

    StartDraw start(int bin) const override;
    double height(int bin, double state) const override;
    /// Throws std::invalid_argument if a bin's regime was not trained.
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

/// Returns a height z with its sd as a measurement of the state. An open bin is exact: the state is
/// the height. A covered bin uses the delta method:
///   m = log(c + δ), √v = sd / (c + δ),  c = max(ceiling − z, 0)
/// A height measured at the ceiling therefore adds little to y while sd is above δ. Throws
/// std::invalid_argument unless z is finite and sd > 0.
Normal measuredState(double z, double sd, double ceiling);

}  // namespace terratact
