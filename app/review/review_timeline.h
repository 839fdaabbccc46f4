#pragma once

#include <QDateTime>
#include <QList>
#include <QString>
#include <vector>

#include "app/recording/session_indexer.h"
#include "app/review/review_notes.h"
#include "core/log/session_reader.h"
#include "widgets/signals/session_timeline.h"

namespace terratact {

/// The lanes of a review, from the top.
enum class ReviewLane : std::uint8_t {
    Link,
    Contact,
    Scenes,
    Estimates,
    Probes,
    Operator,
    Alarms,
    Markers
};
inline constexpr int kReviewLanes = 8;
QString nameOf(ReviewLane lane);

/// A session with what its survey has found and the notes made of it.
Timeline timelineOf(const SessionReader& session, const Surveyed& surveyed,
                    const std::vector<ReviewNote>& notes);

/// An event in the operator's language, without its time.
QString sentenceOf(const EventRow& event);
QString nameOf(EventKind kind);

/// A time of a session as the clock showed it; UTC.
QDateTime wallClock(const SessionReader& session, SessionTime time);

/// The times at which something of a lane begins or happens, in their order.
QList<double> timesOf(const TimelineLane& lane);

}  // namespace terratact
