#include "app/main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QTime>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <utility>

#include "app/numbers_page.h"
#include "app/page.h"
#include "app/training_page.h"
#include "core/terrain/body_ceiling.h"
#include "widgets/arming_control.h"
#include "widgets/atem_panel.h"
#include "widgets/card.h"
#include "widgets/drive_pad.h"
#include "widgets/estimate_strip.h"
#include "widgets/event_list.h"
#include "widgets/force_bars.h"
#include "widgets/held_button.h"
#include "widgets/look.h"
#include "widgets/navigation_rail.h"
#include "widgets/probe_card.h"
#include "widgets/robot_readout.h"
#include "widgets/status_header.h"
#include "widgets/terrain_profile_view.h"
#include "widgets/verdict_strip.h"
#include "widgets/words.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

constexpr auto kLook = 10ms;      // at the world
constexpr double kRedraw = 0.04;  // [s] 25 Hz

Tone toneOf(RobotActivity activity)
{
    switch (activity) {
    case RobotActivity::Halted: return Tone::Plain;
    case RobotActivity::Driving:
    case RobotActivity::Pressing:
    case RobotActivity::Probing: return Tone::Accent;
    case RobotActivity::Pressed: return Tone::Good;
    case RobotActivity::Stopped: return Tone::Bad;
    }
    return Tone::Plain;
}

// Short enough for the header; the whole sentence is describe()'s.
QString glance(RobotActivity activity)
{
    switch (activity) {
    case RobotActivity::Halted: return MainWindow::tr("halted");
    case RobotActivity::Driving: return MainWindow::tr("driving");
    case RobotActivity::Pressing: return MainWindow::tr("pressing down");
    case RobotActivity::Pressed: return MainWindow::tr("flippers pressed");
    case RobotActivity::Probing: return MainWindow::tr("arm is probing");
    case RobotActivity::Stopped: return MainWindow::tr("stopped");
    }
    return {};
}

/// Letters and digits typed there are not commands.
bool takesText(const QWidget* widget)
{
    return widget->inherits("QLineEdit") || widget->inherits("QAbstractSpinBox")
        || widget->inherits("QTextEdit") || widget->inherits("QPlainTextEdit")
        || widget->inherits("QComboBox");
}

/// The quality that these settings are of; balanced where they are none's.
Quality qualityOf(const Settings& settings)
{
    const auto found = std::find_if(kQualities.begin(), kQualities.end(), [&](Quality quality) {
        return withQuality(settings, quality) == settings;
    });
    return found == kQualities.end() ? Quality::Balanced : *found;
}

bool isFunctionKey(int key)
{
    return key >= Qt::Key_F1 && key <= Qt::Key_F12;
}

}  // namespace

MainWindow::MainWindow(Options options)
    : robot_(std::move(options.robot)), source_(std::move(options.source)), link_(options.link),
      acquisition_(std::make_unique<Acquisition>(*source_)),
      worker_(std::make_unique<EstimatorWorker>(std::move(options.model))),
      exploration_(
          std::make_unique<Exploration>(*source_, robot_, *worker_, options.exploration, link_))
{
    if (options.panel)
        panel_ = std::make_unique<PanelControl>(std::move(options.panel), *source_, *exploration_);
    setWindowTitle(tr("Terratact — %1").arg(QString::fromStdString(source_->name())));
    build();
    addTraining(options);
    connectAll();
    offerQualities(options.presets);
    offerViews();
    look_.setInterval(kLook);
    connect(&look_, &QTimer::timeout, this, &MainWindow::look);
    setFocus();
    look_.start();
    worker_->start();
    qApp->installEventFilter(this);
    look();
}

MainWindow::~MainWindow() = default;

