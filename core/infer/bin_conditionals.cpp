#include "core/infer/bin_conditionals.h"

#include <utility>

#include "core/infer/moving_inputs.h"

namespace terratact {

namespace {

class BinSceneConditionals final : public SceneConditionals {
public:
    BinSceneConditionals(const BinModels& models, const Heights& known, const Eigen::VectorXd& s,
                         const std::vector<int>& unknown, Precision precision, int inducing,
                         const Poll& poll)
    {
        for (const int i : unknown) {
            mean_.push_back(models.heightMean(i));
            sd_.push_back(models.heightSd(i));
            conditionals_.push_back(std::make_unique<SceneConditional>(
                models.bin(i, inducing, poll), models.input(i, known, s), movingInputs(unknown, i),
                precision, poll));
        }
    }

    void predict(std::size_t k, const Eigen::MatrixXd& states, Eigen::VectorXd& mean,
                 Eigen::VectorXd& variance) override
    {
        standardiseOthers(k, states, mean_, sd_, inputs_);
        conditionals_[k]->predict(inputs_, mean, variance);
    }

private:
    std::vector<double> mean_, sd_;  // of the unknown bins' heights [m]
    std::vector<std::unique_ptr<SceneConditional>> conditionals_;
    Eigen::MatrixXd inputs_;
};

}  // namespace

BinConditionals::BinConditionals(const BinModels& models, Eigen::VectorXd s, Precision precision,
                                 int inducing, Poll poll)
    : models_(models), s_(std::move(s)), precision_(precision), inducing_(inducing),
      poll_(std::move(poll))
{
}

StartDraw BinConditionals::start(int bin) const
{
    return {models_.heightMean(bin), models_.heightSd(bin)};
}

std::unique_ptr<SceneConditionals> BinConditionals::at(const Heights& known,
                                                       const std::vector<int>& unknown) const
{
    return std::make_unique<BinSceneConditionals>(models_, known, s_, unknown, precision_,
                                                  inducing_, poll_);
}

}  // namespace terratact
