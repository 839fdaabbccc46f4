#include "core/infer/sampling/bin_conditionals.h"

#include <utility>

#include "core/infer/sampling/process_scene.h"

namespace terratact {

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
    auto scene = std::make_unique<ProcessScene>();
    for (const int i : unknown)
        scene->add(std::make_unique<SceneConditional>(models_.bin(i, inducing_, poll_),
                                                      models_.input(i, known, s_),
                                                      movingInputs(unknown, i), precision_, poll_),
                   models_.heightMean(i), models_.heightSd(i));
    return scene;
}

}  // namespace terratact
