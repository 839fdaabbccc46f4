#include <cblas.h>
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QFileInfo>
#include <QIcon>
#include <QScreen>
#include <QSocketNotifier>
#include <QTime>
#include <QTimer>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <string>

#include "app/big_blocks.h"
#include "app/can_check.h"
#include "app/can_source.h"
#include "app/demo.h"
#include "app/language.h"
#include "app/main_window.h"
#include "app/open_file.h"
#include "app/resources.h"
#include "app/review_window.h"
#include "app/robot_in_process.h"
#include "app/robot_setup.h"
#include "app/scenes_window.h"
#include "app/session_housekeeping.h"
#include "app/session_recorder.h"
#include "app/steady_now.h"
#include "app/tradeoff_csv.h"
#include "app/what_if.h"
#include "core/atem/panel_file.h"
#include "core/file_read.h"
#include "core/learn/scene_file.h"
#include "core/learn/sha256.h"
#include "drivers/can_interface.h"
#include "drivers/candump_replay.h"
#include "drivers/gpio_lines.h"
#include "drivers/memory_bus.h"
#include "drivers/socketcan.h"
#include "widgets/look.h"

namespace terratact {
namespace {

constexpr int kDone = 0, kFailed = 1, kWrongArguments = 2;
constexpr int kReopen = 1000;              // never an exit code
constexpr double kNominalBitrate = 500e3;  // [bit/s] of the robot's real bus
constexpr double kDemoSpeed = 4.0;         // simulated seconds per second of a screenshot's drive

struct Arguments {
    std::string model, robot, terrain, screenshot, can, replay, panel;
    std::string fault = "none";
    double speed = 1.0;
    std::optional<double> at;
    bool transmit = false;
    std::uint64_t seed = 1;
    std::string size;  ///< empty: as it was left, or 1440x900
    std::string theme, layout, language;
    int fontScale = 0;  ///< [%] 0: as preferred
    bool safeMode = false;
    std::string sessions;  ///< folder; empty: the user's
    bool noRecord = false;
};

constexpr QSize kDefaultSize{1440, 900};

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
                   "Profile the simulated robot stands on, or varied (default: a built-in one)");
    app.add_option("--fault", arguments.fault,
                   "What goes wrong with the simulated robot, from the start or NAME@SECONDS later")
        ->capture_default_str();
    auto* can =
        app.add_option("--can", arguments.can,
                       "CAN interface of the robot, such as can0 (default: a simulated robot)")
            ->excludes("--terrain")
            ->excludes("--fault");
    app.add_flag("--transmit", arguments.transmit,
                 "Command the robot on --can; without it the console only listens")
        ->needs(can);
    auto* replay =
        app.add_option("file,--replay", arguments.replay,
                       "Session to review, scenes as CSV to go through, or log of candump "
                       "-L to show as if it happened now")
            ->excludes(can)
            ->excludes("--terrain")
            ->excludes("--fault");
    app.add_option("--speed", arguments.speed, "Of the replay: seconds of the log per second")
        ->needs(replay)
        ->check(CLI::Range(0.01, 1000.0));
    app.add_option("--at", arguments.at, "Of a session: where to begin its review [s]")
        ->needs(replay)
        ->check(CLI::Range(0.0, 1e9));
    app.add_option("--panel", arguments.panel,
                   "File of the operator's panel on GPIO lines (default: there is none)");
    app.add_option("--seed", arguments.seed, "Seed of the random numbers")->capture_default_str();
    app.add_option("--screenshot", arguments.screenshot,
                   "Drive to a step, estimate it, save the window as PNG, and exit; of a session: "
                   "as it is at --at")
        ->excludes(can);
    app.add_option("--theme", arguments.theme, "Colours: day, night-red or high-contrast")
        ->check(CLI::IsMember({"day", "night-red", "high-contrast"}));
    app.add_option("--layout", arguments.layout, "Layout: drive, probe or review")
        ->check(CLI::IsMember({"drive", "probe", "review"}));
    app.add_option("--font-scale", arguments.fontScale, "Size of the letters [%]")
        ->check(CLI::Range(kSmallestFont, kLargestFont));
    app.add_option("--language", arguments.language, "en, cs or de (default: the system's)")
        ->check(CLI::IsMember({"en", "cs", "de"}));
    app.add_flag("--safe-mode", arguments.safeMode,
                 "Start with the defaults: preferences are neither read nor saved");
    app.add_option("--sessions", arguments.sessions,
                   "Folder of the recorded sessions (else one in the user's XDG state folder)");
    app.add_flag("--no-record", arguments.noRecord, "Record nothing, whatever the preferences say");
    app.add_option("--size", arguments.size, "Size of the window (default: as it was left)")
        ->check([](const std::string& text) {
            const QSize size = sizeFrom(text);
            const QSize least = ConsoleWindow::kLeast;
            const bool good =
                size.expandedTo(least) == size && size.width() <= 10000 && size.height() <= 10000;
            return good ? std::string()
                        : "expected WIDTHxHEIGHT, from 1200x680 to 10000x10000, not " + text;
        });
}

