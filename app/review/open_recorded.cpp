#include "app/review/open_recorded.h"

#include <memory>
#include <utility>

#include "app/recording/what_if.h"
#include "app/review/review_window.h"
#include "app/review/scenes_window.h"
#include "app/runtime/resources.h"
#include "app/start/console_setup.h"
#include "app/start/until_closed.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

/// Returns the candidate files for a session's model: the preferred one and the shipped ones.
QStringList modelsFor(const ConsoleOptions& options, LoadedPreferences& loaded)
{
    QStringList models{QString::fromStdString(modelFor(options, loaded))};
    for (const std::string& path : shippedModelPaths()) models += QString::fromStdString(path);
    models.removeDuplicates();
    return models;
}

}  // namespace

Result<int> openReview(Application& application, const ConsoleOptions& options)
{
    auto session = SessionReader::open(options.replay);
    if (!session) return session.error();
    const auto robot = options.robot.empty() ? robotOf(*session) : readRobotModel(options.robot);
    if (!robot) return robot.error();
    LoadedPreferences loaded = preferencesFor(options);
    const Preferences preferences = inForce(loaded.preferences, options);
    if (const Status ready = application.start(preferences, options.isPicture()); !ready)
        return ready.error();
    QStringList models = modelsFor(options, loaded);
    ReviewWindow window(
        {.session = std::move(*session),
         .robot = *robot,
         .models = std::move(models),
         .preferences = std::make_unique<PreferenceStore>(std::move(loaded), preferences)});
    if (options.at) window.goTo(*options.at);
    return untilClosed(window, options, [&window] { return window.surveyed(); });
}

Result<int> openScenes(Application& application, const ConsoleOptions& options)
{
    auto file = readTwoTrackScenes(options.replay);
    if (!file) return file.error();
    if (file->scenes.empty()) return fileError(options.replay, TR_NOOP("core", "has no scenes"));
    LoadedPreferences loaded = preferencesFor(options);
    const auto robot = robotFor(options, loaded);
    if (!robot) return robot.error();
    const Preferences preferences = inForce(loaded.preferences, options);
    if (const Status ready = application.start(preferences, options.isPicture()); !ready)
        return ready.error();
    Settings settings = withPreferences({}, preferences);
    if (settings.method == Method::Trail) settings.method = Method::Local;  // no way before them
    settings.seed = options.seed;
    ScenesWindow window({.path = QString::fromStdString(options.replay),
                         .scenes = std::move(file->scenes),
                         .robot = robot->model,
                         .model = modelFileLoader(modelFor(options, loaded), robot->model),
                         .settings = settings,
                         .stepLimit = preferences.obstacleLimit});
    return untilClosed(window, options, [&window] { return window.estimate().has_value(); });
}

}  // namespace terratact
