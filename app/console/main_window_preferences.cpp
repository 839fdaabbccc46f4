// Effects of changed preferences, and when the window may be rebuilt.
#include "app/console/main_window.h"
#include "app/console/pages/alarms_page.h"
#include "app/console/pages/settings_page.h"
#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/session_event_logger.h"
#include "app/mission/text/preset_text.h"
#include "widgets/base/theme.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/alarm_table.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {

int MainWindow::arrangement() const
{
    return static_cast<int>(preferences_->current().layout);
}

void MainWindow::arrange()
{
    const Preferences& preferences = preferences_->current();
    terrainPage_->setThreshold(exploration_->options().settings.forceThreshold);
    terrainPage_->arrange(preferences.layout, lookInForce().fontScale);
}

void MainWindow::applyPreferences(const Preferences& before)
{
    const Preferences& now = preferences_->current();
    const QString changes = changesOf(before, now);
    if (eventLogger_ && !changes.isEmpty()) eventLogger_->decision("settings", verbatim(changes));
    const Settings& set = exploration_->options().settings;
    // Applies changed settings only, because they void a proposal; other changes, such as colours, do not.
    if (const Settings wanted = withPreferences(set, now); wanted != withPreferences(set, before)) {
        exploration_->setSettings(wanted);
        offerQualities();
    }
    if (now.model != before.model) models_->loadPreferred();
    if (now.sound != before.sound) {
        alarms_->setSoundOn(now.sound);
        alarmsPage_->table()->setSoundOn(now.sound);
    }
    if (recorder_ && now.record != before.record) recorder_->setOn(now.record);
    if (now.obstacleLimit != before.obstacleLimit) {
        exploration_->setStepLimit(now.obstacleLimit);
        verdict()->setLimit(now.obstacleLimit);
    }
    showLook();
    if (lookWaits_) arrange();  // the layout does not wait
    exploration_->setEstimateSeconds(now.estimateSeconds);
    exploration_->setProbePolicy(now.probes);
    exploration_->setAttitudeLimits(now.tilt());
    if (now.robot != before.robot || now.language != before.language || now.units != before.units)
        reopen();
}

void MainWindow::showLook()
{
    const Preferences& now = preferences_->current();
    const bool moves = exploration_->armed() && moment_.bus && moment_.bus->link.moves;
    const bool before = lookWaits_;
    lookWaits_ = moves && !hasLook(now.theme, now.fontScale);
    if (!lookWaits_) return setLook(now.theme, now.fontScale);
    if (!before)
        showWhyNot(
            TR_NOOP("terratact::MainWindow", "colours and font change once the robot has stopped"));
}

/// Takes the robot file of a dialog that may have been open since before arming.
void MainWindow::applyRobot(const QString& path)
{
    if (const auto why = whyNotReopening())
        return log({TR_NOOP("terratact::MainWindow", "the robot stays: %1"), *why},
                   EventSeverity::Bad);
    preferences_->change([path](Preferences& p) { p.robot = path; });
}

void MainWindow::reopen()
{
    if (const auto why = whyNotReopening()) {
        log({TR_NOOP("terratact::MainWindow",
                     "robot, language and units change at the next start: %1"),
             *why},
            EventSeverity::Warning);
        return;
    }
    leave();
    emit reopenWanted();
}

void MainWindow::showCards()
{
    const ModelInUse& model = exploration_->estimation().model();
    settings_->setModelCard(model.trouble.empty()
                                ? model.name + QLatin1Char('\n') + model.details
                                : tr("no model: %1").arg(translated(model.trouble)));
    settings_->setRobotCard(robotDetails_);
    settings_->setReopenBlocked(translated(whyNotReopening().value_or(Message())));
}

std::optional<Message> MainWindow::whyNotReopening() const
{
    if (exploration_->following()) return std::nullopt;
    if (exploring(exploration_->state().phase))
        return TR_NOOP("terratact::MainWindow", "An exploration is running: end it with Esc first");
    if (link_ && exploration_->armed())
        return TR_NOOP("terratact::MainWindow", "The robot is armed: disarm it first (M)");
    return std::nullopt;
}

void MainWindow::offerQualities()
{
    const Method method = exploration_->options().settings.method;
    const ModelInUse& model = exploration_->estimation().model();
    const bool measured = !model.name.isEmpty() && model.content.toStdString() == presets_.model;
    const std::vector<PresetCost> costs = measured ? presets_.costs : std::vector<PresetCost>{};
    settings_->setPresets(costs);
    QStringList names;
    for (const QualityPreset preset : kQualityPresets) names << translated(describe(preset));
    header()->setQualities(names, presetLines(method, costs),
                           static_cast<int>(preferences_->current().preset));
}

}  // namespace terratact
