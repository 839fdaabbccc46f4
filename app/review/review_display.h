#pragma once

#include <QCoreApplication>

#include "core/log/review_moment.h"

class QLabel;

namespace terratact {

class EventList;
class StatusHeader;

/// Says around the pages of a review what stood at a moment: in the header link, robot, model and alarms; in a banner
/// that the file is damaged there; in the list beside the robot what had happened last.  GUI thread only.
class ReviewDisplay {
    Q_DECLARE_TR_FUNCTIONS(ReviewDisplay)
public:
    struct Places {
        StatusHeader& header;
        QLabel& damage;
        EventList& events;
    };
    /// All must outlive it.
    ReviewDisplay(const SessionReader& session, const Places& places);

    void show(const ReviewMoment& moment);

private:
    void showLink(const ReviewMoment& moment);
    void showHeader(const ReviewMoment& moment);
    void showDamage(const ReviewMoment& moment);
    void showEvents(SessionTime until);

    const SessionReader& session_;
    Places places_;
    std::int64_t listed_ = -1;  ///< the newest event in the list
};

}  // namespace terratact