int failed(const std::string& why)
{
    std::fprintf(stderr, "terratact-console: %s\n", why.c_str());
    return kFailed;
}

/// What the shipped model's presets cost.
PresetTable shippedPresets()
{
    auto presets = readPresets(resourcePath("models/default.presets.csv"));
    if (!presets) std::fprintf(stderr, "terratact-console: %s\n", presets.error().text.c_str());
    return presets ? *presets : PresetTable{};
}

/// The built-in robot and its bus; whoever talks to it on an end of that must not outlive it.
struct BuiltInRobot {
    BuiltInRobot(const RobotModel& model, const SimulatedRobot& simulated,
                 const RobotOnBus::Options& options)
        : robot(bus, model, simulated, options)
    {
    }
    MemoryBus bus{steadyNow};
    RobotInProcess robot;
};

std::uint64_t drawn()
{
    std::random_device device;
    return (std::uint64_t{device()} << 32U) | device();
}

Result<std::unique_ptr<BuiltInRobot>> builtInRobot(const RobotModel& model,
                                                   const Arguments& arguments)
{
    const auto ground = robotGround(arguments.terrain, arguments.seed);
    if (!ground) return ground.error();
    const double speed = arguments.screenshot.empty() ? 1.0 : kDemoSpeed;
    const auto onBus =
        withFault({.firstEpoch = static_cast<std::uint8_t>(1 + drawn() % 255), .speed = speed},
                  arguments.fault);
    if (!onBus) return onBus.error();
    SimulatedRobot::Options simulation;
    simulation.startX = ground->start;
    simulation.seed = arguments.seed;
    return std::make_unique<BuiltInRobot>(model, SimulatedRobot(model, ground->profile, simulation),
                                          *onBus);
}

using Heard = std::function<void(std::span<const BusFrame>)>;

std::unique_ptr<CanSource> sourceOn(BuiltInRobot& builtIn, const RobotModel& robot,
                                    const Heard& heard)
{
    return std::make_unique<CanSource>(
        builtIn.bus.join("console"), robot,
        CanSource::Options{.mode = CanSource::Mode::Transmit,
                           .name = "SIMULATED ROBOT",
                           .link = {.seed = drawn()},
                           .truth = [&builtIn] { return builtIn.robot.truth(); },
                           .bitrate = kNominalBitrate,
                           .nominal = true,
                           .heard = heard});
}

Result<std::unique_ptr<CanBus>> openBus(const Arguments& arguments)
{
    if (!arguments.replay.empty()) {
        auto log = CandumpReplay::open(arguments.replay, {.speed = arguments.speed});
        if (!log) return Error{log.error().text + " (a replay needs a log of candump -L)"};
        return std::unique_ptr<CanBus>(std::move(*log));
    }
    auto bus = SocketCan::open({.interface = arguments.can, .transmit = arguments.transmit});
    if (!bus) return bus.error();
    if (const std::string warning = (*bus)->warning(); !warning.empty())
        std::fprintf(stderr, "terratact-console: %s\n", warning.c_str());
    return std::unique_ptr<CanBus>(std::move(*bus));
}

