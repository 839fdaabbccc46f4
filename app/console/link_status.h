#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>

#include "app/link/acquisition.h"
#include "app/link/can_source.h"
#include "app/runtime/growing_count.h"
#include "core/atem/link_watch.h"
#include "widgets/control/precondition.h"

class QLabel;

namespace terratact {

class EventList;
class StatusHeader;

/// What a window knows of the robot's telemetry at one time.
struct LinkViewState {
    double now = 0.0;                  ///< [s] on the steady clock
    const Received* newest = nullptr;  ///< null: none came yet
    LinkAccount link{};
    QString heard{};  ///< what comes where telemetry does not; empty: nothing
};

/// Says how the link is and what the robot at its other end does: in the header, in a banner over the whole width
/// where nothing on the screen is live, and in the list of events when that changes.  GUI thread only.
class LinkStatus {
    Q_DECLARE_TR_FUNCTIONS(LinkStatus)
public:
    /// link: the source where it is a bus; else null.  All must outlive it.
    LinkStatus(StatusHeader& header, QLabel& banner, EventList& events,
               const Acquisition& acquisition, CanSource* link);

    /// To be called whenever the window is drawn.
    void show(const LinkViewState& viewState);
    /// Likewise.  panel: what it says to setting something in motion; empty: there is none.
    void showArming(const std::optional<Precondition>& panel);
    bool says(const QString& text) const;  ///< the banner does, in capitals

private:
    void count(const CanView& view, double now);
    void showLink(const LinkViewState& viewState, double age);
    void showRate(double now);
    void showBus(const CanView& view, double now);
    void showBanner(const LinkViewState& viewState, double age);
    QString bannerText(const LinkViewState& viewState, double age) const;
    void tellChange(const LinkAccount& link);
    void showRobot(const Received* newest, double age);
    QString details(const CanView& view) const;

    StatusHeader& header_;
    QLabel& banner_;
    EventList& events_;
    const Acquisition& acquisition_;
    CanSource* link_;
    LinkAccount told_;  ///< in the list of events
    ArmingPhase armingWas_ = ArmingPhase::Disarmed;
    GrowingCount dropped_, errors_;
    bool droppedLately_ = false, erredLately_ = false;
    double rateShownAt_ = 0.0;  ///< [s]; 0: the link was not up since
    double busShownAt_ = 0.0;   ///< [s]
    BusState busShown_ = BusState::Up;
    double upSince_ = 0.0;   ///< [s] the link; 0: it is not
    double worstAge_ = 0.0;  ///< [s] of telemetry, since then
};

}  // namespace terratact
