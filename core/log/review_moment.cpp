#include "core/log/review_moment.h"
#include "core/limits.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/log/event_text.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {
namespace {

constexpr std::size_t kRecentBatches = 24;
constexpr std::size_t kRecentEstimates = 4;

bool isTelemetryFresh(const ReviewMoment& moment)
{
    return moment.measurement && secondsOf(moment.time - moment.measured) <= kLinkLostAfter;
}

/// Returns the silence [s] before the link was up again. Older sessions record no number: there it
/// is the time between the two events.
double silenceBefore(const EventRow& up, SessionTime lost)
{
    return up.number.value_or(kLinkLostAfter + secondsOf(up.time - lost));
}

/// Returns the last row up to a time. The rows are nearly in the order of time.
template <class Row>
const Row* lastUpTo(const std::vector<Row>& rows, SessionTime from, SessionTime to)
{
    const Row* found = nullptr;
    for (const Row& row : rows)
        if (row.time >= from && row.time <= to) found = &row;
    return found;
}

std::optional<AlarmState> alarmState(double number)
{
    if (number == 1.0) return AlarmState::Returned;
    if (number == 2.0) return AlarmState::Acknowledged;
    if (number == 3.0) return AlarmState::Unacknowledged;
    return std::nullopt;
}

void addAlarm(std::map<std::string, Alarm>& alarms, const EventRow& event)
{
    const auto state = alarmState(event.number.value_or(0.0));
    if (!state) {
        alarms.erase(event.subject);
        return;
    }
    Alarm& alarm = alarms[event.subject];
    if (alarm.id.empty()) alarm.since = secondsOf(event.time);
    alarm.id = event.subject;
    alarm.text = messageOf(event);
    alarm.state = *state;
}

/// Returns the time since which the present estimate can be valid: after the last one was
/// discarded.
SessionTime standsSince(const std::vector<EventRow>& events, SessionTime time)
{
    SessionTime since = 0;
    for (const EventRow& event : events)
        if (event.kind == EventKind::Forgotten && event.time <= time)
            since = std::max(since, event.time);
    return since;
}

}  // namespace

ReviewMoments::ReviewMoments(SessionReader& reader, RobotModel robot)
    : reader_(reader), robot_(std::move(robot))
{
}

const std::vector<FrameRow>& ReviewMoments::frames(std::size_t batch)
{
    const std::int64_t id = reader_.batches()[batch].id;
    const auto found = std::find_if(recent_.begin(), recent_.end(),
                                    [id](const Batch& kept) { return kept.id == id; });
    if (found != recent_.end()) return found->frames;
    recent_.push_front({id, reader_.frames(batch)});
    if (recent_.size() > kRecentBatches) recent_.pop_back();
    return recent_.front().frames;
}

std::shared_ptr<const EstimateRow> ReviewMoments::whole(const EstimateRow* row)
{
    if (!row) return nullptr;
    for (const auto& kept : drawn_)
        if (kept->id == row->id) return kept;
    auto copy = std::make_shared<EstimateRow>(*row);
    if (auto draws = reader_.draws(row->id)) setDraws(copy->estimate, std::move(*draws));
    drawn_.push_front(std::move(copy));
    if (drawn_.size() > kRecentEstimates) drawn_.pop_back();
    return drawn_.front();
}

ReviewMoment ReviewMoments::at(SessionTime time)
{
    ReviewMoment moment{.time = time};
    hear(moment);
    addRows(moment);
    addEvents(moment);
    for (const SessionDamage& damage : reader_.damage())
        if (damage.first <= time && time <= damage.last) moment.damage = damage;
    return moment;
}

/// Sets the robot's state from its last frames.
void ReviewMoments::hear(ReviewMoment& moment)
{
    const SessionTime from = moment.time - sessionTimeOf(kReviewWindow);
    TelemetryListener listener(robot_);
    int lines = 0;
    for (std::size_t i = reader_.batchAt(from);
         i < reader_.batches().size() && reader_.batches()[i].first <= moment.time; ++i)
        for (const FrameRow& row : frames(i)) {
            if (row.time < from || row.time > moment.time) continue;
            const auto measurement = listener.receive(row.frame, secondsOf(row.time));
            if (!measurement) continue;
            moment.measurement = measurement;
            moment.forces = listener.forces();
            moment.measured = row.time;
            if (row.time > moment.time - sessionTimeOf(1.0)) ++lines;
        }
    moment.linesPerSecond = lines;
    moment.linkAlive = isTelemetryFresh(moment);
    moment.linkSince = moment.measured;
}

