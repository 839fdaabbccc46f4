#include "app/console/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QLabel>
#include <QPushButton>
#include <QTime>
#include <QVBoxLayout>
#include <chrono>
#include <utility>

#include "app/console/console_keys.h"
#include "app/console/gamepad_control.h"
#include "app/console/pages/alarms_page.h"
#include "app/console/pages/gamepad_page.h"
#include "app/console/pages/live_plots.h"
#include "app/console/pages/settings_page.h"
#include "app/console/pages/signals_page.h"
#include "app/console/pages/training_page.h"
#include "app/console/past/history_control.h"
#include "app/console/past/replay_bar.h"
#include "app/console/profile_menu.h"
#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/session_event_logger.h"
#include "app/pages/numbers_page.h"
#include "app/pages/plots_page.h"
#include "app/shell/open_file.h"
#include "app/shell/page.h"
#include "app/shell/view_menu.h"
#include "widgets/base/elided_label.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/alarm_table.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

constexpr auto kPollPeriod = 10ms;  // polling period
constexpr double kToRead = 0.7;     // [s] an earlier request is a double click or key repeat

}  // namespace

MainWindow::MainWindow(Options options)
    : preferences_(options.preferences ? std::move(options.preferences)
                                       : std::make_unique<PreferenceStore>()),
      presets_(std::move(options.presets)), robot_(std::move(options.robot)),
      source_(std::move(options.source)), link_(options.link),
      acquisition_(std::make_unique<Acquisition>(
          *source_, [this] { pollSoon(); }, robot_)),
      worker_(std::make_unique<EstimatorWorker>(std::move(options.model))),
      exploration_(
          std::make_unique<Exploration>(*source_, robot_, *worker_, options.exploration, link_)),
      alarms_(std::make_unique<ConsoleAlarms>(std::move(options.alarmSound))),
      recorder_(std::move(options.recorder)),
      meter_(std::chrono::duration<double>(kPollPeriod).count()),
      inputClock_(std::move(options.inputClock)), robotDetails_(std::move(options.robotDetails))
{
    if (options.panel)
        panel_ = std::make_unique<PanelControl>(std::move(options.panel), *source_, *exploration_);
    viewStates_ = std::make_unique<LiveViewState>(
        LiveViewState::Parts{*acquisition_, *exploration_, *worker_, link_, panel_.get(),
                             recorder_.get(), preferences_.get()},
        robot_);
    setWindowTitle(tr("%1 — Terratact").arg(format::sourceName(source_->name())));
    build(options);
    connectAll();
    addGamepad(std::move(options.gamepad));
    if (recorder_) {
        eventLogger_ = std::make_unique<SessionEventLogger>(recorder_, *exploration_, *worker_);
        connect(events(), &EventList::added, eventLogger_.get(), &SessionEventLogger::word);
        recorder_->setOn(preferences_->current().record);
        const QString unusual = changesOf(Preferences{}, preferences_->current());
        if (!unusual.isEmpty()) eventLogger_->decision("settings", verbatim(unusual));
    }
    offerQualities();
    profileMenu_ = new ProfileMenu(*terrain(), *exploration_, viewButton());
    viewButton()->setMenu(profileMenu_);
    addHistory();
    defineKeys();
    for (const Message& trouble : preferences_->troubles()) log(trouble, EventSeverity::Warning);
    pollTimer_.setInterval(kPollPeriod);
    connect(&pollTimer_, &QTimer::timeout, this, [this] {
        meter_.beat(steadyNow());
        poll();
    });
    setFocus();
    pollTimer_.start();
    worker_->start();
    poll();
}

MainWindow::~MainWindow()
{
    exploration_->leave();  // halts motion however the window is destroyed
}

void MainWindow::build(const Options& options)
{
    header()->setSource(format::sourceName(source_->name()));
    header()->setModel(tr("model loading …"), Tone::Warning);
    sharedStop_ = std::make_unique<SharedStop>(*exploration_);
    stopDisplay_ = std::make_unique<StopDisplay>(*header(), *addBanner());
    notice_ = std::make_unique<ShortNotice>(*addBanner());
    probeNotice_ = std::make_unique<ProbeNotice>(*rail(), *addBanner());
    panelLost_ = addBanner();
    QLabel& banner = *addBanner();
    QLabel& notRecorded = *addBanner();
    addPages(options);
    linkStatus_ = std::make_unique<LinkStatus>(*header(), banner, *events(), *acquisition_, link_);
    recording_ = addTool({}, {});
    recordingDisplay_ = std::make_unique<RecordingDisplay>(*recording_, notRecorded);
    recording_->setVisible(recorder_ != nullptr);
    connect(recording_, &QPushButton::clicked, this, &MainWindow::mark);
    connect(
        addTool(tr("Open"), tr("Review a session, a log or scenes in a separate window (Ctrl+O)")),
        &QPushButton::clicked, this, &MainWindow::open);
    if (options.replay) addBelowPages(replayBar_ = new ReplayBar(*options.replay, this));
    addViewTool(*preferences_, tr("restarts the console"));
    addHelpTool(demonstrations(), [this](const QString& path) {
        openInAnotherWindow(path, sharedStop_->line(), notOpened());
    });
    arrange();
}

