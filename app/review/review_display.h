#pragma once

#include <QCoreApplication>

#include "core/log/review_moment.h"

class QLabel;

namespace terratact {

class EventList;
class StatusHeader;

/// Shows the state at a moment of the session around the review's pages. The header shows link, robot, model and
/// alarms. A banner reports damage of the file. A list shows the events before the moment. GUI thread only.
class ReviewDisplay {
    Q_DECLARE_TR_FUNCTIONS(ReviewDisplay)
public:
    struct Places {
        StatusHeader& header;
        QLabel& damage;
        EventList& events;
    };
    /// Both arguments must outlive the display.
    ReviewDisplay(const SessionReader& session, const Places& places);

    void show(const ReviewMoment& moment);

private:
    void showLink(const ReviewMoment& moment);
    void showHeader(const ReviewMoment& moment);
    void showDamage(const ReviewMoment& moment);
    void showEvents(SessionTime until);

    const SessionReader& session_;
    Places places_;
    std::int64_t listed_ = -1;  ///< newest listed event
};

}  // namespace terratact