void ReviewMoments::addRows(ReviewMoment& moment)
{
    const SessionTime since = standsSince(reader_.events(), moment.time);
    moment.model = lastUpTo(reader_.models(), 0, moment.time);
    moment.scene = lastUpTo(reader_.scenes(), since, moment.time);
    if (!moment.scene) return;
    const EstimateRow *first = nullptr, *second = nullptr;
    for (const EstimateRow& row : reader_.estimates()) {
        if (row.scene != moment.scene->id || row.time > moment.time) continue;
        (row.role == EstimateRole::Second ? second : first) = &row;
        if (row.role == EstimateRole::Again) moment.state.probed = true;
    }
    moment.estimate = whole(first);
    moment.second = whole(second);
    for (const ProposalRow& row : reader_.proposals())
        if (first && row.estimate == first->id && row.time <= moment.time) moment.proposal = &row;
}

void ReviewMoments::addEvents(ReviewMoment& moment)
{
    std::map<std::string, Alarm> alarms;
    std::optional<SessionTime> lost;
    const EventRow* nextUp = nullptr;
    bool suspected = false;  // a sensor was suspected
    // For sessions without EventKind::TelemetryGap.
    const auto endsSilence = [&](const EventRow& up) {
        return lost && moment.scene && *lost > moment.scene->time
            && silenceBefore(up, *lost) > kMaxSilence;
    };
    for (const EventRow& event : reader_.events()) {
        if (event.time > moment.time) {
            const bool isUp = event.kind == EventKind::Link && event.subject == kLinkUp;
            if (isUp && !nextUp) nextUp = &event;
            continue;
        }
        switch (event.kind) {
        case EventKind::Phase:
            if (const auto phase = phaseOf(event)) {
                moment.state.phase = *phase;
                moment.state.since = secondsOf(event.time);
                moment.state.failure = AtemFailure::None;
                if (*phase == AtemPhase::Failed)
                    moment.state.failure = failureOf(event).value_or(AtemFailure::EstimateError);
            }
            break;
        case EventKind::Arming: moment.arming = armingOf(event); break;
        case EventKind::Link:
            moment.linkAlive = event.subject == kLinkUp;
            moment.telemetryAlone = event.subject == kTelemetryLost;
            moment.linkSince = event.time;
            if (moment.linkAlive && endsSilence(event)) moment.unbroken = false;
            lost = moment.linkAlive ? std::nullopt : std::optional(lost.value_or(event.time));
            break;
        case EventKind::TelemetryGap:
            if (moment.scene && event.time >= moment.scene->time) moment.unbroken = false;
            break;
        case EventKind::Override: moment.overridden = messageOf(event); break;
        case EventKind::Alarm:
            addAlarm(alarms, event);
            if (event.subject != kSensorAlarm) break;
            if (suspected && moment.scene && event.time >= moment.scene->time)
                moment.sensorsSound = false;
            suspected = event.number.value_or(0.0) >= 2.0;
            break;
        case EventKind::Forgotten: moment.forgotten = messageOf(event); break;
        case EventKind::Decision:
            if (moment.proposal && event.proposal == moment.proposal->id
                && (event.subject == "approve" || event.subject == "refuse"))
                moment.decision = &event;
            break;
        case EventKind::Word:
        case EventKind::Panel:
        case EventKind::Marker:
        case EventKind::Gap:
        case EventKind::Session: break;
        }
    }
    if (!moment.linkAlive && nextUp && nextUp->number
        && isTelemetryFresh(moment)) {  // not yet recorded
        moment.linkAlive = true;
        if (endsSilence(*nextUp)) moment.unbroken = false;
    }
    if (suspected) moment.sensorsSound = false;
    for (auto& [id, alarm] : alarms) moment.alarms.push_back(std::move(alarm));
    moment.state.approvalExpired =
        moment.proposal && !moment.decision && moment.state.phase == AtemPhase::Presenting;
}

std::optional<SessionTime> ReviewMoments::frameAfter(SessionTime time)
{
    for (std::size_t i = reader_.batchAt(time + 1); i < reader_.batches().size(); ++i) {
        std::optional<SessionTime> found;
        for (const FrameRow& row : frames(i))
            if (row.time > time && (!found || row.time < *found)) found = row.time;
        if (found) return found;
    }
    return std::nullopt;
}

std::optional<SessionTime> ReviewMoments::frameBefore(SessionTime time)
{
    if (reader_.batches().empty()) return std::nullopt;
    for (std::size_t i = std::min(reader_.batchAt(time), reader_.batches().size() - 1);; --i) {
        std::optional<SessionTime> found;
        for (const FrameRow& row : frames(i))
            if (row.time < time && (!found || row.time > *found)) found = row.time;
        if (found || i == 0) return found;
    }
}

}  // namespace terratact