void MainWindow::addPages(const Options& options)
{
    terrainPage_ = new TerrainPage(robot_, this);
    verdict()->setLimit(exploration_->options().stepLimit);
    terrainPage_->addTerrainTool(header()->qualityButton());  // the header is too narrow
    addPage(terrainPage_, tr("Terrain"), Qt::Key_F2, tr("Terrain, exploration and arm"));
    numbers_ = new NumbersPage(
        [this] {
            const Estimation& estimation = exploration_->estimation();
            const auto& estimate = estimation.estimate();
            return NumbersViewState{
                estimate ? &*estimate : nullptr,
                estimation.revisions().estimate,
                translated(exploration_->whyNoEstimate()),
                exploration_->options().stepLimit,
                estimation.verdict(),
                moment_.latest ? std::optional(moment_.now - secondsOf(moment_.latest->arrived))
                               : std::nullopt};
        },
        this);
    addScrolledPage(numbers_, tr("Numbers"), Qt::Key_F3, tr("The same scene as a table"));
    alarms_->setSoundOn(preferences_->current().sound);
    alarmsPage_ = new AlarmsPage(*alarms_, this);
    connect(alarmsPage_->table(), &AlarmTable::soundWanted, this,
            [this](bool on) { preferences_->change([on](Preferences& p) { p.sound = on; }); });
    addScrolledPage(alarmsPage_, tr("Alarms"), Qt::Key_F4,
                    tr("Active alarms, and past alarms not yet acknowledged"));
    signalsPage_ = new SignalsPage(moment_, *acquisition_, link_, *preferences_, this);
    addScrolledPage(signalsPage_, tr("Signals"), Qt::Key_F5,
                    tr("Every signal on the bus, and its newest frames"));
    addTraining(options);
    settings_ = new SettingsPage(*preferences_, this);
    connect(settings_, &SettingsPage::robotChosen, this, &MainWindow::applyRobot);
    connect(settings_, &SettingsPage::filesWanted, this, &MainWindow::showSettingsFiles);
    connect(settings_, &SettingsPage::connectWanted, this, &MainWindow::showConnect);
    addPage(settings_, tr("Settings"), Qt::Key_F7, tr("Method, limits, look, model and robot"));
    gamepadPage_ = new GamepadPage(*preferences_, this);
    const QString source = format::sourceName(source_->name());
    diagnosticsPage_ = new DiagnosticsPage(
        [this, source] {
            return consoleDiagnostics(viewStates_->facts(moment_, source, robotDetails_), meter_);
        },
        this);
    addPage(diagnosticsPage_, tr("Diagnostics"), Qt::Key_F8,
            tr("Versions, permissions and how fast the console is"));
    cardsPage_ = new QWidget(this);
    auto* cards = new QVBoxLayout(cardsPage_);
    cards->setContentsMargins(12, 10, 12, 10);
    addScrolledPage(cardsPage_, tr("Robot"), Qt::Key_F9,
                    tr("Forces, attitude and the last events"));
    addScrolledPage(gamepadPage_, tr("Gamepad"), Qt::Key_F10,
                    tr("What arrives from the gamepad, and what its controls do"));
    plots_ = std::make_unique<LivePlots>(*acquisition_, link_, *exploration_, *preferences_, this);
    if (signalsPage_->dbc()) plots_->describeBy(*signalsPage_->dbc());
    addScrolledPage(plots_->page(), tr("Plots"), kPlotsKey, tr("Any signal over time"));
    plots_->page()->dockIn(*this);
    connect(terrainPage_, &TerrainPage::tightened, this, &MainWindow::placeCards);
    terrainPage_->allowTight(*this);
    placeCards();
}

PlotsPage* MainWindow::plotsPage() const
{
    return plots_->page();
}

void MainWindow::placeCards()
{
    const int page = rail()->pageOf(Qt::Key_F9);
    const bool apart = terrainPage_->isTight();
    rail()->setOffered(page, apart);
    if (apart)
        cardsPage_->layout()->addWidget(terrainPage_->lower());
    else
        terrainPage_->placeLower();
    terrainPage_->lower()->show();
    if (!apart && rail()->chosen() == page) rail()->choose(0);
}