void MainWindow::build()
{
    setMinimumSize(1200, 680);
    setFocusPolicy(Qt::StrongFocus);  // so that no button has the focus before somebody tabs to it
    resize(1440, 900);

    header_ = new StatusHeader(this);
    header_->setSource(QString::fromStdString(source_->name()));
    header_->setModel(tr("model loading …"), Tone::Doubt);
    header_->arming()->setVisible(link_ != nullptr);
    banner_ = new QLabel(this);
    banner_->setObjectName(QStringLiteral("banner"));
    banner_->setVisible(false);

    rail_ = new NavigationRail(this);
    pages_ = new QStackedWidget(this);
    pages_->addWidget(terrainPage());
    rail_->addPage(tr("Terrain"), Qt::Key_F2,
                   tr("The terrain under the robot, exploring it, and the arm"));
    numbers_ = new NumbersPage(*exploration_, this);
    addPage(numbers_, tr("Numbers"), Qt::Key_F3, tr("The same scene as a table"));
    connect(rail_, &NavigationRail::pageChosen, pages_, &QStackedWidget::setCurrentIndex);

    auto* below = new QHBoxLayout;
    below->setSpacing(0);
    below->addWidget(rail_);
    below->addWidget(pages_, 1);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addWidget(header_);
    all->addWidget(banner_);
    all->addLayout(below, 1);
}

void MainWindow::addPage(Page* page, const QString& name, Qt::Key key, const QString& tip)
{
    pages_->addWidget(page);
    rail_->addPage(name, key, tip);
}

QWidget* MainWindow::terrainPage()
{
    auto* page = new QWidget(this);
    auto* terrainCard = new Card(tr("Terrain"), page);
    verdict_ = new VerdictStrip(page);
    verdict_->setLimit(exploration_->options().stepLimit);
    view_ = new QPushButton(tr("view"), terrainCard);
    view_->setFocusPolicy(Qt::TabFocus);
    view_->setToolTip(tr("What else is drawn: draws, a second method"));
    view_->setAccessibleName(tr("View of the terrain"));
    strip_ = new EstimateStrip(terrainCard);
    terrain_ = new TerrainProfileView(terrainCard);
    terrainCard->note()->hide();
    terrainCard->titleRow()->addWidget(strip_, 1);
    terrainCard->titleRow()->addWidget(view_);
    terrainCard->titleRow()->addWidget(header_->qualityButton());  // the header has no room
    terrainCard->body()->addWidget(strip_->warnings());
    terrainCard->body()->addWidget(terrain_, 1);

    atem_ = new AtemPanel(page);
    probe_ = new ProbeCard(page);

    auto* forceCard = new Card(tr("Front flipper forces [N]"), page);
    forces_ = new ForceBars(forceCard);
    const double threshold = exploration_->options().settings.forceThreshold;
    forces_->setThreshold(threshold);
    forceCard->note()->setText(tr("- - threshold %1 N").arg(words::number(threshold, 1)));
    setTone(*forceCard->note(), Tone::Bad);
    forceCard->body()->addWidget(forces_, 1);

    auto* robotCard = new Card(tr("Robot"), page);
    robotAge_ = robotCard->note();
    robotAge_->setAccessibleName(tr("Age of the telemetry"));
    readout_ = new RobotReadout(robotCard);
    drive_ = new DrivePad(robotCard);
    robotCard->body()->addWidget(readout_, 1);
    robotCard->body()->addWidget(drive_);

    auto* eventCard = new Card(tr("Last minutes"), page);
    events_ = new EventList(eventCard);
    eventCard->body()->addWidget(events_, 1);

    auto* decide = new QVBoxLayout;
    decide->setSpacing(10);
    decide->addWidget(atem_);
    decide->addWidget(probe_, 1);
    auto* upper = new QHBoxLayout;
    upper->setSpacing(10);
    auto* ground = new QVBoxLayout;
    ground->setSpacing(10);
    ground->addWidget(verdict_);
    ground->addWidget(terrainCard, 1);
    upper->addLayout(ground, 1);
    upper->addLayout(decide);
    auto* lower = new QHBoxLayout;
    lower->setSpacing(10);
    lower->addWidget(forceCard, 10);
    lower->addWidget(robotCard, 9);
    lower->addWidget(eventCard, 10);
    for (QWidget* card : std::initializer_list<QWidget*>{atem_, probe_}) card->setFixedWidth(404);

    auto* content = new QVBoxLayout(page);
    content->setContentsMargins(12, 10, 12, 10);
    content->setSpacing(10);
    content->addLayout(upper, 17);
    content->addLayout(lower, 6);
    return page;
}

