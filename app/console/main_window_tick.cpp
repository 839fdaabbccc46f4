// What happens at every tick: the exploration is polled, then the window is drawn from one moment.
#include <QLabel>
#include <QPushButton>
#include <utility>

#include "app/console/main_window.h"
#include "app/console/pages/live_plots.h"
#include "app/console/pages/settings_page.h"
#include "app/console/past/replay_bar.h"
#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/session_event_logger.h"
#include "app/shell/page.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/covered.h"
#include "widgets/control/drive_strip.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"

namespace terratact {

namespace {

constexpr double kRedraw = 0.04;       // [s] 25 Hz
constexpr double kStaleRedraw = 0.06;  // [s] redraw period without new telemetry, for growing ages
constexpr double kNumbers = 0.2;       // [s] update period of numbers, slow enough to read

}  // namespace

void MainWindow::pollSoon()
{
    if (!pollPending_.exchange(true))
        QMetaObject::invokeMethod(this, &MainWindow::poll, Qt::QueuedConnection);
}

void MainWindow::poll()
{
    pollPending_ = false;
    const double now = steadyNow();
    const double input = inputClock_();
    const auto frozen = stalls_.poll(input);
    if (frozen) logStall(*frozen);
    sharedStop_->poll();
    tickPanel(now);
    pollGamepad(input, frozen.has_value());
    if (link_ && (!panel_ || panel_->answers(now))) link_->operatorAlive();
    // A paused log is no silent robot: its picture stays to be looked at.
    if (!replayBar_ || !replayBar_->isStill()) moment_ = momentOf(now, *acquisition_, link_);
    if (lookWaits_) showLook();
    const AtemPhase before = exploration_->state().phase;
    exploration_->tick(moment_);
    // An estimate is drawn at once, and so is a phase that changes what is offered. Telemetry and previews are drawn at
    // 25 Hz, everything else later. Painting would also take processors from a running estimate; by the next frame most
    // estimates are ready.
    const AtemPhase phase = exploration_->state().phase;
    const bool computes = phase == AtemPhase::Estimating || phase == AtemPhase::EstimatingAgain;
    if (computes && phase != before) redrawn_ = now;
    const bool news = (phase != before && !computes)
                   || (exploration_->estimation().estimate().has_value() && !showsEstimate());
    const bool isLive = exploring(phase) || (moment_.latest && moment_.latest->count != drawn_);
    if (news || now - redrawn_ >= (isLive ? kRedraw : kStaleRedraw) - 1e-3) redraw();
}

/// Reports a stall of a console that can send commands. The stall blocked motion commands, or the robot's watchdog
/// halted it.
void MainWindow::logStall(double seconds)
{
    if (link_ && exploration_->armed())
        log({TR_NOOP("terratact::MainWindow",
                     "this window froze for %1 ms: no command could leave"),
             fixed(seconds * 1e3, 0)},
            EventSeverity::Warning);
}

void MainWindow::redraw()
{
    const double now = steadyNow();  // moment_ stands still while a log is paused
    redrawn_ = now;
    const LinkViewState link = viewStates_->link(moment_);
    linkStatus_->show(link);
    showAlarms(link.link);
    showRecording(link.link);
    linkStatus_->showArming(link.bus, viewStates_->panel(now));
    showTerrain();
    using Terrain = ProbeNotice::Terrain;
    probeNotice_->show(exploration_->state(), exploration_->time(), exploration_->proposal(),
                       probeCard()->isVoid(),
                       !terrainPage_->isVisible() ? Terrain::Elsewhere
                       : isCovered(*probeCard())  ? Terrain::Covered
                                                  : Terrain::Seen);
    const StopViewState stop = exploration_->stopViewState();
    const bool elsewhere = stop.state == StopViewState::State::NoEffect && sharedStop_->hasOther();
    stopDisplay_->show(elsewhere ? StopViewState{.state = StopViewState::State::Elsewhere} : stop);
    showPanelLost();
    if (replayBar_) replayBar_->poll();
    if (!std::exchange(wasArmed_, exploration_->armed()) && wasArmed_)
        notice_->endRefusal();  // "not armed"
    notice_->poll(now, !stopDisplay_->isLate());
    header()->setOverridden(translated(Message::listed(exploration_->overridden(), "; ")));
    if (settings_->isVisible()) showCards();
    if (auto* page = qobject_cast<Page*>(currentPage())) page->refresh(now);
    plots_->poll(moment_);

    prepared_ = steadyNow() - now;
    if (const auto& latest = moment_.latest; latest && latest->count != drawn_) {
        newestIn_ = secondsOf(latest->arrived);
        drawn_ = latest->count;
    }
}

void MainWindow::showPanelLost()
{
    panelLost_->setVisible(panel_ && panel_->isLost());
    // A receive-only console stops nothing and cannot release another console's STOP.
    panelLost_->setText(
        exploration_->following() ? tr("PANEL LOST: connect the operator's panel")
        : exploration_->state().phase == AtemPhase::Stopped
            ? tr("PANEL LOST, STOP is asserted: connect the operator's panel, then hold R; or "
                 "start without --panel")
            : tr("PANEL LOST: connect the operator's panel, or start without --panel"));
}

void MainWindow::showTerrain()
{
    const double now = moment_.now;
    TerrainViewState viewState = viewStates_->terrain(moment_);
    viewState.numbersDue = now - numbersShown_ >= kNumbers;
    viewState.numbersFor = kNumbers + kStaleRedraw;
    if (viewState.numbersDue) numbersShown_ = now;
    showHistory(viewState);
    terrainPage_->setViewState(viewState);
    showSecondView(viewState);
    soundContact(terrainPage_->driveStrip()->viewState().contact.value_or(FlipperContacts{}),
                 viewState.measurement);
}

/// Plays the ticks of contacts. measurement: the newest; null: none.
void MainWindow::soundContact(const FlipperContacts& contacts, const Measurement* measurement)
{
    using enum RobotActivity;
    const bool moves =
        measurement && (measurement->activity == Driving || measurement->activity == Pressing);
    const std::optional<double> pitch = contactCue_.poll(contacts, moves, moment_.now);
    const int level = preferences_->current().contactSound;
    if (pitch && level > 0) alarms_->contactTick(*pitch, level / 100.0);
}

bool MainWindow::event(QEvent* event)
{
    if (event->type() != QEvent::UpdateRequest) return ConsoleWindow::event(event);
    const double began = steadyNow();
    const bool done = ConsoleWindow::event(event);  // paints all changes
    const double ended = steadyNow();
    meter_.frame(prepared_ + ended - began, newestIn_ < 0.0 ? -1.0 : ended - newestIn_);
    prepared_ = 0.0;
    newestIn_ = -1.0;
    return done;
}

void MainWindow::showAlarms(const LinkAccount& link)
{
    alarms_->poll(moment_.now, viewStates_->alarms(moment_, link));
    const AlarmList& list = alarms_->list();
    const auto all = list.alarms().size();
    header()->setAlarms(static_cast<int>(all - list.count(AlarmState::Acknowledged)),
                        static_cast<int>(all));
}

void MainWindow::showRecording(const LinkAccount& link)
{
    if (!eventLogger_) return;
    eventLogger_->poll(link, moment_.bus, alarms_->list(),
                       panel_ ? std::optional(panel_->state()) : std::nullopt);
    recordingDisplay_->show(recorder_->state());
}

void MainWindow::tickPanel(double now)
{
    if (!panel_) return;
    const bool silent = alarms_->list().silentFor(now) > 0.0;
    panel_->tick(now, {.mayExplore = atemPanel()->requestButton()->isEnabled(),
                       .shown = probeCard()->shown(),
                       .covered = terrainPage_->isVisible() && isCovered(*probeCard()),
                       .mayAsk = alarms_->soundOn() && !silent && !probeCard()->isVoid()});
}

}  // namespace terratact
