#include <cblas.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <random>
#include <string>

#include "app/can_source.h"
#include "app/demo.h"
#include "app/main_window.h"
#include "app/resources.h"
#include "app/tradeoff_csv.h"
#include "core/atem/panel_file.h"
#include "core/learn/profile_file.h"
#include "core/sim/simulated_robot.h"
#include "core/sim/terrain_shapes.h"
#include "drivers/candump_replay.h"
#include "drivers/gpio_lines.h"
#include "drivers/sim_source.h"
#include "drivers/socketcan.h"
#include "widgets/look.h"

namespace terratact {
namespace {

constexpr int kDone = 0, kFailed = 1, kWrongArguments = 2;
constexpr double kDemoSpeed = 4.0;  // simulated seconds per second of a screenshot's drive

struct Arguments {
    std::string model, robot, terrain, screenshot, can, replay, panel;
    double speed = 1.0;
    bool transmit = false;
    std::uint64_t seed = 1;
    std::string size = "1440x900";
};

QSize sizeFrom(const std::string& text)
{
    int width = 0, height = 0, end = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%n", &width, &height, &end) != 2
        || end != static_cast<int>(text.size()))
        return {};
    return {width, height};
}

void addArguments(CLI::App& app, Arguments& arguments)
{
    app.set_version_flag(
        "--version", std::string("terratact-console ") + TERRATACT_VERSION
                         + "\nBased in part on the work of the Qwt project (http://qwt.sf.net).");
    app.add_option("--model", arguments.model, "Model file (default: the shipped one)");
    app.add_option("--robot", arguments.robot, "Robot file (default: the shipped Absolem)");
    app.add_option("--terrain", arguments.terrain,
                   "Profile the simulated robot stands on (default: a built-in one)");
    auto* can =
        app.add_option("--can", arguments.can,
                       "CAN interface of the robot, such as can0 (default: a simulated robot)")
            ->excludes("--terrain");
    app.add_flag("--transmit", arguments.transmit,
                 "Command the robot on --can; without it the console only listens")
        ->needs(can);
    auto* replay = app.add_option("--replay", arguments.replay,
                                  "Log of candump -L to show as if it happened now")
                       ->excludes(can)
                       ->excludes("--terrain");
    app.add_option("--speed", arguments.speed, "Of the replay: seconds of the log per second")
        ->needs(replay)
        ->check(CLI::Range(0.01, 1000.0));
    app.add_option("--panel", arguments.panel,
                   "File of the operator's panel on GPIO lines (default: there is none)");
    app.add_option("--seed", arguments.seed, "Seed of the random numbers")->capture_default_str();
    app.add_option("--screenshot", arguments.screenshot,
                   "Drive to a step, estimate it, save the window as PNG, and exit")
        ->excludes(can)
        ->excludes(replay);
    app.add_option("--size", arguments.size, "Size of the window")
        ->capture_default_str()
        ->check([](const std::string& text) {
            const QSize size = sizeFrom(text);
            const bool good = size.width() >= 1200 && size.height() >= 680 && size.width() <= 10000
                           && size.height() <= 10000;
            return good ? std::string()
                        : "expected WIDTHxHEIGHT, from 1200x680 to 10000x10000, not " + text;
        });
}

Result<TerrainProfile> terrainFrom(const std::string& path)
{
    if (path.empty()) return demoTerrain();
    auto file = readProfiles(path, 0.1, false);
    if (!file) return file.error();
    return file->profiles.front();
}

int failed(const std::string& why)
{
    std::fprintf(stderr, "terratact-console: %s\n", why.c_str());
    return kFailed;
}

/// What the shipped model's presets cost; nothing for another model, of which nobody knows.
std::vector<PresetCost> presetsOf(const std::string& model)
{
    if (!model.empty()) return {};
    auto presets = readPresets(resourcePath("models/default.presets.csv"));
    if (!presets) std::fprintf(stderr, "terratact-console: %s\n", presets.error().text.c_str());
    return presets ? *presets : std::vector<PresetCost>{};
}

/// Where the robot starts: with some way to go to the step of the built-in terrain.
double startOn(const TerrainProfile& terrain, bool builtIn)
{
    return builtIn ? kDemoStep - 1.1 : terrain.begin() + 0.7;
}

std::unique_ptr<MeasurementSource> simulated(const RobotModel& robot, const TerrainProfile& terrain,
                                             const Arguments& arguments)
{
    SimulatedRobot::Options simulation;
    simulation.startX = startOn(terrain, arguments.terrain.empty());
    simulation.seed = arguments.seed;
    return std::make_unique<SimSource>(SimulatedRobot(robot, terrain, simulation),
                                       arguments.screenshot.empty() ? 1.0 : kDemoSpeed);
}

Result<std::unique_ptr<CanBus>> openBus(const Arguments& arguments)
{
    if (!arguments.replay.empty()) {
        auto log = CandumpReplay::open(arguments.replay, {.speed = arguments.speed});
        if (!log) return log.error();
        return std::unique_ptr<CanBus>(std::move(*log));
    }
    auto bus = SocketCan::open({.interface = arguments.can, .transmit = arguments.transmit});
    if (!bus) return bus.error();
    if (const std::string warning = (*bus)->warning(); !warning.empty())
        std::fprintf(stderr, "terratact-console: %s\n", warning.c_str());
    return std::unique_ptr<CanBus>(std::move(*bus));
}

std::unique_ptr<CanSource> onBus(std::unique_ptr<CanBus> bus, const RobotModel& robot,
                                 const Arguments& arguments)
{
    using Mode = CanSource::Mode;
    const Mode mode = !arguments.replay.empty() ? Mode::Replay
                    : arguments.transmit        ? Mode::Transmit
                                                : Mode::Listen;
    std::random_device device;
    const std::uint64_t seed = (std::uint64_t{device()} << 32U) | device();
    return std::make_unique<CanSource>(std::move(bus), robot,
                                       CanSource::Options{.mode = mode, .link = {.seed = seed}});
}

/// Where telemetry comes from and commands go to.
Status connect(MainWindow::Options& options, const Arguments& arguments)
{
    if (!arguments.can.empty() || !arguments.replay.empty()) {
        auto bus = openBus(arguments);
        if (!bus) return bus.error();
        auto source = onBus(std::move(*bus), options.robot, arguments);
        options.link = source.get();
        options.source = std::move(source);
    } else {
        const auto terrain = terrainFrom(arguments.terrain);
        if (!terrain) return terrain.error();
        options.source = simulated(options.robot, *terrain, arguments);
    }
    if (arguments.panel.empty()) return Done{};
    const auto panel = readPanelFile(arguments.panel);
    if (!panel) return panel.error();
    options.panel = std::make_unique<OperatorPanel>(*panel, openGpioLines);
    return Done{};
}

int run(int argc, char** argv, const Arguments& arguments)
{
    auto robot = readRobotModel(arguments.robot.empty() ? resourcePath("robots/absolem.toml")
                                                        : arguments.robot);
    if (!robot) return failed(robot.error().text);
    MainWindow::Options options;
    options.robot = *robot;
    if (const Status connected = connect(options, arguments); !connected)
        return failed(connected.error().text);

    const bool demo = !arguments.screenshot.empty();
    if (demo && !std::getenv("QT_QPA_PLATFORM")) setenv("QT_QPA_PLATFORM", "offscreen", 1);
    if (!std::getenv("QT_QPA_PLATFORM") && !std::getenv("DISPLAY")
        && !std::getenv("WAYLAND_DISPLAY"))
        return failed("no display: set DISPLAY, or use --screenshot FILE");

    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("terratact-console"));
    QApplication::setApplicationDisplayName(QStringLiteral("Terratact"));
    QApplication::setApplicationVersion(QStringLiteral(TERRATACT_VERSION));
    applyLook(application);

    options.modelPath =
        arguments.model.empty() ? resourcePath("models/default.ttm") : arguments.model;
    options.model = modelFileLoader(options.modelPath, *robot);
    options.exploration.settings = withQuality(options.exploration.settings, Quality::Balanced);
    options.exploration.settings.seed = arguments.seed;
    options.presets = presetsOf(arguments.model);
    if (demo) options.exploration.linkLostAfter = 5.0;  // a picture must not fail on a busy machine

    MainWindow window(std::move(options));
    window.resize(sizeFrom(arguments.size));
    window.show();
    if (!demo) return QApplication::exec();
    const ScreenshotDemo screenshot(window, QString::fromStdString(arguments.screenshot));
    return QApplication::exec();
}

}  // namespace
}  // namespace terratact

int main(int argc, char** argv)
{
    openblas_set_num_threads(1);  // the estimator has threads of its own
    try {
        CLI::App app("The operator's console of Terratact: feel the terrain that cannot be seen");
        terratact::Arguments arguments;
        addArguments(app, arguments);
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return app.exit(error) == 0 ? terratact::kDone : terratact::kWrongArguments;
        }
        return terratact::run(argc, argv, arguments);
    } catch (const std::exception& error) {
        return terratact::failed(error.what());
    }
}
