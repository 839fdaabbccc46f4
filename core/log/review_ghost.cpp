#include "core/log/review_ghost.h"

#include <algorithm>
#include <utility>

#include "core/log/event_text.h"

namespace terratact {

ReviewGhost::ReviewGhost(SessionReader& reader, RobotModel robot)
    : reader_(reader), robot_(std::move(robot))
{
}

ReviewGhost::ViewState ReviewGhost::at(const ReviewMoment& moment)
{
    const AtemPhase phase = moment.state.phase;
    if (moment.estimate || phase == AtemPhase::Pressing || phase == AtemPhase::Estimating)
        return {};
    const EstimateRow* const row = lastUpTo(moment.time);
    if (!row) return {};
    const auto left = leftAt(*row, moment.time);
    if (!left || moment.time > *left + sessionTimeOf(kFollowed)) return {};
    if (isForgotten(*row, *left, moment.time)) return {};
    if (!followed_.empty() && followed_.front().estimate != row->id) followed_.clear();
    while (!followed_.empty() && followed_.back().until > moment.time) followed_.pop_back();
    if (followed_.empty()) begin(*row, *left);
    goTo(moment.time);
    const Followed& now = followed_.back();
    const auto& [first, second] = now.tracks;
    if (now.onePlane) return {first.ghost(), first.why()};
    const bool isAny = first.ghost() || second.ghost();
    return {first.ghost(), isAny ? std::nullopt : first.why(), second.ghost(), false};
}

const EstimateRow* ReviewGhost::lastUpTo(SessionTime time) const
{
    const EstimateRow* found = nullptr;
    for (const EstimateRow& row : reader_.estimates())
        if (row.role != EstimateRole::Second && row.time <= time) found = &row;
    return found;
}

/// Returns the time at which the estimate stopped being valid.
std::optional<SessionTime> ReviewGhost::leftAt(const EstimateRow& row, SessionTime until) const
{
    for (const EventRow& event : reader_.events())
        if (event.kind == EventKind::Forgotten && event.time >= row.time && event.time <= until)
            return event.time;
    return std::nullopt;
}

bool ReviewGhost::isForgotten(const EstimateRow& row, SessionTime left, SessionTime until) const
{
    const auto isSince = [&](SessionTime time) { return time >= row.time && time <= until; };
    // Returns true if Esc or a new model at that time discards the estimate. During an exploration
    // it ends only the exploration.
    const auto endsAll = [&](SessionTime time) {
        return !reader_.start().transmits || !exploring(phaseAt(time));
    };
    for (const ModelRow& model : reader_.models())
        if (isSince(model.time) && (model.time >= left || endsAll(model.time))) return true;
    for (const EventRow& event : reader_.events())
        if (event.kind == EventKind::Decision
            && (event.subject == "abort" || event.subject == "forget") && isSince(event.time)
            && endsAll(event.time))
            return true;
    return false;
}

AtemPhase ReviewGhost::phaseAt(SessionTime time) const
{
    AtemPhase phase{};
    for (const EventRow& event : reader_.events())
        if (event.kind == EventKind::Phase && event.time <= time)
            phase = phaseOf(event).value_or(phase);
    return phase;
}

/// Starts when the estimate came, as the console does: until then the robot stands. The events
/// report silences that no line of telemetry shows.
void ReviewGhost::begin(const EstimateRow& row, SessionTime left)
{
    const SceneRow& scene = *reader_.scene(row.scene);
    Followed& start = followed_.emplace_back(
        Followed{row.id,
                 {GhostTrack(robot_, row.estimate.side[0], scene.measurement),
                  GhostTrack(robot_, row.estimate.side[1], scene.measurement)},
                 row.estimate.onePlane,
                 TelemetryListener(robot_),
                 std::max(row.time, left - sessionTimeOf(kBefore))});
    for (const EventRow& event : reader_.events())
        if (event.kind == EventKind::TelemetryGap && event.time >= scene.time
            && event.time <= start.until)
            for (GhostTrack& track : start.tracks) track.addSilence();
}

void ReviewGhost::goTo(SessionTime until)
{
    const SessionTime apart = sessionTimeOf(10.0);
    while (followed_.back().until < until) {
        const auto before = followed_.rbegin() + 1;
        if (before == followed_.rend() || followed_.back().until - before->until >= apart)
            followed_.push_back(followed_.back());
        follow(std::min(until, followed_[followed_.size() - 2].until + apart));
    }
}

void ReviewGhost::follow(SessionTime until)
{
    Followed& now = followed_.back();
    const SessionTime from = std::exchange(now.until, until);
    for (const EventRow& event : reader_.events())
        if (event.kind == EventKind::TelemetryGap && event.time > from && event.time <= until)
            for (GhostTrack& track : now.tracks) track.addSilence();
    for (std::size_t i = reader_.batchAt(from + 1);
         i < reader_.batches().size() && reader_.batches()[i].first <= until; ++i) {
        if (!now.tracks[0].ghost() && !now.tracks[1].ghost()) return;
        for (const FrameRow& row : reader_.frames(i)) {
            if (row.time <= from || row.time > until) continue;
            const auto received = now.listener.receive(row.frame, secondsOf(row.time));
            if (!received) continue;
            for (GhostTrack& track : now.tracks) track.add(*received);
        }
    }
}

}  // namespace terratact
