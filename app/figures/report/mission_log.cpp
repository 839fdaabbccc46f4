#include "app/figures/report/mission_log.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/figures/report/report_text.h"
#include "app/recording/recorded_sides.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "core/eval/estimate_error.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/log/event_text.h"
#include "core/log/review_moment.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

/// A line of the log. Of one time, kinds follow in the order in which one leads to the next.
struct MissionLine {
    SessionTime time = 0;
    int order = 0;
    Message what, numbers;
};

/// Returns the time of day, UTC, without the date.
std::string clockText(const SessionStart& start, SessionTime time)
{
    const std::string text = utcText(wallTimeOf(start, time));
    return text.substr(11, 12);
}

/// Adds the error of each side whose truth was recorded.
void addErrors(std::vector<Message>& parts, const EstimateRow& row, const SceneRow* scene)
{
    for (const RecordedSide& side : recordedSides(row.estimate.onePlane, scene)) {
        if (!side.truth) continue;
        const EstimateError error = errorAgainst(row.estimate.side.at(side.index), *side.truth);
        Message text{TR_NOOP("Report", "error against the truth: %1 m rms, %2 m at %3 m, %4 of %5 "
                                       "bins in their band"),
                     fixed(error.rms, 3),
                     fixed(error.largest, 3),
                     signedFixed(binCentre(error.bin), 1),
                     error.inBand,
                     kBins};
        parts.push_back(row.estimate.onePlane
                            ? std::move(text)
                            : Message::joined(tableWord(side.name), std::move(text)));
    }
}

Message verdictText(const TwoTrackVerdict& verdict, double limit)
{
    if (verdict.onePlane) return stepText(verdict.side[0], limit);
    return {TR_NOOP("Report", "%1. Left: %2. Right: %3. Either side: %4 %. Cross slope: %5"),
            messageOf(verdict),
            stepText(verdict.side[0], limit),
            stepText(verdict.side[1], limit),
            fixed(100.0 * verdict.either.p, 0),
            crossSlopeText(verdict.crossSlope)};
}

Message estimateName(const EstimateRow& row)
{
    const SourceText text =
        row.role == EstimateRole::Second
            ? TR_NOOP("Report", "estimate %1 of scene %2 (second method)")
        : row.role == EstimateRole::Again
            ? TR_NOOP("Report", "estimate %1 of scene %2 (with the reading of the arm)")
            : TR_NOOP("Report", "estimate %1 of scene %2");
    return {text, row.id, row.scene};
}

/// Returns the line of an estimate, with the verdict that the console showed when it was ready.
Result<MissionLine> lineOf(SessionReader& session, const EstimateRow& recorded,
                           const RobotModel& robot, ReviewMoments& moments)
{
    EstimateRow row = recorded;
    auto full = recordedEstimate(session, recorded);
    if (!full) return full.error();
    row.estimate = std::move(*full);
    const SceneRow* const scene = session.scene(row.scene);
    Message verdict = TR_NOOP("Report", "no verdict: its scene is damaged");
    if (scene) {
        const ReviewMoment moment = moments.at(row.time);
        verdict = verdictText(
            verdictOf(row.estimate, robot, scene->measurement,
                      {.unbroken = moment.unbroken, .sensorsSound = moment.sensorsSound},
                      row.stepLimit),
            row.stepLimit);
    }
    std::vector<Message> parts{std::move(verdict),
                               {TR_NOOP("Report", "method %1, %2 s"),
                                name(row.estimate.side[0].settings.method), fixed(row.seconds, 3)},
                               {TR_NOOP("Report", "arm: %1"), readingsText(row)}};
    addErrors(parts, row, scene);
    return MissionLine{row.time, 0, estimateName(row), Message::listed(std::move(parts), "; ")};
}

/// Returns bits of information, which rounding may have left just below zero: "-0.00" would be printed.
std::string bitsText(double value)
{
    return fixed(std::max(0.0, value), 2);
}

Message binName(const ProposalRow& row)
{
    const SourceText text = row.side == ProbeSide::Left  ? TR_NOOP("Report", "bin %1 m left")
                          : row.side == ProbeSide::Right ? TR_NOOP("Report", "bin %1 m right")
                                                         : TR_NOOP("Report", "bin %1 m");
    return {text, signedFixed(binCentre(row.bin), 1)};
}

MissionLine lineOf(const ProposalRow& row)
{
    const bool isKnownAfter =
        !row.offers.empty() && row.offers[0].bin == row.bin && row.offers[0].side == row.side;
    const std::string limit = fixed(row.stepLimit, 2), before = bitsText(row.bitsBefore);
    std::vector<Message> parts{
        {TR_NOOP("Report", "%1: height %2 m, %3 m … %4 m, sd %5 m above the threshold %6 m"),
         binName(row), signedFixed(row.height, 3), signedFixed(row.q10, 3), signedFixed(row.q90, 3),
         fixed(row.sd, 3), fixed(row.limit, 3)},
        {TR_NOOP("Report", "arm sd %1 m"), fixed(row.armSd, 3)},
        {TR_NOOP("Report", "takes %1 s"), fixed(row.seconds, 0)},
        isKnownAfter ? Message(TR_NOOP("Report", "step above %1 m: %2 bit open, %3 bit after it"),
                               limit, before, bitsText(row.offers[0].bitsAfter))
                     : Message(TR_NOOP("Report", "step above %1 m: %2 bit open"), limit, before)};
    return {row.time,
            1,
            {TR_NOOP("Report", "probe proposed on estimate %1"), row.estimate},
            Message::listed(std::move(parts), "; ")};
}

