#pragma once

#include <QDateTime>
#include <QList>
#include <QString>
#include <vector>

#include "app/recording/review_notes.h"
#include "app/recording/session_indexer.h"
#include "core/log/session_reader.h"
#include "widgets/signals/session_timeline.h"

namespace terratact {

/// The lanes of a review from top to bottom.
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

/// Returns the timeline of a session with the indexer's results and the notes.
Timeline timelineOf(const SessionReader& session, const Surveyed& surveyed,
                    const std::vector<ReviewNote>& notes);

/// Returns an event in the operator's language, without its time.
QString sentenceOf(const EventRow& event);
QString nameOf(EventKind kind);

/// Returns the UTC time of a session time.
QDateTime wallClock(const SessionReader& session, SessionTime time);

/// Returns the start times of all spans and marks of a lane, sorted.
QList<double> timesOf(const TimelineLane& lane);

}  // namespace terratact
