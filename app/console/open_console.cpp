#include "app/console/open_console.h"

#include <QFileInfo>
#include <QTime>
#include <QTimer>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "app/console/connection/connect_window.h"
#include "app/console/connection/robot_connection.h"
#include "app/console/demo.h"
#include "app/console/main_window.h"
#include "app/console/next_start.h"
#include "app/console/past/session_retention.h"
#include "app/display/format.h"
#include "app/recording/session_folder.h"
#include "app/runtime/print_text.h"
#include "app/runtime/resources.h"
#include "app/start/console_setup.h"
#include "drivers/sdl_gamepad.h"

namespace terratact {
namespace {

constexpr int kReopen = 1000;  // never an exit code

/// State that outlives a rebuilt window.
struct Lasting {
    std::optional<Preferences> inForce;  ///< preferences of the previous window; empty: none
    std::optional<SessionRetention> house;
    std::optional<ConsoleOptions> former;  ///< before the operator requested another robot
    std::optional<Message> trouble;        ///< why that was not connected
};

struct Chosen {
    LoadedPreferences loaded;
    Preferences inForce;
    RobotFile robot;
    std::string model;  ///< file
};

Result<Chosen> choose(const ConsoleOptions& options, const std::optional<Preferences>& before)
{
    Chosen chosen;
    chosen.loaded = preferencesFor(options);
    std::vector<Message>& troubles = chosen.loaded.troubles;
    auto robot = before ? usableRobot(before->robot, troubles) : robotFor(options, chosen.loaded);
    if (!robot) return robot.error();
    chosen.robot = std::move(*robot);
    chosen.model = before ? usableModel(before->model, troubles) : modelFor(options, chosen.loaded);
    chosen.inForce = before ? *before : inForce(chosen.loaded.preferences, options);
    return chosen;
}

std::string sessionsOf(const ConsoleOptions& options)
{
    return options.sessions.empty() ? sessionFolder() : options.sessions;
}

std::shared_ptr<SessionRecorder> recorderFor(const ConsoleOptions& options, const Chosen& chosen)
{
    const bool simulated = options.can.empty();
    SessionRecorder::Options recording;
    recording.folder = sessionsOf(options);
    recording.on = chosen.inForce.record;
    recording.start = {.program = std::string("terratact-console ") + TERRATACT_VERSION,
                       .source = simulated ? "SIMULATED ROBOT" : options.can,
                       .bus = simulated ? "sim0" : options.can,
                       .transmits = simulated || options.transmit,
                       .robot = chosen.robot.text,
                       .robotHash = chosen.robot.hash};
    return std::make_shared<SessionRecorder>(std::move(recording));
}

/// Returns the costs of the shipped model's presets.
PresetTable shippedPresets()
{
    auto presets = readPresets(resourcePath("models/default.presets.csv"));
    if (!presets) printText(stderr, "terratact-console: {}\n", presets.error().text);
    return presets ? *presets : PresetTable{};
}

/// Returns "Absolem: robots/absolem.toml\nfile of 2026-01-31, 1234 bytes; content 0123456789abcdef".
QString fileDetails(const RobotFile& robot)
{
    const QFileInfo file(QString::fromStdString(robot.path));
    return QCoreApplication::translate("RobotCard", "%1: %2\nfile of %3, %4 bytes; content %5")
        .arg(format::shownName(robot.model.name), format::line(robot.path),
             file.lastModified().toUTC().date().toString(Qt::ISODate),
             QString::number(robot.text.size()), QString::fromStdString(robot.hash.substr(0, 16)));
}

Exploration::Options explorationFor(const ConsoleOptions& options, const Preferences& preferences)
{
    Exploration::Options exploration;
    exploration.settings = withPreferences(exploration.settings, preferences);
    exploration.settings.seed = options.seed;
    exploration.stepLimit = preferences.obstacleLimit;
    exploration.probes = preferences.probes;
    exploration.attitude = preferences.tilt();
    exploration.seconds = preferences.estimateSeconds;
    if (options.can.empty() && options.replay.empty())
        exploration.groundFile = options.terrain == "varied" ? std::string() : options.terrain;
    if (options.isPicture())  // pictures must not fail on a busy machine
        exploration.linkLostAfter = exploration.staleAfter = 5.0;
    return exploration;
}

/// Returns the window's options except the connection.
MainWindow::Options windowOptions(const ConsoleOptions& options, Chosen chosen)
{
    const RobotModel& robot = chosen.robot.model;
    MainWindow::Options window;
    window.robot = robot;
    window.robotDetails = fileDetails(chosen.robot);
    window.modelPath = chosen.model;
    window.model = modelFileLoader(chosen.model, robot);
    window.exploration = explorationFor(options, chosen.inForce);
    window.presets = shippedPresets();
    window.alarmSound = alarmTone();
    window.preferences =
        std::make_unique<PreferenceStore>(std::move(chosen.loaded), chosen.inForce);
    return window;
}

RetentionLimits retentionOf(const Preferences& preferences)
{
    return {.days = static_cast<double>(preferences.keepDays),
            .gigabytes = static_cast<double>(preferences.keepGigabytes),
            .confirmed = preferences.mayDelete};
}

/// Starts the retention of earlier recordings; the window shows its news.
void keepHouse(Lasting& lasting, std::vector<std::string> earlier, const std::string& folder,
               MainWindow& window)
{
    const PreferenceStore& preferences = window.preferences();
    if (!lasting.house)
        lasting.house.emplace(std::move(earlier), folder, retentionOf(preferences.current()));
    SessionRetention* house = &*lasting.house;
    QObject::connect(&preferences, &PreferenceStore::changed, house, [house, &preferences] {
        house->setLimits(retentionOf(preferences.current()));
    });
    const auto showNews = [house, events = window.events()] {
        for (const Message& sentence : house->consumeNews())
            events->add(sentence, EventSeverity::Warning, QTime::currentTime());
    };
    QObject::connect(house, &SessionRetention::news, &window, showNews);
    showNews();
    QTimer::singleShot(0, house, &SessionRetention::start);
}

/// Opens one window; returns kReopen to request another, of the options that it leaves.
Result<int> openOnce(Application& application, ConsoleOptions& options, Lasting& lasting)
{
    auto chosen = choose(options, lasting.inForce);
    if (!chosen) return chosen.error();
    std::vector<std::string> earlier;
    std::shared_ptr<SessionRecorder> recorder;
    if (options.records()) {
        earlier = sessionsIn(sessionsOf(options));  // before this run adds its own session
        recorder = recorderFor(options, *chosen);
    }
    auto connection =
        connectRobot(chosen->robot.model, options, recorder);  // must outlive the window
    if (!connection) return connection.error();
    auto panel = openPanel(options);
    if (!panel) return panel.error();
    if (const Status ready = application.start(chosen->inForce, options.isPicture()); !ready)
        return ready.error();

    MainWindow::Options parts = windowOptions(options, std::move(*chosen));
    parts.link = connection->source.get();
    parts.replay = connection->replay;
    parts.source = std::move(connection->source);
    parts.panel = std::move(*panel);
    if (!options.isPicture()) parts.gamepad = openSdlGamepad();
    parts.recorder = recorder;
    MainWindow window(std::move(parts));
    QObject::connect(
        &window, &MainWindow::reopenWanted, &window, [] { QApplication::exit(kReopen); },
        Qt::QueuedConnection);
    QObject::connect(
        &window, &MainWindow::connectionWanted, &window,
        [&](const ConnectionWish& wish) {
            lasting.former = std::exchange(options, connectedTo(options, wish));
            QApplication::exit(kReopen);
        },
        Qt::QueuedConnection);
    lasting.former.reset();
    if (lasting.trouble) window.showWhyNot(*std::exchange(lasting.trouble, std::nullopt));
    showWindow(window, options, window.preferences().current().window);
    keepHouse(lasting, std::move(earlier), sessionsOf(options), window);
    std::optional<ScreenshotDemo> screenshot;
    if (options.isPicture()) screenshot.emplace(window, QString::fromStdString(options.screenshot));
    const int ended = QApplication::exec();
    lasting.inForce = window.preferences().current();
    return ended;
}

}  // namespace

Result<int> openConsole(Application& application, const ConsoleOptions& options)
{
    Lasting lasting;
    ConsoleOptions now = options;
    for (;;) {
        auto ended = openOnce(application, now, lasting);
        if (!ended) {
            auto next = startAfter(now, std::exchange(lasting.former, std::nullopt),
                                   lasting.trouble, ended.error().message);
            if (!next) return ended;
            now = std::move(next->options);
            lasting.trouble = std::move(next->why);
            continue;
        }
        if (*ended != kReopen) return ended;
    }
}

}  // namespace terratact
