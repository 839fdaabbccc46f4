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
#include "app/review/scenes_page.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_strip.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/readings/verdict_strip.h"

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
    header()->setModel(tr("model loading …"), Tone::Warning);
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
    rows_ = new SceneRows(options_.scenes, this);
    list_ = new ScenesPage(*rows_, this);
    addPage(list_, tr("Scenes"), Qt::Key_F3, tr("All scenes, their verdicts and errors"));
    connect(list_, &ScenesPage::wanted, this, [this](std::size_t scene) {
        showScene(scene);
        rail()->choose(0);
    });
    const auto tool = [this](const QString& text, const QString& tip, int by) {
        QPushButton* button = addTool(text, tip);
        button->setAccessibleName(tip);
        connect(button, &QPushButton::clicked, this, [this, by] { go(by); });
    };
    tool(tr("next\n."), tr("Next scene (.)"), +1);
    tool(tr("previous\n,"), tr("Previous scene (,)"), -1);
    addHelpTool();

    connect(page_->verdict(), &VerdictStrip::limitChosen, this, [this](double metres) {
        options_.stepLimit = metres;
        rows_->forget();
        ask();
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
                if (job == job_) estimated(estimate, seconds);
            });
    connect(worker_.get(), &EstimatorWorker::failed, this, [this](int job, const Message& why) {
        if (job == job_) failed(why);
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
    list_->choose(scene_);
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
    jobScene_ = scene_;
    job_ = worker_->request({measurement_, {}, options_.settings});
    showViewState();
}

/// Estimates a scene that is not shown, for the list.
void ScenesWindow::estimateNext()
{
    const auto next = rows_->nextWithout(scene_ + 1);
    if (!next) return;
    jobScene_ = *next;
    job_ = worker_->request({lineOf(options_.scenes[*next]), {}, options_.settings});
}

void ScenesWindow::estimated(const TwoTrackEstimate& estimate, double seconds)
{
    const TwoTrackScene& scene = options_.scenes[jobScene_];
    setResult(
        {.verdict = verdictOf(estimate, options_.robot, lineOf(scene), {}, options_.stepLimit).both,
         .error = sceneError(estimate, scene.truth)});
    if (jobScene_ == scene_) {
        estimate_ = estimate;
        seconds_ = seconds;
        showViewState();
    }
    estimateNext();
}

void ScenesWindow::failed(const Message& why)
{
    setResult({.trouble = why});
    if (jobScene_ == scene_) {
        trouble_ = why;
        showViewState();
    }
    estimateNext();
}

void ScenesWindow::setResult(SceneResult result)
{
    constexpr std::size_t kSummaryEvery = 50;  // results, of which each summary reads all
    rows_->setResult(jobScene_, std::move(result));
    const bool isAll = rows_->known() == options_.scenes.size();
    if (isAll || jobScene_ == scene_ || rows_->known() % kSummaryEvery == 0) list_->showSummary();
}

QString ScenesWindow::errorText() const
{
    const auto& result = rows_->result(scene_);
    if (knownHeights(options_.scenes[scene_].truth) == 0) return tr("the truth is unknown");
    if (!result || !result->error) return tr("no error yet");
    return tr("error: median %1 mm, mean %2 mm")
        .arg(format::number(1000.0 * result->error->median, 0),
             format::number(1000.0 * result->error->mean, 0));
}

void ScenesWindow::showViewState()
{
    TerrainViewState viewState;
    viewState.count = ++shows_;
    viewState.measurement = viewState.scene = &measurement_;
    const std::vector<ForceArray> forces = forcesOf(options_.scenes[scene_]);
    viewState.forces = &forces;
    const std::vector<TimedForces> noneBefore;  // another scene's forces are no peaks of this one
    viewState.forcesBefore = &noneBefore;
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
    state_->setText(tr("SCENE %1 of %2 in %3 · drive %4 at %5 s · estimated now, not recorded · %6")
                        .arg(scene_ + 1)
                        .arg(options_.scenes.size())
                        .arg(format::fileName(options_.path), format::shownName(scene.run),
                             format::number(scene.time, 2), errorText()));
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
    keys.addGroup(tr("Pages"));
    addPageKeys();
    keys.addGroup(tr("Scenes"));
    step({Qt::Key_Period, Qt::Key_PageDown}, tr("next scene"), [this] { go(+1); });
    step({Qt::Key_Comma, Qt::Key_PageUp}, tr("previous scene"), [this] { go(-1); });
    step({Qt::Key_Home}, tr("first scene"), [this] { showScene(0); });
    step({Qt::Key_End}, tr("last scene"), [this] { showScene(options_.scenes.size()); });
    addSideKeys(keys, *page_->terrain(), false);
    addHelpKeys();
    addRemoteStop();
}

}  // namespace terratact