void MainWindow::addTraining(const Options& options)
{
    training_ = new TrainingPage(*exploration_,
                                 {.robot = robot_,
                                  .model = QString::fromStdString(options.modelPath),
                                  .load = options.training},
                                 this);
    addPage(training_, tr("Training"), Qt::Key_F6,
            tr("Train a model, compare it with the one in use, adopt it"));
    connect(training_, &TrainingPage::adopted, this, [this](const QString& path) {
        worker_->load(modelFileLoader(path.toStdString(), robot_));
    });
    connect(worker_.get(), &EstimatorWorker::modelLoaded, training_, &TrainingPage::adoptionDone);
    for (const auto failed : {&EstimatorWorker::modelKept, &EstimatorWorker::modelFailed})
        connect(worker_.get(), failed, training_, &TrainingPage::adoptionFailed);
    // Nobody has measured what the presets cost with another model.
    connect(training_, &TrainingPage::adoptionFinished, this, [this] { offerQualities({}); });
}

void MainWindow::offerViews()
{
    auto* menu = new QMenu(view_);
    drawsAction_ = menu->addAction(tr("Some of the draws as thin lines (D)"));
    drawsAction_->setCheckable(true);
    connect(drawsAction_, &QAction::toggled, terrain_, &TerrainProfileView::setDrawsShown);
    menu->addSection(tr("A second method beside it"));
    auto* group = new QActionGroup(menu);
    const auto offer = [&](const QString& text, std::optional<Method> method) {
        QAction* action = menu->addAction(text);
        action->setCheckable(true);
        action->setChecked(method == exploration_->secondMethod());
        group->addAction(action);
        connect(action, &QAction::triggered, exploration_.get(),
                [this, method] { exploration_->setSecondMethod(method); });
    };
    offer(tr("none"), std::nullopt);
    for (const Method method : kMethods)
        if (method != Method::Pafac) offer(words::text(name(method)), method);
    view_->setMenu(menu);
}

void MainWindow::offerQualities(const std::vector<PresetCost>& presets)
{
    const Method method = exploration_->options().settings.method;
    QStringList names, lines;
    for (const Quality quality : kQualities) {
        names << words::text(name(quality));
        const auto cost = std::find_if(presets.begin(), presets.end(), [&](const PresetCost& p) {
            return p.method == method && p.quality == quality;
        });
        lines << (cost == presets.end()
                      ? tr("%1: not measured (terratact tradeoff)").arg(names.back())
                      : tr("%1: %2 ms, quantiles ± %3 mm from a long run, mean error %4 mm")
                            .arg(names.back(), words::number(cost->milliseconds, 1),
                                 words::number(cost->offMm, 1), words::number(cost->errorMm, 0)));
    }
    header_->setQualities(names, lines,
                          static_cast<int>(qualityOf(exploration_->options().settings)));
}

