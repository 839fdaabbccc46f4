#include "app/figures/mission_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "app/figures/report_text.h"
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
    std::string what, numbers;
};

/// Returns the time of day, UTC, without the date.
std::string clockText(const SessionStart& start, SessionTime time)
{
    const std::string text = utcText(wallTimeOf(start, time));
    return text.substr(11, 12);
}

std::string sideText(ProbeSide side)
{
    return side == ProbeSide::Middle ? "" : fmt::format(" {}", name(side));
}

std::string errorText(const EstimateRow& row, const SceneRow* scene)
{
    std::string text;
    for (const RecordedSide& side : recordedSides(row.estimate.onePlane, scene)) {
        if (!side.truth) continue;
        const EstimateError error = errorAgainst(row.estimate.side.at(side.index), *side.truth);
        text += fmt::format("; {}error against the truth: {:.3f} m rms, {:.3f} m at {:+.1f} m, "
                            "{} of {} bins in their band",
                            row.estimate.onePlane ? "" : fmt::format("{} ", side.name), error.rms,
                            error.largest, binCentre(error.bin), error.inBand, kBins);
    }
    return text;
}

std::string verdictText(const TwoTrackVerdict& verdict, double limit)
{
    if (verdict.onePlane) return stepText(verdict.side[0], limit);
    return fmt::format("{}. Left: {}. Right: {}. Either side: {:.0f} %. Cross slope: {}",
                       describe(verdict), stepText(verdict.side[0], limit),
                       stepText(verdict.side[1], limit), 100.0 * verdict.either.p,
                       crossSlopeText(verdict.crossSlope));
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
    std::string verdict = "no verdict: its scene is damaged";
    if (scene) {
        const ReviewMoment moment = moments.at(row.time);
        verdict = verdictText(
            verdictOf(row.estimate, robot, scene->measurement,
                      {.unbroken = moment.unbroken, .sensorsSound = moment.sensorsSound},
                      row.stepLimit),
            row.stepLimit);
    }
    const Settings& settings = row.estimate.side[0].settings;
    const char* const role = row.role == EstimateRole::Second ? " (second method)"
                           : row.role == EstimateRole::Again  ? " (with the reading of the arm)"
                                                              : "";
    return MissionLine{
        row.time, 0, fmt::format("estimate {} of scene {}{}", row.id, row.scene, role),
        fmt::format("{}; method {}, {:.3f} s; arm: {}{}", verdict, name(settings.method),
                    row.seconds, readingsText(row), errorText(row, scene))};
}

/// Returns bits of information, which rounding may have left just below zero: "-0.00" would be printed.
double positiveBits(double value)
{
    return std::max(0.0, value);
}

MissionLine lineOf(const ProposalRow& row)
{
    std::string text =
        fmt::format("bin {:+.1f} m{}: height {:+.3f} m, {:+.3f} … {:+.3f} m, sd {:.3f} m above the "
                    "threshold {:.3f} m; arm sd {:.3f} m; takes {:.0f} s; step above {:.2f} m: "
                    "{:.2f} bit open",
                    binCentre(row.bin), sideText(row.side), row.height, row.q10, row.q90, row.sd,
                    row.limit, row.armSd, row.seconds, row.stepLimit, positiveBits(row.bitsBefore));
    if (!row.offers.empty() && row.offers[0].bin == row.bin && row.offers[0].side == row.side)
        text += fmt::format(", {:.2f} bit after it", positiveBits(row.offers[0].bitsAfter));
    return {row.time, 1, fmt::format("probe proposed on estimate {}", row.estimate), text};
}

std::string kindText(EventKind kind)
{
    switch (kind) {
    case EventKind::Decision: return "operator";
    case EventKind::Phase: return "exploration";
    case EventKind::Marker: return "marker";
    default: return std::string(name(kind));
    }
}

