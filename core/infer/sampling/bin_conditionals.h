#pragma once

#include "core/infer/sampling/conditionals.h"
#include "core/learn/model/bin_models.h"

namespace terratact {

/// The paper's conditionals p(hᵢ | h_{J∖i}, s) at one s. The state of a bin is its height [m].
/// Chains start from the training set's mean and standard deviation. The models must outlive this
/// object.
class BinConditionals final : public Conditionals {
public:
    /// s: features of the models' set. precision, inducing: see Settings. poll: called while models
    /// are factorised and packed, see BinModels::bin.
    BinConditionals(const BinModels& models, Eigen::VectorXd s, Precision precision,
                    int inducing = 0, Poll poll = {});

    StartDraw start(int bin) const override;
    /// Throws std::invalid_argument if s does not fit the models.
    std::unique_ptr<SceneConditionals> at(const Heights& known,
                                          const std::vector<int>& unknown) const override;

private:
    const BinModels& models_;
    Eigen::VectorXd s_;
    Precision precision_;
    int inducing_;
    Poll poll_;
};

}  // namespace terratact