void MainWindow::connectAll()
{
    Exploration* exploration = exploration_.get();
    connect(header_, &StatusHeader::helpRequested, this, &MainWindow::showHelp);
    connect(header_, &StatusHeader::qualityChosen, exploration, [exploration](int index) {
        exploration->setQuality(kQualities.at(static_cast<std::size_t>(index)));
    });
    connect(header_, &StatusHeader::stopPressed, exploration, &Exploration::stop);
    if (link_) {
        connect(header_->arming(), &ArmingControl::armingWanted, this,
                [this] { link_->wantArming(); });
        connect(header_->arming(), &ArmingControl::armingConfirmed, this,
                [this] { link_->confirmArming(); });
        connect(header_->arming(), &ArmingControl::disarmed, this, [this] { link_->disarm(); });
    }
    connect(atem_, &AtemPanel::requested, exploration, &Exploration::request);
    connect(atem_, &AtemPanel::aborted, exploration, &Exploration::abort);
    connect(atem_, &AtemPanel::stopReleased, this, &MainWindow::releaseStop);
    connect(strip_, &EstimateStrip::cancelled, exploration, &Exploration::abort);
    connect(probe_, &ProbeCard::approved, exploration, &Exploration::approve);
    connect(probe_, &ProbeCard::refused, exploration, &Exploration::refuse);
    connect(probe_, &ProbeCard::otherChosen, exploration, &Exploration::choose);
    connect(verdict_, &VerdictStrip::limitChosen, exploration, &Exploration::setStepLimit);
    connect(drive_, &DrivePad::driveRequested, exploration, &Exploration::drive);
    connect(drive_, &DrivePad::haltRequested, exploration, &Exploration::halt);
    const auto note = [this](const QString& text, Weight weight) {
        events_->add(text, weight, QTime::currentTime());
    };
    connect(exploration, &Exploration::happened, events_, note);
    if (panel_) connect(panel_.get(), &PanelControl::happened, events_, note);
    connect(worker_.get(), &EstimatorWorker::estimated, this, &MainWindow::look);
    connect(worker_.get(), &EstimatorWorker::modelLoaded, header_,
            [this](const QString& name, const QString& details) {
                modelTrouble_.clear();
                header_->setModel(tr("model %1").arg(name), Tone::Plain, details);
            });
    connect(worker_.get(), &EstimatorWorker::modelFailed, header_, [this](const QString& why) {
        modelTrouble_ = why;
        header_->setModel(tr("no model"), Tone::Bad, why);
    });
}

void MainWindow::look()
{
    const double now = steadyNow();
    tickPanel(now);
    if (link_ && (!panel_ || panel_->answers(now))) link_->operatorAlive();
    latest_ = acquisition_->latest();
    exploration_->tick(now, latest_);
    // An estimate is shown as soon as it is there; all else waits for its turn.
    const bool news = exploration_->estimate().has_value() && !showsEstimate();
    if (news || now - redrawn_ >= kRedraw - 1e-3) redraw(now);
}

void MainWindow::redraw(double now)
{
    redrawn_ = now;
    showLink(now, latest_);
    showArming(now);
    showTerrain(latest_);
    showVerdict();
    showProbe();
    // A preview takes a telemetry's time: its progress would only flicker.
    strip_->setProgress(exploration_->estimating() ? worker_->progress() : std::nullopt);
    header_->setLatched(exploration_->state().phase == AtemPhase::Stopped);
    atem_->setState(exploration_->state(), exploration_->timeLeft());
    QList<Precondition> preconditions = exploration_->preconditions();
    if (panel_) preconditions << panel_->precondition(now);
    atem_->setPreconditions(preconditions);
    const QString whyNot = exploration_->whyNotDriving();
    drive_->setBlocked(whyNot.isEmpty() ? panelForbids(now) : whyNot);
    if (auto* page = qobject_cast<Page*>(pages_->currentWidget())) page->refresh(now);
}

void MainWindow::tickPanel(double now)
{
    if (panel_) panel_->tick(now, atem_->requestButton()->isEnabled());
}

QString MainWindow::panelForbids(double now) const
{
    if (!panel_) return {};
    const Precondition panel = panel_->precondition(now);
    return panel.level == Precondition::Level::Met ? QString() : panel.text;
}

void MainWindow::releaseStop()
{
    if (panel_ && panel_->stopPressed()) {
        events_->add(tr("STOP is pressed on the panel: release it there first"), Weight::Bad,
                     QTime::currentTime());
        return;
    }
    exploration_->releaseStop();
}

