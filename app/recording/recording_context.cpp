#include "app/recording/recording_context.h"

#include <algorithm>

namespace terratact {
namespace {

bool isModel(const SessionRow& row)
{
    return std::holds_alternative<ModelRow>(row);
}

bool isAnswer(const EventRow& event)
{
    return event.kind == EventKind::Decision && event.proposal != 0;
}

}  // namespace

void RecordingContext::add(const SessionRow& row)
{
    if (const auto* event = std::get_if<EventRow>(&row)) return addEvent(*event);
    if (std::holds_alternative<SceneRow>(row)) {
        const auto newest = std::find_if(ofScene_.rbegin(), ofScene_.rend(), isModel);
        std::vector<SessionRow> model;
        if (newest != ofScene_.rend()) model.push_back(*newest);
        ofScene_ = std::move(model);
        standing_.erase({EventKind::TelemetryGap, {}});
    }
    ofScene_.push_back(row);
}

void RecordingContext::addEvent(EventRow event)
{
    if (isAnswer(event)) {
        ofScene_.emplace_back(std::move(event));
        return;
    }
    event.estimate = event.proposal = 0;  // it may refer to rows before the next file's first scene
    switch (event.kind) {
    case EventKind::Phase:
    case EventKind::Arming:
    case EventKind::Link:
    case EventKind::Forgotten:
    case EventKind::TelemetryGap: standing_[{event.kind, {}}] = std::move(event); break;
    case EventKind::Override:
        standing_.erase({event.kind, {}});
        if (!event.text.empty()) standing_[{event.kind, {}}] = std::move(event);
        break;
    case EventKind::Panel: standing_[{event.kind, event.subject}] = std::move(event); break;
    case EventKind::Alarm:
        if (event.number.value_or(0.0) > 0.0)
            standing_[{event.kind, event.subject}] = std::move(event);
        else
            standing_.erase({event.kind, event.subject});
        break;
    case EventKind::Word:
    case EventKind::Decision:
    case EventKind::Marker:
    case EventKind::Gap:
    case EventKind::Session: break;
    }
}

std::vector<SessionRow> RecordingContext::rows() const
{
    std::vector<SessionRow> all = ofScene_;
    for (const auto& [key, event] : standing_) all.emplace_back(event);
    const auto time = [](const SessionRow& row) {
        return std::visit([](const auto& r) { return r.time; }, row);
    };
    std::stable_sort(all.begin(), all.end(),
                     [&](const SessionRow& a, const SessionRow& b) { return time(a) < time(b); });
    return all;
}

}  // namespace terratact
