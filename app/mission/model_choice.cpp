#include "app/mission/model_choice.h"

#include <utility>

#include "app/runtime/resources.h"

namespace terratact {
namespace {

QString shippedModel()
{
    return QString::fromStdString(shippedModelPath());
}

QString preferredModel(const Preferences& preferences)
{
    return preferences.model.isEmpty() ? shippedModel() : preferences.model;
}

}  // namespace

ModelChoice::ModelChoice(EstimatorWorker& worker, PreferenceStore& preferences,
                         const RobotModel& robot, QString inUse)
    : worker_(worker), preferences_(preferences), robot_(robot), inUse_(std::move(inUse)),
      wanted_(inUse_)
{
    connect(&worker_, &EstimatorWorker::modelLoaded, this, [this] {
        if (!wanted_.isEmpty()) inUse_ = wanted_;
        emit loaded();
        preferInUse();
        end();
    });
    connect(&worker_, &EstimatorWorker::modelKept, this, [this] {
        preferInUse();
        end();
    });
    connect(&worker_, &EstimatorWorker::modelFailed, this, &ModelChoice::end);
}

void ModelChoice::load(const QString& path)
{
    if (wanted_.isEmpty())
        begin(path);
    else
        next_ = path;
}

void ModelChoice::end()
{
    wanted_.clear();
    if (!next_.isEmpty()) begin(std::exchange(next_, QString()));
}

void ModelChoice::begin(const QString& path)
{
    wanted_ = path;
    worker_.load(modelFileLoader(path.toStdString(), robot_));
}

void ModelChoice::loadPreferred()
{
    if (const QString preferred = preferredModel(preferences_.current()); preferred != inUse_)
        load(preferred);
}

void ModelChoice::preferInUse()
{
    if (inUse_.isEmpty() || preferredModel(preferences_.current()) == inUse_) return;
    preferences_.change(
        [this](Preferences& p) { p.model = inUse_ == shippedModel() ? QString() : inUse_; });
}

}  // namespace terratact
