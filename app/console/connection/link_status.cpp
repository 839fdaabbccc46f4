#include "app/console/connection/link_status.h"

#include <QLabel>
#include <QTime>
#include <algorithm>
#include <utility>

#include "app/console/pages/signals_page.h"
#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/preconditions.h"
#include "app/mission/text/bus_text.h"
#include "app/mission/text/robot_text.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"

namespace terratact {
namespace {

constexpr double kRateEvery = 0.5;  // [s] update interval of the telemetry rate

QString sentence(const LinkAccount& link)
{
    return translated(describe(link));
}

QString capitals(const LinkAccount& link)
{
    return sentence(link).toUpper();
}

}  // namespace

LinkStatus::LinkStatus(StatusHeader& header, QLabel& banner, EventList& events,
                       const Acquisition& acquisition, CanSource* link)
    : header_(header), banner_(banner), events_(events), acquisition_(acquisition), link_(link)
{
    header_.arming()->setVisible(link_ != nullptr);
    banner_.setVisible(false);
}

void LinkStatus::show(const LinkViewState& viewState)
{
    const double age =
        viewState.newest ? viewState.now - secondsOf(viewState.newest->arrived) : 0.0;
    worstAge_ = std::max(worstAge_, age);
    const CanView* view = viewState.bus;
    if (view) count(*view, viewState.now);
    showLink(viewState, age);
    if (view) showBus(*view, viewState.now);
    showBanner(viewState, age);
    logChange(viewState.link);
    showRobot(viewState.newest, age);
}

/// Detects new errors. The totals never fall, so only a recent increase makes the link doubtful.
void LinkStatus::count(const CanView& view, double now)
{
    const BusCounters& frames = view.frames;
    droppedLately_ = dropped_.grewLately(frames.dropped, now);
    erredLately_ = errors_.grewLately(frames.errorFrames, now);
}

void LinkStatus::showLink(const LinkViewState& viewState, double age)
{
    const LinkAccount& link = viewState.link;
    if (link.standing == LinkStanding::Up) {
        if (upSince_ == 0.0) upSince_ = viewState.now;
        if (viewState.now - rateShownAt_ >= kRateEvery) showRate(viewState);
        return;
    }
    rateShownAt_ = worstAge_ = upSince_ = 0.0;
    const QString title = capitals(link);
    const QString bus = viewState.bus ? details(*viewState.bus) : QString();
    switch (link.standing) {
    case LinkStanding::Up: break;
    case LinkStanding::Silent: return header_.setLink(sentence(link), Tone::Bad, bus);
    case LinkStanding::Ended: return header_.setLink(title, Tone::Warning, bus);
    case LinkStanding::Unsteady: return header_.setLink(title, Tone::Bad, bus);
    case LinkStanding::Lost:
        header_.setLink(link.alive ? tr("back, not steady yet")
                                   : QStringLiteral("%1 · %2").arg(title, format::age(age)),
                        Tone::Bad, bus);
    }
}

void LinkStatus::showBus(const CanView& view, double now)
{
    if (now - busShownAt_ < kRateEvery && view.bus == busShown_) return;
    busShownAt_ = now;
    busShown_ = view.bus;
    const BusLoad load = link_->tap().load();
    // For a log, the state only shows whether it continues.
    const bool isLog = link_->mode() == CanSource::Mode::Replay;
    const bool isOurs = link_->bitrate().nominal;  // the simulated robot of this program
    QStringList parts{isLog ? tr("log") : isOurs ? tr("bus") : format::shownName(link_->busName())};
    QStringList brief = parts;
    if (!isLog || view.bus != BusState::Up) parts << glance(view.bus);
    if (view.bus != BusState::Up) brief << glance(view.bus);
    parts << loadGlance(load, link_->bitrate());
    const std::uint64_t dropped = view.frames.dropped, errors = view.frames.errorFrames;
    if (dropped > 0) parts << (droppedLately_ ? tr("! %1 dropped") : tr("%1 dropped")).arg(dropped);
    if (droppedLately_) brief << parts.last();
    if (errors > 0) parts << (erredLately_ ? tr("! %1 errors") : tr("%1 errors")).arg(errors);
    if (erredLately_) brief << parts.last();
    const Tone tone = toneOf(view.bus);
    const bool isDoubtful = droppedLately_ || erredLately_;
    header_.setBus(parts.join(QLatin1Char(' ')),
                   tone == Tone::Plain && isDoubtful ? Tone::Warning : tone, details(view),
                   brief.join(QLatin1Char(' ')));
}

void LinkStatus::showRate(const LinkViewState& viewState)
{
    const double now = viewState.now;
    const CanView* view = viewState.bus;
    const std::uint64_t dropped = view ? view->frames.dropped : 0;
    // The rate covers one second, so it is shown after one second.
    QString text = now - upSince_ < 1.0
                     ? tr("link ≤ %1").arg(format::age(worstAge_))
                     : tr("link %1 Hz · ≤ %2")
                           .arg(format::number(acquisition_.rate(), 0), format::age(worstAge_));
    if (dropped > 0) text += tr(" · %1 dropped").arg(dropped);
    const bool isGood =
        worstAge_ <= kStaleAfter && (!view || view->bus == BusState::Up) && !droppedLately_;
    header_.setLink(text, isGood ? Tone::Good : Tone::Warning, view ? details(*view) : QString());
    rateShownAt_ = now;
    worstAge_ = 0.0;
}

QString LinkStatus::details(const CanView& view) const
{
    const BusLoad load = link_->tap().load();
    return tr("%1\n%2 frames/s, %3\n%4 frames dropped by this computer, %5 error frames")
        .arg(busStateText(view.bus, link_->busName()), format::number(load.framesPerSecond, 0),
             busLoadText(load, link_->bitrate()), QString::number(view.frames.dropped),
             QString::number(view.frames.errorFrames));
}

QString LinkStatus::bannerText(const LinkViewState& viewState, double age) const
{
    const LinkAccount& link = viewState.link;
    if (link.standing != LinkStanding::Lost && link.standing != LinkStanding::Unsteady) return {};
    const QString title = capitals(link);
    if (link.standing == LinkStanding::Unsteady)
        return tr("%1 — gaps: %2, the longest %3; values read -- during a gap")
            .arg(title, QString::number(link.gaps), format::age(link.longest));
    if (link.alive)
        return tr("LINK RESTORED after %1 — values are live; the terrain predates the gap")
            .arg(format::age(link.longest));
    const QString trouble = translated(troubleOf(viewState.bus, acquisition_.trouble()));
    const QString why = trouble.isEmpty() ? QString() : QStringLiteral(": ") + trouble;
    return link.alone
             ? tr("%1 for %2 — %3; no measured value is live%4")
                   .arg(title, format::age(age), viewState.otherFrames, why)
             : tr("%1 for %2 — nothing on this screen is live%3").arg(title, format::age(age), why);
}

void LinkStatus::showBanner(const LinkViewState& viewState, double age)
{
    const QString text = bannerText(viewState, age);
    banner_.setVisible(!text.isEmpty());
    if (!text.isEmpty() && banner_.text() != text) banner_.setText(text);
}

/// Adds events for the loss and return of the link. A flapping link adds one of each. The end of frames that came
/// without telemetry adds one, too.
void LinkStatus::logChange(const LinkAccount& link)
{
    const auto isDown = [](const LinkAccount& one) {
        return one.standing == LinkStanding::Lost || one.standing == LinkStanding::Unsteady;
    };
    const bool worsens = logged_.alone && !link.alone;
    if (link.standing == logged_.standing && !(isDown(link) && worsens)) return;
    if (isDown(link) && isDown(logged_) && !worsens) return;
    logged_ = link;
    if (link.standing == LinkStanding::Up && link.gaps > 1)
        events_.add(Message(TR_NOOP("LinkStatus", "%1; gaps before: %2, the longest %3"),
                            describe(link), link.gaps, verbatim(format::age(link.longest))),
                    EventSeverity::Note, QTime::currentTime());
    else if (link.standing != LinkStanding::Silent)
        events_.add(describe(link), isDown(link) ? EventSeverity::Bad : EventSeverity::Note,
                    QTime::currentTime(), EventPlace::LinkBanner);
}

QString LinkStatus::banner() const
{
    return isBannerShown() ? banner_.text() : QString();
}

bool LinkStatus::isBannerShown() const
{
    return !banner_.isHidden();
}

void LinkStatus::showRobot(const Received* newest, double age)
{
    if (!newest) return header_.setRobot(tr("robot: --"), Tone::Plain);
    const RobotActivity activity = newest->sample.measurement.activity;
    if (age <= kStaleAfter)
        header_.setRobot(glance(activity), toneOf(activity));
    else
        header_.setRobot(tr("robot: --"), Tone::Warning);
}

void LinkStatus::showArming(const CanView* bus, const std::optional<Precondition>& panel)
{
    if (!bus) return;
    const CanView& view = *bus;
    if (view.whyNotTransmitting)
        return header_.arming()->setListening(translated(*view.whyNotTransmitting));
    const ArmingState& state = view.link.arming;
    QList<Precondition> needs = Preconditions::toArm(view);
    if (panel) needs << *panel;
    header_.arming()->setState(state, needs);
    if (state.phase == armingWas_) return;
    const bool wasArmed = std::exchange(armingWas_, state.phase) == ArmingPhase::Armed;
    if (state.phase == ArmingPhase::Armed)
        events_.add(TR_NOOP("LinkStatus", "the robot is armed"), EventSeverity::Note,
                    QTime::currentTime());
    if (state.phase == ArmingPhase::Disarmed)
        events_.add(Message(wasArmed ? TR_NOOP("LinkStatus", "disarmed: %1")
                                     : TR_NOOP("LinkStatus", "not armed: %1"),
                            describe(state.cause)),
                    state.cause == DisarmCause::Operator ? EventSeverity::Note : EventSeverity::Bad,
                    QTime::currentTime());
}

}  // namespace terratact