void MainWindow::addTraining(const Options& options)
{
    training_ = new TrainingPage(*exploration_,
                                 {.robot = robot_,
                                  .model = QString::fromStdString(options.modelPath),
                                  .load = options.training},
                                 this);
    addScrolledPage(training_, tr("Training"), Qt::Key_F6,
                    tr("Train a model, compare it with the one in use, adopt it"));
    models_ = std::make_unique<ModelChoice>(*worker_, *preferences_, robot_,
                                            QString::fromStdString(options.modelPath));
    connect(models_.get(), &ModelChoice::loaded, this,
            [this] { training_->setModelInUse(models_->inUse()); });
    connect(training_, &TrainingPage::adopted, models_.get(), &ModelChoice::load);
    connect(worker_.get(), &EstimatorWorker::modelLoaded, training_, &TrainingPage::adoptionDone);
    for (const auto failed : {&EstimatorWorker::modelKept, &EstimatorWorker::modelFailed})
        connect(worker_.get(), failed, training_, &TrainingPage::adoptionFailed);
}

void MainWindow::connectAll()
{
    connectHeader();
    connect(events(), &EventList::added, this, &MainWindow::notice);
    connect(preferences_.get(), &PreferenceStore::changed, this, &MainWindow::applyPreferences);
    connect(preferences_.get(), &PreferenceStore::notSaved, this,
            [this](const Message& why) { log(why, EventSeverity::Warning); });
    connectExploration();
    connectStop();
    connect(alarms_.get(), &ConsoleAlarms::raised, this,
            [this](const Message& text, Severity severity) {
                log(text,
                    severity == Severity::Critical ? EventSeverity::Bad : EventSeverity::Warning);
            });
    if (panel_) connect(alarms_.get(), &ConsoleAlarms::sounded, panel_.get(), &PanelControl::buzz);
    connectWorker();
}

void MainWindow::connectHeader()
{
    connect(header(), &StatusHeader::alarmsRequested, this,
            [this] { rail()->choose(rail()->pageOf(Qt::Key_F4)); });
    connect(header(), &StatusHeader::busRequested, this,
            [this] { rail()->choose(rail()->pageOf(Qt::Key_F5)); });
    connect(header(), &StatusHeader::qualityChosen, this, [this](int index) {
        preferences_->change([index](Preferences& p) {
            p.preset = kQualityPresets.at(static_cast<std::size_t>(index));
        });
    });
    connect(header(), &StatusHeader::stopPressed, exploration_.get(), &Exploration::stop);
    if (link_) {
        connect(header()->arming(), &ArmingControl::armingWanted, this,
                [this] { link_->wantArming(); });
        connect(header()->arming(), &ArmingControl::armingConfirmed, this,
                [this] { link_->confirmArming(); });
        connect(header()->arming(), &ArmingControl::disarmed, this, [this] { link_->disarm(); });
        connect(header()->arming(), &ArmingControl::impossible, this,
                [this](const Message& missing) {
                    showWhyNot({TR_NOOP("terratact::MainWindow", "not armed: %1"), missing});
                });
    }
}

void MainWindow::connectExploration()
{
    Exploration* exploration = exploration_.get();
    connect(atemPanel(), &AtemPanel::requested, exploration, &Exploration::request);
    connect(atemPanel(), &AtemPanel::aborted, exploration, &Exploration::abort);
    connect(atemPanel(), &AtemPanel::forgetWanted, exploration, &Exploration::forgetResult);
    connect(atemPanel(), &AtemPanel::probeWanted, exploration, &Exploration::askProbe);
    connect(atemPanel(), &AtemPanel::overrideWanted, exploration, &Exploration::overrideWarnings);
    connect(atemPanel(), &AtemPanel::stopReleased, this, &MainWindow::releaseStop);
    connect(strip(), &EstimateStrip::cancelled, exploration, &Exploration::abort);
    connect(probeCard(), &ProbeCard::approved, exploration, &Exploration::approve);
    connect(probeCard(), &ProbeCard::refused, exploration, &Exploration::refuse);
    connect(probeCard(), &ProbeCard::otherChosen, exploration, &Exploration::choose);
    connect(verdict(), &VerdictStrip::limitChosen, this, [this](double metres) {
        preferences_->change([metres](Preferences& p) { p.obstacleLimit = metres; });
    });
    connect(drivePad(), &DrivePad::driveRequested, exploration, &Exploration::drive);
    connect(drivePad(), &DrivePad::haltRequested, exploration, &Exploration::halt);
    connect(drivePad(), &DrivePad::feelForwardRequested, exploration, &Exploration::feelForward);
    connect(drivePad(), &DrivePad::letGo, exploration, &Exploration::letGo);
    connect(exploration, &Exploration::happened, this, &MainWindow::log);
    connect(exploration, &Exploration::stateChanged, this, &MainWindow::logState);
    if (panel_) connect(panel_.get(), &PanelControl::happened, this, &MainWindow::log);
}