SourceText kindText(EventKind kind)
{
    switch (kind) {
    case EventKind::Word: return TR_NOOP("Report", "message");
    case EventKind::Decision: return TR_NOOP("Report", "operator");
    case EventKind::Phase: return TR_NOOP("Report", "exploration");
    case EventKind::Arming: return TR_NOOP("Report", "arming");
    case EventKind::Link: return TR_NOOP("Report", "link");
    case EventKind::Forgotten: return TR_NOOP("Report", "estimate void");
    case EventKind::TelemetryGap: return TR_NOOP("Report", "telemetry gap");
    case EventKind::Override: return TR_NOOP("Report", "override");
    case EventKind::Alarm: return TR_NOOP("Report", "alarm");
    case EventKind::Panel: return TR_NOOP("Report", "panel");
    case EventKind::Marker: return TR_NOOP("Report", "marker");
    case EventKind::Gap: return TR_NOOP("Report", "gap");
    case EventKind::Session: return TR_NOOP("Report", "session");
    }
    return {};
}

/// Returns what the number of an event means; empty: it has none, or its text holds it.
Message numberMessage(const EventRow& event)
{
    if (!event.number || event.kind == EventKind::Alarm) return {};
    if (event.kind == EventKind::Panel)
        return *event.number > 0.0 ? TR_NOOP("Report", "contact closed")
                                   : TR_NOOP("Report", "contact open");
    if (event.kind == EventKind::Link)
        return {TR_NOOP("Report", "longest gap %1 s"), fixed(*event.number, 2)};
    return Message::verbatim(fixed(*event.number, 3));
}

MissionLine lineOf(const EventRow& event)
{
    std::vector<Message> numbers;
    if (Message text = textMessage(event); !text.empty()) numbers.push_back(std::move(text));
    if (Message number = numberMessage(event); !number.empty())
        numbers.push_back(std::move(number));
    if (event.kind == EventKind::Decision && event.proposal != 0)
        numbers.emplace_back(TR_NOOP("Report", "proposal %1"), event.proposal);
    if (!event.shown.empty())
        numbers.emplace_back(TR_NOOP("Report", "on the screen: %1"), screenOf(event));
    Message what = kindText(event.kind);
    if (!event.subject.empty()) what = Message::joined(std::move(what), subjectMessage(event));
    return {event.time, 2, std::move(what), Message::listed(std::move(numbers), "; ")};
}

/// Returns the lines in the order of time, with at most the first maxRows estimates: no more can be shown.
Result<std::vector<MissionLine>> linesOf(SessionReader& session, const RobotModel& robot,
                                         const std::function<bool(double)>& progress,
                                         std::size_t maxRows)
{
    std::vector<MissionLine> lines;
    ReviewMoments moments(session, robot);
    const std::size_t count = session.estimates().size();
    for (std::size_t k = 0; k < std::min(count, maxRows); ++k) {
        if (progress && !progress(static_cast<double>(k) / static_cast<double>(count)))
            return fileError(session.path(), "no report: ended before all was read");
        auto line = lineOf(session, session.estimates()[k], robot, moments);
        if (!line) return line.error();
        lines.push_back(std::move(*line));
    }
    for (const ProposalRow& row : session.proposals()) lines.push_back(lineOf(row));
    for (const EventRow& event : session.events())
        if (event.kind != EventKind::Word && event.kind != EventKind::Alarm)
            lines.push_back(lineOf(event));
    std::ranges::stable_sort(
        lines, {}, [](const MissionLine& line) { return std::pair(line.time, line.order); });
    return lines;
}

/// Returns a row for what does not fit.
std::vector<std::string> restRow(std::size_t rest, std::size_t columns, const Wording& wording)
{
    std::vector<std::string> row(columns);
    row.back() = wording({TR_NOOP("Report", "… and %1 more in the session"), rest});
    return row;
}

/// One raise of an alarm; a time is empty if it was not recorded.
struct AlarmSpan {
    std::string id;
    Message text;
    std::optional<SessionTime> raised, acknowledged, gone;
};

