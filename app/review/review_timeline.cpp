#include "app/review/review_timeline.h"

#include <QCoreApplication>
#include <algorithm>
#include <map>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/recording/session_text.h"
#include "core/log/event_text.h"
#include "core/log/review_moment.h"

namespace terratact {
namespace {

struct ReviewWords {
    Q_DECLARE_TR_FUNCTIONS(ReviewTimeline)
};

using Lanes = QList<TimelineLane>;

TimelineLane& laneOf(Timeline& timeline, ReviewLane lane)
{
    return timeline.lanes[static_cast<int>(lane)];
}

/// The spans that are open at a time, by subject.
class OpenSpans {
public:
    explicit OpenSpans(TimelineLane& lane) : lane_(lane) {}
    void begin(const std::string& id, TimelineSpan span)
    {
        end(id, span.first);
        open_[id] = std::move(span);
    }
    void end(const std::string& id, double at)
    {
        const auto found = open_.find(id);
        if (found == open_.end()) return;
        found->second.last = std::max(at, found->second.first);
        lane_.spans << found->second;
        open_.erase(found);
    }
    void endAll(double at)
    {
        while (!open_.empty()) end(open_.begin()->first, at);
    }
    bool has(const std::string& id) const { return open_.contains(id); }

private:
    TimelineLane& lane_;
    std::map<std::string, TimelineSpan> open_;
};

void addRows(Timeline& timeline, const SessionReader& session)
{
    for (const SceneRow& row : session.scenes())
        laneOf(timeline, ReviewLane::Scenes).marks << TimelineMark{
            secondsOf(row.time), TimelineSeverity::Plain, ReviewWords::tr("scene %1").arg(row.id)};
    for (const EstimateRow& row : session.estimates())
        laneOf(timeline, ReviewLane::Estimates).marks
            << TimelineMark{secondsOf(row.time),
                            row.estimate.side[0].converged && row.estimate.side[1].converged
                                ? TimelineSeverity::Good
                                : TimelineSeverity::Warning,
                            ReviewWords::tr("estimate %1 of scene %2, %3")
                                .arg(row.id)
                                .arg(row.scene)
                                .arg(format::text(name(row.estimate.side[0].settings.method)))};
    for (const ProposalRow& row : session.proposals())
        laneOf(timeline, ReviewLane::Probes).marks
            << TimelineMark{secondsOf(row.time), TimelineSeverity::Warning,
                            ReviewWords::tr("probe proposed at %1").arg(format::binName(row.bin))};
}

/// Builds the lanes of phases, links, alarms and estimates, whose spans last until an event ends them.
class EventLanes {
public:
    explicit EventLanes(Timeline& timeline)
        : timeline_(timeline), link_(laneOf(timeline, ReviewLane::Link)),
          estimates_(laneOf(timeline, ReviewLane::Estimates)),
          probes_(laneOf(timeline, ReviewLane::Probes)),
          alarms_(laneOf(timeline, ReviewLane::Alarms))
    {
    }

    void add(const SessionReader& session)
    {
        auto estimate = session.estimates().begin();
        for (const EventRow& event : session.events()) {
            for (; estimate != session.estimates().end() && estimate->time <= event.time;
                 ++estimate)
                begin(*estimate);
            add(event);
        }
        for (; estimate != session.estimates().end(); ++estimate) begin(*estimate);
        for (OpenSpans* open : {&link_, &estimates_, &probes_, &alarms_})
            open->endAll(timeline_.end);
    }

private:
    void begin(const EstimateRow& row)
    {
        if (!estimates_.has("estimate"))
            estimates_.begin("estimate", {secondsOf(row.time), 0.0, TimelineSeverity::Plain,
                                          ReviewWords::tr("an estimate stands")});
    }

    void mark(ReviewLane lane, const EventRow& event, TimelineSeverity severity)
    {
        laneOf(timeline_, lane).marks
            << TimelineMark{secondsOf(event.time), severity, sentenceOf(event)};
    }