/// Reports trouble on every page, in a banner if the event list is hidden.
void MainWindow::notice(const Message& text, EventSeverity severity, EventPlace place)
{
    const bool isShown = (place == EventPlace::ExplorationPanel && atemPanel()->isVisible())
                      || (place == EventPlace::LinkBanner && linkStatus_->isBannerShown());
    if (severity != EventSeverity::Bad || events()->isVisible() || isShown) return;
    notice_->show(translated(text), steadyNow());
}

void MainWindow::connectWorker()
{
    // Queued, because the signal is emitted while the estimate's other state is still changing.
    connect(&exploration_->estimation(), &Estimation::estimateReady, this, &MainWindow::poll,
            Qt::QueuedConnection);
    connect(worker_.get(), &EstimatorWorker::advised, this, &MainWindow::poll);
    connect(worker_.get(), &EstimatorWorker::modelLoaded, this,
            [this](const QString& name, const QString& details) {
                header()->setModel(tr("model %1").arg(name), Tone::Plain, details);
                offerQualities();
                if (link_) link_->begin();  // begins a replay now, so that no press is missed
            });
    connect(worker_.get(), &EstimatorWorker::modelFailed, this, [this](const Message& why) {
        header()->setModel(tr("no model"), Tone::Bad, translated(why));
        if (link_) link_->begin();
    });
}

void MainWindow::connectStop()
{
    connect(sharedStop_.get(), &SharedStop::happened, this, &MainWindow::log);
    connect(sharedStop_.get(), &SharedStop::received, this, [this](const Message& text) {
        events()->log(translated(text), EventSeverity::Note, QTime::currentTime());
    });
    connect(sharedStop_.get(), &SharedStop::reported, this,
            [this](const Message& text) { notice_->show(translated(text), steadyNow()); });
    sharedStop_->listen();
}

void MainWindow::restartMeter()
{
    meter_ = LoopMeter(std::chrono::duration<double>(kPollPeriod).count());
}

void MainWindow::mark()
{
    if (!eventLogger_ || !recorder_->state().recording)
        return log(TR_NOOP("terratact::MainWindow", "not marked: nothing is recorded"),
                   EventSeverity::Warning);
    eventLogger_->mark({});
    log(TR_NOOP("terratact::MainWindow", "marked in the recording"), EventSeverity::Note);
}

void MainWindow::releaseStop()
{
    if (const auto why = panel_ ? panel_->whyNotReleased() : std::nullopt)
        return log(*why, EventSeverity::Bad);
    exploration_->releaseStop();
}

void MainWindow::logState(const Message& text, EventSeverity severity)
{
    events()->add(text, severity, QTime::currentTime(), EventPlace::ExplorationPanel);
}

void MainWindow::log(const Message& text, EventSeverity severity)
{
    events()->add(text, severity, QTime::currentTime());
}

void MainWindow::showWhyNot(const Message& text)
{
    log(text, EventSeverity::Warning);
    notice_->showRefusal(translated(text), steadyNow());
}

void MainWindow::defineKeys()
{
    KeyTable& keys = keyTable();
    addRobotKeys(keys, *this);

    keys.addGroup(tr("Pages"));
    addPageKeys();
    numbers_->addKeys(keys);
    plots_->page()->addKeys(keys);
    addHelpKeys();
    addWindowKeys(keys);

    if (recorder_)
        keys.add({{Qt::Key_K}, tr("mark this moment in the recording"), [this] { mark(); }});

    addExplorationKeys(keys, *this, profileMenu_->draws());
    if (replayBar_) replayBar_->addKeys(keys);

    setKeysNote(tr("In a review, these keys move in time and no robot: A, B, F, M, P, K, 1 to 8, "
                   "Space, Page Up and Down, Up and Down."));
    keys.addGroup(tr("View"));
    addViewKeys(keys, *preferences_);
    addFullScreenKey();
    keys.add({{Qt::Key_Tab, Qt::Key_Backtab}, tr("to the next control, to the previous one"), {}});
}

void MainWindow::leave()
{
    exploration_->leave();
    preferences_->change([this](Preferences& p) { p.window = saveGeometry(); });
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    const double now = steadyNow(), since = now - closeRefused_;
    const bool isAnswer = since > kToRead && since <= ShortNotice::kFor;
    if (mayAskBeforeClosing() && link_ && exploration_->armed() && !isAnswer) {
        closeRefused_ = now;
        const Message why(TR_NOOP("terratact::MainWindow",
                                  "THE ROBOT IS ARMED: close the window again within %1 s to halt "
                                  "and disarm it; or disarm it first (M)"),
                          fixed(ShortNotice::kFor, 0));
        notice_->show(translated(why), now);
        if (since > ShortNotice::kFor) log(why, EventSeverity::Warning);
        return event->ignore();
    }
    leave();
    event->accept();
}

}  // namespace terratact
