#include "app/demo.h"

#include <QApplication>
#include <QPixmap>
#include <QSaveFile>
#include <cstdio>
#include <utility>

#include "app/main_window.h"
#include "app/say.h"

namespace terratact {
namespace {

constexpr double kPatience = 120.0;  // [s] for the whole demonstration
constexpr double kSettle = 0.4;      // [s] the picture stands before it is taken
constexpr double kStepSeen = 0.08;   // [m] the ground 0.5 m ahead has risen by more than this

}  // namespace

ScreenshotDemo::ScreenshotDemo(MainWindow& window, QString file)
    : window_(window), file_(std::move(file)), began_(steadyNow())
{
    connect(&timer_, &QTimer::timeout, this, &ScreenshotDemo::tick);
    timer_.start(10);
}

void ScreenshotDemo::tick()
{
    Exploration& exploration = window_.exploration();
    if (steadyNow() - began_ > kPatience) return fail(tr("the demonstration took too long"));
    if (!window_.modelTrouble().isEmpty()) return fail(window_.modelTrouble());
    if (stage_ != Stage::Settling && !exploration.armed()) {  // at first, or for a busy machine
        stage_ = Stage::Loading;
        return arm();
    }
    if (exploration.state().phase == AtemPhase::Failed && stage_ == Stage::Exploring)
        return fail(QString::fromStdString(describe(exploration.state().failure)));

    switch (stage_) {
    case Stage::Loading: {
        const QList<Precondition> preconditions = exploration.preconditions();
        for (const Precondition& condition : preconditions)
            if (condition.level == Precondition::Level::Missing) return;
        exploration.drive(+1);
        stage_ = Stage::Driving;
        break;
    }
    case Stage::Driving: {
        const auto latest = window_.acquisition().latest();
        if (!latest || !latest->sample.truth) return;
        const Heights& truth = *latest->sample.truth;
        const auto ahead = static_cast<std::size_t>(*binOf(0.5)),
                   below = static_cast<std::size_t>(*binOf(0.2));
        if (truth[ahead] - truth[below] < kStepSeen) return;
        exploration.halt();
        exploration.request();
        stage_ = Stage::Exploring;
        break;
    }
    case Stage::Exploring:
        if (!window_.showsEstimate()) return;
        settled_ = steadyNow();
        stage_ = Stage::Settling;
        break;
    case Stage::Settling:
        if (steadyNow() - settled_ >= kSettle) finish();
        break;
    }
}

// Says both words of an operator; an arming that fails is begun anew.
void ScreenshotDemo::arm()
{
    CanSource& link = *window_.link();
    const CanView view = link.view();
    if (view.link.arming.phase == ArmingPhase::Confirming) link.confirmArming();
    if (view.link.arming.phase == ArmingPhase::Disarmed && whyNotArming(view).empty())
        link.wantArming();
}

void ScreenshotDemo::finish()
{
    timer_.stop();
    QSaveFile file(file_);
    if (!file.open(QIODevice::WriteOnly) || !window_.grab().save(&file, "PNG") || !file.commit())
        return fail(tr("%1: cannot be written: %2").arg(file_, file.errorString()));
    QApplication::exit(0);
}

void ScreenshotDemo::fail(const QString& why)
{
    timer_.stop();
    say(stderr, "terratact-console: {}\n", why.toStdString());
    QApplication::exit(1);
}

}  // namespace terratact
