#include "tests/support/linear_conditionals.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace terratact {

namespace {

class LinearSceneConditionals final : public SceneConditionals {
public:
    LinearSceneConditionals(const LinearConditionals& linear, const Heights& known,
                            const std::vector<int>& unknown)
        : linear_(linear), x_(Eigen::Map<const Eigen::VectorXd>(known.data(), kBins)),
          unknown_(unknown)
    {
    }

    void predict(std::size_t k, const Eigen::MatrixXd& states, Eigen::VectorXd& mean,
                 Eigen::VectorXd& variance) override
    {
        const int i = unknown_[k];
        mean.resize(states.cols());
        variance.setConstant(states.cols(), linear_.sd[i] * linear_.sd[i]);
        for (Eigen::Index c = 0; c < states.cols(); ++c) {
            for (std::size_t l = 0; l < unknown_.size(); ++l)
                x_[unknown_[l]] = states(static_cast<Eigen::Index>(l), c);
            mean[c] = linear_.intercept[i] + linear_.weights.row(i).dot(x_);
        }
    }

private:
    const LinearConditionals& linear_;
    Eigen::VectorXd x_;
    std::vector<int> unknown_;
};

}  // namespace

StartDraw LinearConditionals::start(int bin) const
{
    return {startMean[bin], startSd[bin]};
}

std::unique_ptr<SceneConditionals> LinearConditionals::at(const Heights& known,
                                                          const std::vector<int>& unknown) const
{
    return std::make_unique<LinearSceneConditionals>(*this, known, unknown);
}

LinearConditionals exactConditionals(const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance)
{
    const Eigen::MatrixXd P =
        covariance.llt().solve(Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols()));
    LinearConditionals linear;
    linear.startMean = mean;
    linear.sd = P.diagonal().cwiseInverse().cwiseSqrt();
    linear.startSd = covariance.diagonal().cwiseSqrt();
    linear.weights = -(P.diagonal().cwiseInverse().asDiagonal() * P);
    linear.weights.diagonal().setZero();
    linear.intercept = mean - linear.weights * mean;
    return linear;
}

}  // namespace terratact