void MainWindow::showLink(double now, const std::optional<Received>& latest)
{
    const double age = latest ? now - secondsOf(latest->arrived) : 0.0;
    const bool alive = exploration_->linkAlive();
    worstAge_ = std::max(worstAge_, age);
    if (!alive) {
        header_->setLink(
            latest ? tr("LINK LOST · %1").arg(words::age(age)) : tr("no telemetry yet"), Tone::Bad);
        linkShownAt_ = 0.0;
    } else if (now - linkShownAt_ >= 0.5) {
        header_->setLink(tr("link %1 Hz · ≤ %2")
                             .arg(words::number(acquisition_->rate(), 0), words::age(worstAge_)),
                         worstAge_ <= kStaleAfter ? Tone::Good : Tone::Doubt);
        linkShownAt_ = now;
        worstAge_ = 0.0;
    }
    const std::string trouble = acquisition_->trouble();
    banner_->setVisible(latest && !alive);
    if (latest && !alive)
        banner_->setText(tr("LINK LOST for %1 — nothing on this screen is live%2")
                             .arg(words::age(age),
                                  trouble.empty()
                                      ? QString()
                                      : QStringLiteral(": ") + QString::fromStdString(trouble)));
    if (latest && alive != linkWasAlive_)
        events_->add(alive ? tr("link is up") : tr("link lost"), alive ? Weight::Note : Weight::Bad,
                     QTime::currentTime());
    linkWasAlive_ = alive;

    if (!latest) {
        readout_->clearMeasurement();
        robotAge_->clear();
        header_->setRobot(tr("robot: --"), Tone::Plain);
        return;
    }
    const Measurement& m = latest->sample.measurement;
    const bool fresh = age <= kStaleAfter;
    readout_->setMeasurement(m, age);
    robotAge_->setText(tr("%1 old").arg(words::age(age)));
    setTone(*robotAge_, fresh ? Tone::Muted : Tone::Bad);
    if (fresh) {
        std::array<std::optional<double>, kForceElements> forces;
        std::copy(m.force.begin(), m.force.end(), forces.begin());
        if (latest->count != shownCount_) forces_->setForces(forces);
        header_->setRobot(glance(m.activity), toneOf(m.activity));
    } else {
        forces_->clearForces();
        header_->setRobot(tr("robot: --"), Tone::Doubt);
    }
}

void MainWindow::showArming(double now)
{
    if (!link_) return;
    const CanView view = link_->view();
    const QString whyNot = QString::fromStdString(whyNotArming(view));
    if (!view.transmits) return header_->arming()->setListening(whyNot);
    const ArmingState& state = view.link.arming;
    header_->arming()->setState(state, whyNot.isEmpty() ? panelForbids(now) : whyNot);
    if (state.phase == armingWas_) return;
    if (state.phase == ArmingPhase::Armed)
        events_->add(tr("the robot is armed"), Weight::Note, QTime::currentTime());
    if (state.phase == ArmingPhase::Disarmed)
        events_->add(tr("not armed: %1").arg(QString::fromStdString(describe(state.cause))),
                     state.cause == DisarmCause::Operator ? Weight::Note : Weight::Bad,
                     QTime::currentTime());
    armingWas_ = state.phase;
}

