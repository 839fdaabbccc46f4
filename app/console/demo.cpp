#include "app/console/demo.h"

#include <QApplication>
#include <algorithm>
#include <cstdio>
#include <utility>

#include "app/console/main_window.h"
#include "app/display/translated.h"
#include "app/runtime/print_text.h"
#include "app/shell/window_picture.h"

namespace terratact {
namespace {

constexpr double kPatience = 120.0;     // [s] limit of the whole demonstration
constexpr double kDrivesAtMost = 15.0;  // [s] longest drive; then it explores where it stands
constexpr double kSettle = 0.4;         // [s] the content stays this long before the picture
constexpr double kStepSeen = 0.08;      // [m] rise of the ground 0.5 m ahead that counts as a step

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
    if (steadyNow() - began_ > kPatience) return giveUp(tr("the demonstration took too long"));
    if (!window_.modelTrouble().isEmpty()) return fail(window_.modelTrouble());
    if (stage_ != Stage::Settling
        && !exploration.armed()) {  // at the start, or disarmed by delays of a busy machine
        stage_ = Stage::Loading;
        return arm();
    }
    if (exploration.state().phase == AtemPhase::Failed && stage_ == Stage::Exploring)
        return giveUp(QString::fromStdString(describe(exploration.state().failure).english));

    switch (stage_) {
    case Stage::Loading: {
        const QList<Precondition> preconditions = exploration.preconditions();
        for (const Precondition& condition : preconditions)
            if (condition.level == Precondition::Level::Missing) return;
        exploration.drive(+1);
        if (!drove_) drove_ = steadyNow();
        stage_ = Stage::Driving;
        break;
    }
    case Stage::Driving:
        if (!seesStep() && steadyNow() - *drove_ < kDrivesAtMost) return;
        if (!seesStep())
            printText(
                stderr,
                "terratact-console: no step after {:.0f} s of driving: explored where it stands\n",
                kDrivesAtMost);
        exploration.halt();
        exploration.request();
        stage_ = Stage::Exploring;
        break;
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

bool ScreenshotDemo::seesStep() const
{
    const auto latest = window_.acquisition().latest();
    if (!latest) return false;
    const auto ahead = static_cast<std::size_t>(*binOf(0.5)),
               below = static_cast<std::size_t>(*binOf(0.2));
    const auto rises = [&](const Heights& truth) {
        return truth[ahead] - truth[below] >= kStepSeen;
    };
    const Sample& sample = latest->sample;
    if (sample.sideTruth) return std::ranges::any_of(*sample.sideTruth, rises);
    return sample.truth && rises(*sample.truth);
}

// Performs both actions of arming; begins again if arming fails.
void ScreenshotDemo::arm()
{
    CanSource& link = *window_.link();
    const CanView view = link.view();
    if (view.link.arming.phase == ArmingPhase::Confirming) link.confirmArming();
    if (view.link.arming.phase == ArmingPhase::Disarmed && !whyNotArming(view)) link.wantArming();
}

/// Returns an error text; empty: the picture was saved.
QString ScreenshotDemo::save()
{
    const Status saved = saveWindow(window_, file_.toStdString());
    return saved ? QString() : translated(saved.error().message);
}

void ScreenshotDemo::finish()
{
    timer_.stop();
    const QString trouble = save();
    if (!trouble.isEmpty()) return fail(trouble);
    QApplication::exit(0);
}

/// Saves a picture of the failure and ends with an error.
void ScreenshotDemo::giveUp(const QString& why)
{
    const QString trouble = save();
    fail(QStringLiteral("%1; %2").arg(
        why, trouble.isEmpty() ? tr("%1 shows the window at that time").arg(file_) : trouble));
}

void ScreenshotDemo::fail(const QString& why)
{
    timer_.stop();
    printText(stderr, "terratact-console: {}\n", why.toStdString());
    QApplication::exit(1);
}

}  // namespace terratact