std::vector<AlarmSpan> alarmsOf(const SessionReader& session)
{
    std::vector<AlarmSpan> spans;
    std::map<std::string, std::size_t> open;
    for (const EventRow& event : session.events()) {
        if (event.kind != EventKind::Alarm) continue;
        const double state = event.number.value_or(0.0);
        const auto known = open.find(event.subject);
        if (known == open.end() && state == 0.0) continue;
        const std::size_t index = known == open.end() ? spans.size() : known->second;
        if (known == open.end()) {
            spans.push_back({event.subject, messageOf(event), {}, {}, {}});
            open[event.subject] = index;
        }
        AlarmSpan& span = spans[index];
        if (state == 3.0) {
            if (!span.raised) span.raised = event.time;
            span.gone.reset();  // the cause is back
        }
        if (state == 2.0) span.acknowledged = event.time;
        if (state <= 1.0 && !span.gone) span.gone = event.time;
        if (state == 0.0) open.erase(event.subject);
    }
    return spans;
}

}  // namespace

Result<DocumentPart> missionDecisions(SessionReader& session, const RobotModel& robot,
                                      const std::function<bool(double)>& progress,
                                      std::size_t maxRows, const Wording& wording)
{
    auto lines = linesOf(session, robot, progress, maxRows);
    if (!lines) return lines.error();
    const std::size_t estimates = session.estimates().size();
    const std::size_t all = lines->size() + estimates - std::min(estimates, maxRows);
    DocumentPart part{
        .heading = wording(TR_NOOP("Report", "Decisions and their numbers")),
        .note = lines->empty()
                  ? wording(TR_NOOP("Report", "Nothing was estimated and nobody decided anything."))
                  : "",
        .facts = {},
        .pictures = {},
        .table = {{"UTC", wording(TR_NOOP("Report", "since start")),
                   wording(TR_NOOP("Report", "what")), wording(TR_NOOP("Report", "numbers"))},
                  {1.4, 1.2, 2.5, 6.9},
                  {}}};
    lines->resize(std::min(lines->size(), maxRows));
    part.table.rows.reserve(lines->size() + 1);
    for (const MissionLine& line : *lines)
        part.table.rows.push_back({clockText(session.start(), line.time), momentText(line.time),
                                   wording(line.what), wording(line.numbers)});
    if (all > maxRows) part.table.rows.push_back(restRow(all - maxRows, 4, wording));
    return part;
}

DocumentPart missionAlarms(const SessionReader& session, const Wording& wording)
{
    const std::vector<AlarmSpan> spans = alarmsOf(session);
    const auto moment = [&](const std::optional<SessionTime>& time, SourceText otherwise) {
        return time ? momentText(*time) : wording(otherwise);
    };
    DocumentPart part{
        .heading = wording(TR_NOOP("Report", "Alarms")),
        .note = spans.empty() ? wording(TR_NOOP("Report", "No alarm was raised.")) : "",
        .facts = {},
        .pictures = {},
        .table = {{wording(TR_NOOP("Report", "alarm")), wording(TR_NOOP("Report", "raised")),
                   wording(TR_NOOP("Report", "acknowledged")),
                   wording(TR_NOOP("Report", "cause gone")), wording(TR_NOOP("Report", "text"))},
                  {1.5, 1.4, 1.6, 1.6, 5.9},
                  {}}};
    for (std::size_t k = 0; k < std::min(spans.size(), kMaxReportRows); ++k)
        part.table.rows.push_back({wording(eventName(spans[k].id)),
                                   moment(spans[k].raised, TR_NOOP("Report", "before the session")),
                                   moment(spans[k].acknowledged, TR_NOOP("Report", "no")),
                                   moment(spans[k].gone, TR_NOOP("Report", "no")),
                                   wording(spans[k].text)});
    if (spans.size() > kMaxReportRows)
        part.table.rows.push_back(restRow(spans.size() - kMaxReportRows, 5, wording));
    return part;
}

DocumentPart missionSettings(const SessionReader& session, std::size_t maxRows,
                             const Wording& wording)
{
    DocumentPart part{
        .heading = wording(TR_NOOP("Report", "Active settings")),
        .note = wording(TR_NOOP("Report", "Settings of the estimates, from each change on. Other "
                                          "settings are recorded as decisions.")),
        .facts = {},
        .pictures = {},
        .table = {{wording(TR_NOOP("Report", "from")), wording(TR_NOOP("Report", "estimate")),
                   wording(TR_NOOP("Report", "settings"))},
                  {1.3, 1.7, 9.0},
                  {}}};
    std::map<bool, std::string> last;
    std::size_t rest = 0;
    for (const EstimateRow& row : session.estimates()) {
        const bool isSecond = row.role == EstimateRole::Second;
        const std::string text =
            wording({TR_NOOP("Report", "%1, step limit %2 m"),
                     settingsText(row.estimate.side[0].settings), row.stepLimit});
        if (std::exchange(last[isSecond], text) == text) continue;
        if (part.table.rows.size() == maxRows) {
            ++rest;
            continue;
        }
        part.table.rows.push_back({momentText(row.time),
                                   isSecond ? wording({TR_NOOP("Report", "%1 (second)"), row.id})
                                            : std::to_string(row.id),
                                   text});
    }
    if (rest > 0) part.table.rows.push_back(restRow(rest, 3, wording));
    if (part.table.rows.empty())
        part.note =
            wording(TR_NOOP("Report", "Nothing was estimated, so no settings are recorded."));
    return part;
}

}  // namespace terratact