std::unique_ptr<CanSource> onBus(std::unique_ptr<CanBus> bus, const RobotModel& robot,
                                 const Arguments& arguments, const Heard& heard)
{
    using Mode = CanSource::Mode;
    const Mode mode = !arguments.replay.empty() ? Mode::Replay
                    : arguments.transmit        ? Mode::Transmit
                                                : Mode::Listen;
    std::optional<double> bitrate;
    if (const auto told = controllerFrom(linkDetails(arguments.can)).bitrate)
        bitrate = static_cast<double>(*told);
    return std::make_unique<CanSource>(std::move(bus), robot,
                                       CanSource::Options{.mode = mode,
                                                          .link = {.seed = drawn()},
                                                          .waits = mode == Mode::Replay,
                                                          .bitrate = bitrate,
                                                          .heard = heard});
}

/// Where telemetry comes from and commands go to: a robot on a bus or in a log, or else one in `builtIn`.
Status connect(MainWindow::Options& options, const Arguments& arguments,
               std::unique_ptr<BuiltInRobot>& builtIn)
{
    Heard heard;
    if (const auto recorder = options.recorder)
        heard = [recorder](std::span<const BusFrame> frames) { recorder->take(frames); };
    std::unique_ptr<CanSource> source;
    if (!arguments.can.empty() || !arguments.replay.empty()) {
        auto bus = openBus(arguments);
        if (!bus) return bus.error();
        source = onBus(std::move(*bus), options.robot, arguments, heard);
    } else {
        auto robot = builtInRobot(options.robot, arguments);
        if (!robot) return robot.error();
        builtIn = std::move(*robot);
        source = sourceOn(*builtIn, options.robot, heard);
    }
    options.link = source.get();
    options.source = std::move(source);
    if (arguments.panel.empty()) return Done{};
    const auto panel = readPanelFile(arguments.panel);
    if (!panel) return panel.error();
    options.panel = std::make_unique<OperatorPanel>(*panel, openGpioLines);
    return Done{};
}

bool records(const Arguments& arguments)
{
    return !arguments.noRecord && arguments.replay.empty() && arguments.screenshot.empty();
}

std::string sessionsOf(const Arguments& arguments)
{
    return arguments.sessions.empty() ? sessionFolder() : arguments.sessions;
}

/// Looks after the earlier recordings once there is a window to tell of it.
void keepHouse(SessionHousekeeping& house, MainWindow& window)
{
    const auto tell = [&house, events = window.events()] {
        for (const QString& sentence : house.takeNews())
            events->add(sentence, Weight::Doubt, QTime::currentTime());
    };
    QObject::connect(&house, &SessionHousekeeping::news, &window, tell);
    tell();
    QTimer::singleShot(0, &house, &SessionHousekeeping::start);
}

/// Records what happens, unless it has happened before (a replay) or is only for a picture.
std::shared_ptr<SessionRecorder> recorderFor(const Arguments& arguments,
                                             const std::string& robotPath,
                                             const Preferences& preferences)
{
    constexpr std::size_t kMost = 1U << 20U;  // bytes
    const bool simulated = arguments.can.empty();
    const std::string robot =
        readFile(robotPath, kMost) ? *readFile(robotPath, kMost) : std::string();
    SessionRecorder::Options options;
    options.folder = sessionsOf(arguments);
    options.on = preferences.record;
    options.start = {.program = std::string("terratact-console ") + TERRATACT_VERSION,
                     .source = simulated ? "SIMULATED ROBOT" : arguments.can,
                     .bus = simulated ? "sim0" : arguments.can,
                     .transmits = simulated || arguments.transmit,
                     .robot = robot,
                     .robotHash = sha256Hex(robot)};
    return std::make_shared<SessionRecorder>(std::move(options));
}

