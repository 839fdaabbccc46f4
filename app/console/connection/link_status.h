#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>

#include "app/display/precondition.h"
#include "app/link/acquisition.h"
#include "app/link/can_source.h"
#include "app/runtime/growing_count.h"
#include "core/atem/link_watch.h"

class QLabel;

namespace terratact {

class EventList;
class StatusHeader;

/// State of the robot's telemetry at one time.
struct LinkViewState {
    double now = 0.0;                  ///< [s] on the steady clock
    const CanView* bus = nullptr;      ///< null: the source is no bus
    const Received* newest = nullptr;  ///< null: none received yet
    LinkAccount link{};
    QString otherFrames{};  ///< frames still received without telemetry; empty: none
};

/// Shows link and robot activity in the header, and changes in the event list. A banner appears if nothing on the
/// screen is live. GUI thread only.
class LinkStatus {
    Q_DECLARE_TR_FUNCTIONS(LinkStatus)
public:
    /// link: the source if it is a bus; else null. All arguments must outlive the object.
    LinkStatus(StatusHeader& header, QLabel& banner, EventList& events,
               const Acquisition& acquisition, CanSource* link);

    /// Call for every frame of the window.
    void show(const LinkViewState& viewState);
    /// Call for every frame of the window. panel: precondition of the panel for motion; empty: no panel.
    void showArming(const CanView* bus, const std::optional<Precondition>& panel);
    QString banner() const;      ///< text of the banner; empty: it is hidden
    bool isBannerShown() const;  ///< true if the banner shows a lost or unsteady link

private:
    void count(const CanView& view, double now);
    void showLink(const LinkViewState& viewState, double age);
    void showRate(const LinkViewState& viewState);
    void showBus(const CanView& view, double now);
    void showBanner(const LinkViewState& viewState, double age);
    QString bannerText(const LinkViewState& viewState, double age) const;
    void logChange(const LinkAccount& link);
    void showRobot(const Received* newest, double age);
    QString details(const CanView& view) const;

    StatusHeader& header_;
    QLabel& banner_;
    EventList& events_;
    const Acquisition& acquisition_;
    CanSource* link_;
    LinkAccount logged_;  ///< state last listed as an event
    ArmingPhase armingWas_ = ArmingPhase::Disarmed;
    GrowingCount dropped_, errors_;
    bool droppedLately_ = false, erredLately_ = false;
    double rateShownAt_ = 0.0;  ///< [s]; 0: not since the link came up
    double busShownAt_ = 0.0;   ///< [s]
    BusState busShown_ = BusState::Up;
    double upSince_ = 0.0;   ///< [s] time when the link came up; 0: it is down
    double worstAge_ = 0.0;  ///< [s] largest age of telemetry since then
};

}  // namespace terratact