void MainWindow::showTerrain(const std::optional<Received>& latest)
{
    const auto& scene = exploration_->scene();
    const auto& estimate = exploration_->estimate();
    const auto& live = exploration_->live();
    if (live) {
        if (shownLive_ != live) {
            terrain_->setEstimate(*live, tr("The flippers still move: nothing ahead is felt yet"));
            strip_->setLive(tr("LIVE preview"));
            shownReason_.clear();
        }
        shown_.reset();
    } else if (estimate) {
        if (shown_ != estimate) {
            terrain_->setEstimate(*estimate);
            strip_->setEstimate(*estimate, exploration_->estimateSeconds());
            shown_ = estimate;
        }
    } else if (shown_ || shownLive_ || shownReason_ != exploration_->whyNoEstimate()) {
        shown_.reset();
        shownReason_ = exploration_->whyNoEstimate();
        terrain_->clearEstimate(shownReason_);
        strip_->setNothing(QString());
    }
    const auto& second = exploration_->second();
    if (shownSecond_ != second) {
        shownSecond_ = second;
        terrain_->setSecond(second,
                            second ? words::text(name(second->settings.method)) : QString());
    }
    shownLive_ = live;
    shownEstimate_ = estimate.has_value() && !live;
    if (estimate) shownReason_.clear();

    if (latest && (latest->count != shownCount_)) {
        // An estimate belongs to the scene it rests on, so both are drawn in that pose.
        const Measurement& m = scene ? scene->measurement : latest->sample.measurement;
        const Proprioception s = proprioception(m);
        terrain_->setOutline(robotOutline(robot_, s.pitch, s.front, s.rear));
        terrain_->setTruth(scene ? scene->truth : latest->sample.truth);
        shownCount_ = latest->count;
    }
}

void MainWindow::showVerdict()
{
    const auto verdict = exploration_->verdict();
    if (!verdict)
        return verdict_->setNothing(exploration_->live() ? tr("The flippers still move")
                                                         : exploration_->whyNoEstimate());
    QString probe;
    const auto& proposal = exploration_->proposal();
    if (proposal && proposal->worth)
        probe = tr("probe at %1: %2 → %3 bit")
                    .arg(words::binName(proposal->bin), words::number(proposal->bitsBefore, 2),
                         words::number(proposal->worth->bitsAfter, 2));
    verdict_->setVerdict(*verdict, probe);
}

void MainWindow::showProbe()
{
    const auto& proposal = exploration_->proposal();
    const AtemState& state = exploration_->state();
    const bool asking = proposal && state.phase == AtemPhase::ProposingProbe;
    terrain_->setProposedProbe(asking ? std::optional(proposal->bin) : exploration_->probingBin());
    if (asking) {
        probe_->setProposal(*proposal);
        probe_->setTimeLeft(exploration_->timeLeft().value_or(0.0));
    } else if (const auto bin = exploration_->probingBin()) {
        probe_->setProbing(*bin, exploration_->secondsInPhase(),
                           exploration_->options().probeSeconds);
    } else {
        QString why = tr("No probe is proposed. After an exploration the arm is offered where the "
                         "terrain stays uncertain.");
        if (state.phase == AtemPhase::Presenting) {
            if (state.probed)
                why = tr("The arm has measured; its height is part of the estimate.");
            else if (state.approvalExpired)
                why = tr("The proposal was not answered in time, which means no.");
            else if (exploration_->estimate() && !proposal)
                why = tr("No probe: the estimate stands without the arm.");
        }
        probe_->setNothing(why);
    }
}

void MainWindow::showHelp()
{
    if (!help_) {
        help_ = new QLabel(this, Qt::Tool);
        help_->setWindowTitle(tr("Keys"));
        help_->setTextFormat(Qt::RichText);
        help_->setMargin(18);
        const std::pair<QString, QString> keys[]{
            {tr("F12"), tr("STOP, in every window")},
            {tr("R, held"), tr("release STOP")},
            {tr("W or Up, held"), tr("drive forward")},
            {tr("S or Down, held"), tr("drive back")},
            {tr("M, then M held"), tr("arm a robot on a bus; M again disarms it")},
            {tr("A"), tr("explore the terrain")},
            {tr("Space, held"), tr("approve the proposed probe")},
            {tr("N"), tr("refuse it")},
            {tr("1, 2, 3"), tr("ask for another bin instead")},
            {tr("PgUp, PgDown"), tr("raise or lower what counts as an obstacle")},
            {tr("D"), tr("show some of the draws as thin lines")},
            {tr("F2 … F8"), tr("the pages at the left edge")},
            {tr("Esc"), tr("abort the exploration, or clear its result")},
            {tr("Tab, Space"), tr("go to a button, press it")},
        };
        QString text = QStringLiteral("<table cellpadding=4>");
        for (const auto& [key, meaning] : keys)
            text += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>").arg(key, meaning);
        text += QStringLiteral("</table><p>")
              + tr("Terratact %1. Based in part on the work of the Qwt project "
                   "(http://qwt.sf.net).")
                    .arg(QApplication::applicationVersion())
              + QStringLiteral("</p>");
        help_->setText(text);
    }
    help_->show();
    help_->raise();
}

