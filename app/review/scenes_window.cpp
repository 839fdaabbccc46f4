#include "app/review/scenes_window.h"

#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <limits>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/pages/side_keys.h"
#include "app/pages/terrain_page.h"
#include "widgets/base/theme.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/verdict_strip.h"

namespace terratact {
namespace {

/// Converts a scene to telemetry; left and right are equal.
Measurement measurementOf(const Scene& scene)
{
    Measurement m;
    m.time = scene.time;
    m.pitch = scene.s.pitch;
    m.frontLeft = m.frontRight = scene.s.front;
    m.rearLeft = m.rearRight = scene.s.rear;
    m.frontLeftCurrent = m.frontRightCurrent = scene.s.frontCurrent.value_or(0.0);
    m.rearLeftCurrent = m.rearRightCurrent = scene.s.rearCurrent.value_or(0.0);
    for (std::size_t i = 0; i < m.force.size(); ++i) m.force[i] = scene.s.force[i].value_or(0.0);
    m.missing = missingFeatures(scene.s);
    m.activity = RobotActivity::Pressed;
    return m;
}

/// Returns the true heights; NaN, which is not drawn, for unknown ones.
std::optional<Heights> truthOf(const Scene& scene)
{
    Heights truth{};
    bool isKnown = false;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        truth[i] = scene.truth[i].value_or(std::numeric_limits<double>::quiet_NaN());
        isKnown = isKnown || scene.truth[i];
    }
    return isKnown ? std::optional(truth) : std::nullopt;
}

}  // namespace

ScenesWindow::ScenesWindow(Options options)
    : options_(std::move(options)), worker_(std::make_unique<EstimatorWorker>(options_.model))
{
    const QString name = format::fileName(options_.path);
    setWindowTitle(tr("SCENES — %1 — Terratact").arg(name));
    header()->setSource(tr("SCENES OF A FILE"));
    header()->setModel(tr("model loading …"), Tone::Doubt);
    for (QWidget* const unused : std::initializer_list<QWidget*>{
             header()->arming(), header()->qualityButton(), header()->alarmsButton()})
        unused->hide();
    state_ = addStrip(QStringLiteral("reviewStrip"));
    page_ = new TerrainPage(options_.robot, this);
    page_->arrange(Layout::Review, lookInForce().fontScale);
    page_->setVerdictBeside(404);
    page_->viewButton()->hide();
    page_->events()->parentWidget()->hide();
    page_->atemPanel()->forbidCommands();
    page_->atemPanel()->hide();
    page_->setThreshold(options_.settings.forceThreshold);
    header()->setLink(tr("no link: a file"), Tone::Plain);
    header()->setRobot(tr("robot: --"), Tone::Plain);
    addPage(page_, tr("Terrain"), Qt::Key_F2, tr("The scene and its estimate"));
    const auto tool = [this](const QString& text, const QString& tip, int by) {
        QPushButton* button = addTool(text, tip);
        button->setAccessibleName(tip);
        connect(button, &QPushButton::clicked, this, [this, by] { go(by); });
    };
    tool(tr("next\n."), tr("Next scene (.)"), +1);
    tool(tr("before\n,"), tr("Previous scene (,)"), -1);
    addHelpTool();

    connect(page_->verdict(), &VerdictStrip::limitChosen, this, [this](double metres) {
        options_.stepLimit = metres;
        showViewState();
    });
    connect(worker_.get(), &EstimatorWorker::modelLoaded, this, [this](const QString& model) {
        header()->setModel(tr("model %1").arg(model), Tone::Plain);
        ask();
    });
    connect(worker_.get(), &EstimatorWorker::modelFailed, this, [this](const Message& why) {
        header()->setModel(tr("no model"), Tone::Bad, translated(why));
        trouble_ = why;
        showViewState();
    });
    connect(worker_.get(), &EstimatorWorker::estimated, this,
            [this](int job, const TwoTrackEstimate& estimate, double seconds) {
                if (job != job_) return;
                estimate_ = estimate;
                seconds_ = seconds;
                showViewState();
            });
    connect(worker_.get(), &EstimatorWorker::failed, this, [this](int job, const Message& why) {
        if (job != job_) return;
        trouble_ = why;
        showViewState();
    });
    defineKeys();
    worker_->start();
    showScene(0);
    setFocus();
}

ScenesWindow::~ScenesWindow() = default;

void ScenesWindow::showScene(std::size_t scene)
{
    scene_ = std::min(scene, options_.scenes.size() - 1);
    measurement_ = measurementOf(options_.scenes[scene_]);
    truth_ = truthOf(options_.scenes[scene_]);
    ask();
}

void ScenesWindow::go(int by)
{
    if (by < 0 && scene_ == 0) return;
    showScene(by < 0 ? scene_ - 1 : scene_ + 1);
}

void ScenesWindow::ask()
{
    estimate_.reset();
    trouble_ = {};
    job_ = worker_->request({measurement_, {}, options_.settings});
    showViewState();
}

void ScenesWindow::showViewState()
{
    TerrainViewState viewState;
    viewState.count = ++shows_;
    viewState.measurement = viewState.scene = &measurement_;
    ForceArray array;
    for (std::size_t i = 0; i < kForceElements; ++i)
        array.elements[i].newtons = options_.scenes[scene_].s.force[i];
    const std::vector<ForceArray> forces{array};
    viewState.forces = &forces;
    viewState.sceneTruth = &truth_;
    viewState.whyNoEstimate = trouble_.empty() ? tr("Estimating …") : translated(trouble_);
    page_->verdict()->setLimit(options_.stepLimit);
    if (estimate_) {
        viewState.estimate = {&*estimate_, estimate_.revision()};
        viewState.estimateSeconds = seconds_;
        viewState.verdict =
            verdictOf(*estimate_, options_.robot, measurement_, {}, options_.stepLimit);
        viewState.state.phase = AtemPhase::Presenting;
    }
    viewState.preconditions << Precondition{
        Precondition::Level::Missing,
        TR_NOOP("terratact::ScenesWindow", "A scene of a file commands no robot")};
    viewState.driving = viewState.preconditions;
    page_->setViewState(viewState);
    const Scene& scene = options_.scenes[scene_];
    state_->setText(tr("SCENE %1 of %2 in %3 · drive %4 at %5 s · estimated now, not recorded · "
                       "keys . and , step")
                        .arg(scene_ + 1)
                        .arg(options_.scenes.size())
                        .arg(format::fileName(options_.path), format::shownName(scene.run),
                             format::number(scene.time, 2)));
}

void ScenesWindow::defineKeys()
{
    KeyTable& keys = keyTable();
    const auto step = [&keys](QList<QKeyCombination> of, const QString& meaning,
                              std::function<void()> act) {
        keys.add({.keys = std::move(of),
                  .meaning = meaning,
                  .pressed = std::move(act),
                  .repeats = true});
    };
    keys.addGroup(tr("Scenes"));
    step({Qt::Key_Period, Qt::Key_PageDown}, tr("next scene"), [this] { go(+1); });
    step({Qt::Key_Comma, Qt::Key_PageUp}, tr("previous scene"), [this] { go(-1); });
    step({Qt::Key_Home}, tr("first scene"), [this] { showScene(0); });
    step({Qt::Key_End}, tr("last scene"), [this] { showScene(options_.scenes.size()); });
    addSideKeys(keys, *page_->terrain());
    addHelpKeys();
    addRemoteStop();
}

}  // namespace terratact