    void add(const EventRow& event)
    {
        const double at = secondsOf(event.time);
        switch (event.kind) {
        case EventKind::Link:
            link_.begin("link",
                        {at, at,
                         event.subject == kLinkUp ? TimelineSeverity::Good : TimelineSeverity::Bad,
                         sentenceOf(event)});
            break;
        case EventKind::Forgotten: estimates_.end("estimate", at); break;
        case EventKind::Phase: addPhase(event, at); break;
        case EventKind::Alarm:
            // A continued file starts with the alarms that were active; one that was already open adds no mark.
            if (const double state = event.number.value_or(0.0);
                state == 3.0 || (state == 2.0 && !alarms_.has(event.subject)))
                alarms_.begin(event.subject, {at, at, TimelineSeverity::Bad, sentenceOf(event)});
            else if (event.number.value_or(0.0) != 2.0)
                alarms_.end(event.subject, at);
            break;
        case EventKind::Decision:
            mark(ReviewLane::Operator, event, TimelineSeverity::Accent);
            break;
        case EventKind::TelemetryGap:
            mark(ReviewLane::Estimates, event, TimelineSeverity::Warning);
            break;
        case EventKind::Override:
        case EventKind::Panel:
        case EventKind::Arming: mark(ReviewLane::Operator, event, TimelineSeverity::Plain); break;
        case EventKind::Marker: mark(ReviewLane::Markers, event, TimelineSeverity::Accent); break;
        case EventKind::Gap: mark(ReviewLane::Link, event, TimelineSeverity::Bad); break;
        case EventKind::Session: mark(ReviewLane::Markers, event, TimelineSeverity::Plain); break;
        case EventKind::Word: break;
        }
    }

    void addPhase(const EventRow& event, double at)
    {
        const auto phase = phaseOf(event);
        probes_.end("probe", at);
        if (phase == AtemPhase::ProposingProbe)
            probes_.begin("probe", {at, at, TimelineSeverity::Warning, sentenceOf(event)});
        if (phase == AtemPhase::Probing)
            probes_.begin("probe", {at, at, TimelineSeverity::Accent, sentenceOf(event)});
        if (phase == AtemPhase::Advancing)
            mark(ReviewLane::Operator, event, TimelineSeverity::Good);
        if (phase == AtemPhase::Stopped || phase == AtemPhase::Failed)
            mark(ReviewLane::Operator, event, TimelineSeverity::Bad);
    }

