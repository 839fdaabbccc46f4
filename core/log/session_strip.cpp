#include "core/log/session_strip.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/log/event_text.h"

namespace terratact {
namespace {

/// Returns the row's measurement with the session's time.
Measurement timed(const SceneRow& row)
{
    Measurement measurement = row.measurement;
    measurement.time = secondsOf(row.time);
    return measurement;
}

}  // namespace

SessionStrip::SessionStrip(SessionReader& reader, const RobotModel& robot, SessionTime from)
    : reader_(&reader), strip_(robot), listener_(robot), sensors_(robot), at_(from)
{
}

/// Returns the rows after at_, up to a time, in their order.
std::vector<SessionStrip::Act> SessionStrip::actsUpTo(SessionTime until) const
{
    using Kind = Act::Kind;
    std::vector<Act> acts;
    const auto add = [&](SessionTime time, Kind kind, const void* row) {
        if (time > at_ && time <= until) acts.push_back({time, kind, row});
    };
    const std::vector<ModelRow>& models = reader_->models();
    for (const ModelRow& row : models)
        if (&row != &models.front()) add(row.time, Kind::Model, &row);
    for (const SceneRow& row : reader_->scenes()) add(row.time, Kind::Scene, &row);
    for (const EstimateRow& row : reader_->estimates())
        if (row.role != EstimateRole::Second) add(row.time, Kind::Estimate, &row);
    for (const EventRow& row : reader_->events()) {
        if (row.kind == EventKind::TelemetryGap) add(row.time, Kind::Gap, &row);
        if (row.kind == EventKind::Forgotten) add(row.time, Kind::Left, &row);
        if (row.kind != EventKind::Decision) continue;
        if (row.subject == "forget") add(row.time, Kind::Clear, &row);
        if (row.subject == "abort" && !isExploring(row.time)) add(row.time, Kind::Abort, &row);
        if (row.subject == "restore") add(row.time, Kind::Restore, &row);
    }
    std::ranges::stable_sort(acts, {},
                             [](const Act& act) { return std::tuple(act.time, act.kind); });
    return acts;
}

void SessionStrip::apply(const Act& act)
{
    switch (act.kind) {
    case Act::Kind::Gap: strip_.addSilence(); break;
    case Act::Kind::Model: strip_.endSection(); break;
    case Act::Kind::Scene: strip_.beginScene(timed(*static_cast<const SceneRow*>(act.row))); break;
    case Act::Kind::Estimate: enter(static_cast<const EstimateRow*>(act.row)); break;
    case Act::Kind::Clear:
        if (!stands_) strip_.endSection();
        [[fallthrough]];
    case Act::Kind::Abort:
        if (std::exchange(stands_, false)) strip_.removeLast();
        break;
    case Act::Kind::Left: stands_ = false; break;
    case Act::Kind::Restore: enter(reader_->estimate(entered_)); break;
    }
}

void SessionStrip::enter(const EstimateRow* row)
{
    if (!row) return;
    entered_ = row->id;
    stands_ = true;
    strip_.enter(row->estimate, row->id, row->readings);
}

/// Returns true if an exploration of this console runs, which "abort" then ends instead of an estimate.
bool SessionStrip::isExploring(SessionTime time) const
{
    AtemPhase phase{};
    for (const EventRow& event : reader_->events())
        if (event.kind == EventKind::Phase && event.time <= time)
            phase = phaseOf(event).value_or(phase);
    return reader_->start().transmits && exploring(phase);
}

void SessionStrip::goTo(SessionTime until)
{
    for (const Act& act : actsUpTo(until)) {
        follow(act.time);
        apply(act);
    }
    follow(until);
}

void SessionStrip::follow(SessionTime until)
{
    const SessionTime from = std::exchange(at_, std::max(at_, until));
    if (at_ == from) return;
    for (std::size_t i = reader_->batchAt(from + 1);
         i < reader_->batches().size() && reader_->batches()[i].first <= until; ++i)
        for (const FrameRow& row : reader_->frames(i)) {
            if (row.time <= from || row.time > until) continue;
            const auto received = listener_.receive(row.frame, secondsOf(row.time));
            if (!received) continue;
            sensors_.add(*received);
            strip_.add(*received, sensors_.standing());
        }
}

}  // namespace terratact