/// "robots/absolem.toml\ncontent 0123456789abcdef"
QString fileDetails(const std::string& path, const RobotModel& robot)
{
    constexpr std::size_t kMost = 1U << 20U;  // bytes
    const auto content = readFile(path, kMost);
    const std::string hash = content ? sha256Hex(*content).substr(0, 16) : content.error().text;
    const QFileInfo file(QString::fromStdString(path));
    return QCoreApplication::translate("RobotCard", "%1: %2\nfile of %3, %4 bytes; content %5")
        .arg(QString::fromStdString(robot.name), QString::fromStdString(path),
             file.lastModified().toUTC().date().toString(Qt::ISODate), QString::number(file.size()),
             QString::fromStdString(hash));
}

/// The preferences with what the command line says.  A picture's and a safe start have none.
LoadedPreferences preferencesFor(const Arguments& arguments)
{
    const bool none = arguments.safeMode || !arguments.screenshot.empty();
    return loadPreferences(none ? QString() : preferencesPath());
}

Preferences inForce(Preferences preferences, const Arguments& arguments)
{
    for (const ThemeName theme : {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast})
        if (name(theme) == arguments.theme) preferences.theme = theme;
    for (const Layout layout : {Layout::Drive, Layout::Probe, Layout::Review})
        if (name(layout) == arguments.layout) preferences.layout = layout;
    if (arguments.fontScale > 0) preferences.fontScale = arguments.fontScale;
    if (!arguments.language.empty())
        preferences.language = QString::fromStdString(arguments.language);
    if (!arguments.model.empty()) preferences.model = QString::fromStdString(arguments.model);
    if (!arguments.robot.empty()) preferences.robot = QString::fromStdString(arguments.robot);
    return preferences;
}

/// The preferred robot file, or where that cannot be read the shipped one.
std::string usableRobot(const QString& preferred, QStringList& troubles)
{
    if (!preferred.isEmpty()) {
        const auto robot = readRobotModel(preferred.toStdString());
        if (robot) return preferred.toStdString();
        troubles << robotNotUsed(QString::fromStdString(robot.error().text));
    }
    return resourcePath("robots/absolem.toml");
}

/// Likewise the model.
std::string usableModel(const QString& preferred, QStringList& troubles)
{
    if (!preferred.isEmpty()) {
        if (const QFileInfo info(preferred); info.isFile() && info.isReadable())
            return preferred.toStdString();
        troubles << modelNotUsed(preferred);
    }
    return resourcePath("models/default.ttm");
}

/// What the command line says, and else what is preferred.
std::string robotFor(const Arguments& arguments, LoadedPreferences& loaded)
{
    return arguments.robot.empty() ? usableRobot(loaded.preferences.robot, loaded.troubles)
                                   : arguments.robot;
}

std::string modelFor(const Arguments& arguments, LoadedPreferences& loaded)
{
    return arguments.model.empty() ? usableModel(loaded.preferences.model, loaded.troubles)
                                   : arguments.model;
}

void setSize(ConsoleWindow& window, const QByteArray& left, const Arguments& arguments)
{
    const bool isPicture = !arguments.screenshot.empty();
    if (!arguments.size.empty())
        window.resize(sizeFrom(arguments.size));
    else if (left.isEmpty() || !window.restoreGeometry(left))
        window.resize(isPicture ? kDefaultSize
                                : kDefaultSize.boundedTo(window.screen()->availableSize()));
    if (isPicture) window.setRoom(window.size());
}

int endingPipe[2] = {-1, -1};

extern "C" void requestEnd(int /*signal*/)
{
    const char byte = 0;
    [[maybe_unused]] const ssize_t written = ::write(endingPipe[1], &byte, 1);
}

/// A polite signal closes the window as its user would: the robot is halted and the recording closed.
void closeOnSignals(QWidget& window)
{
    if (endingPipe[0] < 0 && ::pipe2(endingPipe, O_CLOEXEC | O_NONBLOCK) != 0) return;
    auto* notifier = new QSocketNotifier(endingPipe[0], QSocketNotifier::Read, &window);
    QObject::connect(notifier, &QSocketNotifier::activated, &window, [&window, notifier] {
        notifier->setEnabled(false);
        window.close();
    });
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) std::signal(signal, requestEnd);
}

