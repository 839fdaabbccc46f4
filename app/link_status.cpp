#include "app/link_status.h"

#include <QLabel>
#include <QTime>
#include <algorithm>

#include "app/bus_words.h"
#include "app/preconditions.h"
#include "app/robot_words.h"
#include "app/signals_page.h"
#include "widgets/arming_control.h"
#include "widgets/event_list.h"
#include "widgets/robot_readout.h"
#include "widgets/status_header.h"
#include "widgets/words.h"

namespace terratact {
namespace {

constexpr double kRateEvery = 0.5;  // [s] the rate of telemetry is shown anew

}  // namespace

LinkStatus::LinkStatus(StatusHeader& header, QLabel& banner, EventList& events,
                       const Acquisition& acquisition, CanSource* link)
    : header_(header), banner_(banner), events_(events), acquisition_(acquisition), link_(link)
{
    header_.arming()->setVisible(link_ != nullptr);
    banner_.setVisible(false);
}

void LinkStatus::show(const LinkSight& sight)
{
    const double age = sight.newest ? sight.now - secondsOf(sight.newest->arrived) : 0.0;
    worstAge_ = std::max(worstAge_, age);
    count(sight.now);
    showLink(sight, age);
    showBus(sight.now);
    showBanner(sight, age);
    tellChange(sight);
    showRobot(sight.newest, age);
}

/// What a doubt is only while it happens: the counts stand for ever.
void LinkStatus::count(double now)
{
    if (!link_) return;
    const BusCounters frames = link_->view().frames;
    droppedLately_ = dropped_.grewLately(frames.dropped, now);
    erredLately_ = errors_.grewLately(frames.errorFrames, now);
}

void LinkStatus::showLink(const LinkSight& sight, double age)
{
    if (sight.alive && !sight.ended) {
        if (sight.now - rateShownAt_ >= kRateEvery) showRate(sight.now);
        return;
    }
    const QString bus = link_ ? details(link_->view()) : QString();
    if (sight.ended) return header_.setLink(tr("END OF THE LOG"), Tone::Doubt, bus);
    header_.setLink(sight.newest ? tr("LINK LOST · %1").arg(words::age(age))
                                 : tr("no telemetry yet"),
                    Tone::Bad, bus);
    rateShownAt_ = 0.0;
}

void LinkStatus::showBus(double now)
{
    if (!link_ || now - busShownAt_ < kRateEvery) return;
    busShownAt_ = now;
    const CanView view = link_->view();
    const BusLoad load = link_->tap().load();
    // Of a log the state says only whether it goes on.
    const bool isLog = link_->mode() == CanSource::Mode::Replay;
    const bool isOurs = link_->bitrate().nominal;  // a robot in this program
    QStringList parts{isLog    ? tr("log")
                      : isOurs ? tr("bus")
                               : QString::fromStdString(link_->busName())};
    if (!isLog || view.bus != BusState::Up) parts << glance(view.bus);
    const QString brief = parts.join(QLatin1Char(' '));
    parts << loadGlance(load, link_->bitrate());
    const std::uint64_t dropped = view.frames.dropped, errors = view.frames.errorFrames;
    if (dropped > 0) parts << (droppedLately_ ? tr("! %1 dropped") : tr("%1 dropped")).arg(dropped);
    if (errors > 0) parts << (erredLately_ ? tr("! %1 errors") : tr("%1 errors")).arg(errors);
    const Tone tone = toneOf(view.bus);
    const bool isDoubtful = droppedLately_ || erredLately_;
    header_.setBus(parts.join(QLatin1Char(' ')),
                   tone == Tone::Plain && isDoubtful ? Tone::Doubt : tone, details(view), brief);
}

void LinkStatus::showRate(double now)
{
    const auto view = link_ ? std::optional(link_->view()) : std::nullopt;
    const std::uint64_t dropped = view ? view->frames.dropped : 0;
    QString text =
        tr("link %1 Hz · ≤ %2").arg(words::number(acquisition_.rate(), 0), words::age(worstAge_));
    if (dropped > 0) text += tr(" · %1 dropped").arg(dropped);
    const bool isGood =
        worstAge_ <= kStaleAfter && (!view || view->bus == BusState::Up) && !droppedLately_;
    header_.setLink(text, isGood ? Tone::Good : Tone::Doubt, view ? details(*view) : QString());
    rateShownAt_ = now;
    worstAge_ = 0.0;
}

QString LinkStatus::details(const CanView& view) const
{
    const BusLoad load = link_->tap().load();
    return tr("%1\n%2 frames/s, %3\n%4 frames dropped by this computer, %5 error frames")
        .arg(busWords(view.bus, link_->busName()), words::number(load.framesPerSecond, 0),
             loadWords(load, link_->bitrate()), QString::number(view.frames.dropped),
             QString::number(view.frames.errorFrames));
}

void LinkStatus::showBanner(const LinkSight& sight, double age)
{
    banner_.setVisible(sight.newest && !sight.alive && !sight.ended);
    if (!banner_.isVisible()) return;
    const QString heard = link_ ? stillComes(link_->tap().frames(sight.now)) : QString();
    const QString trouble = troubleWords(link_, acquisition_.trouble());
    const QString why = trouble.isEmpty() ? QString() : QStringLiteral(": ") + trouble;
    banner_.setText(
        heard.isEmpty()
            ? tr("LINK LOST for %1 — nothing on this screen is live%2").arg(words::age(age), why)
            : tr("TELEMETRY LOST for %1 — %2; no measured value is live%3")
                  .arg(words::age(age), heard, why));
}

void LinkStatus::tellChange(const LinkSight& sight)
{
    const bool alive = sight.alive && !sight.ended;
    if (sight.newest && alive != wasAlive_)
        events_.add(alive         ? tr("link is up")
                    : sight.ended ? tr("end of the log")
                                  : tr("link lost"),
                    alive || sight.ended ? Weight::Note : Weight::Bad, QTime::currentTime());
    wasAlive_ = alive;
}

void LinkStatus::showRobot(const Received* newest, double age)
{
    if (!newest) return header_.setRobot(tr("robot: --"), Tone::Plain);
    const RobotActivity activity = newest->sample.measurement.activity;
    if (age <= kStaleAfter)
        header_.setRobot(glance(activity), toneOf(activity));
    else
        header_.setRobot(tr("robot: --"), Tone::Doubt);
}

void LinkStatus::showArming(const std::optional<Precondition>& panel)
{
    if (!link_) return;
    const CanView view = link_->view();
    if (!view.transmits) return header_.arming()->setListening(whyFollowing(link_));
    const ArmingState& state = view.link.arming;
    QList<Precondition> needs = Preconditions::toArm(view);
    if (panel) needs << *panel;
    header_.arming()->setState(state, needs);
    if (state.phase == armingWas_) return;
    armingWas_ = state.phase;
    if (state.phase == ArmingPhase::Armed)
        events_.add(tr("the robot is armed"), Weight::Note, QTime::currentTime());
    if (state.phase == ArmingPhase::Disarmed)
        events_.add(tr("not armed: %1").arg(words::sentence(describe(state.cause))),
                    state.cause == DisarmCause::Operator ? Weight::Note : Weight::Bad,
                    QTime::currentTime());
}

}  // namespace terratact
