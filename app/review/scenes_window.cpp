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
#include "widgets/control/drive_strip.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/verdict_strip.h"

namespace terratact {
namespace {

/// Converts a scene to telemetry.
Measurement lineOf(const TwoTrackScene& scene)
{
    Measurement m = measurementOf(scene.s);
    m.time = scene.time;
    m.activity = RobotActivity::Pressed;
    return m;
}

/// Returns the true heights of both sides; NaN, which is not drawn, for unknown ones.
std::optional<std::array<Heights, 2>> truthOf(const TwoTrackScene& scene)
{
    std::array<Heights, 2> truth{};
    bool isKnown = false;
    for (std::size_t side = 0; side < 2; ++side)
        for (std::size_t i = 0; i < kBins; ++i) {
            const std::optional<double>& height = scene.truth.at(side)[i];
            truth.at(side)[i] = height.value_or(std::numeric_limits<double>::quiet_NaN());
            isKnown = isKnown || height;
        }
    return isKnown ? std::optional(truth) : std::nullopt;
}

/// Returns the means of both sides; NaN where one is unknown.
std::optional<Heights> meanOf(const std::optional<std::array<Heights, 2>>& sides)
{
    if (!sides) return std::nullopt;
    Heights mean{};
    for (std::size_t i = 0; i < kBins; ++i) mean[i] = 0.5 * ((*sides)[0][i] + (*sides)[1][i]);
    return mean;
}

/// Returns the forces of the front flippers: one array without a name if left and right are equal.
std::vector<ForceArray> forcesOf(const TwoTrackScene& scene)
{
    const auto arrayOf = [&scene](Flipper flipper, const char* name) {
        ForceArray array{.name = QString::fromLatin1(name)};
        for (std::size_t i = 0; i < kForceElements; ++i)
            array.elements[i].newtons = scene.s.forces[indexOf(flipper)][i];
        return array;
    };
    const auto& left = scene.s.forces[indexOf(Flipper::FrontLeft)];
    const auto& right = scene.s.forces[indexOf(Flipper::FrontRight)];
    if (left == right) return {arrayOf(Flipper::FrontLeft, "")};
    return {arrayOf(Flipper::FrontLeft, "L"), arrayOf(Flipper::FrontRight, "R")};
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
    page_->driveStrip()->hide();  // recorded scenes are not driven
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
    measurement_ = lineOf(options_.scenes[scene_]);
    sideTruth_ = truthOf(options_.scenes[scene_]);
    truth_ = meanOf(sideTruth_);
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
    const std::vector<ForceArray> forces = forcesOf(options_.scenes[scene_]);
    viewState.forces = &forces;
    viewState.sceneTruth = &truth_;
    viewState.sceneSideTruth = &sideTruth_;
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
    viewState.driving = viewState.feeling = viewState.preconditions;
    page_->setViewState(viewState);
    const TwoTrackScene& scene = options_.scenes[scene_];
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
