#include "app/model_choice.h"

#include <utility>

#include "app/resources.h"

namespace terratact {
namespace {

QString shippedModel()
{
    return QString::fromStdString(resourcePath("models/default.ttm"));
}

QString preferredModel(const Preferences& preferences)
{
    return preferences.model.isEmpty() ? shippedModel() : preferences.model;
}

}  // namespace

ModelChoice::ModelChoice(EstimatorWorker& worker, PreferenceStore& preferences,
                         const RobotModel& robot, QString inUse)
    : worker_(worker), preferences_(preferences), robot_(robot), inUse_(std::move(inUse))
{
    connect(&worker_, &EstimatorWorker::modelLoaded, this, [this] {
        if (!wanted_.isEmpty()) inUse_ = std::exchange(wanted_, QString());
        emit loaded();
        preferInUse();
    });
    connect(&worker_, &EstimatorWorker::modelKept, this, [this] {
        wanted_.clear();
        preferInUse();
    });
}

void ModelChoice::load(const QString& path)
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