bool MainWindow::keyPressed(int key)
{
    if (const int page = rail_->pageOf(key); page >= 0) {
        rail_->choose(page);
        return true;
    }
    switch (key) {
    case Qt::Key_A:
        if (atem_->requestButton()->isEnabled()) exploration_->request();
        return true;
    case Qt::Key_F1: showHelp(); return true;
    case Qt::Key_D: drawsAction_->toggle(); return true;
    case Qt::Key_PageUp: verdict_->raiseButton()->click(); return true;
    case Qt::Key_PageDown: verdict_->lowerButton()->click(); return true;
    case Qt::Key_1:
    case Qt::Key_2:
    case Qt::Key_3:
        if (probe_->asks()) probe_->otherButton(static_cast<std::size_t>(key - Qt::Key_1))->click();
        return true;
    case Qt::Key_Escape:
        if (atem_->abortButton()->isEnabled()) exploration_->abort();
        return true;
    case Qt::Key_Space: probe_->approveButton()->hold(); return true;
    case Qt::Key_N:
        if (probe_->asks()) probe_->refuseButton()->click();
        return true;
    case Qt::Key_R: atem_->releaseButton()->hold(); return true;
    case Qt::Key_M: header_->arming()->pressKey(); return true;
    case Qt::Key_W:
    case Qt::Key_Up: drive_->forwardButton()->hold(); return true;
    case Qt::Key_S:
    case Qt::Key_Down: drive_->backButton()->hold(); return true;
    default: return false;
    }
}

bool MainWindow::keyReleased(int key)
{
    switch (key) {
    case Qt::Key_Space: probe_->approveButton()->letGoSoon(); return true;
    case Qt::Key_R: atem_->releaseButton()->letGoSoon(); return true;
    case Qt::Key_M: header_->arming()->releaseKey(); return true;
    case Qt::Key_W:
    case Qt::Key_Up: drive_->forwardButton()->letGoSoon(); return true;
    case Qt::Key_S:
    case Qt::Key_Down: drive_->backButton()->letGoSoon(); return true;
    default: return false;
    }
}

bool MainWindow::eventFilter(QObject* object, QEvent* event)
{
    const bool press = event->type() == QEvent::KeyPress;
    if (!(press || event->type() == QEvent::KeyRelease) || !object->isWidgetType()) return false;
    const auto* keys = static_cast<QKeyEvent*>(event);
    if (press && keys->key() == Qt::Key_F12) {  // in every window of the program, dialogs included
        if (!keys->isAutoRepeat()) exploration_->stop();
        return true;
    }
    // A key that is held is let go wherever that happens: over a menu, in a dialog, with Ctrl held.
    if (!press && !keys->isAutoRepeat()) keyReleased(keys->key());
    const auto* widget = static_cast<QWidget*>(object);
    if (widget->window() != this || QApplication::activeModalWidget()
        || QApplication::activePopupWidget())
        return false;
    if (keys->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return false;
    if (takesText(widget) && !isFunctionKey(keys->key())) return false;
    // Space means the button that has the focus; only without one it answers the proposal.
    if (keys->key() == Qt::Key_Space && qobject_cast<const QAbstractButton*>(widget)) return false;
    if (keys->isAutoRepeat()) return keys->key() != Qt::Key_Tab && keys->key() != Qt::Key_Backtab;
    return press ? keyPressed(keys->key()) : keyReleased(keys->key());
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    exploration_->leave();
    event->accept();
}

}  // namespace terratact