    Timeline& timeline_;
    OpenSpans link_, estimates_, probes_, alarms_;
};

void addSurvey(Timeline& timeline, const Surveyed& surveyed)
{
    for (const SessionSpan& span : surveyed.contacts)
        laneOf(timeline, ReviewLane::Contact).spans
            << TimelineSpan{secondsOf(span.first), secondsOf(span.last), TimelineSeverity::Plain,
                            ReviewWords::tr("a force element is in contact")};
    for (const SessionSpan& span : surveyed.silences)
        laneOf(timeline, ReviewLane::Link).spans
            << TimelineSpan{secondsOf(span.first), secondsOf(span.last), TimelineSeverity::Bad,
                            ReviewWords::tr("no telemetry came")};
    for (const SessionDamage& damage : surveyed.damage)
        timeline.gaps << TimelineSpan{
            secondsOf(damage.first), secondsOf(damage.last), TimelineSeverity::Bad,
            ReviewWords::tr("DAMAGED, not shown: %1").arg(translated(damage.why))};
}

QString alarmSentence(const EventRow& event)
{
    const QString text =
        event.text.empty() ? format::eventWord(event.subject) : translated(messageOf(event));
    const double state = event.number.value_or(0.0);
    if (state == 3.0) return ReviewWords::tr("alarm: %1").arg(text);
    if (state == 2.0) return ReviewWords::tr("alarm seen: %1").arg(text);
    if (state == 1.0) return ReviewWords::tr("alarm returned: %1").arg(text);
    return ReviewWords::tr("alarm gone: %1").arg(text);
}

QString subjectText(const EventRow& event)
{
    const Message subject = subjectOf(event);
    return subject.context.empty() ? format::eventWord(event.subject) : translated(subject);
}

QString textOf(const EventRow& event)
{
    if (event.kind == EventKind::Marker)
        return format::line(event.text);  // text that a person typed
    if (event.kind == EventKind::Decision && event.message.empty())
        return format::eventWord(event.text);  // a name, or a number that has no translation
    return translated(messageOf(event));
}

}  // namespace

QString nameOf(ReviewLane lane)
{
    switch (lane) {
    case ReviewLane::Link: return ReviewWords::tr("1 link");
    case ReviewLane::Contact: return ReviewWords::tr("2 contact");
    case ReviewLane::Scenes: return ReviewWords::tr("3 scenes");
    case ReviewLane::Estimates: return ReviewWords::tr("4 estimates");
    case ReviewLane::Probes: return ReviewWords::tr("5 probes");
    case ReviewLane::Operator: return ReviewWords::tr("6 operator");
    case ReviewLane::Alarms: return ReviewWords::tr("7 alarms");
    case ReviewLane::Markers: return ReviewWords::tr("8 markers");
    }
    return {};
}

QString nameOf(EventKind kind)
{
    switch (kind) {
    case EventKind::Word: return ReviewWords::tr("message");
    case EventKind::Decision: return ReviewWords::tr("decision");
    case EventKind::Phase: return ReviewWords::tr("exploration");
    case EventKind::Arming: return ReviewWords::tr("arming");
    case EventKind::Link: return ReviewWords::tr("link");
    case EventKind::Forgotten: return ReviewWords::tr("estimate void");
    case EventKind::TelemetryGap: return ReviewWords::tr("telemetry gap");
    case EventKind::Override: return ReviewWords::tr("override");
    case EventKind::Alarm: return ReviewWords::tr("alarm");
    case EventKind::Panel: return ReviewWords::tr("panel");
    case EventKind::Marker: return ReviewWords::tr("marker");
    case EventKind::Gap: return ReviewWords::tr("gap");
    case EventKind::Session: return ReviewWords::tr("session");
    }
    return {};
}

namespace {

QString wordsOf(const EventRow& event)
{
    if (event.kind == EventKind::Alarm) return alarmSentence(event);
    if (event.kind == EventKind::Word) return translated(messageOf(event));
    if (event.kind == EventKind::Panel)
        return event.number.value_or(0.0) > 0.0
                 ? ReviewWords::tr("contact closed: %1").arg(format::eventWord(event.subject))
                 : ReviewWords::tr("contact open: %1").arg(format::eventWord(event.subject));
    if (event.kind == EventKind::TelemetryGap)
        return ReviewWords::tr("telemetry was missing for a while since the scene");
    if (event.kind == EventKind::Override)
        return event.text.empty()
                 ? ReviewWords::tr("nothing is overridden")
                 : ReviewWords::tr("overridden: %1").arg(translated(messageOf(event)));
    QStringList parts;
    if (event.kind == EventKind::Link) parts << ReviewWords::tr("link");
    if (!event.subject.empty()) parts << subjectText(event);
    if (!event.text.empty()) parts << textOf(event);
    return parts.join(QStringLiteral(": "));
}

}  // namespace

QString sentenceOf(const EventRow& event)
{
    // One event is one line, because a line end in its text could imitate another event.
    return wordsOf(event).replace(QLatin1Char('\n'), QLatin1Char(' '));
}

Timeline timelineOf(const SessionReader& session, const Surveyed& surveyed,
                    const std::vector<ReviewNote>& notes)
{
    Timeline timeline{.begin = secondsOf(session.begin()), .end = secondsOf(session.end())};
    for (int lane = 0; lane < kReviewLanes; ++lane)
        timeline.lanes << TimelineLane{nameOf(static_cast<ReviewLane>(lane))};
    addRows(timeline, session);
    EventLanes(timeline).add(session);
    addSurvey(timeline, surveyed);
    for (const ReviewNote& note : notes)
        laneOf(timeline, ReviewLane::Markers).marks
            << TimelineMark{note.time, TimelineSeverity::Good, format::line(note.text)};
    return timeline;
}

QDateTime wallClock(const SessionReader& session, SessionTime time)
{
    return QDateTime::fromMSecsSinceEpoch(wallTimeOf(session.start(), time) / 1'000'000).toUTC();
}

QList<double> timesOf(const TimelineLane& lane)
{
    QList<double> times;
    for (const TimelineSpan& span : lane.spans) times << span.first;
    for (const TimelineMark& mark : lane.marks) times << mark.time;
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

}  // namespace terratact