/// The application in its language and look; `pictures`: without a display.
Status startApplication(int& argc, char** argv, bool pictures, const Preferences& preferences,
                        std::optional<QApplication>& application)
{
    if (pictures && !std::getenv("QT_QPA_PLATFORM")) setenv("QT_QPA_PLATFORM", "offscreen", 1);
    if (!std::getenv("QT_QPA_PLATFORM") && !std::getenv("DISPLAY")
        && !std::getenv("WAYLAND_DISPLAY"))
        return Error{"no display: set DISPLAY, or use --screenshot FILE"};
    if (!application) application.emplace(argc, argv);
    QApplication::setApplicationName(QStringLiteral("terratact-console"));
    QApplication::setApplicationDisplayName(QStringLiteral("Terratact"));
    QApplication::setApplicationVersion(QStringLiteral(TERRATACT_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("org.terratact.console"));
    QApplication::setWindowIcon(QIcon::fromTheme(QStringLiteral("org.terratact.console")));
    installLanguage(*application, preferences.language);
    applyLook(*application, preferences.theme, preferences.fontScale);
    return Done{};
}

/// Shows a window of a file until it is closed, or saves it as it is once `isReady`.
int showFile(ConsoleWindow& window, const Arguments& arguments,
             const std::function<bool()>& isReady)
{
    setSize(window, {}, arguments);
    closeOnSignals(window);
    window.show();
    if (arguments.screenshot.empty()) return QApplication::exec();
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &window, [&] {
        if (!isReady()) return;
        look.stop();
        const bool saved = window.grab().save(QString::fromStdString(arguments.screenshot), "PNG");
        QApplication::exit(saved ? kDone : failed(arguments.screenshot + ": cannot be written"));
    });
    look.start(200);
    return QApplication::exec();
}

/// Files a session's model may be in: what is preferred, and what is shipped.
QStringList modelsFor(const Arguments& arguments, LoadedPreferences& loaded)
{
    QStringList models{QString::fromStdString(modelFor(arguments, loaded)),
                       QString::fromStdString(resourcePath("models/default.ttm"))};
    models.removeDuplicates();
    return models;
}

/// Opens a recorded session for review and stays until it is closed.
int openReview(int& argc, char** argv, const Arguments& arguments)
{
    auto session = SessionReader::open(arguments.replay);
    if (!session) return failed(session.error().text);
    const auto robot =
        arguments.robot.empty() ? robotOf(*session) : readRobotModel(arguments.robot);
    if (!robot) return failed(robot.error().text);
    LoadedPreferences loaded = preferencesFor(arguments);
    const Preferences preferences = inForce(loaded.preferences, arguments);
    std::optional<QApplication> application;
    if (const Status ready =
            startApplication(argc, argv, !arguments.screenshot.empty(), preferences, application);
        !ready)
        return failed(ready.error().text);
    QStringList models = modelsFor(arguments, loaded);
    ReviewWindow window(
        {.session = std::move(*session),
         .robot = *robot,
         .models = std::move(models),
         .preferences = std::make_unique<PreferenceStore>(std::move(loaded), preferences)});
    if (arguments.at) window.goTo(*arguments.at);
    return showFile(window, arguments, [&window] { return window.surveyed(); });
}

/// Opens a file of scenes and stays until it is closed.
int openScenes(int& argc, char** argv, const Arguments& arguments)
{
    auto file = readScenes(arguments.replay);
    if (!file) return failed(file.error().text);
    if (file->scenes.empty()) return failed(arguments.replay + ": has no scenes");
    LoadedPreferences loaded = preferencesFor(arguments);
    const auto robot = readRobotModel(robotFor(arguments, loaded));
    if (!robot) return failed(robot.error().text);
    const Preferences preferences = inForce(loaded.preferences, arguments);
    std::optional<QApplication> application;
    if (const Status ready =
            startApplication(argc, argv, !arguments.screenshot.empty(), preferences, application);
        !ready)
        return failed(ready.error().text);
    Settings settings = withPreferences({}, preferences);
    settings.seed = arguments.seed;
    ScenesWindow window({.path = QString::fromStdString(arguments.replay),
                         .scenes = std::move(file->scenes),
                         .robot = *robot,
                         .model = modelFileLoader(modelFor(arguments, loaded), *robot),
                         .settings = settings,
                         .stepLimit = preferences.obstacleLimit});
    return showFile(window, arguments, [&window] { return window.estimate().has_value(); });
}

