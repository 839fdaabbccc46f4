#include "core/log/review_ghost.h"

#include <algorithm>
#include <utility>

namespace terratact {

ReviewGhost::ReviewGhost(SessionReader& reader, RobotModel robot)
    : reader_(reader), robot_(std::move(robot))
{
}

ReviewGhost::Sight ReviewGhost::at(const ReviewMoment& moment)
{
    const AtemPhase phase = moment.state.phase;
    if (moment.estimate || phase == AtemPhase::Pressing || phase == AtemPhase::Estimating)
        return {};
    const EstimateRow* const row = lastUpTo(moment.time);
    if (!row) return {};
    const auto left = leftAt(*row, moment.time);
    if (!left || isForgotten(*left, moment.time)) return {};
    if (!followed_ || followed_->estimate != row->id || followed_->until > moment.time)
        begin(*row, *left);
    follow(moment.time);
    return {followed_->track.ghost(), followed_->track.why()};
}

const EstimateRow* ReviewGhost::lastUpTo(SessionTime time) const
{
    const EstimateRow* found = nullptr;
    for (const EstimateRow& row : reader_.estimates())
        if (row.role != EstimateRole::Second && row.time <= time) found = &row;
    return found;
}

/// When the estimate no longer stood.
std::optional<SessionTime> ReviewGhost::leftAt(const EstimateRow& row, SessionTime until) const
{
    for (const EventRow& event : reader_.events())
        if (event.kind == EventKind::Forgotten && event.time >= row.time && event.time <= until)
            return event.time;
    return std::nullopt;
}

bool ReviewGhost::isForgotten(SessionTime left, SessionTime until) const
{
    const auto isSince = [&](SessionTime time) { return time >= left && time <= until; };
    if (std::ranges::any_of(reader_.models(), isSince, &ModelRow::time)) return true;
    AtemPhase phase{};
    for (const EventRow& event : reader_.events()) {
        if (event.time > until) continue;
        if (event.kind == EventKind::Phase) phase = phaseFrom(event.subject).value_or(phase);
        // The press that ended an exploration left the ghost; one that found none ended both.
        if (event.kind == EventKind::Decision && event.subject == "abort" && isSince(event.time)
            && (!exploring(phase) || !reader_.start().transmits))
            return true;
    }
    return false;
}

/// As the console does: from when the estimate is there, for until then the robot stands.
void ReviewGhost::begin(const EstimateRow& row, SessionTime left)
{
    const SceneRow& scene = *reader_.scene(row.scene);
    followed_.emplace(Followed{row.id, GhostTrack(robot_, row.estimate, scene.measurement),
                               TelemetryListener(robot_), row.time});
    for (const EventRow& event : reader_.events())
        if (event.kind == EventKind::Unheard && event.time >= scene.time && event.time <= left)
            followed_->track.takeSilence();
}

void ReviewGhost::follow(SessionTime until)
{
    const SessionTime from = std::exchange(followed_->until, until);
    for (std::size_t i = reader_.batchAt(from + 1);
         i < reader_.batches().size() && reader_.batches()[i].first <= until; ++i) {
        if (!followed_->track.ghost()) return;
        for (const FrameRow& row : reader_.frames(i)) {
            if (row.time <= from || row.time > until) continue;
            if (const auto heard = followed_->listener.take(row.frame, secondsOf(row.time)))
                followed_->track.take(*heard);
        }
    }
}

}  // namespace terratact