MissionLine lineOf(const EventRow& event)
{
    const std::string subject = subjectWords(event);
    std::string numbers = textWords(event);
    const auto add = [&numbers](const std::string& text) {
        numbers += (numbers.empty() ? "" : "; ") + text;
    };
    if (event.number && event.kind != EventKind::Alarm) add(fmt::format("{:.3f}", *event.number));
    if (event.kind == EventKind::Decision && event.proposal != 0)
        add(fmt::format("proposal {}", event.proposal));
    if (!event.shown.empty()) add("on the screen: " + event.shown);
    return {event.time, 2,
            kindText(event.kind) + (subject.empty() ? "" : fmt::format(": {}", subject)), numbers};
}

/// Returns the lines in the order of time; of the estimates the first maxRows alone, because only those can be shown.
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
std::vector<std::string> restRow(std::size_t rest, std::size_t columns)
{
    std::vector<std::string> row(columns);
    row.back() = fmt::format("… and {} more in the session", rest);
    return row;
}

/// One raise of an alarm; a time is empty if it was not recorded.
struct AlarmSpan {
    std::string id, text;
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
            spans.push_back({event.subject, textWords(event), {}, {}, {}});
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
                                      std::size_t maxRows)
{
    auto lines = linesOf(session, robot, progress, maxRows);
    if (!lines) return lines.error();
    const std::size_t estimates = session.estimates().size();
    const std::size_t all = lines->size() + estimates - std::min(estimates, maxRows);
    DocumentPart part{
        .heading = "Decisions and their numbers",
        .note = lines->empty() ? "Nothing was estimated and nobody decided anything." : "",
        .facts = {},
        .pictures = {},
        .table = {{"UTC", "since start", "what", "numbers"}, {1.4, 1.2, 2.5, 6.9}, {}}};
    lines->resize(std::min(lines->size(), maxRows));
    part.table.rows.reserve(lines->size() + 1);
    for (MissionLine& line : *lines)
        part.table.rows.push_back({clockText(session.start(), line.time), momentText(line.time),
                                   std::move(line.what), std::move(line.numbers)});
    if (all > maxRows) part.table.rows.push_back(restRow(all - maxRows, 4));
    return part;
}

DocumentPart missionAlarms(const SessionReader& session)
{
    const std::vector<AlarmSpan> spans = alarmsOf(session);
    DocumentPart part{.heading = "Alarms",
                      .note = spans.empty() ? "No alarm was raised." : "",
                      .facts = {},
                      .pictures = {},
                      .table = {{"alarm", "raised", "acknowledged", "cause gone", "text"},
                                {1.5, 1.4, 1.6, 1.6, 5.9},
                                {}}};
    for (std::size_t k = 0; k < std::min(spans.size(), kMaxReportRows); ++k)
        part.table.rows.push_back(
            {spans[k].id, spans[k].raised ? momentText(*spans[k].raised) : "before the session",
             spans[k].acknowledged ? momentText(*spans[k].acknowledged) : "no",
             spans[k].gone ? momentText(*spans[k].gone) : "no", spans[k].text});
    if (spans.size() > kMaxReportRows)
        part.table.rows.push_back(restRow(spans.size() - kMaxReportRows, 5));
    return part;
}

DocumentPart missionSettings(const SessionReader& session, std::size_t maxRows)
{
    DocumentPart part{.heading = "Settings in force",
                      .note = "Settings of the estimates, from each change on. Other settings are "
                              "recorded as decisions.",
                      .facts = {},
                      .pictures = {},
                      .table = {{"from", "estimate", "settings"}, {1.3, 1.7, 9.0}, {}}};
    std::map<bool, std::string> last;
    std::size_t rest = 0;
    for (const EstimateRow& row : session.estimates()) {
        const bool isSecond = row.role == EstimateRole::Second;
        const std::string text = fmt::format(
            "{}, step limit {} m", settingsText(row.estimate.side[0].settings), row.stepLimit);
        if (std::exchange(last[isSecond], text) == text) continue;
        if (part.table.rows.size() == maxRows) {
            ++rest;
            continue;
        }
        part.table.rows.push_back(
            {momentText(row.time), fmt::format("{}{}", row.id, isSecond ? " (second)" : ""), text});
    }
    if (rest > 0) part.table.rows.push_back(restRow(rest, 3));
    if (part.table.rows.empty()) part.note = "Nothing was estimated, so no settings are recorded.";
    return part;
}

}  // namespace terratact