/// Opens the console and stays until it is closed; kReopen: it is to be opened anew.  kept: what was in force in the
/// window before and, afterwards, in this one; empty: there was none.
int openConsole(int& argc, char** argv, const Arguments& arguments,
                std::optional<QApplication>& application, std::optional<Preferences>& kept,
                std::optional<SessionHousekeeping>& house)
{
    LoadedPreferences loaded = preferencesFor(arguments);
    const std::string robotPath =
        kept ? usableRobot(kept->robot, loaded.troubles) : robotFor(arguments, loaded);
    const auto robot = readRobotModel(robotPath);
    if (!robot) return failed(robot.error().text);
    const std::string model =
        kept ? usableModel(kept->model, loaded.troubles) : modelFor(arguments, loaded);
    const Preferences preferences = kept ? *kept : inForce(loaded.preferences, arguments);
    std::unique_ptr<BuiltInRobot> builtIn;  // outlives the window, which talks to it
    MainWindow::Options options;
    options.robot = *robot;
    std::vector<std::string> earlier;
    if (records(arguments)) {
        earlier = sessionsIn(sessionsOf(arguments));
        options.recorder = recorderFor(arguments, robotPath, preferences);
    }
    if (const Status connected = connect(options, arguments, builtIn); !connected)
        return failed(connected.error().text);

    const bool demo = !arguments.screenshot.empty();
    if (const Status ready = startApplication(argc, argv, demo, preferences, application); !ready)
        return failed(ready.error().text);
    options.robotDetails = fileDetails(robotPath, *robot);
    options.modelPath = model;
    options.model = modelFileLoader(model, *robot);
    options.exploration.settings = withPreferences(options.exploration.settings, preferences);
    options.exploration.settings.seed = arguments.seed;
    options.exploration.stepLimit = preferences.obstacleLimit;
    options.exploration.seconds = preferences.estimateSeconds;
    options.presets = shippedPresets();
    options.preferences = std::make_unique<PreferenceStore>(std::move(loaded), preferences);
    if (demo) options.exploration.linkLostAfter = 5.0;  // a picture must not fail on a busy machine

    MainWindow window(std::move(options));
    setSize(window, window.preferences().current().window, arguments);
    QObject::connect(
        &window, &MainWindow::reopenWanted, &window, [] { QApplication::exit(kReopen); },
        Qt::QueuedConnection);
    closeOnSignals(window);
    window.show();
    if (!house)
        house.emplace(
            std::move(earlier),
            SessionRetention{.days = static_cast<double>(preferences.keepDays),
                             .gigabytes = static_cast<double>(preferences.keepGigabytes)});
    keepHouse(*house, window);
    std::optional<ScreenshotDemo> screenshot;
    if (demo) screenshot.emplace(window, QString::fromStdString(arguments.screenshot));
    const int ended = QApplication::exec();
    kept = window.preferences().current();
    return ended;
}

int run(int& argc, char** argv, const Arguments& arguments)
{
    if (!arguments.replay.empty()) {
        const FileKind kind = kindOfFile(QString::fromStdString(arguments.replay));
        if (kind == FileKind::Session) return openReview(argc, argv, arguments);
        if (kind == FileKind::Scenes) return openScenes(argc, argv, arguments);
        if (!arguments.screenshot.empty())
            return failed(arguments.replay + ": is no session, of which a picture could be saved");
    }
    std::optional<QApplication> application;
    std::optional<Preferences> kept;
    std::optional<SessionHousekeeping> house;
    for (;;) {
        const int ended = openConsole(argc, argv, arguments, application, kept, house);
        if (ended != kReopen) return ended;
    }
}

}  // namespace
}  // namespace terratact

int main(int argc, char** argv)
{
    terratact::giveBackBigBlocks();
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
