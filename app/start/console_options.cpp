#include "app/start/console_options.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/shell/about.h"
#include "app/shell/console_window.h"
#include "app/shell/preferences/preferences.h"

namespace terratact {
namespace {

/// Parses "1280x720"; returns an empty size, which no window has, for anything else.
QSize sizeFrom(const std::string& text)
{
    int width = 0, height = 0, end = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%n", &width, &height, &end) != 2
        || end != static_cast<int>(text.size()))
        return {};
    return {width, height};
}

std::string whyNoSize(const std::string& text)
{
    const QSize size = sizeFrom(text);
    const bool good = size.expandedTo(ConsoleWindow::kMin) == size && size.width() <= 10000
                   && size.height() <= 10000;
    return good ? std::string()
                : "expected WIDTHxHEIGHT, from 1200x680 to 10000x10000, not " + text;
}

void declareRobot(CLI::App& app, ConsoleOptions& options)
{
    app.add_option("--model", options.model, "Model file (default: the shipped one)");
    app.add_option("--robot", options.robot, "Robot file (default: the shipped Absolem)");
    app.add_option(
        "--terrain", options.terrain,
        "CSV of the profile or ground lines under the simulated robot, or varied (default: "
        "a built-in one)");
    app.add_option("--fault", options.fault,
                   "What goes wrong with the simulated robot, from the start or NAME@SECONDS later")
        ->capture_default_str();
    auto* can =
        app.add_option("--can", options.can,
                       "CAN interface of the robot, such as can0 (default: a simulated robot)")
            ->excludes("--terrain")
            ->excludes("--fault");
    app.add_flag("--transmit", options.transmit,
                 "Command the robot on --can; without it the console only listens")
        ->needs(can);
}

void declareFile(CLI::App& app, ConsoleOptions& options)
{
    auto* replay =
        app.add_option("file,--replay", options.replay,
                       "Session to review, scenes as CSV to go through, or log of CAN frames "
                       "to show as if it happened now")
            ->excludes("--can")
            ->excludes("--terrain")
            ->excludes("--fault");
    app.add_option("--speed", options.speed, "Of the replay: seconds of the log per second")
        ->needs(replay)
        ->check(CLI::Range(0.01, 1000.0));
    app.add_option("--interface", options.interface,
                   "Of a log with frames of several interfaces: which is replayed")
        ->needs(replay);
    app.add_option("--at", options.at, "Of a session: where to begin its review [s]")
        ->needs(replay)
        ->check(CLI::Range(0.0, 1e9));
}

void declareLook(CLI::App& app, ConsoleOptions& options)
{
    app.add_option("--theme", options.theme, "Colours: day, night-red or high-contrast")
        ->check(CLI::IsMember({"day", "night-red", "high-contrast"}));
    app.add_option("--layout", options.layout, "Layout: drive, probe or review")
        ->check(CLI::IsMember({"drive", "probe", "review"}));
    app.add_option("--font-scale", options.fontScale, "Size of the letters [%]")
        ->check(CLI::Range(kSmallestFont, kLargestFont));
    app.add_option("--language", options.language, "en, cs or de (default: the system's)")
        ->check(CLI::IsMember({"en", "cs", "de"}));
    app.add_option("--length-unit", options.lengthUnit, "Unit of lengths: m or cm")
        ->check(CLI::IsMember({"m", "cm"}));
    app.add_option("--angle-unit", options.angleUnit, "Unit of angles: deg or rad")
        ->check(CLI::IsMember({"deg", "rad"}));
}

}  // namespace

CommandFiles filesOf(const ConsoleOptions& options)
{
    CommandFiles files;
    for (const std::string& input :
         {options.model, options.robot, options.terrain, options.replay, options.panel})
        if (!input.empty()) files.inputs.push_back(input);
    files.inputs.insert(files.inputs.end(), options.dbc.begin(), options.dbc.end());
    for (const std::string& input : files.inputs)
        for (std::string& companion : companionsOf(input))
            files.companions.push_back(std::move(companion));
    if (options.isPicture()) files.outputs.push_back(options.screenshot);
    return files;
}

void declareOptions(CLI::App& app, ConsoleOptions& options)
{
    app.set_version_flag("--version",
                         std::string("terratact-console ") + TERRATACT_VERSION + '\n' + kQwtCredit);
    declareRobot(app, options);
    declareFile(app, options);
    app.add_option("--panel", options.panel,
                   "File of the operator's panel on GPIO lines (default: there is none)");
    app.add_option("--dbc", options.dbc,
                   "DBC file for frames that are not the robot's; may be repeated")
        ->allow_extra_args(false);
    app.add_option("--seed", options.seed, "Seed of the random numbers")->capture_default_str();
    app.add_option("--screenshot", options.screenshot,
                   "Drive to a step (or 15 s), estimate the terrain, save the window as PNG, and "
                   "exit; of a session: as it is at --at. It reads no preferences")
        ->excludes("--can");
    declareLook(app, options);
    app.add_flag("--safe-mode", options.safeMode,
                 "Start with the defaults: preferences are neither read nor saved");
    app.add_option("--sessions", options.sessions,
                   "Folder of the recorded sessions (else one in the user's XDG state folder)");
    app.add_flag("--no-record", options.noRecord, "Record nothing, whatever the preferences say");
    app.add_flag("--errors-in-window", options.errorsInWindow,
                 "Say in a window, too, why it cannot start (for menus and file managers)");
    app.add_option_function<std::string>(
           "--size", [&options](const std::string& text) { options.size = sizeFrom(text); },
           "Size of the window, where its screen has that much (default: as it was left)")
        ->check(whyNoSize);
}

}  // namespace terratact
