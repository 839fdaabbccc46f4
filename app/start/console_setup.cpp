#include "app/start/console_setup.h"

#include <QFileInfo>

#include "app/runtime/resources.h"

namespace terratact {

LoadedPreferences preferencesFor(const ConsoleOptions& options)
{
    if (options.safeMode || options.isPicture()) return loadPreferences({});
    const QString path = preferencesPath();
    LoadedPreferences loaded = loadPreferences(path);
    if (path.isEmpty())
        loaded.troubles.emplace_back(
            TR_NOOP("Preferences", "Preferences: there is no home folder to save them in: set HOME "
                                   "or XDG_CONFIG_HOME"));
    return loaded;
}

Preferences inForce(Preferences preferences, const ConsoleOptions& options)
{
    for (const ThemeName theme : {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast})
        if (name(theme) == options.theme) preferences.theme = theme;
    for (const Layout layout : {Layout::Drive, Layout::Probe, Layout::Review})
        if (name(layout) == options.layout) preferences.layout = layout;
    for (const LengthUnit unit : {LengthUnit::Metre, LengthUnit::Centimetre})
        if (name(unit) == options.lengthUnit) preferences.units.length = unit;
    for (const AngleUnit unit : {AngleUnit::Degree, AngleUnit::Radian})
        if (name(unit) == options.angleUnit) preferences.units.angle = unit;
    if (options.fontScale > 0) preferences.fontScale = options.fontScale;
    if (!options.language.empty()) preferences.language = QString::fromStdString(options.language);
    if (!options.model.empty()) preferences.model = QString::fromStdString(options.model);
    if (!options.robot.empty()) preferences.robot = QString::fromStdString(options.robot);
    QStringList dbc;
    for (const std::string& file : options.dbc) dbc << QString::fromStdString(file);
    preferences.dbc = dbc + preferences.dbc;
    preferences.dbc.removeDuplicates();
    return preferences;
}

Result<RobotFile> usableRobot(const QString& preferred, std::vector<Message>& troubles)
{
    if (!preferred.isEmpty()) {
        auto robot = readRobotFile(preferred.toStdString());
        if (robot) return robot;
        troubles.push_back(robotNotUsed(robot.error()));
    }
    return readRobotFile(resourcePath("robots/absolem.toml"));
}

std::string usableModel(const QString& preferred, std::vector<Message>& troubles)
{
    if (!preferred.isEmpty()) {
        if (const QFileInfo info(preferred); info.isFile() && info.isReadable())
            return preferred.toStdString();
        troubles.push_back(modelNotUsed(preferred));
    }
    return shippedModelPath();
}

Result<RobotFile> robotFor(const ConsoleOptions& options, LoadedPreferences& loaded)
{
    return options.robot.empty() ? usableRobot(loaded.preferences.robot, loaded.troubles)
                                 : readRobotFile(options.robot);
}

std::string modelFor(const ConsoleOptions& options, LoadedPreferences& loaded)
{
    return options.model.empty() ? usableModel(loaded.preferences.model, loaded.troubles)
                                 : options.model;
}

}  // namespace terratact
